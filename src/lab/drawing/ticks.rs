//! Ticks: round values along an axis, and numbers as words.

use libm::{exp10, floor, log10};
use plotters::coord::ranged1d::{BoldPoints, Ranged};
use plotters::coord::types::RangedCoordf64;
use std::ops::Range;

/// A labelled value.
#[derive(Clone, Debug)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

/// At most so many round values, where the drawing library puts them.
pub(super) fn linear(range: &Range<f64>, most: usize) -> Vec<Tick> {
    let values = RangedCoordf64::from(range.clone()).key_points(BoldPoints(most.max(2)));
    let values: Vec<f64> = values.into_iter().filter(|x| range.contains(x)).collect();
    let largest = values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let power = floor(log10(largest.max(f64::MIN_POSITIVE)));
    // Very large and very small numbers carry their power of ten.
    let power = if (-4.0..5.0).contains(&power) {
        0.0
    } else {
        power
    };
    let unit = exp10(power);
    let is_whole = |x: f64| (x - x.round()).abs() < 1e-6;
    let exact = |digits: &i32| {
        values
            .iter()
            .all(|x| is_whole(x / unit * exp10(f64::from(*digits))))
    };
    let digits = (0..9).find(exact).unwrap_or(9) as usize;
    let label = |value: f64| match power {
        _ if value == 0.0 => "0".to_owned(),
        0.0 => format!("{value:.digits$}"),
        _ => format!("{:.digits$}×10{}", value / unit, superscript(power as i32)),
    };
    values
        .iter()
        .map(|&value| Tick {
            value,
            label: label(value),
        })
        .collect()
}

/// Ticks of a logarithmic axis, about so many at most, and the values of faint lines between them: powers
/// of ten where there are three; on a shorter range their 1, 2, 5; on a still shorter one, round values
/// as on a linear axis.
pub(super) fn logarithmic(range: &Range<f64>, most: usize) -> (Vec<Tick>, Vec<f64>) {
    // The ends of a range may be off by a rounding.
    let held = range.start * (1.0 - 1e-12)..=range.end * (1.0 + 1e-12);
    let powers = floor(log10(*held.start())) as i32..=floor(log10(*held.end())) as i32;
    let multiples = |factors: &[f64]| -> Vec<f64> {
        let all = powers
            .clone()
            .flat_map(|p| factors.iter().map(move |f| f * exp10(f64::from(p))));
        all.filter(|x| held.contains(x)).collect()
    };
    let faint = match powers.clone().count() {
        0..=8 => multiples(&[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]),
        _ => Vec::new(),
    };
    let (ones, fives) = (multiples(&[1.0]), multiples(&[1.0, 2.0, 5.0]));
    let power = |x: f64| log10(x).round() as i32;
    let plain = ones.iter().all(|&x| (-3..=4).contains(&power(x)));
    let values = match (ones.len(), fives.len()) {
        (count @ 3.., _) => {
            let every = count.div_ceil(most.max(2)) as i32;
            let shown = |&x: &f64| power(x) % every == 0;
            let ones: Vec<f64> = ones.into_iter().filter(shown).collect();
            if !plain {
                let label = |x| format!("10{}", superscript(power(x)));
                let ticks = ones.into_iter().map(|value| Tick {
                    value,
                    label: label(value),
                });
                return (ticks.collect(), faint);
            }
            ones
        }
        (_, 0..=2) => return (linear(range, most), Vec::new()),
        // Side by side they would touch.
        (2, many) if many > 2 * most => ones,
        _ => fives,
    };
    let tick = |value| Tick {
        value,
        label: number(value),
    };
    (values.into_iter().map(tick).collect(), faint)
}

/// Three significant digits, without trailing zeros.
pub(super) fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let power = floor(log10(value.abs()) + 1e-9) as i32;
    let (value, power, suffix) = match power {
        -4..=5 => (value, power, String::new()),
        _ => (
            value / exp10(f64::from(power)),
            0,
            format!("×10{}", superscript(power)),
        ),
    };
    let digits = format!("{value:.*}", (2 - power).max(0) as usize);
    let digits = match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.'),
        false => &digits,
    };
    format!("{digits}{suffix}")
}

fn superscript(power: i32) -> String {
    let raised = |c: char| match c.to_digit(10) {
        Some(digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit as usize).unwrap_or(c),
        None => '⁻',
    };
    power.to_string().chars().map(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits() {
        assert_eq!(number(0.91999), "0.92");
        assert_eq!(number(1234.6), "1235");
        assert_eq!(number(100.0), "100");
        assert_eq!(number(2.5e-7), "2.5×10⁻⁷");
        assert_eq!(number(-0.5), "-0.5");
        assert_eq!(superscript(-1_234_567_890), "⁻¹²³⁴⁵⁶⁷⁸⁹⁰");
    }

    fn labels(ticks: &[Tick]) -> Vec<&str> {
        ticks.iter().map(|tick| tick.label.as_str()).collect()
    }

    #[test]
    fn linear_ticks_are_round_and_tell_apart() {
        assert_eq!(
            labels(&linear(&(-0.05..1.05), 7)),
            ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]
        );
        assert_eq!(
            labels(&linear(&(-1e5..3.1e6), 5)),
            ["0", "1×10⁶", "2×10⁶", "3×10⁶"]
        );
        assert_eq!(labels(&linear(&(1.0009..1.0051), 3)), ["1.002", "1.004"]);
    }

    #[test]
    fn log_ticks_follow_the_range() {
        let of = |low: f64, high: f64| logarithmic(&(low..high), 9).0;
        assert_eq!(labels(&of(1.0, 1000.0)), ["1", "10", "100", "1000"]);
        assert_eq!(labels(&of(1e-6, 1e-3))[0], "10⁻⁶");
        assert_eq!(labels(&of(0.9, 22.0)), ["1", "2", "5", "10", "20"]);
        assert_eq!(
            labels(&logarithmic(&(9.0..4500.0), 3).0),
            ["10", "100", "1000"]
        );
        assert_eq!(labels(&logarithmic(&(11.0..4500.0), 3).0), ["100", "1000"]);
        assert_eq!(labels(&of(2.2, 4.4)), ["2.5", "3.0", "3.5", "4.0"]);
        assert!(of(1e-300, 1e300).len() <= 9, "a wide axis keeps few ticks");
    }
}
