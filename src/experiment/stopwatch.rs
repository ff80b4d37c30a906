//! How long one thing takes for the time of another.

use crate::stats::Estimate;
use std::hint::black_box;
use std::time::Instant;

/// The time of `b` over the time of `a`: one ratio for each round.
///
/// Each round times both, in alternating order, so that what slows the machine for a while slows both;
/// of all rounds the middle half is kept, for some are interrupted.
pub fn in_turns<A, B>(rounds: u32, a: impl Fn() -> A, b: impl Fn() -> B) -> Estimate {
    let time_a = || {
        let start = Instant::now();
        black_box(a());
        start.elapsed().as_secs_f64()
    };
    let time_b = || {
        let start = Instant::now();
        black_box(b());
        start.elapsed().as_secs_f64()
    };
    let mut ratios: Vec<f64> = (0..rounds)
        .map(|round| {
            let (a, b) = if round % 2 == 0 {
                let a = time_a();
                (a, time_b())
            } else {
                let b = time_b();
                (time_a(), b)
            };
            b / a.max(f64::MIN_POSITIVE)
        })
        .collect();
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
