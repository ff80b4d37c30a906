//! What a wanted error costs.

use super::bias::Bias;
use super::size::{Size, Verdict};
use crate::stats::price::{Paid, ratio};
use crate::stats::slope::Line;
use serde::Serialize;

/// How long a method takes to reach an error, in seconds of the size and threads measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Reach {
    /// So long, with its 95 % interval: by the price of its largest pictures, for its error is known
    /// to fall as one over the root of time.
    Priced {
        /// Seconds.
        seconds: f64,
        /// Lower end of the interval.
        low: f64,
        /// Upper end of the interval.
        high: f64,
    },
    /// About so long: between two sizes that were measured.
    Between {
        /// Seconds.
        seconds: f64,
    },
    /// At most so long: the smallest size was good enough.
    AtMost {
        /// Seconds.
        seconds: f64,
    },
    /// Longer: not reached in the longest time measured, and no law says when.
    MoreThan {
        /// Seconds.
        seconds: f64,
    },
    /// Never: it levels out above, beyond doubt.
    Never,
}

/// What reaching the relative error `target` costs a method, from the sizes it was run at and the
/// squared errors and seconds of its largest pictures.
pub(super) fn reach(
    target: f64,
    sizes: &[Size],
    largest: &[Paid],
    verdict: Verdict,
    bias: Option<Bias>,
) -> Reach {
    if verdict == Verdict::Biased && bias.is_some_and(|bias| bias.floor() >= target) {
        return Reach::Never;
    }
    // One second of the error that is wanted.
    let wanted = vec![[target * target, 1.0]; largest.len()];
    if verdict == Verdict::Sufficient
        && let Some(found) = ratio(largest, &wanted)
    {
        return Reach::Priced {
            seconds: found.ratio,
            low: found.low,
            high: found.high,
        };
    }
    if let Some(first) = sizes.first()
        && first.error <= target
    {
        return Reach::AtMost {
            seconds: first.seconds,
        };
    }
    for pair in sizes.windows(2) {
        if pair[1].error > target {
            continue;
        }
        let [before, after] = [pair[0], pair[1]].map(|s| (s.error, s.seconds));
        let seconds = Line::through(&[before, after]).map_or(after.1, |line| line.at(target));
        // Where an error is zero there is no line, and the later size is good enough.
        let seconds = if seconds.is_finite() {
            seconds
        } else {
            after.1
        };
        return Reach::Between { seconds };
    }
    Reach::MoreThan {
        seconds: sizes.last().map_or(0.0, |s| s.seconds),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sizes() -> Vec<Size> {
        let size = |k: u32| Size {
            spp: 1 << (2 * k),
            rays: f64::from(1 << (2 * k)),
            seconds: 0.1 * f64::from(1 << (2 * k)),
            mean_seconds: 0.1 * f64::from(1 << (2 * k)),
            spread: 0.0,
            error: 0.4 / f64::from(1 << k),
            error_error: 0.001,
            top_share: 0.001,
        };
        (0..3).map(size).collect()
    }

    const PAID: [Paid; 3] = [[0.011, 1.5], [0.009, 1.6], [0.010, 1.7]];

    #[test]
    fn a_known_law_is_carried_on_and_an_unknown_one_is_not() {
        let at = |target, verdict| reach(target, &sizes(), &PAID, verdict, None);
        let Reach::Priced { seconds, low, high } = at(0.01, Verdict::Sufficient) else {
            panic!("a price");
        };
        assert!((seconds - 160.0).abs() < 1e-9 && low < 160.0 && high > 160.0);
        assert_eq!(
            at(0.01, Verdict::Insufficient),
            Reach::MoreThan { seconds: 1.6 }
        );
        let Reach::Between { seconds } = at(0.2, Verdict::Faster) else {
            panic!("between");
        };
        assert!((seconds - 0.4).abs() < 1e-12, "{seconds}");
        assert_eq!(
            at(0.5, Verdict::Insufficient),
            Reach::AtMost { seconds: 0.1 }
        );
    }

    #[test]
    fn what_levels_out_above_never_gets_there() {
        let bias = Some(Bias {
            square: 0.0025,
            error: 0.0001,
            mean: -0.01,
            mean_error: 0.001,
            evenness: 0.5,
        });
        let at = |target| reach(target, &sizes(), &PAID, Verdict::Biased, bias);
        assert_eq!(at(0.02), Reach::Never);
        assert!(matches!(at(0.2), Reach::Between { .. }));
    }
}
