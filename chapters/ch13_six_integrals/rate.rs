//! The variance of one blurred pixel for each integral.

use crate::figures::name;
use crate::profiles::Profile;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::experiment::convergence::{Design, Estimator, Sizes, converge};
use halfdisk::lab::figures::variance_chart;

/// The pixel of each row that is looked at: left of the middle, where nothing is all or nothing.
const PIXEL: usize = 10;

/// The variance of one pixel of each row, against its samples.
pub fn chart(desk: &mut Desk, profiles: &[Profile]) -> Result<(), DeskError> {
    let design = Design {
        replicates: 32,
        doublings: desk.choose(5, 3),
        first: 4,
        seed: desk.options.seed,
    };
    let mut runs = Vec::new();
    for profile in profiles {
        let (row, _) = profile.read(1, 0, |_| {})?;
        let truth = row.get(PIXEL).map_or(f64::NAN, |reading| reading.exact);
        let estimator = Estimator {
            name: name(profile.integral),
            about: "",
            truth,
            rays_per_sample: 3,
            sizes: Sizes::Doublings,
            run: |n: u32, seed: u64| {
                let row = profile.read(n, seed, |_| {}).ok();
                let reading = row.and_then(|(row, _)| row.get(PIXEL).copied());
                reading.map_or(f64::NAN, |reading| reading.read.mean())
            },
        };
        runs.push((converge(&estimator, &design), None));
    }
    let chart = variance_chart("One blurred pixel for each integral", &runs);
    let caption = "Each of the six follows the law 1/N, though one draws a point of the pixel, one a moment and \
                   one a direction.";
    desk.figure("rate.svg", caption, chart.to_svg()?)
}
