//! Chapter 12, exercises 2 and 3: when roulette should start, and a path tracer of one's own.
//!
//! A path that plays roulette early saves rays and adds noise. Between bright walls hardly anything is saved; on a dark
//! floor under a bright sky all is lost. The second part is the whole path tracer in a room that needs no
//! geometry: a share of all directions leads to a lamp, all others to the next wall.

#![allow(clippy::print_stdout)]

use halfdisk::geometry::Ray;
use halfdisk::integrators::Path;
use halfdisk::lab::estimators::walks::{self, Walks};
use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, SceneError, gallery};
use halfdisk::stats::Estimate;

/// A dark floor under a white sky, which nobody aims at.
const FLOOR: &str = "
    name = 'floor'
    background = 1
    camera = { from = [0, 1, -1], to = [0, 0, 0], fov = 40 }
    materials.dark.lambert.albedo = 0.05
    objects = [{ material = 'dark', quad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] } }]";

/// The segment after which roulette starts.
const STARTS: [u32; 5] = [1, 2, 3, 5, 100];

/// Many paths along one ray, whose roulette starts like this.
fn paths(scene: &Scene, ray: &Ray, start: u32, count: u32) -> Walks {
    let path = Path {
        roulette_from: start,
        ..Path::from_eye(64)
    };
    walks::solid(scene, ray, &path, 0.0, count, 12)
}

/// Variance times rays: what certainty costs.
fn price(found: &Walks) -> f64 {
    found.estimate.variance() * found.rays_each()
}

/// What the room without geometry is made of.
#[derive(Clone, Copy, Debug)]
struct Room {
    /// The share of all directions in which a lamp of radiance 1 is seen, in `(0, 1)`.
    lamp: f64,
    /// The share of the light that a wall reflects, in `[0, 1)`.
    albedo: f64,
}

impl Room {
    /// Radiance of a wall: `L = ρ (s + (1 - s) L)`.
    fn truth(&self) -> f64 {
        self.albedo * self.lamp / (1.0 - self.albedo * (1.0 - self.lamp))
    }

    // ANCHOR: path
    /// One path. A direction is a number in `[0, 1)`, and those below `lamp` lead to the lamp: by chance it is met with
    /// the density 1, by aiming with the density `1 / lamp`.
    fn path(&self, random: &mut Numbers) -> f64 {
        let mut uniform = || f64::from(random.one());
        let (by_chance, by_aiming) = (1.0, 1.0 / self.lamp);
        let weight = |own: f64, other: f64| own * own / (own * own + other * other);
        let (mut li, mut beta) = (0.0, 1.0);
        loop {
            // Aim: the wall scatters the lamp's light.
            li += beta * self.albedo / by_aiming * weight(by_aiming, by_chance);
            // Look anywhere.
            beta *= self.albedo / by_chance;
            if uniform() < self.lamp {
                return li + beta * weight(by_chance, by_aiming);
            }
            // Roulette, by what the walls have left of the light.
            let survives = beta;
            if uniform() >= survives {
                return li;
            }
            beta /= survives;
        }
    }
    // ANCHOR_END: path

    fn read(&self, count: u32) -> Estimate {
        let one = |i| self.path(&mut Stream::new(12, i, 0).at(0, Purpose::Integrand));
        (0..count).map(one).collect()
    }
}

fn floor() -> Result<Scene, SceneError> {
    let (file, text) = ("exercise", FLOOR);
    gallery::from_text(Source { file, text }, None, |_| {})
}

fn main() -> Result<(), SceneError> {
    let (cornell, floor) = (gallery::load("cornell")?, floor()?);
    for (name, scene, place) in [
        ("the box, a point of the floor", &cornell, [0.35, 0.93]),
        ("a dark floor under the sky", &floor, [0.5, 0.5]),
    ] {
        println!("{name}");
        let ray = scene.camera.ray(place[0], place[1]);
        for start in STARTS {
            let found = paths(scene, &ray, start, 400_000);
            println!(
                "  from segment {start:3}: {:.5} ± {:.5}, {:5.2} rays, variance times rays {:.3e}",
                found.estimate.mean(),
                found.estimate.std_error(),
                found.rays_each(),
                price(&found)
            );
        }
    }
    for lamp in [0.01, 0.3, 0.9] {
        let room = Room { lamp, albedo: 0.8 };
        let read = room.read(400_000);
        println!(
            "a lamp in {lamp} of all directions: {:.5} ± {:.5}, exactly {:.5}",
            read.mean(),
            read.std_error(),
            room.truth()
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whenever_roulette_starts_the_mean_is_the_same() {
        for (scene, [s, t]) in [
            (gallery::load("cornell").unwrap(), [0.35, 0.93]),
            (floor().unwrap(), [0.5, 0.5]),
        ] {
            let ray = scene.camera.ray(s, t);
            let of = |start| paths(&scene, &ray, start, 40_000).estimate;
            let never = of(100);
            for start in STARTS {
                let read = of(start);
                let error = read.std_error().hypot(never.std_error());
                let apart = (read.mean() - never.mean()).abs();
                assert!(apart <= 4.4 * error + 1e-6, "{start}: {apart} {error}");
            }
        }
    }

    #[test]
    fn on_the_dark_floor_an_early_start_loses_everything() {
        let floor = floor().unwrap();
        let ray = floor.camera.ray(0.5, 0.5);
        let [early, late] = [1, 5].map(|start| paths(&floor, &ray, start, 40_000));
        assert!(price(&late) < 1e-6 * price(&early));
    }

    #[test]
    fn the_room_without_geometry_reads_the_truth_and_without_a_weight_it_does_not() {
        for lamp in [0.01, 0.3, 0.9] {
            let room = Room { lamp, albedo: 0.8 };
            let read = room.read(100_000);
            let z = read.z(room.truth());
            assert!(z.abs() <= 4.4, "{lamp}: {z}");
            // Whoever counts the lamp whenever it is met or aimed at reads twice the light.
            let twice = 2.0 * room.truth();
            assert!(read.z(twice).abs() > 100.0, "{lamp}");
        }
    }
}
