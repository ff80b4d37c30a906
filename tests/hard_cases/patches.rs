//! A50: patches of any size, in any place, at any angle.

use super::scene;
use glam::{DVec3, Vec3};
use halfdisk::geometry::Ray;
use halfdisk::radiosity::{FormFactors, Patch, PatchSize, Patches, Solution, form_factor};
use halfdisk::scene::{Scene, Tracer};

/// A room around `middle` with a lamp for a ceiling, seen from its middle unless `middle` is elsewhere.
fn room(side: f64, middle: [f64; 3]) -> Scene {
    let at = |p: [f64; 3]| [0, 1, 2].map(|i| middle[i] + side * (p[i] - 0.5));
    let along = |v: [f64; 3]| v.map(|x| side * x);
    let [x, y, z] = [[1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
    let walls = [
        ([0., 0., 0.], z, x),
        ([0., 1., 0.], x, z),
        ([0., 0., 0.], x, y),
        ([0., 0., 1.], y, x),
        ([0., 0., 0.], y, z),
        ([1., 0., 0.], z, y),
    ];
    let mut text = String::new();
    for (i, (corner, u, v)) in walls.into_iter().enumerate() {
        let emits = if i == 1 { "emits = 1\n" } else { "" };
        let [corner, u, v] = [at(corner), along(u), along(v)];
        text += &format!(
            "[[objects]]\nmaterial = 'half'\n{emits}quad = {{ corner = {corner:?}, u = {u:?}, v = {v:?} }}\n"
        );
    }
    scene(&text)
}

fn reflected(scene: &Scene, length: f64) -> Vec<f64> {
    let solution = Solution::new(scene, PatchSize::Length(length), &()).expect("a solution");
    let reflected: Vec<f64> = solution.reflected.iter().map(|of| of[0]).collect();
    let bright = |x: &f64| (0.05..0.5).contains(x);
    assert!(
        reflected.len() == 96 && reflected.iter().all(bright),
        "{reflected:?}"
    );
    reflected
}

fn worst(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter()
        .zip(b)
        .map(|(x, y)| (x - y).abs())
        .fold(0.0, f64::max)
}

/// The share of pairs of patches that see each other, by a ray that starts a fixed distance off its patch.
fn plainly_seen(scene: &Scene, distance: f64) -> f64 {
    let size = PatchSize::Number(24);
    let patches = Patches::new(scene, size).expect("patches").all;
    let middle = |patch: &Patch| patch.polygon.iter().sum::<DVec3>() / 4.0;
    let mut tracer = Tracer::new(scene);
    let [mut seen, mut all] = [0, 0];
    for a in &patches {
        for b in patches.iter().filter(|b| b.normal != a.normal) {
            let off = |patch: &Patch| (middle(patch) + patch.normal * distance).as_vec3();
            let (from, to): (Vec3, Vec3) = (off(a), off(b));
            let ray = Ray {
                t_max: 1.0,
                ..Ray::new(from, to - from)
            };
            seen += u32::from(tracer.unoccluded(&ray));
            all += 1;
        }
    }
    f64::from(seen) / f64::from(all)
}

#[test]
fn a50_rooms_of_any_size_have_the_same_light() {
    let unit = reflected(&room(1.0, [0.0; 3]), 0.25);
    let mut off = 0.0_f64;
    for side in [1e-3, 1e-2, 0.3, 7.0, 1e3, 1e6] {
        let aside = [0.1, -0.23, 0.07].map(|x| x * side);
        off = off.max(worst(&reflected(&room(side, aside), 0.25 * side), &unit));
    }
    let plain = [1.0, 1e-3].map(|side| plainly_seen(&room(side, [0.0; 3]), 1e-3));
    println!(
        "rooms of sides 1e-3 to 1e6 differ by {off:.0e}; a fixed offset of 1e-3 sees {:.0} % of the pairs \
         in the unit room, {:.0} % in the smallest",
        100.0 * plain[0],
        100.0 * plain[1]
    );
    assert!(off > 0.0 && off < 1e-5, "{off:e}");
    assert!(plain[0] == 1.0 && plain[1] < 0.5, "{plain:?}");
}

/// Four patches along a side of 0.7, also where it is rounded to a little more.
const LENGTH: f64 = 0.18;

#[test]
fn a50_rooms_far_from_the_eye_keep_their_light() {
    // In order of light, for where corners are rounded patches are cut in another order.
    let sorted = |scene: &Scene| {
        let mut reflected = reflected(scene, LENGTH);
        reflected.sort_by(f64::total_cmp);
        reflected
    };
    let unit = sorted(&room(0.7, [0.0; 3]));
    // A side that is no power of two, or all corners would be rounded alike.
    let at = |far: f64| room(0.7, [1.0037 * far, -far * 1.0071, 0.3013 * far]);
    let off = [1e1, 1e2, 1e3, 1e4].map(|far| worst(&sorted(&at(far)), &unit));
    let plain = [1.0, 1e4].map(|far| plainly_seen(&at(far), 1e-4));
    println!(
        "rooms 1e1, 1e2, 1e3 and 1e4 away differ by {off:?}; a fixed offset of 1e-4 sees {:.0} % of the pairs \
         at 1, {:.0} % at 1e4",
        100.0 * plain[0],
        100.0 * plain[1]
    );
    // Coordinates there are rounded to 5e-7, 4e-6, 3e-5 and 5e-4.
    assert!(
        off[0] < 1e-6 && off[1] < 1e-5 && off[2] < 1e-4 && off[3] < 2e-3,
        "{off:?}"
    );
    assert!(plain[0] == 1.0 && plain[1] < 0.1, "{plain:?}");

    // Further away patches are refused, small ones before large ones.
    let said = |far: f64, length: f64| {
        let made = Solution::new(&at(far), PatchSize::Length(length), &());
        made.err().map(|error| error.to_string())
    };
    let told = said(1e5, LENGTH).expect("a refusal");
    assert!(told.contains("stand where rounding moves points"), "{told}");
    assert!(told.contains("up to 9.6e-2"), "{told}");
    assert!(said(1e4, 0.05).is_some() && said(1e4, LENGTH).is_none());
}

#[test]
fn a50_slivers_see_what_others_see() {
    // The floor in strips, one of them a hundred-thousandth as wide as long.
    let strip = |low: f64, high: f64| {
        let corners = [[low, 0.], [low, 1.], [high, 1.], [high, 0.]];
        let polygon = corners.map(|[x, z]| DVec3::new(x, 0.0, z)).to_vec();
        Patch::new(polygon, [0.5; 3], [0.0; 3]).expect("an area")
    };
    let ceiling = [[0., 0.], [1., 0.], [1., 1.], [0., 1.]];
    let ceiling = ceiling.map(|[x, z]| DVec3::new(x, 1.0, z)).to_vec();
    let patches = [
        strip(0.0, 0.4),
        strip(0.4, 0.400_01),
        strip(0.400_01, 1.0),
        Patch::new(ceiling, [0.5; 3], [0.0; 3]).expect("an area"),
    ];
    let factors = FormFactors {
        patches: &patches,
        scene: None,
        points: 16,
    };
    let whole = 0.199_824_895_7;
    let of_ceiling: f64 = factors.row(3).iter().sum();
    let weighted: f64 = (0..3).map(|i| patches[i].area * factors.row(i)[3]).sum();
    assert!((of_ceiling - whole).abs() < 1e-9, "{of_ceiling}");
    assert!((weighted - whole).abs() < 1e-9, "{weighted}");
    let [there, back] = [factors.row(3)[1], patches[1].area * factors.row(1)[3]];
    assert!((there / back - 1.0).abs() < 1e-6, "{there:e} {back:e}");

    // One that lies along a wall sees half of it, and nothing of it from its middle to the middle of the wall.
    let wall = [[0., 0.], [0., 1.], [1., 1.], [1., 0.]];
    let wall = wall.map(|[y, z]| DVec3::new(0.0, y, 1.0 - z)).to_vec();
    let wall = Patch::new(wall, [0.5; 3], [0.0; 3]).expect("an area");
    let pair = [strip(0.0, 1e-5), wall];
    let [found, _] = form_factor(&pair[0], &pair[1], 1e-9);
    let plain = centre_to_centre(&pair);
    println!("a sliver along a wall sees {found:.6} of it, from centre to centre {plain:.1e}");
    assert!((found - 0.5).abs() < 1e-4, "{found}");
    assert!(plain < 1e-4, "{plain:e}");
}

/// The plain form of a form factor: from the centre of one patch to that of the other.
fn centre_to_centre(pair: &[Patch; 2]) -> f64 {
    let middle = |patch: &Patch| patch.polygon.iter().sum::<DVec3>() / 4.0;
    let way = middle(&pair[1]) - middle(&pair[0]);
    let cosines = pair[0].normal.dot(way) * -pair[1].normal.dot(way);
    cosines.max(0.0) * pair[1].area / (std::f64::consts::PI * way.length_squared().powi(2))
}

/// Two long strips of width 1 that share a long edge at an angle.
fn wedge(angle: f64) -> [Patch; 2] {
    let long = 1000.0;
    let (sin, cos) = libm::sincos(angle);
    let strip = |x: f64, y: f64| {
        let corners = [[0., 0., 0.], [0., 0., long], [x, y, long], [x, y, 0.]];
        corners.map(DVec3::from).to_vec()
    };
    let mut leaning = strip(cos, sin);
    leaning.reverse();
    [strip(1.0, 0.0), leaning].map(|p| Patch::new(p, [0.5; 3], [0.0; 3]).expect("an area"))
}

#[test]
fn a50_patches_touch_at_any_angle() {
    let flat = std::f64::consts::PI;
    for angle in [1e-3, 0.01, 0.1, 1.0, 2.0, 3.0, flat - 0.01, flat - 1e-3] {
        let pair = wedge(angle);
        // Hottel's strings, for strips without end; these have one, and see past it.
        let exact = 1.0 - libm::sin(0.5 * angle);
        let [found, _] = form_factor(&pair[0], &pair[1], 1e-9 * exact);
        let plain = centre_to_centre(&pair);
        println!(
            "angle {angle:.3}: {found:.4e}, by strings {exact:.4e}, centre to centre {plain:.2e}"
        );
        assert!(
            (found / exact - 1.0).abs() < 3e-3,
            "{angle}: {found:e} {exact:e}"
        );
        assert!((plain / exact - 1.0).abs() > 1.0, "{angle}: {plain:e}");
    }
}
