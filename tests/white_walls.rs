//! Rooms whose walls keep nearly all of the light: what a path is worth must not grow with its length.

use crate::checks::CRITICAL;
use halfdisk::integrators::{Integrator, Path};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Tracer, gallery};
use halfdisk::stats::Estimate;

/// Samples of the radiance in a room that glows with radiance 1 in all its points.
fn samples(material: &str, max_depth: u32, count: u32) -> Vec<f64> {
    let text = format!(
        "name = 'room'\ncamera = {{ from = [0.3, 0.1, 0], to = [0, 0, 1], fov = 40 }}\n\
         [materials.wall]\n{material}\n[[objects]]\nmaterial = 'wall'\nemits = 1\n\
         sphere = {{ center = [0, 0, 0], radius = 1, inward = true }}\n"
    );
    let source = Source {
        file: "room.toml",
        text: &text,
    };
    let scene = gallery::from_text(source, None, |_| {}).unwrap();
    let path = Path::from_eye(max_depth);
    let ray = scene.camera.ray(0.4, 0.6);
    let mut tracer = Tracer::new(&scene);
    let sample = |i| f64::from(path.li(&mut tracer, &ray, &Stream::new(4, i, 0)).g);
    (0..count).map(sample).collect()
}

#[test]
fn no_albedo_below_one_makes_the_variance_of_a_path_grow_without_bound() {
    for (material, albedo, max_depth, count) in [
        ("lambert.albedo = 0.9", 0.9_f64, 512, 20_000),
        ("lambert.albedo = 0.98", 0.98, 512, 20_000),
        ("lambert.albedo = 0.995", 0.995, 2000, 8000),
        ("lambert.albedo = [0.99, 0.98, 0.4]", 0.98, 512, 20_000),
        (
            "mixture = { kd = 0.6, ks = 0.38, kt = 0 }",
            0.98,
            512,
            20_000,
        ),
    ] {
        let samples = samples(material, max_depth, count);
        let exact = (1.0 - albedo.powi(max_depth as i32)) / (1.0 - albedo);
        let largest = samples.iter().copied().fold(0.0, f64::max);
        let mean: Estimate = samples.iter().copied().collect();
        let squares: Estimate = samples.iter().map(|x| (x / exact - 1.0).powi(2)).collect();
        println!("{material}: {mean:?} for {exact}, largest {largest}, variance {squares:?}");
        // The smallest bias that is seen is 5 %.
        assert!(mean.z(exact).abs() < CRITICAL, "{material}: {mean:?}");
        assert!(CRITICAL * mean.std_error() < 0.05 * exact, "{material}");
        // The length of a path is geometric: its variance is at most the square of its mean, and one
        // longer than thirty means does not happen. With a survival of at most 0.95 and an albedo of
        // 0.98 a path is worth 1.03 times as much with each segment.
        assert!(squares.mean() < 1.5, "{material}: {squares:?}");
        assert!(largest < 30.0 * exact, "{material}: {largest}");
    }
}
