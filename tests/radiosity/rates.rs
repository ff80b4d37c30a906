//! How fast errors fall: with patches, with sweeps, with shots.

use super::rooms::{CENTRE, MEAN, floor_mean, gathered, system};
use super::{cube, worst};
use glam::DVec3;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Kajiya};
use halfdisk::radiosity::{Channels, Patch};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Tracer;
use halfdisk::stats::Estimate;
use halfdisk::stats::slope::fit;

/// The radiance of a point of the floor by the patch it is in.
fn constant(patches: &[Patch], radiance: &[Channels], p: DVec3) -> f64 {
    let holds = |patch: &&Patch| {
        let low = patch
            .polygon
            .iter()
            .copied()
            .reduce(DVec3::min)
            .expect("corners");
        let high = patch
            .polygon
            .iter()
            .copied()
            .reduce(DVec3::max)
            .expect("corners");
        patch.normal.y > 0.5 && p.x >= low.x && p.x <= high.x && p.z >= low.z && p.z <= high.z
    };
    let found = patches
        .iter()
        .position(|patch| holds(&patch))
        .expect("a patch");
    radiance[found][0]
}

#[test]
fn s0_24_errors_fall_with_the_patches() {
    let rooms: Vec<(Vec<Patch>, Vec<Channels>)> = [2, 4, 8, 16]
        .map(|n| {
            let patches = cube(n);
            let radiance = system(&patches).gauss_seidel(1e-10).radiance;
            (patches, radiance)
        })
        .into();
    let (finest, truth) = &rooms[3];
    let [mut constants, mut gathers, mut paid] = [Vec::new(), Vec::new(), Vec::new()];
    for replicate in 0..8 {
        let [mut by_constant, mut by_gather] = [[0.0; 3]; 2];
        for i in 0..64 {
            let [u, v] = Stream::new(26, replicate, i)
                .at(0, Purpose::Integrand)
                .two();
            let p = DVec3::new(f64::from(u) - 0.5, 0.0, f64::from(v) - 0.55);
            let exact = gathered(finest, truth, p);
            for (k, (patches, radiance)) in rooms.iter().take(3).enumerate() {
                by_constant[k] += (constant(patches, radiance, p) - exact).powi(2) / 64.0;
                by_gather[k] += (gathered(patches, radiance, p) - exact).powi(2) / 64.0;
            }
        }
        constants.push(by_constant.to_vec());
        gathers.push(by_gather.to_vec());
        paid.push(vec![24.0, 96.0, 384.0]);
    }
    let constant = fit(&paid, &constants).expect("a slope");
    let gather = fit(&paid, &gathers).expect("a slope");
    let means: Vec<f64> = rooms.iter().map(|(p, r)| floor_mean(p, r)).collect();
    let steps: Vec<f64> = means.windows(2).map(|w| (w[1] - w[0]).abs()).collect();
    println!("against patches: constant {constant}, gathered {gather}; means differ by {steps:?}");
    // First order in the size of patches, which is one over the root of their number.
    assert!((constant.line.slope + 0.5).abs() < 0.1, "{constant}");
    // Second order: half-derived, half-measured between 1 and 1.5 in the number.
    assert!((-1.5..=-0.85).contains(&gather.line.slope), "{gather}");
    // The mean converges twice as fast as its values: quarters from step to step.
    assert!(
        steps[1] / steps[2] > 3.0 && steps[0] / steps[1] > 3.0,
        "{steps:?}"
    );
    assert!((means[3] - MEAN).abs() < 2e-4, "{means:?}");
    assert!((gathered(finest, truth, DVec3::new(0.0, 0.0, -0.05)) - CENTRE).abs() < 1e-4);
}

#[test]
fn jacobi_shrinks_by_the_largest_albedo() {
    let patches = cube(4);
    let mut system = system(&patches);
    for (i, albedo) in system.albedo.iter_mut().enumerate() {
        *albedo = [0.2 + 0.6 * (i % 7) as f64 / 6.0; 3];
    }
    let exact = system.gauss_seidel(1e-16).radiance;
    let errors: Vec<f64> = (0..20).map(|k| worst(&system.jacobi(k), &exact)).collect();
    let ratios: Vec<f64> = errors.windows(2).map(|w| w[1] / w[0]).collect();
    let largest = ratios.iter().copied().fold(0.0, f64::max);
    println!("Jacobi's error shrinks by {largest:.4} at worst; the largest albedo is 0.8");
    assert!(largest <= 0.8 + 1e-9, "{ratios:?}");
    assert!(largest > 0.4, "no miracle: {ratios:?}");
    assert!(system.gauss_seidel(1e-12).sweeps < 40);
}

#[test]
fn a_sweep_of_jacobi_is_a_bounce_of_paths() {
    let patches = cube(8);
    let system = system(&patches);
    let scene = super::scene(super::CUBE);
    let floor = f64::from(patches[0].polygon[0].y as f32);
    for bounces in 1..=4 {
        let read = floor_mean(&patches, &system.jacobi(bounces));
        // Looking down at random points of the floor; an eye's ray and one for each bounce.
        let path = Kajiya {
            max_depth: bounces + 1,
        };
        let mut estimate = Estimate::new();
        let mut tracer = Tracer::new(&scene);
        for i in 0..40_000 {
            let stream = Stream::new(27, bounces, i);
            let [u, v] = stream.at(9, Purpose::Integrand).two();
            let from = glam::Vec3::new(u - 0.5, floor as f32 + 1e-3, v - 0.55);
            let ray = Ray::new(from, glam::Vec3::NEG_Y);
            estimate.add(f64::from(path.li(&mut tracer, &ray, &stream).g));
        }
        let off = |read: f64| (read - estimate.mean()).abs();
        // The mean's own error on this mesh is below 0.1 %.
        let noise = 4.0 * estimate.std_error() + 1e-3 * read;
        println!(
            "{bounces} bounces: patches {read:.5}, paths {:.5} ± {:.5}",
            estimate.mean(),
            estimate.std_error()
        );
        assert!(off(read) < noise, "{bounces}: {read} {}", estimate.mean());
        // The mistake: one sweep more or less.
        let less = floor_mean(&patches, &system.jacobi(bounces - 1));
        assert!(off(less) > noise, "{bounces}: {less}");
    }
}

#[test]
fn the_brightest_shoots_first() {
    let patches = cube(4);
    let system = system(&patches);
    let areas: Vec<f64> = patches.iter().map(|patch| patch.area).collect();
    let exact = system.gauss_seidel(1e-14).radiance;
    let (early, left) = system.southwell(&areas, patches.len());
    assert!(
        left.windows(2).all(|w| w[1] <= w[0]),
        "unshot power never grows"
    );
    let jacobi = worst(&system.jacobi(1), &exact);
    println!(
        "after as many shots as patches {:.3} of the power is unshot, the worst error is {:.3}; after one sweep of \
         Jacobi it is {jacobi:.3}",
        left[left.len() - 1],
        worst(&early, &exact)
    );
    assert!(worst(&early, &exact) < 0.8 * jacobi);
}
