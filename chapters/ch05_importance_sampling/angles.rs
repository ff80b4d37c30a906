//! Laws of directions, seen as laws of the angle from the normal.

use glam::{Vec2, Vec3};
use halfdisk::lab::chapter::Desk;
use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::sampling::{half_disk, hemisphere};
use halfdisk::space::{Flat, Solid, Space};
use halfdisk::stats::Estimate;
use halfdisk::stats::chi_square::chi_square;
use halfdisk::stats::z_test::{FOUR, z_test};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Cells of a histogram.
pub const CELLS: usize = 36;

/// A way to draw directions, and the density it claims.
pub struct Law {
    /// Its name in figures.
    pub name: &'static str,
    /// Draws the angle of one direction, in radians.
    pub angle: fn(&mut Numbers) -> f64,
    /// Density of the angle, per radian.
    pub density: fn(f64) -> f64,
}

/// The angles of a world: from `low` to a right angle.
pub struct World {
    /// Minus a right angle in the flat world, where left and right differ; 0 in space.
    pub low: f64,
    /// Uniform, cosine, cosine².
    pub laws: [Law; 3],
}

/// A law with its angles, counted in cells of equal size.
pub struct Drawn {
    /// The law.
    pub law: Law,
    /// Angles in each cell.
    pub counts: Vec<u64>,
    /// The mean cosine.
    pub cosine: Estimate,
    low: f64,
}

/// Draws the angles of a world and tests them: what was drawn, and how far the mean cosine is off.
pub fn work(desk: &mut Desk, world: World, name: &str, mean: f64) -> (Vec<Drawn>, f64) {
    let (count, seed) = (desk.choose(500_000, 200_000), desk.options.seed);
    let polar = (world.low == 0.0).then(polar);
    let drawn: Vec<Drawn> = (0..)
        .zip(world.laws.into_iter().chain(polar))
        .map(|(i, law)| Drawn::new(law, world.low, count, &Stream::new(seed, i, 0)))
        .collect();
    let cosine = &drawn[1].cosine;
    let says = format!("{name}: mean cosine of cosine directions");
    desk.estimate(&format!("mean_cos_{name}"), &says, cosine, Some(mean));
    // As uniform: right for the first, wrong for the others.
    let tests = [("uniform", 0, 0), ("cosine", 1, 1), ("cos_n", 2, 2)];
    for (test, i, as_if) in [&tests[..], &[("wrong", 1, 0), ("polar", 3, 0)]].concat() {
        if let Some(found) = drawn.get(i) {
            let p = found.p_value(drawn[as_if].law.density);
            let says = format!(
                "{name}: p of {} as {}",
                found.law.name, drawn[as_if].law.name
            );
            // Four decimals are all that a chance like this says.
            desk.value(&format!("p_{test}_{name}"), &says, (p * 1e4).round() / 1e4);
        }
    }
    let z = z_test(cosine, mean, FOUR).z.abs();
    (drawn, z)
}

/// The half disk.
pub fn flat() -> World {
    World {
        low: -FRAC_PI_2,
        laws: [
            Law {
                name: "uniform",
                angle: |u| across(half_disk::sample_uniform(u.one())),
                density: |t| half_disk::pdf_uniform(Flat::tilted(t as f32)).into(),
            },
            Law {
                name: "cosine",
                angle: |u| across(half_disk::sample_cosine(u.one())),
                density: |t| half_disk::pdf_cosine(Flat::tilted(t as f32)).into(),
            },
            Law {
                name: "cosine²",
                angle: |u| across(half_disk::sample_cos_n(u.two(), 2.0)),
                density: |t| half_disk::pdf_cos_n(Flat::tilted(t as f32), 2.0).into(),
            },
        ],
    }
}

/// The hemisphere.
pub fn solid() -> World {
    World {
        low: 0.0,
        laws: [
            Law {
                name: "uniform",
                angle: |u| down(hemisphere::sample_uniform(u.two())),
                density: |t| around(t, hemisphere::pdf_uniform(Solid::tilted(t as f32))),
            },
            Law {
                name: "cosine",
                angle: |u| down(hemisphere::sample_cosine(u.two())),
                density: |t| around(t, hemisphere::pdf_cosine(Solid::tilted(t as f32))),
            },
            Law {
                name: "cosine²",
                angle: |u| down(hemisphere::sample_cos_n(u.two(), 2.0)),
                density: |t| around(t, hemisphere::pdf_cos_n(Solid::tilted(t as f32), 2.0)),
            },
        ],
    }
}

/// The mistake: a polar angle drawn uniformly, said to be uniform on the hemisphere.
pub fn polar() -> Law {
    let [uniform, ..] = solid().laws;
    Law {
        name: "polar angle uniform",
        angle: |u| FRAC_PI_2 * f64::from(u.one()),
        ..uniform
    }
}

/// The angle from the normal, positive to the right.
fn across(w: Vec2) -> f64 {
    libm::atan2(w.x.into(), w.y.into())
}

/// The angle from the normal.
fn down(w: Vec3) -> f64 {
    libm::atan2(libm::hypot(w.x.into(), w.y.into()), w.z.into())
}

/// A density per steradian, as one of the angle: all azimuths together.
fn around(angle: f64, pdf: f32) -> f64 {
    TAU * libm::sin(angle) * f64::from(pdf)
}

impl Drawn {
    /// Draws `count` angles of a law between `low` and a right angle.
    pub fn new(law: Law, low: f64, count: u32, stream: &Stream) -> Drawn {
        let mut counts = vec![0; CELLS];
        let mut cosine = Estimate::new();
        let mut numbers = stream.at(0, Purpose::Direction);
        for _ in 0..count {
            let angle = (law.angle)(&mut numbers);
            cosine.add(libm::cos(angle));
            let cell = (angle - low) / (FRAC_PI_2 - low) * CELLS as f64;
            counts[(cell as usize).min(CELLS - 1)] += 1;
        }
        Drawn {
            law,
            counts,
            cosine,
            low,
        }
    }

    /// Width of a cell.
    pub fn width(&self) -> f64 {
        (FRAC_PI_2 - self.low) / CELLS as f64
    }

    /// An angle, counted in cells from the lowest.
    pub fn place(&self, cells: f64) -> f64 {
        self.low + cells * self.width()
    }

    // ANCHOR: test
    /// The chance that right samples of `density` lie at least so far from it.
    pub fn p_value(&self, density: fn(f64) -> f64) -> f64 {
        const STEPS: usize = 64;
        let middle = |i: usize| self.place((i as f64 + 0.5) / STEPS as f64);
        let share = |cell: usize| {
            let steps = (cell * STEPS..(cell + 1) * STEPS).map(middle);
            steps.map(density).sum::<f64>() / STEPS as f64 * self.width()
        };
        let expected: Vec<f64> = (0..CELLS)
            .map(|cell| self.cosine.count() as f64 * share(cell))
            .collect();
        chi_square(&self.counts, &expected).p
    }
    // ANCHOR_END: test
}
