//! The Cornell box by walks of several kinds, and how long they are.

use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Kajiya, Roulette, Survival};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, HeatMap};
use halfdisk::render::{Options, Pixel, Rendered, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer, gallery};

/// The rays of a walk, in place of its light.
struct Segments(Roulette);

impl Integrator for Segments {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let before = tracer.counts().total();
        Integrator::li(&self.0, tracer, ray, stream);
        Rgb::grey((tracer.counts().total() - before) as f32)
    }
}

/// What the pictures cost, and what they gained.
pub struct Found {
    /// Rays traced.
    pub rays: u64,
    /// Certainty per ray of survival by throughput over the best constant.
    pub gain: f64,
}

/// Paints the box in all ways.
pub fn work(desk: &mut Desk) -> Result<Found, DeskError> {
    let side = desk.choose(32, 24);
    let scene = gallery::load("cornell")?.sized([side; 2]);
    let by_throughput = Roulette {
        survival: Survival::Throughput(0.05),
    };
    let constant = |q| Roulette {
        survival: Survival::Constant(q),
    };
    let painted = [
        (
            "throughput",
            "by what it carries",
            paint(desk, &scene, &by_throughput)?,
        ),
        ("90", "0.9", paint(desk, &scene, &constant(0.9))?),
        ("80", "0.8", paint(desk, &scene, &constant(0.8))?),
        ("70", "0.7", paint(desk, &scene, &constant(0.7))?),
        ("50", "0.5", paint(desk, &scene, &constant(0.5))?),
        (
            "cut_100",
            "1, cut at 100 segments",
            paint(desk, &scene, &Kajiya { max_depth: 100 })?,
        ),
        (
            "cut_4",
            "1, cut at 4 segments",
            paint(desk, &scene, &Kajiya { max_depth: 4 })?,
        ),
    ];
    let mut rays = 0;
    let mut prices = Vec::new();
    for (name, says, rendered) in &painted {
        let per_walk = rendered.rays.total() as f64 / rendered.rays.camera as f64;
        let variance = rendered.film.sample_variance();
        let (mean, error) = rendered.film.mean();
        let number = Number::new(&format!("the box, survival {says}: mean"), mean);
        let error = Some(error);
        desk.number(&format!("box_{name}"), Number { error, ..number });
        for (what, text, value) in [
            ("variance", "variance", variance),
            ("segments", "segments of a walk", per_walk),
            ("price", "variance times segments", variance * per_walk),
        ] {
            desk.value(&format!("box_{what}_{name}"), &format!("  {text}"), value);
        }
        // Seconds differ from run to run: they are shown, and kept nowhere.
        let seconds = rendered.time.as_secs_f64() / rendered.rays.camera as f64;
        desk.say(&format!(
            "  variance times microseconds: {:.3}",
            1e6 * seconds * variance
        ));
        prices.push(variance * per_walk);
        rays += rendered.rays.total();
    }
    let best = prices[1..5].iter().copied().fold(f64::INFINITY, f64::min);
    let gain = best / prices[0];
    desk.value(
        "box_gain",
        "the box: certainty per ray over the best constant",
        gain,
    );
    rays += heat_map(desk, by_throughput)?;
    Ok(Found { rays, gain })
}

/// How long walks are, pixel by pixel.
fn heat_map(desk: &mut Desk, roulette: Roulette) -> Result<u64, DeskError> {
    let side = desk.choose(96, 48);
    let scene = gallery::load("cornell")?.sized([side; 2]);
    let lengths = paint(desk, &scene, &Segments(roulette))?;
    let hottest = lengths.film.max();
    let mean_of = |pixel: &Pixel| pixel.channels[0].mean();
    let map = HeatMap {
        title: "Segments of a walk".to_owned(),
        label: "segments, mean".to_owned(),
        width: lengths.film.width(),
        values: lengths.film.pixels().iter().map(mean_of).collect(),
        axis: Axis::Linear,
    };
    let caption = "Mean number of segments of a walk, pixel by pixel: one where it ends at once (the lamp, and \
                   what lies outside), three and more on the white walls and blocks.";
    desk.figure("depths.svg", caption, map.to_svg_at(432)?)?;
    let (mean, error) = lengths.film.mean();
    let number = Number::new("segments of a walk, mean over the picture", mean);
    let error = Some(error);
    desk.number("depths_mean", Number { error, ..number });
    desk.value(
        "depths_most",
        "mean segments of a walk, in the pixel where they are longest",
        hottest,
    );
    Ok(lengths.rays.total())
}

fn paint(desk: &Desk, scene: &Scene, by: &impl Integrator) -> Result<Rendered, DeskError> {
    let options = Options {
        spp: desk.spp(96, 32),
        seed: desk.options.seed,
        ..Options::default()
    };
    let rendered = render(scene, by, &options, &desk.bar("box"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
