//! Everything with an outline: where a ray crosses it, and the surface there.

use super::{Ellipse, FlatSurface};
use crate::numeric::{gamma, quadratic};
use glam::{DVec2, Vec2};

/// Bound on how far off a shape `f64` puts a point or sees a ray's origin, relative to the shape's
/// coordinates: 32 roundings, of which a dozen were counted.
const F64_ERROR: f32 = 16.0 * f64::EPSILON as f32;

/// Where a ray crosses a shape.
///
/// Both numbers are kept in `f64` until the nearest crossing is known: rounded to `f32`, a far
/// hit's distance would move the point along the shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intersection {
    /// Distance along the ray in units of its direction's length.
    pub t: f64,
    /// The point on the shape.
    pub p: DVec2,
}

/// Everything a ray can hit. To add a shape: a variant, and follow the compiler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A straight wall.
    Segment(Segment),
    /// A round wall.
    Circle(Circle),
    /// A stretched one.
    Ellipse(Ellipse),
}

impl Shape {
    /// The first crossing with `0 < t < t_max`.
    pub fn intersect(&self, origin: DVec2, direction: DVec2, t_max: f64) -> Option<Intersection> {
        match self {
            Shape::Segment(s) => s.intersect(origin, direction, t_max),
            Shape::Circle(c) => c.intersect(origin, direction, t_max),
            Shape::Ellipse(e) => e.intersect(origin, direction, t_max),
        }
    }

    /// The surface at a point of this shape, such as that of a crossing.
    pub fn surface(&self, p: DVec2) -> FlatSurface {
        match self {
            Shape::Segment(s) => s.surface(p),
            Shape::Circle(c) => c.surface(p),
            Shape::Ellipse(e) => e.surface(p),
        }
    }

    /// The smallest and largest coordinates.
    pub fn bounds(&self) -> [Vec2; 2] {
        match self {
            Shape::Segment(s) => [s.from.min(s.to), s.from.max(s.to)],
            Shape::Circle(c) => [c.center - c.radius, c.center + c.radius],
            Shape::Ellipse(e) => [e.center - e.axes, e.center + e.axes],
        }
    }
}

/// A straight wall; its normal is on the left of the way from the first end to the second.
///
/// The ends are rounded to `f32` one by one, so that walls which share a corner share its bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    from: Vec2,
    to: Vec2,
}

impl Segment {
    /// The segment of two ends; `None` where they are not finite in `f32`, or equal there.
    pub fn new(from: DVec2, to: DVec2) -> Option<Self> {
        let (from, to) = (from.as_vec2(), to.as_vec2());
        (from.is_finite() && to.is_finite() && from != to).then_some(Segment { from, to })
    }

    /// The ends, in order.
    pub fn ends(&self) -> [Vec2; 2] {
        [self.from, self.to]
    }

    /// The first crossing with `0 < t < t_max`.
    ///
    /// The ends lie on different sides of the ray, or one lies on it. Two segments that share an
    /// end compute the same number for it, bit for bit, so no ray slips between them.
    fn intersect(&self, origin: DVec2, direction: DVec2, t_max: f64) -> Option<Intersection> {
        let (from, to) = (self.from.as_dvec2(), self.to.as_dvec2());
        let side = |end: DVec2| direction.perp_dot(end - origin);
        let (first, second) = (side(from), side(to));
        let between = (first <= 0.0 && second >= 0.0) || (first >= 0.0 && second <= 0.0);
        // Equal means both zero: the segment is seen edge on. A NaN makes every comparison false.
        if !between || first == second {
            return None;
        }
        // The sign of the numerator tells on which side of the wall the ray begins, from the ends
        // as they are: a ray that has left the wall cannot meet it again.
        let along = to - from;
        let t = (from - origin).perp_dot(along) / (second - first);
        let p = from + along * (first / (first - second));
        (t > 0.0 && t < t_max).then_some(Intersection { t, p })
    }

    /// The surface at the share `s` in `[0, 1]` of the way from the first end to the second.
    pub fn surface_at(&self, s: f32) -> FlatSurface {
        let (from, to) = (self.from.as_dvec2(), self.to.as_dvec2());
        self.surface(from + (to - from) * f64::from(s))
    }

