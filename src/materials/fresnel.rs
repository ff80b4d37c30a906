//! How much light a smooth interface between two transparent media reflects.

/// Cosine of the refracted direction; `None` under total reflection.
///
/// * `cos_i` in `[0, 1]`: cosine of the incident direction with the normal.
/// * `eta > 0`: index of the far medium over the index of the near one.
/// * Method: Snell's law, `sin θ_t = sin θ_i / eta`.
pub fn cos_refracted(cos_i: f64, eta: f64) -> Option<f64> {
    let sin2_t = (1.0 - cos_i * cos_i) / (eta * eta);
    (sin2_t < 1.0).then(|| (1.0 - sin2_t).sqrt())
}

/// The share of unpolarised light reflected by a smooth dielectric interface; 1 under total
/// reflection, exactly 0 where both media are the same.
///
/// * `cos_i` in `[0, 1]` and `eta > 0` as in [`cos_refracted`].
/// * Source: Born, Wolf, Principles of Optics (7th ed. 1999), "Reflection and refraction of a
///   plane wave".
pub fn dielectric(cos_i: f64, eta: f64) -> f64 {
    if eta == 1.0 {
        return 0.0;
    }
    let Some(cos_t) = cos_refracted(cos_i, eta) else {
        return 1.0;
    };
    let parallel = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    let perpendicular = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    0.5 * (parallel * parallel + perpendicular * perpendicular)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_glass() {
        let cos = |degrees: f64| libm::cos(degrees.to_radians());
        for (cos_i, expected) in [
            (1.0, 0.04),
            (cos(45.0), 0.050_239_911),
            (cos(60.0), 0.089_186_713),
            (0.1, 0.571_592_520),
            (0.01, 0.943_752_543),
            (0.0, 1.0),
        ] {
            let f = dielectric(cos_i, 1.5);
            assert!((f - expected).abs() < 1e-8, "cos {cos_i}: {f}");
        }
    }

    #[test]
    fn both_ways_through_the_interface_lose_the_same() {
        for k in 1..100 {
            let cos_i = f64::from(k) / 100.0;
            let cos_t = cos_refracted(cos_i, 1.5).expect("no total reflection into glass");
            let there = dielectric(cos_i, 1.5);
            let back = dielectric(cos_t, 1.0 / 1.5);
            assert!((there - back).abs() < 1e-12, "{there} {back}");
        }
    }

    #[test]
    fn no_interface_reflects_nothing_at_any_angle() {
        for cos_i in [0.0, 1e-300, 1e-5, 0.3, 1.0] {
            assert_eq!(dielectric(cos_i, 1.0), 0.0);
        }
    }

    #[test]
    fn beyond_the_critical_angle_everything_comes_back() {
        // sin 41.8103° = 1 / 1.5.
        let cos = |degrees: f64| libm::cos(degrees.to_radians());
        assert_eq!(dielectric(cos(60.0), 1.0 / 1.5), 1.0);
        assert_eq!(dielectric(cos(41.82), 1.0 / 1.5), 1.0);
        assert!(dielectric(cos(41.80), 1.0 / 1.5) < 1.0);
    }

    #[test]
    fn the_mean_over_the_hemisphere() {
        // Cosine-weighted: ∫ F(c) 2c dc by the midpoint rule.
        let mean = |eta: f64| {
            let n = 200_000;
            let c = |k: i32| (f64::from(k) + 0.5) / f64::from(n);
            (0..n)
                .map(|k| dielectric(c(k), eta) * 2.0 * c(k))
                .sum::<f64>()
                / f64::from(n)
        };
        assert!((mean(1.5) - 0.091_778).abs() < 1e-5);
        assert!((mean(1.0 / 1.5) - 0.596_346).abs() < 1e-5);
    }
}
