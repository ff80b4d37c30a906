//! Factors that are often forgotten, by name.

use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, FRAC_PI_2, FRAC_PI_4, PI, SQRT_2, TAU};

/// The constants, and how they are written.
const NAMED: [(f64, &str); 14] = [
    (0.5, "1/2"),
    (0.25, "1/4"),
    (-1.0, "a wrong sign"),
    (PI, "π"),
    (FRAC_1_PI, "1/π"),
    (TAU, "2π"),
    (0.5 * FRAC_1_PI, "1/2π"),
    (2.0 * TAU, "4π"),
    (0.25 * FRAC_1_PI, "1/4π"),
    (FRAC_PI_2, "π/2"),
    (FRAC_2_PI, "2/π"),
    (FRAC_PI_4, "π/4"),
    (SQRT_2, "√2"),
    (PI * PI, "π²"),
];

/// The name of a factor, known to a per cent.
pub(super) fn name(factor: f64) -> Option<&'static str> {
    let close = |(value, _): &&(f64, &str)| (factor / value - 1.0).abs() < 0.01;
    NAMED.iter().find(close).map(|(_, name)| *name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_have_names_and_no_two_the_same() {
        for (value, text) in NAMED {
            assert_eq!(name(value * 1.004), Some(text));
        }
        assert_eq!(name(1.0), None);
        assert_eq!(name(f64::NAN), None);
    }
}
