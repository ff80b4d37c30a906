//! Power is neither made nor lost.

use super::{fixed, mean};
use crate::checks::{alike, unlike};
use halfdisk::integrators::{Pass, Photons};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::gallery;

#[test]
fn s0_27_power_is_neither_made_nor_lost() {
    let furnace = gallery::load("furnace").unwrap();
    let photons = Photons::new(6);
    let pass = Pass {
        scene: &furnace,
        sample: 3,
        seed: 1,
        sampler: Sampler::Independent,
        fixed: &[],
        stop: &|| false,
    };
    let walks = 1 << 16;
    let traced = pass.trace(0..walks, |tracer, stream, leave| {
        photons.trace(tracer, pass.moment(), stream, leave);
    });
    let (found, rays) = traced.unwrap();
    assert!(rays.secondary > u64::from(walks) && rays.camera == 0);
    // Six walls of four units that send π, and keep half of what they get.
    let emitted = 24.0 * std::f64::consts::PI;
    for segments in 1..6 {
        let lands = found.iter().filter(|photon| photon.segments == segments);
        let sum: f64 = lands.clone().map(|photon| f64::from(photon.power.g)).sum();
        let expected = emitted * 0.5_f64.powi(segments as i32 - 1);
        let share = lands.count() as f64 / f64::from(walks);
        let error = expected / (share * f64::from(walks)).sqrt();
        alike(
            "flux",
            (sum / f64::from(walks), error),
            (expected, 0.0),
            0.1,
        );
    }
    assert!(found.iter().all(|photon| (1..6).contains(&photon.segments)));
    // Roulette keeps their powers alike.
    let all = found.iter().map(|photon| photon.power.g);
    let (least, most) = all.fold((f32::MAX, 0.0_f32), |(a, b), x| (a.min(x), b.max(x)));
    assert!(most < 1.001 * least, "{least} {most}");
}

#[test]
fn a_furnace_reads_what_its_walls_add_up_to() {
    // No disc reaches an edge of the room.
    let furnace = gallery::load("furnace").unwrap().sized([8; 2]);
    let expected = |depth: u32| 2.0 * (1.0 - 0.5_f64.powi(depth as i32));
    for depth in [1, 2, 3, 5, 24] {
        let ours = mean(&furnace, &fixed(depth, 0.08, 1 << 14), 4, 12);
        if depth <= 2 {
            // Light straight from the walls is found by aiming, with some noise.
            assert!((ours.0 / expected(depth) - 1.0).abs() < 0.02, "{ours:?}");
            continue;
        }
        alike("furnace", ours, (expected(depth), 0.0), 0.04);
        if depth < 6 {
            unlike("a bounce too few", ours, (expected(depth - 1), 0.0));
        }
    }
    // Discs that reach beyond walls lack what is not there, and lack less as they shrink.
    let lacks = |radius| 2.0 - mean(&furnace, &fixed(24, radius, 1 << 12), 4, 12).0;
    let [wide, half] = [1.0, 0.5].map(lacks);
    println!("lacks {wide:.3} and {half:.3}");
    assert!(wide > 0.08 && half < 0.7 * wide);
}
