//! Numbers as a learner types them.

use std::str::FromStr;

/// A number, and half a unit of its last digit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Typed {
    pub value: f64,
    pub half_unit: f64,
}

impl FromStr for Typed {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let value = number(text)?;
        let (digits, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let decimals = digits.split_once('.').map_or(0, |(_, d)| d.len());
        let power: f64 = power.parse().unwrap_or(0.0);
        let half_unit = 0.5 * libm::pow(10.0, power - decimals as f64);
        Ok(Typed { value, half_unit })
    }
}

fn number(text: &str) -> Result<f64, String> {
    let value = text.parse::<f64>().ok().filter(|x| x.is_finite());
    value.ok_or_else(|| "a finite number is needed, such as 0.6366".to_owned())
}

pub(super) fn error(text: &str) -> Result<f64, String> {
    let error = number(text)?;
    let right = error > 0.0;
    right
        .then_some(error)
        .ok_or_else(|| "a standard error is above 0".to_owned())
}

pub(super) fn albedo(text: &str) -> Result<f32, String> {
    between(text, 1.0, "an albedo is from 0 to 1")
}

pub(super) fn tilt(text: &str) -> Result<f32, String> {
    between(text, 90.0, "a tilt is from 0 to 90 degrees")
}

fn between(text: &str, most: f64, rule: &str) -> Result<f32, String> {
    let value = number(text)?;
    if (0.0..=most).contains(&value) {
        Ok(value as f32)
    } else {
        Err(rule.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_say_how_sure_a_number_is() {
        for (text, value, half) in [
            ("0.2026", 0.2026, 5e-5),
            ("1.000", 1.0, 5e-4),
            ("2", 2.0, 0.5),
            ("-6.4e-3", -0.0064, 5e-5),
            ("1.5E2", 150.0, 5.0),
        ] {
            let typed: Typed = text.parse().expect(text);
            assert_eq!(typed.value, value);
            assert!((typed.half_unit / half - 1.0).abs() < 1e-12, "{text}");
        }
        for text in ["", "nan", "inf", "1e999", "2/pi", "0,64"] {
            assert!(text.parse::<Typed>().is_err(), "{text}");
        }
    }
}
