//! The quadratic equation of a ray and a sphere.

/// The real roots of a quadratic, `near <= far`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roots {
    /// The smaller root.
    pub near: f64,
    /// The larger root.
    pub far: f64,
}

impl Roots {
    /// The smaller root that is positive, or else the larger root, positive or not.
    #[inline(always)]
    pub fn ahead(self) -> f64 {
        if self.near > 0.0 { self.near } else { self.far }
    }
}

// ANCHOR: quadratic
/// Solves `a t² + 2 h t + c = 0` for real `t`; `None` where there is none or `a` is zero.
///
/// * Arguments: `h` is *half* the linear coefficient, as it falls out of `|o + t d - c|² = r²`, and
///   `discriminant` is `h² - a c`: the caller has it, because that difference cancels where a better
///   form does not, as for a small sphere far away.
/// * Method: `q = -(h + sign(h) √(h² - a c))`, roots `q / a` and `c / q`, so that no difference of
///   nearly equal numbers is taken here.
/// * Source: Press et al., Numerical Recipes (3rd ed. 2007), "Quadratic and Cubic Equations".
pub fn quadratic(discriminant: f64, a: f64, h: f64, c: f64) -> Option<Roots> {
    // Written so that a NaN in any coefficient counts as "no root".
    if !(discriminant >= 0.0 && a != 0.0) {
        return None;
    }
    let root = discriminant.sqrt();
    let q = if h < 0.0 { root - h } else { -root - h };
    // q is zero only when h and c both are: a double root at the origin.
    let (t0, t1) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    Some(if t0 <= t1 {
        Roots { near: t0, far: t1 }
    } else {
        Roots { near: t1, far: t0 }
    })
}
// ANCHOR_END: quadratic

#[cfg(test)]
mod tests {
    use super::*;

    /// With the discriminant as it stands.
    fn solve(a: f64, h: f64, c: f64) -> Option<Roots> {
        quadratic(h * h - a * c, a, h, c)
    }

    #[test]
    fn keeps_the_small_root_that_the_school_formula_loses() {
        // Roots 1e-9 and 1e9: -h - sqrt(h² - c) is 0 to 16 digits, c / q is not.
        let roots = solve(1.0, -0.5 * (1e9 + 1e-9), 1.0).expect("two roots");
        assert!((roots.near - 1e-9).abs() < 1e-24, "{roots:?}");
        assert!((roots.far - 1e9).abs() < 1e-6, "{roots:?}");
    }

    #[test]
    fn refuses_what_has_no_root() {
        assert_eq!(solve(1.0, 0.0, 1.0), None);
        assert_eq!(solve(0.0, 1.0, 1.0), None);
        assert_eq!(solve(f64::NAN, 1.0, 1.0), None);
        assert_eq!(solve(1.0, f64::NAN, 1.0), None);
    }

    #[test]
    fn a_double_root_at_the_origin_is_two_zeros() {
        assert_eq!(
            solve(2.0, 0.0, 0.0),
            Some(Roots {
                near: 0.0,
                far: 0.0
            })
        );
    }
}
