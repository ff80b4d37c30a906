//! A point on a surface of the flat world, and the rays that leave it.

use crate::numeric::offset_origin;
use glam::Vec2;

/// A point on a surface with all that rays need to leave it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatSurface {
    /// The point, recomputed on the shape.
    pub p: Vec2,
    /// Bound on the rounding error of `p`, coordinate by coordinate, in scene units.
    pub error: Vec2,
    /// Unit normal on the shape's front side.
    pub n: Vec2,
}

impl FlatSurface {
    /// Where a ray that goes in `direction` starts: certainly on that side of the surface.
    pub fn leave(&self, direction: Vec2) -> Vec2 {
        // The third coordinate is zero throughout, and moving by nothing keeps it so.
        let [p, error, n, direction] =
            [self.p, self.error, self.n, direction].map(|v| v.extend(0.0));
        offset_origin(p, error, n, direction).truncate()
    }

    /// The normal of the side that the direction `w` leaves on.
    pub fn normal_towards(&self, w: Vec2) -> Vec2 {
        if self.n.dot(w) < 0.0 { -self.n } else { self.n }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_start_on_the_side_they_go_to() {
        let surface = FlatSurface {
            p: Vec2::new(1000.0, -3.0),
            error: Vec2::splat(1e-3),
            n: Vec2::new(0.6, 0.8),
        };
        for w in [surface.n, -surface.n] {
            let off = (surface.leave(w) - surface.p).dot(w);
            assert!((1.4e-3..2e-3).contains(&off), "{off}");
            assert_eq!(surface.normal_towards(w), w);
        }
    }
}
