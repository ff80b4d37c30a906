//! Writes measured numbers the way they are read: no digit that its error does not support.

use std::ops::Range;

/// Between groups of three digits: narrow, and no line breaks there.
const THIN_SPACE: char = '\u{202f}';
/// Around signs and before units.
const NO_BREAK_SPACE: char = '\u{a0}';
const MINUS: char = '\u{2212}';

/// The powers of ten, from the leading digit, that are written out instead of as `1.2 × 10⁻⁵`.
const WRITTEN_OUT: Range<i32> = -4..7;
/// An error says which digits count, so a larger number can still be written out honestly.
const WRITTEN_OUT_WITH_ERROR: Range<i32> = -4..9;
/// Whole numbers below this are exact in an `f64`.
const EXACT_INTEGERS: f64 = 1e15;

/// Digits shown of a number that is exact.
pub const DIGITS: usize = 7;
/// Digits shown of a number that is neither exact nor given an error: nobody knows whether more would be right.
pub const UNSURE_DIGITS: usize = 4;
/// Digits shown of an error: it is itself an estimate.
pub const ERROR_DIGITS: usize = 2;

/// An exact number: whole numbers in full, others to seven significant digits.
pub fn plain(value: f64) -> String {
    whole_or(value, DIGITS)
}

/// A number that was measured and stands without its error: whole numbers in full, for they were counted, others
/// to four significant digits.
pub fn unsure(value: f64) -> String {
    whole_or(value, UNSURE_DIGITS)
}

fn whole_or(value: f64, digits: usize) -> String {
    if value.fract() == 0.0 && value.abs() < EXACT_INTEGERS {
        fixed(value, 0)
    } else {
        significant(value, digits)
    }
}

/// A number to this many significant digits, without trailing zeros.
pub fn significant(value: f64, digits: usize) -> String {
    let lead = leading_power(value, digits);
    let last = lead + 1 - digits as i32;
    if WRITTEN_OUT.contains(&lead) {
        trimmed(fixed(value, last))
    } else {
        let mantissa = trimmed(fixed(value / 10f64.powi(lead), last - lead));
        with_power(&mantissa, lead)
    }
}

/// `value ± error`, both cut at the second significant digit of the error.
///
/// An error of zero says that nothing was estimated; then the value stands alone.
pub fn with_error(value: f64, error: f64) -> String {
    if error <= 0.0 {
        return plain(value);
    }
    let last = leading_power(error, ERROR_DIGITS) + 1 - ERROR_DIGITS as i32;
    let larger = value.abs().max(error);
    let digits_kept = leading_power(larger, f64::DIGITS as usize) + 1 - last;
    let lead = leading_power(larger, digits_kept as usize);
    let pair = |scale: f64, last: i32| {
        let (value, error) = (fixed(value / scale, last), fixed(error / scale, last));
        format!("{value}{NO_BREAK_SPACE}±{NO_BREAK_SPACE}{error}")
    };
    if WRITTEN_OUT_WITH_ERROR.contains(&lead) {
        pair(1.0, last)
    } else {
        let mantissa = format!("({})", pair(10f64.powi(lead), last - lead));
        with_power(&mantissa, lead)
    }
}

/// A number followed by its unit, on the same line.
pub fn with_unit(number: &str, unit: &str) -> String {
    format!("{number}{NO_BREAK_SPACE}{unit}")
}

/// The power of ten of the leading digit, once the value is rounded to `digits` digits.
fn leading_power(value: f64, digits: usize) -> i32 {
    let scientific = format!("{value:.*e}", digits - 1);
    (scientific.split_once('e'))
        .and_then(|(_, power)| power.parse().ok())
        .unwrap_or(0)
}

