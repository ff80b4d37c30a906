//! Lamps: points that shine, and that no ray can meet.

use crate::color::Rgb;
use glam::Vec2;
use std::f32::consts::TAU;

/// A point that shines the same in all directions of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Where it is.
    pub position: Vec2,
    /// Its power, in W.
    pub power: Rgb,
}

/// What arrives from a lamp at a point, if nothing stands in the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightAtPoint {
    /// Unit direction to the lamp.
    pub wi: Vec2,
    /// Distance to the lamp.
    pub distance: f32,
    /// Irradiance of a surface that faces the lamp, in W/m; the cosine is the caller's.
    pub irradiance: Rgb,
}

impl PointLight {
    /// Power per angle, `Φ / 2π`, in W/rad: a full circle has 2π of them, a sphere 4π.
    pub fn intensity(&self) -> Rgb {
        self.power * (1.0 / TAU)
    }

    /// The light that arrives at `p`: it fades with the distance, `I / r`, for it spreads over the
    /// edge of a circle. `None` where `p` is the lamp itself.
    pub fn light_at(&self, p: Vec2) -> Option<LightAtPoint> {
        let way = self.position - p;
        Some(LightAtPoint {
            wi: way.try_normalize()?,
            distance: way.length(),
            irradiance: self.intensity() * (1.0 / way.length()),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_power_arrives_at_a_circle_of_any_radius() {
        let lamp = PointLight {
            position: Vec2::new(3.0, 4.0),
            power: Rgb::grey(8.0),
        };
        for radius in [0.1, 5.0, 300.0] {
            let at = lamp.position - Vec2::new(0.6, 0.8) * radius;
            let light = lamp.light_at(at).unwrap();
            let total = light.irradiance.g * TAU * light.distance;
            assert!((total - 8.0).abs() < 1e-5, "{total}");
            assert!((light.wi - Vec2::new(0.6, 0.8)).length() < 1e-5);
        }
        assert_eq!(lamp.light_at(lamp.position), None);
    }
}
