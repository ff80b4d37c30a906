//! An ellipse along the axes: the curve whose foci mirrors and glass know.

use super::{FlatSurface, Intersection};
use crate::numeric::{gamma, quadratic};
use glam::{DVec2, Vec2};

/// A closed wall that is the unit circle, stretched along both axes; its normal points outwards.
///
/// What comes from one focus an elliptic mirror sends to the other. Glass of index `n` whose ellipse has the
/// eccentricity `1/n` sends rays parallel to its long axis to the far focus, exactly: Descartes, La
/// Dioptrique (1637), eighth discourse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ellipse {
    /// Its centre.
    pub center: Vec2,
    /// Half its width and half its height, positive.
    pub axes: Vec2,
}

impl Ellipse {
    /// The foci, on the longer axis; both are the centre of a circle.
    pub fn foci(&self) -> [DVec2; 2] {
        let [a, b] = self.axes.as_dvec2().to_array();
        let off = (a * a - b * b).abs().sqrt();
        let along = if a > b { DVec2::X } else { DVec2::Y };
        [-1.0, 1.0].map(|side| self.center.as_dvec2() + along * (side * off))
    }

    /// Distance of a focus from the centre, over the longer half axis; in `[0, 1)`.
    pub fn eccentricity(&self) -> f64 {
        let [a, b] = self.axes.as_dvec2().to_array();
        (1.0 - (a.min(b) / a.max(b)).powi(2)).sqrt()
    }

    /// The first crossing with `0 < t < t_max`: that of the circle in coordinates that are not stretched.
    pub(super) fn intersect(
        &self,
        origin: DVec2,
        direction: DVec2,
        t_max: f64,
    ) -> Option<Intersection> {
        let (center, axes) = (self.center.as_dvec2(), self.axes.as_dvec2());
        let (o, d) = ((origin - center) / axes, direction / axes);
        let off_axis = o.perp_dot(d);
        let a = d.length_squared();
        let roots = quadratic(
            a - off_axis * off_axis,
            a,
            o.dot(d),
            o.length_squared() - 1.0,
        )?;
        let t = roots.ahead();
        (t > 0.0 && t < t_max).then(|| Intersection {
            t,
            p: center + (o + d * t).normalize() * axes,
        })
    }

    /// The surface at the angle of the circle that it is stretched from, in radians.
    pub fn surface_at(&self, angle: f64) -> FlatSurface {
        let (sin, cos) = libm::sincos(angle);
        self.surface(self.center.as_dvec2() + DVec2::new(cos, sin) * self.axes.as_dvec2())
    }

    pub(super) fn surface(&self, p: DVec2) -> FlatSurface {
        let axes = self.axes.as_dvec2();
        let size = self.center.abs() + self.axes.max_element();
        // Stretched back and forth: a few roundings more than of a circle.
        let f64_error = size * (32.0 * f64::EPSILON as f32);
        FlatSurface {
            p: p.as_vec2(),
            error: p.as_vec2().abs() * gamma(2) + f64_error,
            n: ((p - self.center.as_dvec2()) / (axes * axes))
                .normalize()
                .as_vec2(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{FlatSpecular, frame};
    use super::*;
    use crate::color::Rgb;
    use std::f64::consts::TAU;

    /// Where a ray goes on from the surface that it meets, by the branch that is asked for.
    fn next(ellipse: &Ellipse, specular: FlatSpecular, o: DVec2, d: DVec2) -> (DVec2, DVec2) {
        let met = ellipse.intersect(o, d, f64::INFINITY).expect("a hit");
        let surface = ellipse.surface(met.p);
        let axes = frame(surface.n);
        let both = specular.specular(axes.transpose() * -d.as_vec2());
        let branch = match specular {
            FlatSpecular::Mirror { .. } => both.reflected,
            FlatSpecular::Glass { .. } => both.transmitted,
        };
        let wi = branch.expect("a branch").wi;
        let out = axes * Vec2::new(wi.x, wi.z);
        (met.p, out.as_dvec2().normalize())
    }

    /// How far a line passes a point by.
    fn off(point: DVec2, (o, d): (DVec2, DVec2)) -> f64 {
        d.perp_dot(point - o).abs()
    }

    #[test]
    fn a_mirror_sends_one_focus_to_the_other() {
        for axes in [Vec2::new(2.0, 1.2), Vec2::new(0.7, 1.5)] {
            let ellipse = Ellipse {
                center: Vec2::new(0.5, -1.0),
                axes,
            };
            let [near, far] = ellipse.foci();
            let white = FlatSpecular::Mirror {
                reflectance: Rgb::WHITE,
            };
            for k in 0..200 {
                let (sin, cos) = libm::sincos(TAU * f64::from(k) / 200.0 + 0.01);
                let ray = next(&ellipse, white, near, DVec2::new(cos, sin));
                assert!(off(far, ray) < 1e-6, "{axes} {k}: {}", off(far, ray));
                assert!(off(near + DVec2::splat(0.1), ray) > 1e-6);
            }
        }
    }

    #[test]
    fn glass_of_the_right_eccentricity_focuses_a_beam() {
        let ior = 1.5_f32;
        // Half the width is 1, and the foci 1/n from the centre.
        let height = (1.0 - 1.0 / f64::from(ior).powi(2)).sqrt();
        let right = Ellipse {
            center: Vec2::ZERO,
            axes: Vec2::new(1.0, height as f32),
        };
        assert!((right.eccentricity() * f64::from(ior) - 1.0).abs() < 1e-6);
        let wrong = Ellipse {
            axes: Vec2::new(1.0, 0.7),
            ..right
        };
        let worst = |ellipse: &Ellipse| {
            let past = |k: i32| {
                let y = height * 0.9 * f64::from(k) / 50.0;
                let o = DVec2::new(-3.0, y);
                let glass = FlatSpecular::Glass { ior };
                off(ellipse.foci()[1], next(ellipse, glass, o, DVec2::X))
            };
            (-50..=50).map(past).fold(0.0, f64::max)
        };
        assert!(worst(&right) < 1e-6, "{}", worst(&right));
        assert!(worst(&wrong) > 0.01, "{}", worst(&wrong));
    }

    #[test]
    fn a_stretched_circle_is_met_where_it_is() {
        let ellipse = Ellipse {
            center: Vec2::new(1.0, 2.0),
            axes: Vec2::new(3.0, 0.5),
        };
        for k in 0..100 {
            let surface = ellipse.surface_at(TAU * f64::from(k) / 100.0 + 0.003);
            let (p, n) = (surface.p.as_dvec2(), surface.n.as_dvec2());
            let from = p + n;
            let met = ellipse.intersect(from, -n, 5.0).expect("a hit");
            assert!(met.p.distance(p) < 1e-6 && (met.t - 1.0).abs() < 1e-6);
            // From inside, the other way round.
            let inside = surface.leave(-surface.n).as_dvec2();
            let out = ellipse.intersect(inside, n, 5.0).expect("a hit");
            assert!(out.p.distance(p) < 1e-5, "{} {p}", out.p);
            let gone = surface.leave(surface.n).as_dvec2();
            assert_eq!(ellipse.intersect(gone, n, 50.0), None);
        }
    }
}
