//! Chapter 10: Russian roulette in a furnace, on both sides of its wall.

use crate::of_chapters::survival::Game;
use crate::within;
use halfdisk::sampling::stream::Stream;
use halfdisk::stats::Estimate;

/// The probability to survive a surface.
pub const SURVIVAL: [f64; 2] = [0.4, 0.98];
/// The albedo of the walls: the chapter's.
pub const ALBEDO: f64 = 0.8;
/// Albedos with curves of their own.
pub const ALBEDOS: [f64; 3] = [0.5, ALBEDO, 0.9];
/// Independent runs, and walks in each.
pub const RUNS: u32 = 12;
const WALKS: u32 = 400;

fn game(albedo: f64, survival: f64) -> Game {
    Game {
        albedo,
        survival: within(survival, SURVIVAL),
    }
}

/// The mean of a walk, its variance, which may be infinite, and its segments; then the wall, up to which no walk has a
/// variance; and 1 where a measured variance settles, else 0. Then, for each of
/// [`ALBEDOS`], variance times segments over the squared mean.
pub fn law(survival: f64) -> Vec<f64> {
    let game = game(ALBEDO, survival);
    let wall = ALBEDO * ALBEDO;
    let settles = f64::from(u8::from(game.settles()));
    let price = |albedo| {
        let game = self::game(albedo, survival);
        game.price() / (game.mean() * game.mean())
    };
    let own = [game.mean(), game.variance(), game.rays(), wall, settles];
    own.into_iter().chain(ALBEDOS.map(price)).collect()
}

/// The mean of all walks and the standard error that they claim; then the variance that each of [`RUNS`] runs of 400
/// walks claims.
pub fn run(survival: f64, seed: u32) -> Vec<f64> {
    let game = game(ALBEDO, survival);
    let run = |k| -> Estimate {
        let walk = |i| game.walk(&Stream::new(seed.into(), i, k)).0;
        (0..WALKS).map(walk).collect()
    };
    let runs: Vec<Estimate> = (0..RUNS).map(run).collect();
    let all = runs.iter().fold(Estimate::new(), |all, run| all.merge(run));
    let claimed = runs.iter().map(Estimate::variance);
    [all.mean(), all.std_error()]
        .into_iter()
        .chain(claimed)
        .collect()
}
