//! Who looks: a pinhole, or a thin lens in its place.

use crate::geometry::Ray;
use crate::sampling::stream::{Purpose, Stream};
use crate::sampling::warps;
use glam::{DVec3, Vec2, Vec3};

/// A perspective camera. With a pinhole every ray starts at one point and all is sharp; with a thin
/// lens rays start all over its disk, and only what is in the plane of focus is sharp.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    origin: Vec3,
    forward: Vec3,
    /// Half the height of the image plane at distance 1, but to the right.
    across: DVec3,
    /// Half the width of the image plane at distance 1, to the right.
    right: Vec3,
    /// Half the height of the image plane at distance 1, upwards.
    up: Vec3,
    lens: Option<Lens>,
}

/// An ideal thin lens: all light from a point of the plane of focus that meets the lens comes
/// together in one point of the film.
///
/// A point at depth `z` is spread over a disk which, measured in the plane at `z`, has the
/// lens's radius times `|z - focus| / focus`.
///
/// Source: Cook, Porter, Carpenter, Distributed Ray Tracing (SIGGRAPH 1984), "Depth of field".
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// Radius of the disk in scene units, positive.
    pub radius: f32,
    /// Distance of the plane of focus along the direction of view, positive; may be infinite.
    pub focus: f32,
}

/// How light enters the eye.
#[derive(Clone, Copy, Debug)]
pub struct Connection {
    /// Where it enters, in coordinates of the scene.
    pub point: Vec3,
    /// The film position `(s, t)` in `[0, 1)²` on which it falls.
    pub film: [f32; 2],
    /// The mean radiance over the whole film, in W/(m² sr), of one W/sr that goes to the point from the unit
    /// distance; it falls with the square of the distance.
    pub importance: f32,
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
        let across = right * half_height;
        Some(Camera {
            origin,
            forward: forward.as_vec3(),
            across,
            right: (across * aspect).as_vec3(),
            up: (right.cross(forward) * half_height).as_vec3(),
            lens: None,
        })
    }

    /// The same camera for an image of another shape; its angle across the height stays.
    ///
    /// * `aspect`: image width over height.
    #[must_use]
    pub fn with_aspect(self, aspect: f64) -> Self {
        Camera {
            right: (self.across * aspect).as_vec3(),
            ..self
        }
    }

    /// The same camera with a lens, or with a pinhole.
    #[must_use]
    pub fn with_lens(self, lens: Option<Lens>) -> Self {
        Camera { lens, ..self }
    }

    /// The lens, if there is one.
    pub fn lens(&self) -> Option<Lens> {
        self.lens
    }

    /// From the middle of the pupil to the point of the image plane at distance 1.
    fn toward(&self, s: f32, t: f32) -> Vec3 {
        self.forward + self.right * (2.0 * s - 1.0) + self.up * (1.0 - 2.0 * t)
    }

    /// The ray through film position `(s, t)` in `[0, 1]²`, `s` to the right and `t` downwards, and
    /// through the pinhole or the middle of the lens.
    pub fn ray(&self, s: f32, t: f32) -> Ray {
        Ray::new(self.origin, self.toward(s, t).normalize())
    }

    /// Where it is, and the middle of the image plane at distance 1 seen from there, half its width to the right and
    /// half its height upwards; `None` where it has a lens.
    pub fn pinhole(&self) -> Option<[Vec3; 4]> {
        let all = [self.origin, self.forward, self.right, self.up];
        self.lens.is_none().then_some(all)
    }

    /// A ray through film position `(s, t)` and a uniform point of the lens; a pinhole draws no
    /// number.
    pub fn sample_ray(&self, s: f32, t: f32, stream: &Stream) -> Ray {
        let Some(lens) = self.lens else {
            return self.ray(s, t);
        };
        let on_disk = warps::sample_disk_concentric(stream.at(0, Purpose::Lens).two());
        let aside = self.across(on_disk * lens.radius);
        // From a point of the lens to the point of focus, in units of the distance of focus, so
        // that a lens focused at infinity sends parallel rays.
        let toward = self.toward(s, t) - aside / lens.focus;
        Ray::new(self.origin + aside, toward.normalize())
    }

    /// A point of the pupil for light from the point `p`, and the place of the film that it falls on;
    /// `None` outside the picture.
    ///
    /// * `u` in `[0, 1)²`: a uniform point of the lens; a pinhole does not look at it.
    pub fn connect(&self, p: Vec3, u: [f32; 2]) -> Option<Connection> {
        let aside = match self.lens {
            Some(lens) => self.across(warps::sample_disk_concentric(u) * lens.radius),
            None => Vec3::ZERO,
        };
        let point = self.origin + aside;
        let direction = (p.as_dvec3() - point.as_dvec3()).try_normalize()?.as_vec3();
        let cos = direction.dot(self.forward);
        let focus = self.lens.map_or(f32::INFINITY, |lens| lens.focus);
        let film = self.film_position(direction / cos + aside / focus)?;
        (cos > 0.0).then(|| Connection {
            point,
            film,
            // Of each watt per square metre that the pupil faces, dω = cos³ θ dA of the film at distance 1.
            importance: 1.0 / (self.film_area() * cos.powi(3)),
        })
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
        self.origin + self.across(offset)
    }

    fn across(&self, offset: Vec2) -> Vec3 {
        self.right.normalize() * offset.x + self.up.normalize() * offset.y
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
    fn all_rays_of_a_lens_meet_in_the_plane_of_focus() {
        let pinhole = Camera::new(Vec3::ZERO, DVec3::Z, DVec3::Y, 0.7, 1.5).expect("a camera");
        let (radius, focus) = (0.25, 4.0);
        let camera = pinhole.with_lens(Some(Lens { radius, focus }));
        // Where a ray of the sample passes the plane at depth z.
        let at = |camera: &Camera, z: f32, sample| {
            let ray = camera.sample_ray(0.3, 0.6, &Stream::new(1, 0, sample));
            ray.at((z - ray.origin.z) / ray.direction.z)
        };
        let sharp = pinhole.ray(0.3, 0.6);
        let mut widest = 0.0_f32;
        for sample in 0..1000 {
            let in_focus = sharp.at(focus / sharp.direction.z);
            assert!((at(&camera, focus, sample) - in_focus).length() < 2e-6);
            let behind = sharp.at(6.0 / sharp.direction.z);
            widest = widest.max((at(&camera, 6.0, sample) - behind).length());
        }
        // A |z - f| / f, half of it to either side.
        let confusion = radius * (6.0 - focus) / focus;
        assert!(
            widest <= confusion * 1.00001 && widest > 0.98 * confusion,
            "{widest}"
        );

        // Focused at infinity all rays are parallel; without a lens no number is drawn.
        let parallel = pinhole.with_lens(Some(Lens {
            radius,
            focus: f32::INFINITY,
        }));
        let stream = Stream::new(1, 0, 5);
        let ray = parallel.sample_ray(0.3, 0.6, &stream);
        assert_eq!(ray.direction, sharp.direction);
        assert!(ray.origin != Vec3::ZERO);
        let through_hole = pinhole.sample_ray(0.3, 0.6, &stream);
        assert_eq!(
            (through_hole.origin, through_hole.direction),
            (sharp.origin, sharp.direction)
        );
        // The middle of the lens is where the hole was.
        let middle = camera.sample_ray(0.3, 0.6, &stream.fixing(&[Purpose::Lens]));
        assert_eq!(
            (middle.origin, middle.direction),
            (sharp.origin, sharp.direction)
        );
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
