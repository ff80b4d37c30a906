//! Chapter 11, exercise 2: the density of aiming is 7 % off. Which test notices?
//!
//! It depends on where the density is used. As the divisor of an estimate it must be that of the
//! samples. In a weight it need only be the same in both: then the weights still add up to one, the
//! mean is right, and no test of means can notice. A histogram of the samples notices always.

#![allow(clippy::print_stdout)]

use halfdisk::integrators::world::FlatTracer;
use halfdisk::lab::estimators::overhead::{Overhead, Technique};
use halfdisk::lab::mistakes::misled::{Misled, Slip};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::SceneError;
use halfdisk::stats::Estimate;
use halfdisk::stats::chi_square::chi_square;

const FACTOR: f32 = 0.93;
const WALKS: u32 = 400_000;
const HEURISTIC: Heuristic = Heuristic::Balance;
const SLIPS: [(&str, Slip); 3] = [
    ("everywhere", Slip::Density(FACTOR)),
    ("in one weight", Slip::OneWeight(FACTOR)),
    ("in both weights", Slip::BothWeights(FACTOR)),
];

/// What a walk reads that is misled.
fn reading(lamp: &Overhead, slip: Slip) -> Result<Estimate, SceneError> {
    let world = lamp.world(1)?;
    let mut misled = Misled {
        world: FlatTracer::new(&world),
        slip,
    };
    let one = |i| Technique::Both(HEURISTIC).walk(&mut misled, &Stream::new(13, i, 0));
    Ok((0..WALKS).map(one).collect())
}

/// The chance that right samples of a density `factor` times as large lie at least so far from it:
/// the last cell is for what that density does not account for.
fn histogram(lamp: &Overhead, factor: f64) -> f64 {
    const CELLS: usize = 32;
    let mut counts = vec![0; CELLS];
    let mut numbers = Stream::new(13, 0, 1).at(0, Purpose::LightPoint);
    for _ in 0..WALKS {
        let theta = lamp.sample_aim(f64::from(numbers.one()));
        let share = 0.5 + 0.5 * theta / lamp.half_angle;
        counts[(share * CELLS as f64) as usize] += 1;
    }
    let width = 2.0 * lamp.half_angle / CELLS as f64;
    let middle = |cell: usize| (cell as f64 + 0.5) * width - lamp.half_angle;
    let expected = |cell| f64::from(WALKS) * width * factor * lamp.pdf(middle(cell))[1];
    let mut expected: Vec<f64> = (0..CELLS).map(expected).collect();
    let rest = f64::from(WALKS) - expected.iter().sum::<f64>();
    if rest > 1.0 {
        expected.push(rest);
        counts.push(0);
    }
    chi_square(&counts, &expected).p
}

fn main() -> Result<(), SceneError> {
    for half_angle in [0.1, 1.0] {
        let lamp = Overhead::new(half_angle);
        println!(
            "half angle {half_angle}: the floor reflects {:.6}",
            lamp.mean()
        );
        for (place, slip) in SLIPS {
            let read = reading(&lamp, slip)?;
            let exact = slip.reading(&lamp, 1, HEURISTIC);
            println!(
                "  7 % off {place}: {:.6} ± {:.6}, by quadrature {exact:.6}, {:+.1} standard errors",
                read.mean(),
                read.std_error(),
                read.z(lamp.mean())
            );
        }
        println!(
            "  histogram of the samples: p {:.4}, 7 % off {:.4}",
            histogram(&lamp, 1.0),
            histogram(&lamp, f64::from(FACTOR))
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_notice_two_of_three() {
        for half_angle in [0.1, 1.0] {
            let lamp = Overhead::new(half_angle);
            let noticed = SLIPS.map(|(_, slip)| {
                let read = reading(&lamp, slip).unwrap();
                let own = read.z(slip.reading(&lamp, 1, HEURISTIC));
                assert!(own.abs() <= 4.4, "{slip:?}: {own}");
                read.z(lamp.mean()).abs() > 4.4
            });
            assert_eq!(noticed, [true, true, false], "{half_angle}");
        }
    }

    #[test]
    fn a_histogram_always_does() {
        let lamp = Overhead::new(1.0);
        assert!(histogram(&lamp, 1.0) > 1e-3);
        assert!(histogram(&lamp, f64::from(FACTOR)) < 1e-6);
    }
}