/// The value written out down to the digit that counts `10^last`, grouped in threes from 10 000.
fn fixed(value: f64, last: i32) -> String {
    let decimals = usize::try_from(-last).unwrap_or(0);
    let size = match last {
        1.. => {
            let unit = 10f64.powi(last);
            (value.abs() / unit).round() * unit
        }
        _ => value.abs(),
    };
    let digits = format!("{size:.decimals$}");
    let (whole, fraction) = digits.split_at(digits.find('.').unwrap_or(digits.len()));
    let mut written = String::new();
    if value < 0.0 && digits.contains(|c: char| ('1'..='9').contains(&c)) {
        written.push(MINUS);
    }
    for (index, digit) in whole.char_indices() {
        if index > 0 && whole.len() > 4 && (whole.len() - index).is_multiple_of(3) {
            written.push(THIN_SPACE);
        }
        written.push(digit);
    }
    written + fraction
}

fn trimmed(number: String) -> String {
    if number.contains('.') {
        number
            .trim_end_matches('0')
            .trim_end_matches('.')
            .to_string()
    } else {
        number
    }
}

fn with_power(mantissa: &str, power: i32) -> String {
    let raised: String = power.to_string().chars().map(superscript).collect();
    format!("{mantissa}{NO_BREAK_SPACE}×{NO_BREAK_SPACE}10{raised}")
}

fn superscript(c: char) -> char {
    match c {
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '-' => '⁻',
        digit => digit
            .to_digit(10)
            .and_then(|digit| char::from_u32(0x2070 + digit))
            .unwrap_or(digit),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ordinary spaces, so that the expectations below can be read.
    fn spaced(number: String) -> String {
        number.replace([THIN_SPACE, NO_BREAK_SPACE], " ")
    }

    #[test]
    fn numbers_without_error() {
        for (value, written) in [
            (0.0, "0"),
            (-0.0, "0"),
            (4.0, "4"),
            (-3.0, "−3"),
            (9999.0, "9999"),
            (10000.0, "10 000"),
            (1_000_000.0, "1 000 000"),
            (1e15, "1 × 10¹⁵"),
            (0.0769231, "0.0769231"),
            (12350.1, "12 350.1"),
            (2.0 / 3.0, "0.6666667"),
            (-0.5, "−0.5"),
            (0.000123, "0.000123"),
            (0.0000123, "1.23 × 10⁻⁵"),
            (-4.5e-12, "−4.5 × 10⁻¹²"),
            (123456789.5, "1.234568 × 10⁸"),
            (9_999_999.9, "1 × 10⁷"),
        ] {
            assert_eq!(spaced(plain(value)), written);
        }
    }

    #[test]
    fn fewer_digits_round_the_whole_part_too() {
        for (value, written) in [
            (0.012345, "0.0123"),
            (65.04, "65"),
            (123456.0, "123 000"),
            (0.99999, "1"),
        ] {
            assert_eq!(spaced(significant(value, 3)), written);
        }
    }

    #[test]
    fn numbers_with_error() {
        for (value, error, written) in [
            (12345.0, 12.3, "12 345 ± 12"),
            (1234567.0, 12345.0, "1 235 000 ± 12 000"),
            (0.0769231, 3e-8, "0.076923100 ± 0.000000030"),
            (0.5, 0.0996, "0.50 ± 0.10"),
            (-2.5, 0.25, "−2.50 ± 0.25"),
            (-0.001, 0.5, "0.00 ± 0.50"),
            (0.0, 0.01, "0.000 ± 0.010"),
            (1e-9, 2.0, "0.0 ± 2.0"),
            (12345678.0, 12.0, "12 345 678 ± 12"),
            (1.2346e-5, 1.2e-7, "(1.235 ± 0.012) × 10⁻⁵"),
            (9.99999e-6, 1e-7, "(1.000 ± 0.010) × 10⁻⁵"),
            (3e12, 2.5e10, "(3.000 ± 0.025) × 10¹²"),
        ] {
            assert_eq!(spaced(with_error(value, error)), written);
        }
    }

    #[test]
    fn an_error_of_zero_leaves_the_value_alone() {
        assert_eq!(with_error(0.25, 0.0), "0.25");
    }

    #[test]
    fn spaces_never_break_a_line() {
        let written = with_unit(&with_error(-12345.0, 12.3), "rays");
        assert_eq!(written, "−12\u{202f}345\u{a0}±\u{a0}12\u{a0}rays");
    }
}
