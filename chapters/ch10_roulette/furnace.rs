//! What the furnace reads: cut, by roulette, clamped.

use crate::survival::Game;
use halfdisk::integrators::Kajiya;
use halfdisk::lab::chapter::{Desk, Number};
use halfdisk::lab::estimators::worlds::Furnace;
use halfdisk::sampling::stream::Stream;
use halfdisk::space::Flat;
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::Largest;
use rayon::prelude::*;

/// The albedo of this chapter's furnace.
pub const ALBEDO: f64 = 0.8;
/// Chances to survive, in percent; the first lies below the wall of 64.
pub const PERCENT: [u32; 5] = [50, 65, 80, 90, 95];
/// Walks that survive fewer surfaces than this are common at every chance above.
const COMMON: u32 = 12;

/// A game of this chapter.
pub fn game(percent: u32) -> Game {
    Game {
        albedo: ALBEDO,
        survival: f64::from(percent) / 100.0,
    }
}

/// The share of the light that a depth cut loses.
pub fn cuts(desk: &mut Desk) {
    for (percent, bounces) in [(50, 2), (50, 5), (80, 5), (80, 20), (90, 8), (90, 43)] {
        let albedo = f64::from(percent) / 100.0;
        let cut = Kajiya {
            max_depth: bounces + 1,
        };
        let mut room = Furnace {
            albedo: albedo as f32,
        };
        let stream = Stream::new(desk.options.seed, 0, 0);
        let read = cut.walk::<Flat>(&mut room, &Furnace::eye(), &stream).r;
        let lost = 100.0 * (1.0 - f64::from(read) * (1.0 - albedo));
        let says = format!("albedo {albedo}, {bounces} bounces: light lost");
        // The rest is the rounding of transport in `f32`.
        let number = Number::new(&says, (lost * 1e4).round() / 1e4)
            .exact(100.0 * albedo.powi(bounces as i32 + 1))
            .unit("%");
        desk.number(&format!("lost_{percent}_{bounces}"), number);
    }
}

/// What roulette was found to be.
pub struct Played {
    /// Rays traced.
    pub rays: u64,
    /// How far the means that have a variance are from their truths.
    pub compared: Largest,
    /// Chance to survive, variance times rays over the squared mean, its error; where it has one.
    pub prices: Vec<(f64, f64, f64)>,
}

/// Mean and variance of roulette.
pub fn survivals(desk: &mut Desk) -> Played {
    let (walks, seed) = (desk.choose(120_000, 60_000), desk.options.seed);
    let played: Vec<_> = PERCENT
        .into_par_iter()
        .map(|percent| {
            let game = game(percent);
            let mut found = [Estimate::new(); 3];
            let mut rays = 0;
            for i in 0..walks {
                let (value, segments) = game.walk(&Stream::new(seed, i, percent));
                rays += segments;
                found[0].add(value);
                found[1].add((value - game.mean()).powi(2));
                let common = segments <= u64::from(COMMON);
                found[2].add(if common { value * value } else { 0.0 });
            }
            (percent, found, rays)
        })
        .collect();
    let mut compared = Largest::default();
    let mut prices = Vec::new();
    for (percent, [mean, square, common], rays) in &played {
        let game = game(*percent);
        let says = |what: &str| format!("survival {}: {what}", game.survival);
        let known = game.variance().is_finite();
        desk.estimate(
            &format!("mean_{percent}"),
            &says("mean"),
            mean,
            Some(game.mean()),
        );
        let variance = Number::new(&says("variance"), square.mean());
        let variance = Number {
            error: game.settles().then(|| square.std_error()),
            exact: known.then(|| game.variance()),
            ..variance
        };
        desk.number(&format!("variance_{percent}"), variance);
        let exact = game.mean_of(COMMON, |s| s * s);
        let says_common = says("mean square of walks of at most 12 segments");
        desk.estimate(
            &format!("common_{percent}"),
            &says_common,
            common,
            Some(exact),
        );
        let per_walk = *rays as f64 / f64::from(walks);
        if game.settles() {
            let scale = per_walk / (game.mean() * game.mean());
            let price = (
                game.survival,
                scale * square.mean(),
                scale * square.std_error(),
            );
            prices.push(price);
        }
        let segments = Number::new(&says("segments of a walk"), per_walk);
        desk.number(&format!("segments_{percent}"), segments.exact(game.rays()));
        if known {
            desk.value(
                &format!("price_{percent}"),
                &says("variance times segments"),
                game.price(),
            );
            compared.add(mean.z(game.mean()));
        }
    }
    Played {
        rays: played.iter().map(|p| p.2).sum(),
        compared,
        prices,
    }
}

/// What is left of the mean where no walk may be worth more than a bound.
pub fn clamps(desk: &mut Desk) {
    let (walks, game) = (desk.choose(80_000, 50_000), game(65));
    for most in [10.0, 30.0, 100.0] {
        let one = |i| {
            game.walk(&Stream::new(desk.options.seed, i, 300))
                .0
                .min(most)
        };
        let read: Estimate = (0..walks).map(one).collect();
        let says = format!("survival 0.65, no walk above {most}: mean");
        desk.estimate(
            &format!("clamp_{most}"),
            &says,
            &read,
            Some(game.clamped(most)),
        );
        let lost = 100.0 * (1.0 - game.clamped(most) / game.mean());
        let number = Number::new("  light lost by that", lost).unit("%");
        desk.number(&format!("clamp_lost_{most}"), number);
        desk.value(
            &format!("clamp_variance_{most}"),
            "  its variance",
            read.variance(),
        );
    }
}

/// How many walks an error of one percent takes, and whether it does.
pub fn needed(desk: &mut Desk) {
    let game = game(90);
    let target = 0.01 * game.mean();
    let walks = (game.variance() / (target * target)).round();
    desk.value("needed", "survival 0.9: walks for an error of 1 %", walks);
    let runs = desk.choose(250, 120);
    let seed = desk.options.seed;
    let squares: Vec<f64> = (0..runs)
        .into_par_iter()
        .map(|run| {
            let one = |i| game.walk(&Stream::new(seed, i, 1000 + run)).0;
            let mean: Estimate = (0..walks as u32).map(one).collect();
            (mean.mean() / game.mean() - 1.0).powi(2)
        })
        .collect();
    let squares: Estimate = squares.into_iter().collect();
    let reached = 100.0 * squares.mean().sqrt();
    let number = Number {
        error: Some(reached * 0.5 * squares.std_error() / squares.mean()),
        ..Number::new("error of so many walks, over many runs", reached)
    };
    desk.number("reached", number.exact(1.0).unit("%"));
}
