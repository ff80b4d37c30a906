//! Rough surfaces as many small mirrors: how their normals are spread, which of them one sees, and
//! how one draws among those.
//!
//! Everything is decided in `f64`, and `sin²` of a facet's angle is the sum `x² + y²`: as
//! `1 - cos²` it would have lost its digits just where a nearly smooth surface has its peak.
//!
//! Sources: Walter, Marschner, Li, Torrance, Microfacet Models for Refraction through Rough
//! Surfaces (EGSR 2007), section 5.2; Smith, Geometrical Shadowing of a Random Rough Surface (IEEE
//! Transactions on Antennas and Propagation 15(5), 1967), for the masking; Heitz, Sampling the GGX
//! Distribution of Visible Normals (JCGT 7(4), 2018), and Dupuy, Benyoub, Sampling Visible GGX
//! Normals with Spherical Caps (Computer Graphics Forum 42(8), 2023).

use crate::numeric;
use glam::DVec3;
use std::f32::consts::TAU;
use std::f64::consts::PI;

/// The distribution of normals of Trowbridge, Reitz and Walter et al., alike in all azimuths.
///
/// Directions `w` are unit and on the upper side, `w.z > 0`.
#[derive(Clone, Copy, Debug)]
pub struct Ggx {
    /// The roughness α in `(0, 1]`: about the root of the mean square slope, which itself is
    /// infinite.
    pub alpha: f64,
}

impl Ggx {
    /// `D(h)`, in 1/sr: the area of facets with normals around `h`, per solid angle and per area of
    /// the surface; `∫ D(h) h.z dh = 1`.
    ///
    /// * `h`: of any length but 0, `h.z >= 0`.
    pub fn d(&self, h: DVec3) -> f64 {
        let a2 = self.alpha * self.alpha;
        let sin2 = h.x * h.x + h.y * h.y;
        let cos2 = h.z * h.z;
        let spread = (a2 * cos2 + sin2) / (cos2 + sin2);
        a2 / (PI * spread * spread)
    }

    /// The share in `[0, 1]` of the facets turned to `w` that no other facet hides from there.
    pub fn g1(&self, w: DVec3) -> f64 {
        w.z * self.g1_per_cos(w)
    }

    /// `G1(w) / w.z`, which stays finite where `w` grazes the surface.
    pub fn g1_per_cos(&self, w: DVec3) -> f64 {
        let slope2 = self.alpha * self.alpha * (w.x * w.x + w.y * w.y);
        2.0 / (w.z + (w.z * w.z + slope2).sqrt())
    }

    /// Draws the normal of a facet that is seen from `w`.
    ///
    /// * Domain: `u` in `[0, 1)²` → unit `h` with `h.z > 0` and `h · w >= 0`.
    /// * Density: `G1(w) (w · h) D(h) / w.z`, per steradian ([`Ggx::pdf_visible`]).
    /// * Method: stretched by 1/α the facets are those of a hemisphere, whose mirror turns `w` into
    ///   every direction of a spherical cap alike. Draw that, take the half vector, stretch back.
    ///   Nothing cancels: the half vector's height is `(1 - u₀) (1 + w.z)`.
    /// * Source: Dupuy, Benyoub (2023), listing 3.
    pub fn sample_visible(&self, w: DVec3, u: [f32; 2]) -> DVec3 {
        let stretch = DVec3::new(self.alpha, self.alpha, 1.0);
        let w = (w * stretch).normalize();
        let below = f64::from(u[0]) * (1.0 + w.z);
        let r = (below * (2.0 - below)).max(0.0).sqrt();
        let (sin, cos) = numeric::sin_cos(TAU * u[1]);
        let h = DVec3::new(
            w.x + r * f64::from(cos),
            w.y + r * f64::from(sin),
            1.0 + w.z - below,
        );
        (h * stretch).normalize()
    }

    /// Density of [`Ggx::sample_visible`] at the unit normal `h`, per steradian.
    pub fn pdf_visible(&self, w: DVec3, h: DVec3) -> f64 {
        self.g1_per_cos(w) * w.dot(h).max(0.0) * self.d(h)
    }
}
