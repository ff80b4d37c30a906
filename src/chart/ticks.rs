//! Ticks: round values along an axis, and numbers as words.

use libm::{exp10, floor, log10};

/// How far a position may be from where it should.
const ROUNDING: f64 = 1e-12;

/// A labelled value.
#[derive(Clone, Debug)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

/// Round values (steps of 1, 2 or 5 times a power of ten), about half a dozen of them.
pub(super) fn linear_ticks(low: f64, high: f64) -> Vec<Tick> {
    let rough = (high - low) / 6.0;
    let power = floor(log10(rough));
    let (lead, power) = match rough / exp10(power) {
        lead if lead < 1.5 => (1.0, power),
        lead if lead < 3.5 => (2.0, power),
        lead if lead < 7.5 => (5.0, power),
        _ => (1.0, power + 1.0),
    };
    let step = lead * exp10(power);
    let first = (low / step).ceil() as i64;
    let last = (high / step).floor() as i64;
    let largest = low.abs().max(high.abs());
    (first..=last)
        .map(|n| n as f64 * step)
        .map(|value| Tick {
            value,
            label: round_number(value, largest, power as i32),
        })
        .collect()
}

/// Ticks and faint lines between two positions: powers of ten where they suffice; on a shorter
/// range their 1, 2, 5; on a still shorter one, round values as on a linear axis.
pub(super) fn log_ticks(low: f64, high: f64) -> (Vec<Tick>, Vec<f64>) {
    // The logarithm of a power of ten may be off by a rounding.
    let (first, last) = ((low - ROUNDING).ceil(), (high + ROUNDING).floor());
    let powers: Vec<i32> = (first as i32..=last as i32).collect();
    let minor = match powers.len() {
        0..=7 => multiples(low, high, &[2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0]),
        _ => Vec::new(),
    };
    if powers.len() >= 3 {
        return (power_ticks(&powers), minor);
    }
    let fives = multiples(low, high, &[1.0, 2.0, 5.0]);
    if fives.len() >= 3 {
        let tick = |value| Tick {
            value,
            label: number(value),
        };
        return (fives.into_iter().map(tick).collect(), minor);
    }
    (linear_ticks(exp10(low), exp10(high)), Vec::new())
}

/// The factors times every power of ten, as far as they lie between two positions.
fn multiples(low: f64, high: f64, factors: &[f64]) -> Vec<f64> {
    (low.floor() as i32..=high.floor() as i32)
        .flat_map(|power| factors.iter().map(move |f| f * exp10(f64::from(power))))
        .filter(|&value| (low..=high).contains(&log10(value)))
        .collect()
}

/// At most nine powers of ten, written out as long as all of them are short.
fn power_ticks(powers: &[i32]) -> Vec<Tick> {
    let plain = powers.iter().all(|power| (-3..=4).contains(power));
    let tick = |&power: &i32| {
        let value = exp10(f64::from(power));
        let label = if plain {
            number(value)
        } else {
            format!("10{}", superscript(power))
        };
        Tick { value, label }
    };
    let every = powers.len().div_ceil(9) as i32;
    let round = powers.iter().filter(|&power| power % every == 0);
    round.map(tick).collect()
}

/// A multiple of 10^`power`, in the notation that suits a list whose largest entry is given.
fn round_number(value: f64, largest: f64, power: i32) -> String {
    let places = |digits: i32| digits.max(0) as usize;
    if value == 0.0 {
        "0".to_owned()
    } else if largest < 1e5 && power >= -4 {
        format!("{value:.*}", places(-power))
    } else {
        let lead = floor(log10(largest)) as i32;
        let mantissa = value / exp10(f64::from(lead));
        let digits = places(lead - power);
        format!("{mantissa:.digits$}×10{}", superscript(lead))
    }
}

/// Three significant digits, without trailing zeros.
pub(super) fn number(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let power = floor(log10(value.abs()) + 1e-9) as i32;
    let (value, suffix) = if (-4..=5).contains(&power) {
        (value, String::new())
    } else {
        let suffix = format!("×10{}", superscript(power));
        (value / exp10(f64::from(power)), suffix)
    };
    let shown_power = if suffix.is_empty() { power } else { 0 };
    let digits = format!("{value:.*}", (2 - shown_power).max(0) as usize);
    let digits = if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        &digits
    };
    format!("{digits}{suffix}")
}

fn superscript(power: i32) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '4' => '⁴',
        '5' => '⁵',
        '6' => '⁶',
        '7' => '⁷',
        '8' => '⁸',
        '9' => '⁹',
        _ => '⁰',
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
    }
}
