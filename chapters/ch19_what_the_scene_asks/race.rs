//! Every integrator of the book on the room: error against rays and seconds.

use crate::{ROOM, load};
use halfdisk::integrators::{self, Kajiya, Path, Settings, WALKS, Whitted};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, HALF, Style};
use halfdisk::lab::experiment::cost::Reference;
use halfdisk::numeric::three_digits;
use halfdisk::render::{Options, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::Scene;
use halfdisk::stats::Estimate;
use halfdisk::stats::price::{Paid, ratio};

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
#[derive(Clone, Default)]
struct Entry {
    square: Estimate,
    rays: Estimate,
    seconds: Estimate,
    /// Squared error and rays of each replicate.
    by_rays: Vec<Paid>,
    /// Squared error and seconds of each replicate.
    by_seconds: Vec<Paid>,
}

/// Lets them run.
pub fn work(desk: &mut Desk) -> Result<Race, DeskError> {
    let scene = load(ROOM, desk.choose([16; 2], [12; 2]))?;
    let (truth, mut rays) = reference(desk, &scene)?;
    let sizes = desk.choose(4, 2);
    let mut entries = vec![vec![Entry::default(); SIZES.len()]; WALKS.len()];
    // In turns, so that what else the machine does is shared fairly.
    for replicate in 0..desk.choose(8, 3) {
        for (size, spp) in SIZES.into_iter().take(sizes).enumerate() {
            for (place, integrator) in WALKS.into_iter().enumerate() {
                let options = Options {
                    spp,
                    seed: desk.options.seed + 1000 * (1 + place as u64) + replicate,
                    // So that there is work for several threads.
                    tile: 4,
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
                let (square, each) = (squares.mean(), rendered.rays.total() as f64 / pixels);
                let seconds = rendered.time.as_secs_f64();
                entry.square.add(square);
                entry.rays.add(each);
                entry.seconds.add(seconds);
                entry.by_rays.push([square, each]);
                entry.by_seconds.push([square, seconds]);
                rays += rendered.rays.total();
            }
        }
    }
    let path = &entries[WALKS.len() - 1][sizes - 1];
    let mut gain = 1.0;
    for (integrator, sizes_of) in WALKS.into_iter().zip(&entries) {
        let name = integrator.name;
        let key = name.replace('-', "_");
        let largest = &sizes_of[sizes - 1];
        let [error, its_error] = root(&largest.square);
        let spp = SIZES[sizes - 1];
        let says = format!("{name}: relative error with {spp} samples");
        let number = Number {
            error: Some(its_error),
            ..Number::new(&says, error)
        };
        desk.number(&format!("error_{key}"), number);
        let rays_each = largest.rays.mean().round();
        desk.value(
            &format!("race_rays_{key}"),
            &format!("{name}: rays for each pixel"),
            rays_each,
        );
        // A bias stays, however much is paid; and path is what the others are compared with.
        if integrator == Whitted::ENTRY || integrator == Path::ENTRY {
            continue;
        }
        for (unit, first, ours, base) in [
            ("rays", "price", &largest.by_rays, &path.by_rays),
            ("time", "seconds", &largest.by_seconds, &path.by_seconds),
        ] {
            let found = ratio(ours, base);
            let found = found.ok_or(DeskError::Missing(format!("a price of {name}")))?;
            let says = format!("{name}: {unit} for the same error, relative to path");
            for (end, says, value) in [
                ("", says.as_str(), found.ratio),
                ("_low", "  its 95 % interval: from", found.low),
                ("_high", "  to", found.high),
            ] {
                desk.value(&format!("{first}_{key}{end}"), says, rounded(value));
            }
            if integrator == Kajiya::ENTRY && unit == "rays" {
                gain = found.ratio;
            }
        }
    }
    chart(desk, &entries, sizes)?;
    Ok(Race { rays, gain })
}

fn chart(desk: &mut Desk, entries: &[Vec<Entry>], sizes: usize) -> Result<(), DeskError> {
    let curves = |cost: fn(&Entry) -> f64| {
        let curve = |(integrator, entries): (integrators::Entry, &Vec<Entry>)| {
            let points = entries[..sizes].iter().filter_map(|entry| {
                let [error, its_error] = root(&entry.square);
                (error > 0.0).then(|| (cost(entry), error, its_error))
            });
            Curve::measured(integrator.name, Style::MarksAndLine, points)
        };
        WALKS.into_iter().zip(entries).map(curve).collect()
    };
    let chart = |x_label: &str, curves| CurveChart {
        title: "Every integrator in the room".to_owned(),
        x_label: x_label.to_owned(),
        y_label: "root of the mean squared relative error".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves,
    };
    let by_rays = chart("rays for each pixel", curves(|entry| entry.rays.mean()));
    let caption = "Relative error against rays for each pixel. Whitted's tree levels out at what it leaves out; all others \
                   fall with the slope -1/2, from different heights. Bars: one standard error.";
    desk.figure("chart.svg", caption, by_rays.to_svg_at(HALF)?)?;
    let by_time = chart("seconds", curves(|entry| entry.seconds.mean()));
    let caption = "The same against the seconds of one such picture, on the machine that ran this. The order is \
                   the same: rays tell most of the time. Bars: one standard error.";
    desk.figure("seconds.svg", caption, by_time.to_svg_at(HALF)?)
}

/// A ratio as it deserves: three digits at most.
fn rounded(x: f64) -> f64 {
    three_digits(x).parse().unwrap_or(x)
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
    let spp = desk.choose(192, 96);
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
