//! Chapter 6, exercise 2: fewer directions at deeper surfaces.
//!
//! Each surface averages over however many directions it has, so the mean stays right: no bias.
//! What changes are the variance and the rays. The deep levels have the most rays and the least
//! light, so thinning them saves much and costs little.

#![allow(clippy::print_stdout)]

use glam::Vec3;
use halfdisk::integrators::world::World;
use halfdisk::lab::estimators::directions::{Drawn, Recipe};
use halfdisk::lab::estimators::worlds::{Counted, Plates};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::space::{Ray, Solid, Space};
use halfdisk::stats::Estimate;

/// Directions at surfaces of each depth.
type Plan = [u32; 3];

const PLATES: Plates = Plates {
    albedo: [0.8, 0.8],
    emission: [0.0, 1.0],
};

/// Light that a ray finds, with as many directions at each depth as the plan says.
fn li(
    world: &mut Counted<Plates>,
    ray: &Ray<Solid>,
    depth: usize,
    plan: &Plan,
    place: u64,
    stream: &Stream,
) -> f32 {
    let Some(hit) = World::<Solid>::intersect(world, ray, 1) else {
        return 0.0;
    };
    let Some(&count) = plan.get(depth) else {
        return hit.emission.r;
    };
    let frame = Solid::frame(hit.surface.n);
    let mut sum = 0.0;
    for index in 0..count {
        let place = place * 64 + u64::from(index) + 1;
        let mut numbers = stream.at(place, Purpose::Direction);
        let Drawn { w, pdf } = Recipe::Uniform.draw::<Solid>(index, count, &mut numbers);
        let next = hit.surface.spawn(Solid::to_world(&frame, w));
        sum += li(world, &next, depth + 1, plan, place, stream) * Solid::cos(w) / pdf;
    }
    hit.emission.r + hit.surface.albedo.r * Solid::LAMBERT * sum / count as f32
}

/// The radiance of the lower plate, and the rays of one estimate.
fn measure(plan: &Plan, runs: u32) -> (Estimate, f64) {
    let mut world = Counted::new(PLATES);
    let down = Ray::new(Vec3::new(0.0, 0.5, 0.0), Vec3::NEG_Y);
    let sample = |i| f64::from(li(&mut world, &down, 0, plan, 0, &Stream::new(7, i, 0)));
    let estimate = (0..runs).map(sample).collect();
    (estimate, world.rays as f64 / f64::from(runs))
}

fn main() {
    let truth = PLATES.radiance(3)[0];
    println!("truth {truth:.6}");
    for (name, plan) in [
        ("16, 16, 16", [16, 16, 16]),
        ("16, 8, 5", [16, 8, 5]),
        ("16, 1, 1", [16, 1, 1]),
    ] {
        let (estimate, rays) = measure(&plan, 2000);
        println!(
            "{name}: {:.6} ± {:.6}, {rays:.0} rays, variance x rays {:.3}",
            estimate.mean(),
            estimate.std_error(),
            estimate.variance() * rays
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_bias_fewer_rays_and_a_better_bargain() {
        let truth = PLATES.radiance(3)[0];
        let (full, full_rays) = measure(&[16, 16, 16], 2000);
        let (thin, thin_rays) = measure(&[16, 8, 5], 2000);
        for estimate in [full, thin] {
            assert!(estimate.z(truth).abs() <= 4.0, "{estimate:?} for {truth}");
            assert!(
                4.0 * estimate.std_error() < 0.02 * truth,
                "detects two percent"
            );
        }
        assert!(thin_rays < 0.3 * full_rays, "{thin_rays} of {full_rays}");
        assert!(thin.variance() * thin_rays < full.variance() * full_rays);
    }
}
