//! Light that mirrors and glass focus, where geometry knows where it goes.

use super::flat::{photons, world};
use super::scene;
use crate::checks::CRITICAL;
use glam::{DVec2, DVec3, Vec2};
use halfdisk::color::Rgb;
use halfdisk::flatland::FlatWorld;
use halfdisk::integrators::Photons;
use halfdisk::integrators::world::{Emitted, FlatTracer};
use halfdisk::materials::fresnel;
use halfdisk::photons::{Kernel, Photon, PhotonMap};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Tracer;
use halfdisk::space::{Flat, Ray};

/// Photons of a beam: from `(x, y)` for `y` uniform between two heights, each with this power, along `direction`.
fn beam(
    world: &FlatWorld,
    [from, to]: [Vec2; 2],
    direction: Vec2,
    walks: u32,
) -> Vec<Photon<Flat>> {
    let by = Photons::in_space::<Flat>(64);
    let mut tracer = FlatTracer::new(world);
    let mut found = Vec::new();
    for walk in 0..walks {
        let stream = Stream::new(3, walk, 0);
        let u = stream.at(0, Purpose::Emission).one();
        let ray = Ray::new(from + (to - from) * u, direction);
        let start = Emitted {
            ray,
            power: Rgb::WHITE,
            is_delta: true,
        };
        by.follow(&mut tracer, start, &stream, &mut |p| found.push(p));
    }
    found
}

/// Checks a share of `walks` that counted, which is `expected`.
fn share(what: &str, count: usize, walks: u32, expected: f64) {
    let n = f64::from(walks);
    let (share, error) = (count as f64 / n, (expected * (1.0 - expected) / n).sqrt());
    println!("{what}: {share:.5} for {expected:.5} ± {error:.5}");
    assert!(
        (share - expected).abs() <= CRITICAL * error + 1e-9,
        "{what}: {share}"
    );
    assert!(error < 0.01, "{what}");
}

#[test]
fn an_elliptic_mirror_sends_all_light_of_one_focus_to_the_other() {
    // Foci at -1 and 1.
    let target = |x: f32| {
        format!(
            "[[objects]]\nmirror = 1\nellipse = {{ center = [0, 0], axes = [2, {}] }}\n\
             [[objects]]\nalbedo = 0\ncircle = {{ center = [{x}, 0], radius = 0.01 }}\n\
             [[lamps]]\npoint = {{ position = [-1, 0], power = 3 }}\n",
            3.0_f64.sqrt()
        )
    };
    let walks = 20_000;
    let once = |x: f32| {
        let found = photons(&world(&target(x)), &Photons::in_space::<Flat>(4), walks, 2);
        let early = found.iter().filter(|photon| photon.segments <= 2);
        let power: f64 = early.clone().map(|photon| f64::from(photon.power.g)).sum();
        (early.count(), power / f64::from(walks))
    };
    let (count, power) = once(1.0);
    assert_eq!(count, walks as usize, "all by one reflection");
    assert!((power - 3.0).abs() < 1e-4, "{power}");
    let (count, _) = once(0.9);
    assert!(count < walks as usize / 2, "beside the focus: {count}");
}

#[test]
fn a_glass_ellipse_of_the_right_eccentricity_has_a_focus() {
    let ior = 1.5_f64;
    let height = (1.0 - 1.0 / (ior * ior)).sqrt();
    let scene = |ior: f64| {
        let x = 1.0 / 1.5;
        world(&format!(
            "[[objects]]\nglass = {ior}\nellipse = {{ center = [0, 0], axes = [1, {height}] }}\n\
             [[objects]]\nalbedo = 0\nsegment = {{ from = [{x}, -0.001], to = [{x}, 0.001] }}\n"
        ))
    };
    let (top, walks) = (0.9 * height, 40_000);
    let ends = [-top, top].map(|y| Vec2::new(-2.0, y as f32));
    let landed = |ior| beam(&scene(ior), ends, Vec2::X, walks).len();
    // What the front lets in, by the angle at which a ray meets it.
    let enters = |k: i32| {
        let y = top * f64::from(k) / 1000.0;
        let x = -(1.0 - (y / height).powi(2)).sqrt();
        let n = DVec2::new(x, y / (height * height)).normalize();
        1.0 - fresnel::dielectric(-n.x, ior)
    };
    let expected = (-1000..=1000).map(enters).sum::<f64>() / 2001.0;
    share("focus", landed(ior), walks, expected);
    let wrong = landed(1.45);
    assert!(wrong < walks as usize / 4, "another glass: {wrong}");
}

