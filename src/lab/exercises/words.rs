//! Numbers and words of a report.

use super::question::Reading;

/// A reading with its error, to two digits of it.
pub(super) fn shown(reading: &Reading) -> String {
    if reading.error == 0.0 {
        return digits(reading.value);
    }
    let decimals = (1.0 - libm::log10(reading.error).floor()).clamp(0.0, 12.0) as usize;
    format!(
        "{:.decimals$} ± {:.decimals$}",
        reading.value, reading.error
    )
}

/// A number with five digits.
pub(super) fn digits(x: f64) -> String {
    match x.abs() {
        0.0 => "0".to_owned(),
        1e-3..1e5 => {
            let decimals = (4.0 - libm::log10(x.abs()).floor()).clamp(0.0, 8.0) as usize;
            let text = format!("{x:.decimals$}");
            match text.contains('.') {
                true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
                false => text,
            }
        }
        _ => format!("{x:.3e}"),
    }
}

pub(super) fn upper(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_the_digits_that_are_known() {
        let reading = |value, error| {
            shown(&Reading {
                value,
                error,
                ..Reading::default()
            })
        };
        assert_eq!(reading(0.625_12, 0.001_2), "0.6251 ± 0.0012");
        assert_eq!(reading(12.75, 0.3), "12.75 ± 0.30");
        assert_eq!(reading(0.5, 0.0), "0.5");
        for (x, text) in [
            (0.0, "0"),
            (1.0, "1"),
            (-2.0 / 3.0, "-0.66667"),
            (1234.56, "1234.6"),
            (20_000.0, "20000"),
            (1.5e-7, "1.500e-7"),
        ] {
            assert_eq!(digits(x), text);
        }
        assert_eq!(upper("the mean of x²"), "The mean of x²");
    }
}