    fn surface(&self, p: DVec2) -> FlatSurface {
        let along = self.to.as_dvec2() - self.from.as_dvec2();
        let size = self.from.abs().max(self.to.abs());
        FlatSurface {
            p: p.as_vec2(),
            // One rounding to f32, one to spare, and those of f64, which matter only where a long
            // wall passes close to the world's origin.
            error: p.as_vec2().abs() * gamma(2) + size * F64_ERROR,
            n: along.perp().normalize().as_vec2(),
        }
    }
}

/// A round wall; its normal points outwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub center: Vec2,
    /// Its radius, positive.
    pub radius: f32,
}

impl Circle {
    /// The first crossing with `0 < t < t_max`.
    ///
    /// The discriminant comes from the distance between centre and line, as the sphere's does:
    /// `(f·d)² - f²d² = -(f × d)²`, which does not cancel for a small circle far away.
    fn intersect(&self, origin: DVec2, direction: DVec2, t_max: f64) -> Option<Intersection> {
        let (center, radius) = (self.center.as_dvec2(), f64::from(self.radius));
        let from_center = origin - center;
        let off_axis = from_center.perp_dot(direction);
        let a = direction.length_squared();
        let roots = quadratic(
            a * radius * radius - off_axis * off_axis,
            a,
            from_center.dot(direction),
            from_center.length_squared() - radius * radius,
        )?;
        let t = roots.ahead();
        (t > 0.0 && t < t_max).then(|| Intersection {
            t,
            p: center + (from_center + direction * t).normalize() * radius,
        })
    }

    /// The surface in the unit direction `n` from the centre.
    pub fn surface_towards(&self, n: DVec2) -> FlatSurface {
        self.surface(self.center.as_dvec2() + n * f64::from(self.radius))
    }

    fn surface(&self, p: DVec2) -> FlatSurface {
        FlatSurface {
            p: p.as_vec2(),
            error: p.as_vec2().abs() * gamma(2) + (self.center.abs() + self.radius) * F64_ERROR,
            n: (p - self.center.as_dvec2()).normalize().as_vec2(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_on_the_left() {
        let floor = Segment::new(DVec2::ZERO, DVec2::X).unwrap();
        assert_eq!(floor.surface_at(0.5).n, Vec2::Y);
        let ball = Circle {
            center: Vec2::ZERO,
            radius: 2.0,
        };
        assert_eq!(ball.surface_towards(DVec2::X).n, Vec2::X);
        assert_eq!(ball.surface_towards(DVec2::X).p, Vec2::new(2.0, 0.0));
    }

    #[test]
    fn what_cannot_be_a_segment() {
        assert_eq!(Segment::new(DVec2::ONE, DVec2::ONE), None);
        assert_eq!(Segment::new(DVec2::ONE, DVec2::splat(1.0 + 1e-12)), None);
        assert_eq!(Segment::new(DVec2::ZERO, DVec2::splat(1e40)), None);
    }

    #[test]
    fn a_segment_seen_edge_on_is_not_there() {
        let wall = Shape::Segment(Segment::new(DVec2::X, DVec2::X * 2.0).unwrap());
        assert_eq!(wall.intersect(DVec2::ZERO, DVec2::X, f64::INFINITY), None);
        let lifted = DVec2::new(1.0, 1e-9);
        assert!(wall.intersect(-DVec2::Y, lifted + DVec2::Y, 2.0).is_none());
        assert!(wall.intersect(-DVec2::Y, DVec2::ONE, 2.0).is_some());
    }

    #[test]
    fn the_reach_is_not_part_of_the_ray() {
        let wall = Shape::Segment(Segment::new(DVec2::X, DVec2::ONE).unwrap());
        let (from, to) = (DVec2::new(0.0, 0.5), DVec2::X);
        assert_eq!(wall.intersect(from, to, 1.0), None);
        let found = wall.intersect(from, to, 1.0 + 1e-15).unwrap();
        assert_eq!((found.t, found.p), (1.0, DVec2::new(1.0, 0.5)));
    }
}
