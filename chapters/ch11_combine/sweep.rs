//! One lamp of many sizes, found in four ways.

use halfdisk::integrators::world::FlatTracer;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::estimators::overhead::{Aim, Overhead, Technique};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::Largest;
use rayon::prelude::*;

/// Half the angles at which the lamp is seen, in hundredths of a radian.
const HUNDREDTHS: [u32; 12] = [1, 2, 5, 10, 20, 30, 50, 70, 90, 110, 130, 150];

/// Names and techniques, in the order of the curves.
pub const WAYS: [(&str, Technique); 4] = [
    ("chance", Technique::Chance),
    ("aiming", Technique::Aiming),
    ("balance", Technique::Both(Heuristic::Balance)),
    ("power", Technique::Both(Heuristic::Power)),
];

/// What was found under a lamp of one size.
pub struct Size {
    /// The lamp.
    pub lamp: Overhead,
    /// Mean of each technique's walks.
    pub means: [Estimate; 4],
    /// Mean squared distance from the truth: the variance of one walk.
    pub squares: [Estimate; 4],
    rays: u64,
}

/// All sizes, and what is worth saying about them.
pub struct Sweep {
    /// From small to large.
    pub sizes: Vec<Size>,
    /// Rays traced.
    pub rays: u64,
    /// How far the means are from their truths.
    pub compared: Largest,
    /// Variance by the balance heuristic under the lamp of half angle 1.1.
    pub at_one: f64,
    /// How far the balance heuristic lies above the better technique at compared, in squared means.
    pub premium: f64,
    /// How far the worse technique lies above the better one at compared, in squared means.
    pub stake: f64,
}

/// Runs all of it and records what it found.
pub fn work(desk: &mut Desk) -> Result<Sweep, DeskError> {
    let (walks, seed) = (desk.choose(24_000, 12_000), desk.options.seed);
    let sizes: Vec<Size> = HUNDREDTHS
        .into_par_iter()
        .map(|hundredths| size(hundredths, walks, seed))
        .collect::<Result<_, DeskError>>()?;
    let mut sweep = Sweep {
        rays: sizes.iter().map(|s| s.rays).sum(),
        compared: Largest::default(),
        at_one: 0.0,
        premium: 0.0,
        stake: 0.0,
        sizes,
    };
    for (size, hundredths) in sweep.sizes.iter().zip(HUNDREDTHS) {
        let Size {
            lamp,
            means,
            squares,
            ..
        } = size;
        let mu2 = lamp.mean() * lamp.mean();
        for (i, (name, technique)) in WAYS.into_iter().enumerate() {
            let says = format!("half angle {}: variance, {name}", lamp.half_angle);
            let number = format!("variance_{name}_{hundredths}");
            desk.estimate(&number, &says, &squares[i], Some(lamp.variance(technique)));
            sweep.compared.add(means[i].z(lamp.mean()));
        }
        let [chance, aiming, balance, _] = WAYS.map(|(_, t)| lamp.variance(t));
        let best = chance.min(aiming);
        sweep.premium = sweep.premium.max((balance - best) / mu2);
        sweep.stake = sweep.stake.max((chance.max(aiming) - best) / mu2);
        let says = format!("half angle {}: the bound", lamp.half_angle);
        desk.value(&format!("bound_{hundredths}"), &says, lamp.bound());
        if hundredths == 110 {
            sweep.at_one = squares[2].mean();
        }
    }
    let says = "largest |z| of the means of all techniques and sizes";
    desk.value("largest_z", says, to(100.0, sweep.compared.z));
    let says = "balance heuristic above the better technique, squared means";
    desk.number("premium", Number::new(says, to(1000.0, sweep.premium)));
    let says = "worse technique above the better one, squared means";
    desk.number("stake", Number::new(says, to(10.0, sweep.stake)));
    Ok(sweep)
}

/// Rounded to one part in so many: more digits would say nothing.
pub fn to(parts: f64, x: f64) -> f64 {
    (parts * x).round() / parts
}

// ANCHOR: size
fn size(hundredths: u32, walks: u32, seed: u64) -> Result<Size, DeskError> {
    let lamp = Overhead::new(f64::from(hundredths) / 100.0);
    let world = lamp.world(1)?;
    let mut walk = FlatTracer::new(&world);
    let mut means = [Estimate::new(); 4];
    let mut squares = [Estimate::new(); 4];
    for i in 0..walks {
        let stream = Stream::new(seed, i, hundredths);
        for (k, (_, technique)) in WAYS.into_iter().enumerate() {
            let found = technique.walk(&mut walk, &stream);
            means[k].add(found);
            squares[k].add((found - lamp.mean()).powi(2));
        }
    }
    // ANCHOR_END: size
    let rays = walk.rays;
    Ok(Size {
        lamp,
        means,
        squares,
        rays,
    })
}

/// The same where points of the lamp are drawn by its length, without rays.
pub fn by_length(desk: &mut Desk) {
    let samples = desk.choose(200_000, 50_000);
    for hundredths in [3, 100, 150] {
        let lamp = Overhead {
            half_angle: f64::from(hundredths) / 100.0,
            aim: Aim::Length,
        };
        let mut squares = [Estimate::new(); 3];
        for i in 0..samples {
            let stream = Stream::new(desk.options.seed, i, 1000 + hundredths);
            let u = stream.at(0, Purpose::Integrand).two().map(f64::from);
            for (square, (_, technique)) in squares.iter_mut().zip(WAYS) {
                square.add((lamp.estimate(technique, u) - lamp.mean()).powi(2));
            }
        }
        for (square, (name, technique)) in squares.iter().zip(WAYS) {
            let says = format!("half angle {}, by length: {name}", lamp.half_angle);
            let number = format!("length_{name}_{hundredths}");
            desk.estimate(&number, &says, square, Some(lamp.variance(technique)));
        }
    }
}
