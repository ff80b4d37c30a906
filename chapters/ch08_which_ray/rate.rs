//! The variance of many choices, for a mixture with a faint mirror.

use crate::RULES;
use crate::mixed_furnace::MixedFurnace;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::experiment::convergence::{Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;
use halfdisk::materials::{Choice, Mixture};
use halfdisk::sampling::stream::Stream;

/// The variance of the mean of `N` weights, by each rule that leaves any.
pub fn chart(desk: &mut Desk, material: Mixture) -> Result<(), DeskError> {
    let design = Design {
        replicates: desk.choose(256, 64),
        doublings: desk.choose(10, 6),
        first: 4,
        seed: desk.options.seed,
    };
    let rules = RULES
        .iter()
        .filter(|(choice, ..)| matches!(choice, Choice::Equal | Choice::Analog));
    let runs = rules.map(|&(choice, _, name)| {
        let room = MixedFurnace {
            material,
            choice,
            segments: 1,
        };
        let estimator = Estimator {
            name,
            about: "",
            truth: f64::from(material.k_tot().r),
            rays_per_sample: 1,
            sizes: Sizes::Doublings,
            run: move |n: u32, seed: u64| {
                let weight = |i| {
                    let next = room.next(1, &Stream::new(seed, i, 0));
                    next.map_or(0.0, |next| f64::from(next.weight.r))
                };
                (0..n).map(weight).sum::<f64>() / f64::from(n)
            },
        };
        (
            converge(&estimator, &design),
            Some(room.weight_variance()[0]),
        )
    });
    let chart = variance_chart(
        "Choices of a mixture with a faint mirror",
        &runs.collect::<Vec<_>>(),
    );
    let caption = "Shares (0.7, 0.05, 0.05): chosen alike, or with absorption as a fourth choice. Dashed: Σ k²/p − \
                   k_tot², over N. Chosen by the shares there is no variance to draw.";
    desk.figure("rate.svg", caption, chart.to_svg()?)
}
