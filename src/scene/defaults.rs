//! What a description says where a program leaves something out, as in `..Object::default()`.

use super::description::{Camera, Film, Light, Material, Render, Shape, Sky};
use super::textures::Textured;
use super::value::{
    Direction, Emission, Fov, NotNegative, Positive, Radiance, Shutter, Triple, Whole,
};

impl Default for Render {
    fn default() -> Self {
        Render {
            max_depth: Whole(12),
            spp: Whole(64),
        }
    }
}

/// A pinhole at the origin that looks along `-z`.
impl Default for Camera {
    fn default() -> Self {
        Camera {
            from: Triple::default(),
            to: Triple([0.0, 0.0, -1.0]),
            up: Direction::default(),
            fov: Fov::default(),
            lens_radius: NotNegative::default(),
            focus: None,
            shutter: Shutter::default(),
        }
    }
}

impl Default for Film {
    fn default() -> Self {
        Film { size: [256, 256] }
    }
}

/// Grey and diffuse.
impl Default for Material {
    fn default() -> Self {
        let albedo = Textured::default();
        Material::Lambert { albedo }
    }
}

/// The unit sphere.
impl Default for Shape {
    fn default() -> Self {
        Shape::Sphere {
            center: Triple::default(),
            radius: Positive::default(),
            inward: false,
        }
    }
}

/// A point at the origin.
impl Default for Light {
    fn default() -> Self {
        Light::Point {
            position: Triple::default(),
            intensity: Emission::default(),
        }
    }
}

/// Black.
impl Default for Sky {
    fn default() -> Self {
        Sky::Radiance(Radiance::default())
    }
}
