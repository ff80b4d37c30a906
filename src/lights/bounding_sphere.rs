//! Balls around what light passes or is aimed at.

use crate::geometry::Aabb;
use glam::Vec3;
use std::f64::consts::PI;

/// A ball around something: light from infinitely far away passes that around the scene, and rays are aimed at
/// those around what focuses light.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoundingSphere {
    /// Its centre.
    pub center: Vec3,
    /// Its radius, in scene units; 0 where there is nothing.
    pub radius: f32,
}

/// Radii are rounded outwards by this.
const OUTWARDS: f32 = 1.0 + 4.0 * f32::EPSILON;

impl BoundingSphere {
    /// The ball around a box.
    pub fn of(bounds: Aabb) -> Self {
        if !bounds.is_finite() {
            return BoundingSphere::default();
        }
        let center = bounds.center();
        let radius = (bounds.max - center)
            .length()
            .max((center - bounds.min).length());
        BoundingSphere {
            center,
            radius: radius * OUTWARDS,
        }
    }

    /// A ball around balls, in the middle of the box around them; `None` around none, and where it is not finite.
    pub fn around(balls: &[BoundingSphere]) -> Option<Self> {
        let of = |ball: &BoundingSphere| Aabb {
            min: ball.center - ball.radius,
            max: ball.center + ball.radius,
        };
        let bounds = balls.iter().map(of).reduce(Aabb::union)?;
        let center = bounds.center();
        let reach = |ball: &BoundingSphere| (ball.center - center).length() + ball.radius;
        let radius = balls.iter().map(reach).fold(0.0, f32::max) * OUTWARDS;
        radius
            .is_finite()
            .then_some(BoundingSphere { center, radius })
    }

    /// Area of its cross-section.
    pub(super) fn disc(&self) -> f64 {
        PI * f64::from(self.radius).powi(2)
    }
}
