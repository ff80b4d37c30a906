//! Are the promised errors kept? Renders scenes to several target errors, and measures how far each
//! picture is from a reference with other random numbers and many more samples.
//!
//! ```sh
//! cargo run --release --example promises -- cornell lens motion six mesh
//! ```

use clap::Parser;
use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Bar, answer, on_ctrl_c, tell};
use halfdisk::render::accuracy::{Accuracy, Measure, true_error};
use halfdisk::render::stopping::{Goal, Outcome, Prediction, render_to};
use halfdisk::render::{Film, Options, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::{Scene, gallery};
use std::error::Error;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};

/// Are the errors and seconds that `halfdisk render --target-error` promises kept?
#[derive(Parser)]
struct Arguments {
    /// Scenes of the gallery
    #[arg(default_values = ["cornell", "lens", "motion", "six", "mesh"])]
    scenes: Vec<String>,
    /// Target errors in percent, above 0 and up to 100
    #[arg(long, value_delimiter = ',', value_parser = percent, default_values = ["5", "2", "1"])]
    targets: Vec<f64>,
    /// Side of the pictures in pixels
    #[arg(long, default_value_t = 128, value_parser = clap::value_parser!(u32).range(1..=4096))]
    size: u32,
    /// Samples of the reference for each of the longest render's
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..))]
    ratio: u32,
    /// Seed of the first picture
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

fn percent(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&x| x > 0.0 && x <= 100.0);
    number.ok_or_else(|| "a number above 0 and up to 100".to_owned())
}

/// A render, what it promised, and what is true of it.
struct Kept {
    target: f64,
    outcome: Outcome,
    said: Prediction,
    /// The relative error of the picture, by the reference.
    error: f64,
}

impl Kept {
    /// The true error in targets.
    fn error(&self) -> f64 {
        self.error / self.target
    }

    /// The seconds that it took in those that were said.
    fn seconds(&self) -> f64 {
        self.outcome.reached.seconds / self.said.seconds
    }

    fn row(&self, scene: &str) -> String {
        format!(
            "{scene:9} {:5.1} % {:6.2} % {:7.3} % {:7.3} {:9} {:9} {:7.2} {:7.2} {:6.2} {:6}",
            100.0 * self.target,
            100.0 * self.outcome.reached.error,
            100.0 * self.error,
            self.error(),
            self.outcome.reached.spp,
            self.said.pilot.spp,
            self.said.seconds,
            self.outcome.reached.seconds,
            self.seconds(),
            self.outcome.extensions
        )
    }
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            tell(format_args!("error: {e}"));
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let stop = on_ctrl_c();
    let mut all = Vec::new();
    answer(
        "scene     target  reached      true /target       spp pilot spp   s said, taken  ratio longer\n",
    )?;
    for name in &arguments.scenes {
        let scene = gallery::load(name)?.sized([arguments.size; 2]);
        for kept in promises(name, &scene, arguments, stop)? {
            answer(&format!("{}\n", kept.row(name)))?;
            all.push(kept);
        }
        if stop.load(Ordering::Relaxed) {
            break;
        }
    }
    if all.is_empty() {
        return Ok(());
    }
    let near = |ratio: f64, by: f64| (ratio - 1.0).abs() <= by;
    answer(&format!(
        "\nof {}, {} are within 10 % of their target, the worst at {:.3} times it; {} took within 25 % of \
         the seconds that they said\n",
        all.len(),
        all.iter().filter(|k| near(k.error(), 0.1)).count(),
        all.iter().map(Kept::error).fold(0.0, f64::max),
        all.iter().filter(|k| near(k.seconds(), 0.25)).count(),
    ))?;
    Ok(())
}

/// Renders a scene to each target, and judges the pictures by a reference; none where it is interrupted.
fn promises(
    name: &str,
    scene: &Scene,
    arguments: &Arguments,
    stop: &'static AtomicBool,
) -> Result<Vec<Kept>, Box<dyn Error>> {
    let path = Path::new(scene.suggested.max_depth);
    let options = Options {
        seed: arguments.seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let quiet = Bar::hidden(stop);
    let outcomes = arguments.targets.iter().map(|percent| {
        let error = Some(percent / 100.0);
        let goal = Goal {
            error,
            ..Goal::default()
        };
        render_to(scene, &path, &options, &goal, &quiet)
    });
    let outcomes: Vec<Outcome> = outcomes.collect();

    let longest = outcomes.iter().map(|o| o.reached.spp).max();
    let options = Options {
        seed: arguments.seed ^ 0x5eed_0000,
        spp: longest.unwrap_or(1).saturating_mul(arguments.ratio),
        ..options
    };
    let bar = Bar::new(&format!("reference of {name}"), stop);
    let reference = render(scene, &path, &options, &bar);
    if reference.interrupted {
        return Ok(Vec::new());
    }
    let judged = outcomes.into_iter().zip(&arguments.targets);
    judged
        .map(|(outcome, percent)| {
            Ok(Kept {
                target: percent / 100.0,
                error: error(&outcome.rendered.film, &reference.film),
                said: outcome.prediction.ok_or("a render was interrupted")?,
                outcome,
            })
        })
        .collect()
}

/// The relative error of a picture: what is between it and the reference, without the reference's own
/// error, which is independent of the picture's.
fn error(film: &Film, reference: &Film) -> f64 {
    let apart = true_error(
        &film.picture(),
        &reference.picture(),
        Measure::RootMeanSquare,
    );
    let own = Accuracy::of(reference).error(Measure::RootMeanSquare);
    (apart * apart - own * own).max(0.0).sqrt()
}
