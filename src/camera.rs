//! A pinhole camera.

use crate::geometry::Ray;
use glam::{DVec3, Vec2, Vec3};

/// A perspective camera with an infinitely small hole: every ray starts at one point.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    origin: Vec3,
    forward: Vec3,
    /// Half the width of the image plane at distance 1, to the right.
    right: Vec3,
    /// Half the height of the image plane at distance 1, upwards.
    up: Vec3,
}

impl Camera {
    /// A camera at `origin` that looks along `forward`.
    ///
    /// * `fov`: the full angle across the image height, in radians, in `(0, π)`.
    /// * `aspect`: image width over height.
    /// * `None` where `forward` is zero or `up` is parallel to it: the picture has no upright then.
    pub fn new(origin: Vec3, forward: DVec3, up: DVec3, fov: f64, aspect: f64) -> Option<Self> {
        let forward = forward.try_normalize()?;
        // The sine of the angle between the two; below it no digit of `right` is left.
        let right = forward.cross(up.try_normalize()?);
        if right.length() < 1e-9 {
            return None;
        }
        let right = right.normalize();
        let half_height = libm::tan(fov / 2.0);
        Some(Camera {
            origin,
            forward: forward.as_vec3(),
            right: (right * half_height * aspect).as_vec3(),
            up: (right.cross(forward) * half_height).as_vec3(),
        })
    }

    /// The ray through film position `(s, t)` in `[0, 1]²`: `s` to the right, `t` downwards.
    pub fn ray(&self, s: f32, t: f32) -> Ray {
        let toward = self.forward + self.right * (2.0 * s - 1.0) + self.up * (1.0 - 2.0 * t);
        Ray::new(self.origin, toward.normalize())
    }

    /// The unit direction of view.
    pub fn forward(&self) -> Vec3 {
        self.forward
    }

    /// Area of the film at distance 1.
    pub fn film_area(&self) -> f32 {
        4.0 * self.right.length() * self.up.length()
    }

    /// The film position `(s, t)` in `[0, 1)²` seen in `direction`; `None` outside the picture.
    pub fn film_position(&self, direction: Vec3) -> Option<[f32; 2]> {
        let depth = direction.dot(self.forward);
        let along = |axis: Vec3| direction.dot(axis) / (depth * axis.length_squared());
        let s = 0.5 * (1.0 + along(self.right));
        let t = 0.5 * (1.0 - along(self.up));
        let on_film = depth > 0.0 && (0.0..1.0).contains(&s) && (0.0..1.0).contains(&t);
        on_film.then_some([s, t])
    }

    /// The point `offset` to the right and up from the camera's origin, across its view.
    pub fn beside(&self, offset: Vec2) -> Vec3 {
        self.origin + self.right.normalize() * offset.x + self.up.normalize() * offset.y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_corners_of_a_square_picture() {
        let camera = Camera::new(Vec3::ZERO, DVec3::Z, DVec3::Y, 90_f64.to_radians(), 1.0)
            .expect("a proper camera");
        // Looking along +z with y up, the image's right is -x.
        let top_left = camera.ray(0.0, 0.0).direction;
        let expected = Vec3::new(1.0, 1.0, 1.0).normalize();
        assert!((top_left - expected).length() < 1e-6, "{top_left}");
        assert!((camera.ray(0.5, 0.5).direction - Vec3::Z).length() < 1e-6);
    }

    #[test]
    fn a_direction_finds_its_way_back_to_the_film() {
        let up = DVec3::new(0.1, 1.0, 0.0);
        let camera = Camera::new(Vec3::ZERO, DVec3::new(1.0, -0.3, 2.0), up, 0.7, 1.5)
            .expect("a proper camera");
        for (s, t) in [(0.1, 0.2), (0.5, 0.5), (0.99, 0.01)] {
            let [u, v] = camera
                .film_position(camera.ray(s, t).direction)
                .expect("on the film");
            assert!((s - u).abs() < 1e-6 && (t - v).abs() < 1e-6, "{u} {v}");
        }
        assert_eq!(camera.film_position(camera.ray(1.1, 0.5).direction), None);
        assert_eq!(camera.film_position(-camera.ray(0.5, 0.5).direction), None);
    }

    #[test]
    fn no_upright_no_camera() {
        let looking = |forward, up| Camera::new(Vec3::ZERO, forward, up, 1.0, 1.0);
        assert!(looking(DVec3::Y, DVec3::Y).is_none());
        assert!(looking(DVec3::Y, -DVec3::Y).is_none());
        assert!(looking(DVec3::ZERO, DVec3::Y).is_none());
        assert!(looking(DVec3::Z, DVec3::ZERO).is_none());
        assert!(looking(DVec3::Z, DVec3::Y).is_some());
    }
}
