//! The variance of many estimates under a lamp of half angle 1.1, where neither technique is good.

use crate::sweep::WAYS;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::estimators::overhead::Overhead;
use halfdisk::lab::experiment::convergence::{Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;
use halfdisk::sampling::stream::{Purpose, Stream};

/// The variance of the mean of `N` estimates, by each technique.
pub fn chart(desk: &mut Desk) -> Result<(), DeskError> {
    let lamp = Overhead::new(1.1);
    let design = Design {
        replicates: desk.choose(128, 64),
        doublings: desk.choose(10, 6),
        first: 4,
        seed: desk.options.seed,
    };
    let runs = WAYS.map(|(name, technique)| {
        let estimator = Estimator {
            name,
            about: "",
            truth: lamp.mean(),
            rays_per_sample: 2,
            sizes: Sizes::Doublings,
            run: move |n: u32, seed: u64| {
                let one = |i| {
                    let u = Stream::new(seed, i, 0).at(0, Purpose::Integrand).two();
                    lamp.estimate(technique, u.map(f64::from))
                };
                (0..n).map(one).sum::<f64>() / f64::from(n)
            },
        };
        (
            converge(&estimator, &design),
            Some(lamp.variance(technique)),
        )
    });
    let chart = variance_chart("A lamp of half angle 1.1", &runs);
    let caption = "All four follow σ²/N; dashed, σ² by quadrature. Both weighted estimates lie below both \
                   techniques alone.";
    desk.figure("rate.svg", caption, chart.to_svg()?)
}
