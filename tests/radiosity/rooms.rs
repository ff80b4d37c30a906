//! The two golden rooms.

use super::{CUBE, bare, cube, scene, solve};
use glam::{DVec2, DVec3};
use halfdisk::flatland::{self, exact::ROOM_FLOOR};
use halfdisk::radiosity::flat::FlatSolution;
use halfdisk::radiosity::{Channels, Patch, PatchSize, point_to_polygon};
use halfdisk::radiosity::{Matrix, System};
use halfdisk::scene::read::Source;

/// Radiance reflected at the middle of the floor of the cube whose ceiling shines, and its mean over the floor:
/// radiosity on ever finer patches, extrapolated, and a path tracer of 12 million paths agree within
/// 1e-5 and 1e-4.
pub const CENTRE: f64 = 0.197_60;
pub const MEAN: f64 = 0.171_22;

/// The system of the cube, by exact inner integrals.
pub fn system(patches: &[Patch]) -> System<f64> {
    let factors = bare(patches, 2);
    System {
        emission: patches.iter().map(|patch| patch.emission).collect(),
        albedo: patches.iter().map(|patch| patch.albedo).collect(),
        factors: Matrix::new(
            patches.len(),
            (0..patches.len()).flat_map(|i| factors.row(i)).collect(),
        ),
    }
}

/// What a point of the floor reflects, gathered once more.
pub fn gathered(patches: &[Patch], radiance: &[Channels], p: DVec3) -> f64 {
    let floor = &patches[0];
    let lift = floor.polygon[0].y;
    let p = DVec3::new(p.x, lift, p.z);
    let others = patches
        .iter()
        .zip(radiance)
        .filter(|(patch, _)| patch.normal.y < 0.5);
    let sum: f64 = others
        .map(|(patch, of)| of[0] * point_to_polygon(p, floor.normal, &patch.polygon))
        .sum();
    0.5 * sum
}

/// The mean over the floor.
pub fn floor_mean(patches: &[Patch], radiance: &[Channels]) -> f64 {
    let floor = patches
        .iter()
        .zip(radiance)
        .filter(|(patch, _)| patch.normal.y > 0.5);
    floor.map(|(patch, of)| patch.area * of[0]).sum()
}

/// The middle of the floor, as seen from the camera.
fn middle() -> DVec3 {
    DVec3::new(0.0, 0.0, -0.05)
}

#[test]
fn s0_25_the_room_in_space() {
    let [mut centres, mut means] = [Vec::new(), Vec::new()];
    for n in [2, 4, 8] {
        let patches = cube(n);
        let radiance = system(&patches).gauss_seidel(1e-12).radiance;
        centres.push(gathered(&patches, &radiance, middle()));
        means.push(floor_mean(&patches, &radiance));
    }
    println!("floor's centre {centres:.6?}, mean {means:.6?}");
    // The error of the finest is at most its distance from the one before.
    for (values, golden) in [(&centres, CENTRE), (&means, MEAN)] {
        let step = (values[2] - values[1]).abs();
        assert!(
            (values[2] - golden).abs() < step + 1e-5,
            "{values:?} {golden}"
        );
        assert!(step < 3e-3 * golden, "{step}");
    }
    // The mistake: the factors of centres, which create energy.
    assert!((CENTRE - MEAN).abs() > 0.02, "the two are told apart");
}

#[test]
fn the_scene_gives_the_room_its_light() {
    // Shadow rays in an empty room change nothing; the indirect light is what the golden mean has above the
    // direct.
    let scene = scene(CUBE);
    let solution = solve(&scene, PatchSize::Length(0.125));
    let floor: Vec<usize> = (0..solution.patches.all.len())
        .filter(|&i| solution.patches.all[i].normal.y > 0.5)
        .collect();
    let mean = |c: usize| -> f64 {
        floor
            .iter()
            .map(|&i| solution.patches.all[i].area * solution.reflected[i][c])
            .sum()
    };
    for c in 0..3 {
        assert!((mean(c) / MEAN - 1.0).abs() < 3e-3, "{}", mean(c));
    }
    assert_eq!(solution.effort.patches, 384);
    assert_eq!(solution.effort.bytes, 4 * 384 * 384);
}

#[test]
fn the_flat_room_is_golden() {
    let room = flatland::load("room").expect("the room");
    let mut off = Vec::new();
    for n in [8_u32, 16, 32] {
        let solution = FlatSolution::new(&room, 1.0 / f64::from(n)).expect("a solution");
        // Each wall's back is a patch, too, and sees nothing.
        assert_eq!(solution.patches.len(), 8 * n as usize);
        let rows = (0..solution.patches.len()).map(|i| solution.system.factors.row_sum(i));
        assert!(
            rows.into_iter()
                .all(|sum| sum.abs() < 1e-14 || (sum - 1.0).abs() < 1e-13)
        );
        let read = 0.5 * solution.arriving(DVec2::new(0.5, 0.0), DVec2::Y)[0];
        off.push(read - ROOM_FLOOR);
    }
    println!("flat room: off by {off:?} with 8, 16, 32 patches a wall");
    assert!(off[2].abs() < 5e-6, "{off:?}");
    assert!(off[1].abs() < 0.4 * off[0].abs(), "{off:?}");
}

