//! Chapter 10, exercise 2: survival by what a path carries, where it pays, and where it hurts.
//!
//! In a room whose walls are dark and light, a path that was just dimmed is worth less work than one
//! that was not. On a dark floor under a bright sky the path has one segment left, and that one is
//! all the light there is: whoever ends it there has saved a ray and lost the answer.

#![allow(clippy::print_stdout)]

use glam::Vec2;
use halfdisk::flatland::{FlatWorld, gallery};
use halfdisk::integrators::world::FlatTracer;
use halfdisk::integrators::{Kajiya, Roulette, Survival};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::read::{SceneError, Source};
use halfdisk::space::{Flat, Ray};
use halfdisk::stats::Estimate;

/// A room with three dark walls and one that is bright and glows.
const ROOM: &str = "
    name = 'room'
    [[objects]]
    albedo = 0.15
    polyline = { points = [[0, 1], [0, 0], [1, 0], [1, 1]] }
    [[objects]]
    albedo = 0.9
    emits = 1
    segment = { from = [1, 1], to = [0, 1] }";

/// A dark floor under a bright sky.
const FLOOR: &str = "
    name = 'floor'
    background = 1
    [[objects]]
    albedo = 0.05
    segment = { from = [-1, 0], to = [2, 0] }";

fn world(text: &str) -> Result<FlatWorld, SceneError> {
    let file = "exercise";
    gallery::from_text(Source { file, text })
}

/// Either integrator, by a name.
#[derive(Clone, Copy, Debug)]
enum Way {
    Ends(Survival),
    Cut(u32),
}

/// What a way reads of the floor, and its rays for one walk.
fn measure(world: &FlatWorld, way: Way, walks: u32) -> (Estimate, f64) {
    let eye = Ray::<Flat>::new(Vec2::new(0.5, 0.5), Vec2::NEG_Y);
    let mut walk = FlatTracer::new(world);
    let one = |i| {
        let stream = Stream::new(11, i, 0);
        let li = match way {
            Way::Ends(survival) => Roulette { survival }.walk(&mut walk, &eye, &stream),
            Way::Cut(max_depth) => Kajiya { max_depth }.walk(&mut walk, &eye, &stream),
        };
        f64::from(li.r)
    };
    let read: Estimate = (0..walks).map(one).collect();
    (read, walk.rays as f64 / f64::from(walks))
}

/// Variance times rays: what certainty costs.
fn price((read, rays): &(Estimate, f64)) -> f64 {
    read.variance() * rays
}

const WAYS: [(&str, Way); 5] = [
    ("by what it carries", Way::Ends(Survival::Throughput(0.05))),
    ("0.5", Way::Ends(Survival::Constant(0.5))),
    ("0.7", Way::Ends(Survival::Constant(0.7))),
    ("0.9", Way::Ends(Survival::Constant(0.9))),
    ("cut at 40 segments", Way::Cut(40)),
];

fn main() -> Result<(), SceneError> {
    for (name, text) in [("dark and bright walls", ROOM), ("a dark floor", FLOOR)] {
        println!("{name}");
        let world = world(text)?;
        for (way, survival) in WAYS {
            let found = measure(&world, survival, 400_000);
            println!(
                "  survival {way}: {:.5} ± {:.5}, {:.2} rays, variance times rays {:.5}",
                found.0.mean(),
                found.0.std_error(),
                found.1,
                price(&found)
            );
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_agree() {
        for text in [ROOM, FLOOR] {
            let world = world(text).unwrap();
            let (truth, _) = measure(&world, Way::Cut(40), 400_000);
            for (way, survival) in WAYS {
                let (read, _) = measure(&world, survival, 400_000);
                let error = read.std_error().hypot(truth.std_error());
                let apart = (read.mean() - truth.mean()).abs();
                assert!(apart <= 4.4 * error + 1e-6, "{way}: {apart} {error}");
            }
        }
    }

    #[test]
    fn it_hurts_on_the_dark_floor() {
        let floor = world(FLOOR).unwrap();
        let hurt = measure(&floor, Way::Ends(Survival::Throughput(0.05)), 400_000);
        let cut = measure(&floor, Way::Cut(40), 400_000);
        assert!((hurt.0.variance() / (0.05 * 0.95) - 1.0).abs() < 0.05);
        assert!(hurt.1 < 0.6 * cut.1, "rays were saved");
        assert!(price(&cut) < 1e-9 * price(&hurt), "and the answer was lost");
    }
}
