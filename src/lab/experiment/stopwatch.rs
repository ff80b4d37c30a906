//! How long one thing takes for the time of another.

use super::study::order;
use crate::stats::Estimate;
use crate::time::Moment;
use std::hint::black_box;

/// The time of `b` over the time of `a`: one ratio for each round; NaN where there is no clock.
///
/// Each round times both, in alternating order, so that what slows the machine for a while slows both;
/// of all rounds the middle half is kept, for some are interrupted.
pub fn in_turns<A, B>(rounds: u32, a: impl Fn() -> A, b: impl Fn() -> B) -> Estimate {
    let work: [&dyn Fn(); 2] = [&|| drop(black_box(a())), &|| drop(black_box(b()))];
    let ratio = |round| {
        let mut seconds = [0.0; 2];
        for i in order(round, 2) {
            let start = Moment::now();
            work[i]();
            seconds[i] = start.elapsed().map_or(f64::NAN, |time| time.as_secs_f64());
        }
        seconds[1] / seconds[0].max(f64::MIN_POSITIVE)
    };
    let mut ratios: Vec<f64> = (0..rounds).map(ratio).collect();
    ratios.sort_by(f64::total_cmp);
    let aside = ratios.len() / 4;
    ratios[aside..ratios.len() - aside]
        .iter()
        .copied()
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twice_the_work_takes_longer() {
        let work = |n: u32| move || (0..n).map(|x| f64::from(x).sqrt()).sum::<f64>();
        let ratio = in_turns(15, work(100_000), work(400_000));
        assert!(ratio.count() == 9 && ratio.mean() > 1.5, "{ratio:?}");
    }
}