#[test]
fn strings_around_a_blocker() {
    // Two walls of length 2 at distance 2, and between them a wall of length 1 in the middle: Hottel's
    // strings go around it.
    let text = "name = 't'\nmaterials.grey.albedo = 0.5\n\
        [[objects]]\nmaterial = 'grey'\nsegment = { from = [-1, 0], to = [1, 0] }\n\
        [[objects]]\nmaterial = 'grey'\nsegment = { from = [1, 2], to = [-1, 2] }\n\
        [[objects]]\nmaterial = 'grey'\nsegment = { from = [-0.5, 1], to = [0.5, 1] }\n";
    let world = flatland::gallery::from_text(Source { file: "t", text }).expect("a world");
    let solution = FlatSolution::new(&world, 0.1).expect("a solution");
    let is = |ends: [DVec2; 2], y: f64, up: f64| {
        ends[0].y == y && ends[1].y == y && (ends[1].x - ends[0].x) * up > 0.0
    };
    let all = &solution.patches;
    let floor: Vec<usize> = (0..all.len())
        .filter(|&i| is(all[i].ends, 0.0, 1.0))
        .collect();
    let ceiling: Vec<usize> = (0..all.len())
        .filter(|&i| is(all[i].ends, 2.0, -1.0))
        .collect();
    let pairs = floor
        .iter()
        .flat_map(|i| ceiling.iter().map(move |j| (*i, *j)));
    let found = pairs
        .map(|(i, j)| all[i].length() * solution.system.factors.at(i, j))
        .sum::<f64>()
        / 2.0;
    // Strings through the gap on the left, and as many on the right: crossed less uncrossed, halved.
    let [near, far] = [0.5, 1.5].map(|x| libm::hypot(x, 1.0));
    let gap = 0.5 * (2.0 * (near + far) - 2.0 - 2.0 * far);
    let exact = 2.0 * gap / 2.0;
    println!("past a blocker {found:.6}, by strings {exact:.6}");
    assert!((found / exact - 1.0).abs() < 5e-3, "{found} {exact}");
    let open = 2.0_f64.sqrt() - 1.0;
    assert!(
        found < open - 0.1,
        "the mistake, without shadow rays: {open}"
    );
}

#[test]
fn a_flat_wall_in_the_middle_of_a_patch_does_not_leak() {
    // A square room whose floor and ceiling would be one patch each, but for a wall at 0.6: lit on its left.
    let wall = |from: [f64; 2], to: [f64; 2], emits: &str| {
        format!(
            "[[objects]]\nmaterial = 'grey'\n{emits}segment = {{ from = {from:?}, to = {to:?} }}\n"
        )
    };
    let text = "name = 't'\nmaterials.grey.albedo = 0.5\n".to_owned()
        + &wall([0., 0.], [1., 0.], "")
        + &wall([1., 0.], [1., 1.], "")
        + &wall([1., 1.], [0., 1.], "")
        + &wall([0., 1.], [0., 0.], "emits = 1\n")
        + &wall([0.6, 0.], [0.6, 1.], "");
    let world = flatland::gallery::from_text(Source {
        file: "t",
        text: &text,
    })
    .expect("a world");
    let solution = FlatSolution::new(&world, 2.0).expect("a solution");
    // Two sides each of seven pieces: the floor and the ceiling are cut in two.
    assert_eq!(solution.patches.len(), 14);
    let [mut dark, mut lit] = [0, 0];
    for (i, (patch, radiance)) in solution
        .patches
        .iter()
        .zip(&solution.solved.radiance)
        .enumerate()
    {
        let [a, b] = patch.ends;
        let inwards = 0.5 * (a + b) + 0.1 * (b - a).perp().normalize();
        let inside = |x: f64| (0.0..1.0).contains(&x);
        let sum = solution.system.factors.row_sum(i);
        if !inside(inwards.x) || !inside(inwards.y) {
            assert!(sum == 0.0, "{patch:?}: outside");
            continue;
        }
        assert!((sum - 1.0).abs() < 1e-6, "{patch:?}: {sum}");
        if inwards.x > 0.6 {
            dark += 1;
            assert_eq!(*radiance, [0.0; 3], "{patch:?}");
        } else {
            lit += 1;
            assert!(radiance[0] > 0.05, "{patch:?}");
        }
    }
    assert_eq!([dark, lit], [4, 4]);
}
