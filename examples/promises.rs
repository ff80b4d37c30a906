//! Are the promised errors kept? Renders scenes to several target errors, and measures how far each
//! picture is from a reference with other random numbers and many more samples.
//!
//! ```sh
//! cargo run --release --example promises -- --size 64 cornell spheres gloss lens caustic
//! ```

use clap::Parser;
use halfdisk::integrators::Path;
use halfdisk::render::accuracy::{Accuracy, Measure, true_error};
use halfdisk::render::target::{Goal, render_to};
use halfdisk::render::{Options, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::gallery;
use std::error::Error;

#[derive(Parser)]
struct Arguments {
    /// Scenes of the gallery
    #[arg(default_values = ["cornell", "spheres", "gloss", "lens", "caustic"])]
    scenes: Vec<String>,
    /// Target errors in percent, the largest first
    #[arg(long, value_delimiter = ',', default_values_t = [5.0, 2.0, 1.0])]
    targets: Vec<f64>,
    /// Side of the pictures in pixels
    #[arg(long, default_value_t = 64)]
    size: i64,
    /// Samples of the reference for each of the longest render's
    #[arg(long, default_value_t = 100)]
    ratio: u32,
    /// Seed of the first picture
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    println!(
        "{:9} {:>6} {:>8} {:>9} {:>7} {:>9} {:>9} {:>15} {:>6} {:>5}",
        "scene",
        "target",
        "reached",
        "true",
        "/target",
        "spp",
        "pilot spp",
        "s said, taken",
        "ratio",
        "longer"
    );
    let (mut kept, mut late, mut worst, mut all) = (0, 0, 0.0_f64, 0);
    for name in &arguments.scenes {
        let scene = gallery::load_with(name, |said| said.film.size = [arguments.size; 2])?;
        let path = Path::new(scene.suggested.max_depth);
        let options = Options {
            seed: arguments.seed,
            sampler: Sampler::Sobol,
            ..Options::default()
        };
        let goals = arguments.targets.iter().map(|percent| Goal {
            error: Some(percent / 100.0),
            ..Goal::default()
        });
        let outcomes: Vec<_> = goals
            .map(|goal| (goal, render_to(&scene, &path, &options, &goal, &())))
            .collect();

        let longest = outcomes.iter().map(|(_, o)| o.reached.spp).max();
        let options = Options {
            seed: arguments.seed ^ 0x5eed_0000,
            spp: longest.unwrap_or(1).saturating_mul(arguments.ratio),
            ..options
        };
        let reference = render(&scene, &path, &options, &()).film;
        let own = Accuracy::of(&reference).error(Measure::RootMeanSquare);
        for (goal, outcome) in outcomes {
            let target = goal.error.ok_or("a target")?;
            let picture = outcome.rendered.film.picture();
            let apart = true_error(&picture, &reference.picture(), Measure::RootMeanSquare);
            // The reference is not the truth either; its error is independent of the picture's.
            let error = (apart * apart - own * own).max(0.0).sqrt();
            let said = outcome.prediction.ok_or("a prediction")?;
            let ratio = outcome.reached.seconds / said.seconds;
            println!(
                "{name:9} {:5.1} % {:6.2} % {:7.3} % {:>7.3} {:9} {:9} {:7.2} {:7.2} {:6.2} {:5}",
                100.0 * target,
                100.0 * outcome.reached.error,
                100.0 * error,
                error / target,
                outcome.reached.spp,
                said.pilot.spp,
                said.seconds,
                outcome.reached.seconds,
                ratio,
                outcome.extensions
            );
            all += 1;
            kept += u32::from((error / target - 1.0).abs() <= 0.1);
            late += u32::from((ratio - 1.0).abs() > 0.25);
            worst = worst.max(error / target);
        }
    }
    println!(
        "\n{kept} of {all} within 10 % of their target, the worst at {worst:.3} times; {late} took more \
         than 25 % longer or shorter than they said"
    );
    Ok(())
}
