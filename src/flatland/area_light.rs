//! Shapes that glow, and how a point aims at them.

use super::{FlatSurface, Shape};
use crate::color::Rgb;
use glam::{DVec2, Vec2};

/// A part of the world that emits light on its front side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaLight {
    /// Its outline.
    pub shape: Shape,
    /// In W/(m·rad).
    pub radiance: Rgb,
    /// Index into [`FlatWorld::parts`](super::FlatWorld::parts).
    pub part: usize,
}

/// A point of a glowing shape, as drawn for another point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AreaLightSample {
    /// The point.
    pub surface: FlatSurface,
    /// The unit direction to it.
    pub wi: Vec2,
    /// The density of that direction, per radian.
    pub pdf: f32,
}

/// The angles in which a shape is seen.
struct View {
    /// Unit direction to its beginning.
    from: DVec2,
    /// How far it turns from there, counter-clockwise, in radians; positive.
    turn: f64,
}

impl AreaLight {
    /// Draws a point, uniformly in the angle at which `p` sees the shape's front; `None` where it
    /// does not see it.
    ///
    /// * Density: one over that angle, per radian ([`AreaLight::pdf`]).
    pub fn sample(&self, p: Vec2, u: f32) -> Option<AreaLightSample> {
        let View { from, turn } = self.view(p)?;
        let angle = f64::from(u) * turn;
        let toward = DVec2::new(libm::cos(angle), libm::sin(angle)).rotate(from);
        let surface = match &self.shape {
            Shape::Segment(s) => {
                let [a, b] = s.ends().map(|end| end.as_dvec2() - p.as_dvec2());
                let (first, second) = (toward.perp_dot(a), toward.perp_dot(b));
                s.surface_at((first / (first - second)).clamp(0.0, 1.0) as f32)
            }
            Shape::Circle(c) => {
                let center = c.center.as_dvec2() - p.as_dvec2();
                let radius = f64::from(c.radius);
                let off_axis = toward.perp_dot(center);
                let half_chord = (radius * radius - off_axis * off_axis).max(0.0).sqrt();
                let near = toward * (toward.dot(center) - half_chord);
                c.surface_towards((near - center).normalize())
            }
            Shape::Ellipse(_) => return None,
        };
        Some(AreaLightSample {
            surface,
            wi: toward.as_vec2(),
            pdf: self.pdf(p),
        })
    }

    /// Density of [`AreaLight::sample`] at every direction in which `p` sees the shape's front, per
    /// radian; 0 where it does not.
    pub fn pdf(&self, p: Vec2) -> f32 {
        self.view(p).map_or(0.0, |view| (1.0 / view.turn) as f32)
    }

    fn view(&self, p: Vec2) -> Option<View> {
        match &self.shape {
            Shape::Segment(s) => {
                let [a, b] = s.ends().map(|end| end.as_dvec2() - p.as_dvec2());
                // Seen from its left, the segment runs counter-clockwise.
                let turn = libm::atan2(a.perp_dot(b), a.dot(b));
                (turn > 0.0).then(|| View {
                    from: a.normalize(),
                    turn,
                })
            }
            Shape::Circle(c) => {
                let center = c.center.as_dvec2() - p.as_dvec2();
                let sin = f64::from(c.radius) / center.length();
                (sin < 1.0).then(|| {
                    let half = libm::asin(sin);
                    let back = DVec2::new(libm::cos(half), -libm::sin(half));
                    View {
                        from: back.rotate(center.normalize()),
                        turn: 2.0 * half,
                    }
                })
            }
            // No ellipse shines.
            Shape::Ellipse(_) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Circle, Segment};
    use super::*;

    fn glowing(shape: Shape) -> AreaLight {
        AreaLight {
            shape,
            radiance: Rgb::WHITE,
            part: 0,
        }
    }

    fn lamps() -> [AreaLight; 2] {
        let ceiling = Segment::new(DVec2::new(2.0, 1.0), DVec2::new(-1.0, 1.5));
        let ball = Circle {
            center: Vec2::new(0.5, 3.0),
            radius: 0.7,
        };
        [
            glowing(Shape::Segment(ceiling.expect("two ends"))),
            glowing(Shape::Circle(ball)),
        ]
    }

    #[test]
    fn points_are_on_the_shape_in_their_direction_and_evenly_spread() {
        for lamp in lamps() {
            let p = Vec2::new(0.2, -0.3);
            let all: Vec<_> = (0..=64)
                .map(|k| lamp.sample(p, k as f32 / 64.0).expect("seen"))
                .collect();
            for s in &all {
                let way = (s.surface.p - p).normalize();
                assert!((way - s.wi).length() < 1e-6, "{s:?}");
                assert!(s.surface.n.dot(s.wi) < 1e-3, "the front: {s:?}");
                let ray = (p.as_dvec2(), s.wi.as_dvec2());
                if let Some(met) = lamp.shape.intersect(ray.0, ray.1, f64::INFINITY) {
                    let off = (met.p.as_vec2() - s.surface.p).length();
                    // At the rim of a circle a small turn is a large step.
                    assert!(off < 2e-3, "{off}");
                }
            }
            let steps = all.windows(2).map(|w| w[0].wi.perp_dot(w[1].wi));
            for step in steps {
                assert!((step * 64.0 * all[0].pdf - 1.0).abs() < 1e-3, "{step}");
            }
        }
    }

    #[test]
    fn backs_and_insides_are_dark() {
        let [ceiling, ball] = lamps();
        for (lamp, p) in [
            (ceiling, Vec2::new(0.2, 4.0)),
            (ball, ball_center(&ball)),
            (ball, Vec2::new(0.5, 2.4)),
        ] {
            assert_eq!((lamp.sample(p, 0.5), lamp.pdf(p)), (None, 0.0));
        }
    }

    fn ball_center(ball: &AreaLight) -> Vec2 {
        match ball.shape {
            Shape::Circle(c) => c.center,
            Shape::Segment(s) => s.ends()[0],
            Shape::Ellipse(e) => e.center,
        }
    }
}