#[test]
fn a_point_in_a_ball_of_glass_seems_to_sit_n_times_as_far() {
    // The aplanatic point, at 1/n from the middle of a ball of radius 1, and another one.
    let photon_lines = |height: f64| {
        let scene = scene(&format!(
            "camera = {{ from = [0, 0, 5], to = [0, 0, 0], fov = 40 }}\n\
             materials.half.lambert.albedo = 0\nmaterials.clear.glass.ior = 1.5\n\
             [[objects]]\nmaterial = 'clear'\nsphere = {{ center = [0, 0, 0], radius = 1 }}\n\
             [[objects]]\nmaterial = 'half'\n\
             quad = {{ corner = [-90, -90, -3], u = [180, 0, 0], v = [0, 180, 0] }}\n\
             [[lights]]\npoint = {{ position = [0, 0, {height}], intensity = 1 }}\n"
        ));
        let (mut tracer, by) = (Tracer::new(&scene), Photons::new(3));
        let mut found = Vec::new();
        for walk in 0..20_000 {
            let stream = Stream::new(9, walk, 0);
            by.trace(&mut tracer, 0.0, &stream, &mut |photon| {
                if photon.segments == 2 {
                    found.push((photon.p.as_dvec3(), photon.wi.as_dvec3()));
                }
            });
        }
        // The camera is the origin.
        found
            .into_iter()
            .map(|(p, wi)| (p + DVec3::Z * 5.0, wi))
            .collect::<Vec<_>>()
    };
    // Of those that leave by the lower half: how far their lines pass the image by.
    let worst = |lines: &[(DVec3, DVec3)]| {
        let lower = lines.iter().filter(|(p, wi)| {
            let h = p.dot(*wi);
            let leaves = *p + *wi * (-h - (h * h - p.length_squared() + 1.0).max(0.0).sqrt());
            leaves.z < 0.0
        });
        let off = |(p, wi): &(DVec3, DVec3)| (DVec3::Z * 1.5 - *p).cross(*wi).length();
        let offs: Vec<f64> = lower.map(off).collect();
        assert!(offs.len() > 3000, "{}", offs.len());
        offs.into_iter().fold(0.0, f64::max)
    };
    let (right, wrong) = (worst(&photon_lines(1.0 / 1.5)), worst(&photon_lines(0.6)));
    println!("past the image by {right:.1e}; of another point {wrong:.2}");
    assert!(right < 3e-5 && wrong > 0.1);
}

#[test]
fn a_glass_slab_lets_through_what_its_faces_leave() {
    let slab = world(
        "[[objects]]\nglass = 1.5\npolyline = { points = [[0, 1], [0, 2], [9, 2], [9, 1]], closed = true }\n\
         [[objects]]\nalbedo = 0\nsegment = { from = [-1, 0], to = [10, 0] }\n",
    );
    let walks = 100_000;
    let ends = [4.0, 5.0].map(|x| Vec2::new(x, 3.0));
    let landed = beam(&slab, ends, Vec2::NEG_Y, walks).len();
    let r = fresnel::dielectric(1.0, 1.5);
    share("slab", landed, walks, (1.0 - r) / (1.0 + r));
    // Two faces that do not see each other's light would read less.
    let once = (1.0 - r) * (1.0 - r);
    assert!(
        (landed as f64 / f64::from(walks) - once).abs() > 0.0005,
        "{landed}"
    );
}

/// Where a ray at height `u`, parallel to the axis, meets a screen at `s` after a round mirror of radius 1.
fn round_mirror(u: f64, s: f64) -> f64 {
    let angle = libm::asin(u);
    u - (libm::cos(angle) - s) * libm::tan(2.0 * angle)
}

#[test]
fn a_caustic_is_what_its_map_says_blurred_as_the_window_says() {
    let (screen, top, walks) = (0.6_f64, 0.6_f64, 200_000);
    let round = world(&format!(
        "[[objects]]\nmirror = 1\ncircle = {{ center = [0, 0], radius = 1 }}\n\
         [[objects]]\nalbedo = 0\nsegment = {{ from = [{screen}, -0.75], to = [{screen}, 0.75] }}\n"
    ));
    let ends = [-top, top].map(|y| Vec2::new(screen as f32 + 1e-4, y as f32));
    let found = beam(&round, ends, Vec2::X, walks);
    let back: Vec<_> = found.into_iter().filter(|p| p.segments == 2).collect();
    assert_eq!(back.len(), walks as usize, "all come back to the screen");
    // The caustic of a round mirror is a nephroid, whose points are cos of (3 cos a - cos 3a) / 4 and sin³ a.
    let nephroid = |a: f64| (3.0 * libm::cos(a) - libm::cos(3.0 * a)) / 4.0;
    let (mut low, mut high) = (0.0, 0.7);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if nephroid(middle) < screen {
            low = middle
        } else {
            high = middle
        }
    }
    let fold = libm::pow(libm::sin(low), 3.0);
    const STEPS: u32 = 400_000;
    // The share of the beam that comes to a window, counted on a grid: the blurred truth.
    let counted = |at: f64, radius: f64| {
        let y = |k: u32| top * (2.0 * (f64::from(k) + 0.5) / f64::from(STEPS) - 1.0);
        let within = (0..STEPS).filter(|&k| (round_mirror(y(k), screen) - at).abs() < radius);
        within.count() as f64 / f64::from(STEPS)
    };
    for radius in [0.05_f64, 0.01] {
        let map = PhotonMap::new(back.clone(), walks, radius as f32, Kernel::Constant);
        let read = |at: f64| {
            let p = Vec2::new(screen as f32, at as f32);
            f64::from(map.estimate(p, Vec2::X, radius as f32, |p| p.power).g)
        };
        for at in [0.0, 0.5 * fold, fold - radius, fold, fold + 2.0 * radius] {
            let part = counted(at, radius);
            let truth = part / (2.0 * radius);
            let error = (part * (1.0 - part) / f64::from(walks)).sqrt() / (2.0 * radius);
            let off = read(at) - truth;
            println!(
                "r {radius} at {at:.4}: {:.4} for {truth:.4} ± {error:.4}",
                read(at)
            );
            assert!(off.abs() <= CRITICAL * error + 1e-3 * truth, "{at}: {off}");
        }
        // Beyond the nephroid there is next to nothing.
        let (inside, beyond) = (read(fold - 0.5 * radius), read(fold + 2.0 * radius));
        assert!(inside > 2.0 * beyond, "{inside} {beyond}");
    }
}
