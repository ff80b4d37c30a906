//! What samples take away from the error of a point, and what they leave.

use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Path, Radiosity};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Curve, Style};
use halfdisk::lab::estimators::walks;
use halfdisk::lab::experiment::convergence::{
    Convergence, Design, Estimator, Size, Sizes, converge,
};
use halfdisk::lab::figures::variance_chart;
use halfdisk::radiosity::PatchSize;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer, gallery};

/// Segments of the longest path.
const SEGMENTS: u32 = 40;
/// So few patches that their error can be seen beside the noise.
const PATCHES: usize = 60;

/// The mean of many samples along one ray, compared with the truth.
fn many(
    scene: &Scene,
    ray: &Ray,
    by: &dyn Integrator,
    name: &'static str,
    truth: f64,
    design: &Design,
) -> Convergence {
    let estimator = Estimator {
        name,
        about: "",
        truth,
        rays_per_sample: 1,
        sizes: Sizes::Doublings,
        run: |n: u32, seed: u64| {
            let mut tracer = Tracer::new(scene);
            let mut one = |i| f64::from(by.li(&mut tracer, ray, &Stream::new(seed, i, 0)).r);
            (0..n).map(&mut one).sum::<f64>() / f64::from(n)
        },
    };
    converge(&estimator, design)
}

/// A point of the ceiling of the box, by paths and by few patches; the rays of the longest runs.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    desk.say("\na point of the ceiling of the box");
    let scene = gallery::load("cornell")?;
    // No lamp shines at the ceiling, so all of its light is indirect.
    let ray = scene.camera.ray(0.3, 0.1);
    let path = Path::new(SEGMENTS);
    let patches = Radiosity::new(&scene, SEGMENTS, PatchSize::Number(PATCHES), &())?;
    let number = patches.solution().effort.patches as f64;
    desk.value("few_patches", "patches", number);
    let (count, seed) = (desk.choose(150_000, 60_000), desk.options.seed);
    let by_paths = walks::solid(&scene, &ray, &path, 0.0, count, seed);
    let by_patches = walks::solid(&scene, &ray, &patches, 0.0, count, seed + 1);
    let [truth, read] = [&by_paths, &by_patches].map(|found| found.estimate);
    desk.estimate("point_path", "radiance by paths", &truth, None);
    desk.estimate("point_patches", "radiance by patches", &read, None);
    let off = Number {
        error: Some(100.0 * truth.std_error().hypot(read.std_error()) / truth.mean()),
        ..Number::new(
            "difference, of the radiance",
            100.0 * (read.mean() / truth.mean() - 1.0),
        )
    };
    desk.number("point_off", off.unit("%"));

    let design = Design {
        replicates: 64,
        doublings: desk.choose(9, 8),
        first: 4,
        seed,
    };
    let runs = [
        (&path as &dyn Integrator, "path", &truth),
        (&patches, "radiosity", &read),
    ];
    let runs = runs.map(|(by, name, known)| {
        let run = many(&scene, &ray, by, name, truth.mean(), &design);
        (run, Some(known.variance()))
    });
    let squares = |run: &Convergence| -> Vec<(f64, f64, f64)> {
        let of = |s: &Size| {
            let square = s.rmse * s.rmse;
            (f64::from(s.samples), square, 2.0 * s.rmse * s.rmse_error)
        };
        run.sizes.iter().map(of).collect()
    };
    let squared = squares(&runs[1].0);
    let bias = (read.mean() - truth.mean()).powi(2);
    let level = [squared.first(), squared.last()];
    let level: Vec<(f64, f64)> = level
        .into_iter()
        .flatten()
        .map(|(n, ..)| (*n, bias))
        .collect();
    let mut chart = variance_chart("A point of the ceiling", &runs);
    chart.y_label = "variance, or squared error, of the mean".to_owned();
    let marks = Curve::measured("radiosity, squared error", Style::MarksAndLine, squared);
    chart.curves.push(marks.coloured(2));
    chart
        .curves
        .push(Curve::new("squared bias", Style::Dashed, level).coloured(2));
    let caption = format!(
        "The variances of both follow σ²/N, dashed. With {number} patches the squared error of radiosity does not: it \
         levels out at the squared bias, which the patches leave and no sample takes away."
    );
    desk.figure("levels.svg", &caption, chart.to_svg()?)?;
    Ok(by_paths.rays + by_patches.rays)
}
