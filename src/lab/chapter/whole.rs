//! Whole numbers as people type them.

use std::fmt::Display;
use std::ops::RangeInclusive;

/// A reader of whole numbers within `range`, for the command line: `1000`, `1e3` and `1_000` are the
/// same, and what is refused is told which are allowed.
pub fn whole<T>(
    range: RangeInclusive<T>,
) -> impl Fn(&str) -> Result<T, String> + Clone + Send + Sync + 'static
where
    T: TryFrom<u64> + PartialOrd + Display + Clone + Send + Sync + 'static,
{
    move |text| {
        let value = number(text).and_then(|n| T::try_from(n).ok());
        value.filter(|n| range.contains(n)).ok_or_else(|| {
            format!(
                "a whole number from {} to {} is needed",
                range.start(),
                range.end()
            )
        })
    }
}

/// Below this, every whole number is an `f64`.
const EXACT: f64 = 9_007_199_254_740_992.0;

fn number(text: &str) -> Option<u64> {
    let plain = text.replace('_', "");
    if plain.bytes().all(|b| b.is_ascii_digit()) {
        return plain.parse().ok();
    }
    let value: f64 = plain.parse().ok()?;
    (value.fract() == 0.0 && (0.0..EXACT).contains(&value)).then_some(value as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_may_be_written_with_a_power_of_ten() {
        let read = whole(1..=65_536_u32);
        for (text, value) in [
            ("1000", 1000),
            ("1e3", 1000),
            ("6.4E4", 64_000),
            ("4_096", 4096),
        ] {
            assert_eq!(read(text), Ok(value), "{text}");
        }
        for text in [
            "", "0", "-1", "1e-3", "1.5", "1e9", "inf", "nan", "many", "65537",
        ] {
            let why = read(text).unwrap_err();
            assert_eq!(why, "a whole number from 1 to 65536 is needed", "{text}");
        }
        let most = u64::MAX.to_string();
        assert_eq!(whole(0..=u64::MAX)(&most), Ok(u64::MAX));
        assert!(whole(0..=u64::MAX)("18446744073709551616").is_err());
    }
}
