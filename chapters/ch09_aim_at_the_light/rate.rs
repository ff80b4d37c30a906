//! The variance of many walks under one lamp of half-angle 0.1.

use crate::shrinking_lamp::{self, Technique};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::experiment::convergence::{Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;

/// The variance of the mean of `N` walks, by each technique.
pub fn chart(desk: &mut Desk) -> Result<(), DeskError> {
    let half_angle = 0.1;
    let design = Design {
        replicates: desk.choose(128, 64),
        doublings: desk.choose(8, 5),
        first: 8,
        seed: desk.options.seed,
    };
    // Whether the lamp can be built is known before it is built a thousand times.
    shrinking_lamp::flat(Technique::Aim, half_angle, 1, 0)?;
    let truth = libm::sin(half_angle);
    let ways = [
        (Technique::Uniform, "by chance, uniform"),
        (Technique::Cosine, "by chance, cosine"),
        (Technique::Aim, "aimed at"),
    ];
    let runs = ways.map(|(technique, name)| {
        let estimator = Estimator {
            name,
            about: "",
            truth,
            rays_per_sample: 2,
            sizes: Sizes::Doublings,
            run: move |n: u32, seed: u64| {
                let walks = shrinking_lamp::flat(technique, half_angle, n, seed);
                walks.map_or(f64::NAN, |walks| walks.estimate.mean())
            },
        };
        let known = technique.exact_flat(half_angle) * truth * truth;
        (converge(&estimator, &design), Some(known))
    });
    let chart = variance_chart("A lamp of half-angle 0.1", &runs);
    let caption = "All three follow σ²/N with the closed forms of the text. Aiming does not change the rate; it \
                   lowers the line by more than six powers of ten.";
    desk.figure("rate.svg", caption, chart.to_svg()?)
}
