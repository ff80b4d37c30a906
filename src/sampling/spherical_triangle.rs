//! Directions to a triangle, uniformly in solid angle.

use glam::DVec3;

/// A triangle seen from the origin, as one of directions.
#[derive(Clone, Copy, Debug)]
pub struct SphericalTriangle {
    /// Unit directions of the corners.
    corners: [DVec3; 3],
    solid_angle: f64,
    /// Sine and cosine of the angle at the first corner.
    alpha: (f64, f64),
}

impl SphericalTriangle {
    /// The triangle of three corners relative to the eye, in either order; `None` where it is seen
    /// edge-on, or a corner is where the eye is.
    pub fn new(corners: [DVec3; 3]) -> Option<Self> {
        let [a, b, c] = corners.map(DVec3::normalize_or_zero);
        let volume = a.dot(b.cross(c)).abs();
        // Van Oosterom, Strackee, The Solid Angle of a Plane Triangle (IEEE TBME 30(2), 1983).
        let solid_angle = 2.0 * libm::atan2(volume, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
        let (n_b, n_c) = (a.cross(b), a.cross(c));
        let sides = (n_b.length_squared() * n_c.length_squared()).sqrt();
        let alpha = (volume / sides, n_b.dot(n_c) / sides);
        (volume > 0.0 && sides > 0.0).then_some(SphericalTriangle {
            corners: [a, b, c],
            solid_angle,
            alpha,
        })
    }

    /// Its solid angle in sr.
    pub fn solid_angle(&self) -> f64 {
        self.solid_angle
    }

    /// Draws a direction.
    ///
    /// * Domain: `u` in `[0, 1)²` → unit direction within the triangle.
    /// * Density: the reciprocal of [`SphericalTriangle::solid_angle`], per steradian
    ///   ([`SphericalTriangle::pdf`]).
    /// * Method: the first uniform cuts off a triangle of that share of the solid angle by an arc
    ///   through the second corner, the second chooses a direction of the arc; the differences of
    ///   the paper as products, so that small triangles keep their digits.
    /// * Source: Arvo, Stratified Sampling of Spherical Triangles (SIGGRAPH 1995).
    pub fn sample(&self, u: [f32; 2]) -> DVec3 {
        let [a, b, c] = self.corners;
        let [share, along] = u.map(f64::from);
        let part = share * self.solid_angle;
        let (sin_alpha, cos_alpha) = self.alpha;
        let (sin_part, cos_part) = libm::sincos(part);
        let half = libm::sin(0.5 * part);
        let versed = 2.0 * half * half;
        // s = sin(part - α), t = cos(part - α), u = t - cos α, v = s + sin α (a·b).
        let s = sin_part * cos_alpha - cos_part * sin_alpha;
        let t = cos_part * cos_alpha + sin_part * sin_alpha;
        let u = sin_part * sin_alpha - versed * cos_alpha;
        let v =
            sin_part * cos_alpha + versed * sin_alpha - sin_alpha * 0.5 * (a - b).length_squared();
        // The cosine of the arc from a to the point where the cut meets the side towards c.
        let q = ((v * t - u * s) * cos_alpha - v) / ((v * s + u * t) * sin_alpha);
        let q = if q.is_nan() { 1.0 } else { q.clamp(-1.0, 1.0) };
        let cut = q * a + ((1.0 - q) * (1.0 + q)).sqrt() * across(c, a);
        let one_minus_z = along * 0.5 * (cut - b).length_squared();
        let z = 1.0 - one_minus_z;
        z * b + (one_minus_z * (1.0 + z)).max(0.0).sqrt() * across(cut, b)
    }

    /// Density of [`SphericalTriangle::sample`] inside the triangle, per steradian.
    pub fn pdf(&self) -> f64 {
        1.0 / self.solid_angle
    }
}

/// The unit direction of the part of `w` across `axis`; zero where there is none.
fn across(w: DVec3, axis: DVec3) -> DVec3 {
    (w - w.dot(axis) * axis).normalize_or_zero()
}
