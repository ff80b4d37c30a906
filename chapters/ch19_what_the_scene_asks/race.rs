//! Every integrator of the book on the final scene: error against rays and seconds.

use crate::savings::two_digits;
use crate::{FINAL, load};
use halfdisk::integrators::{self, Kajiya, Path, Settings, WALKS, Whitted};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, HALF, Style};
use halfdisk::lab::experiment::cost::Reference;
use halfdisk::render::{Options, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::Scene;
use halfdisk::stats::Estimate;

/// Samples per pixel.
const SIZES: [u32; 4] = [1, 4, 16, 64];

/// What the race cost, and its result.
pub struct Race {
    /// Rays traced.
    pub rays: u64,
    /// Rays for the same error of `kajiya`, over those of `path`.
    pub gain: f64,
}

/// One integrator at one size.
#[derive(Clone, Copy, Default)]
struct Entry {
    square: Estimate,
    rays: Estimate,
    seconds: Estimate,
}

/// Lets them run.
pub fn work(desk: &mut Desk) -> Result<Race, DeskError> {
    let scene = load(FINAL, desk.choose([32; 2], [12; 2]))?;
    let (truth, mut rays) = reference(desk, &scene)?;
    let sizes = desk.choose(4, 2);
    let mut entries = vec![[Entry::default(); SIZES.len()]; WALKS.len()];
    // In turns, so that what else the machine does is shared fairly.
    for replicate in 0..desk.choose(4, 3) {
        for (size, spp) in SIZES.into_iter().take(sizes).enumerate() {
            for (place, integrator) in WALKS.into_iter().enumerate() {
                let options = Options {
                    spp,
                    seed: desk.options.seed + 1000 * (1 + place as u64) + replicate,
                    ..Options::default()
                };
                let settings = Settings::new(scene.suggested.max_depth);
                let by = integrator.prepare(&scene, &settings)?;
                let rendered = render(&scene, &by, &options, &desk.bar(integrator.name));
                if rendered.interrupted {
                    return Err(DeskError::Interrupted);
                }
                let entry = &mut entries[place][size];
                let pixels = f64::from(scene.size[0]) * f64::from(scene.size[1]);
                let squares: Estimate = truth.squares(&rendered.film).into_iter().collect();
                entry.square.add(squares.mean());
                entry.rays.add(rendered.rays.total() as f64 / pixels);
                entry.seconds.add(rendered.time.as_secs_f64());
                rays += rendered.rays.total();
            }
        }
    }
    let path = &entries[WALKS.len() - 1][sizes - 1];
    let paid = |entry: &Entry| entry.square.mean() * entry.rays.mean();
    let mut gain = 1.0;
    for (integrator, sizes_of) in WALKS.into_iter().zip(&entries) {
        let key = integrator.name.replace('-', "_");
        let largest = &sizes_of[sizes - 1];
        let [error, its_error] = root(&largest.square);
        let spp = SIZES[sizes - 1];
        let says = format!("{}: relative error with {spp} samples", integrator.name);
        let number = Number {
            error: Some(its_error),
            ..Number::new(&says, error)
        };
        desk.number(&format!("error_{key}"), number);
        let says = format!("{}: rays for each pixel", integrator.name);
        desk.value(
            &format!("race_rays_{key}"),
            &says,
            largest.rays.mean().round(),
        );
        // A bias stays, however much is paid.
        if integrator != Whitted::ENTRY {
            let ratio = paid(largest) / paid(path);
            let says = format!(
                "{}: rays for the same error, of those of path",
                integrator.name
            );
            desk.value(&format!("price_{key}"), &says, two_digits(ratio));
            let seconds = largest.square.mean() * largest.seconds.mean();
            let ratio = seconds / (path.square.mean() * path.seconds.mean());
            let says = format!(
                "{}: time for the same error, of that of path",
                integrator.name
            );
            desk.value(&format!("seconds_{key}"), &says, two_digits(ratio));
            if integrator == Kajiya::ENTRY {
                gain = paid(largest) / paid(path);
            }
        }
    }
    chart(desk, &entries, sizes)?;
    Ok(Race { rays, gain })
}

fn chart(desk: &mut Desk, entries: &[[Entry; SIZES.len()]], sizes: usize) -> Result<(), DeskError> {
    let curves = |cost: fn(&Entry) -> f64| {
        let curve = |(integrator, entries): (integrators::Entry, &[Entry; SIZES.len()])| {
            let points = entries[..sizes].iter().filter_map(|entry| {
                let [error, its_error] = root(&entry.square);
                (error > 0.0).then(|| (cost(entry), error, its_error))
            });
            Curve::measured(integrator.name, Style::MarksAndLine, points)
        };
        WALKS.into_iter().zip(entries).map(curve).collect()
    };
    let chart = |x_label: &str, curves| CurveChart {
        title: "Every integrator in the final room".to_owned(),
        x_label: x_label.to_owned(),
        y_label: "root of the mean squared relative error".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves,
    };
    let by_rays = chart("rays for each pixel", curves(|entry| entry.rays.mean()));
    let caption = "Error against rays. Whitted's tree comes to rest at what it leaves out.";
    desk.figure("chart.svg", caption, by_rays.to_svg_at(HALF)?)?;
    let by_time = chart("seconds", curves(|entry| entry.seconds.mean()));
    let caption = "Error against seconds, on the machine that ran this.";
    desk.figure("seconds.svg", caption, by_time.to_svg_at(HALF)?)
}

/// The root of a mean square and its standard error; none where noise of the truth makes the square
/// negative.
fn root(square: &Estimate) -> [f64; 2] {
    let error = square.mean().max(0.0).sqrt();
    [
        error,
        0.5 * square.std_error() / error.max(f64::MIN_POSITIVE),
    ]
}

/// Two pictures of many samples, whose noise is independent, and the rays they took.
fn reference(desk: &Desk, scene: &Scene) -> Result<(Reference, u64), DeskError> {
    let mut rays = 0;
    let spp = desk.choose(1024, 256);
    let mut half = |seed| {
        let options = Options {
            spp,
            seed,
            sampler: Sampler::Sobol,
            ..Options::default()
        };
        let path = Path::new(scene.suggested.max_depth);
        let rendered = render(scene, &path, &options, &desk.bar("truth"));
        rays += rendered.rays.total();
        if rendered.interrupted {
            return Err(DeskError::Interrupted);
        }
        Ok(rendered.film)
    };
    let seed = desk.options.seed;
    let [a, b] = [half(seed + 101)?, half(seed + 102)?];
    Ok((Reference::new(&a, &b, spp), rays))
}
