//! Random inputs of the hard cases, from fixed seeds.

use glam::{DVec3, Vec3};
use halfdisk::geometry::{Quad, Ray, Shape, Sphere, Triangle};
use halfdisk::sampling::frame::Frame;
use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::sampling::warps;
use std::f64::consts::TAU;

/// A run of random inputs.
pub struct Draw(Numbers);

impl Draw {
    /// The run number `index` of a test's seed.
    pub fn new(seed: u64, index: u32) -> Self {
        Draw(Stream::new(seed, index, 0).at(0, Purpose::Direction))
    }

    /// A uniform in `[0, 1)`.
    pub fn one(&mut self) -> f32 {
        self.0.one()
    }

    /// A uniform between two numbers.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.one()
    }

    /// A whole number below `end`.
    pub fn below(&mut self, end: usize) -> usize {
        ((f64::from(self.one()) * end as f64) as usize).min(end - 1)
    }

    /// Ten to a uniform power.
    pub fn power(&mut self, low: f32, high: f32) -> f32 {
        libm::pow(10.0, f64::from(self.between(low, high))) as f32
    }

    /// A power of ten of either sign.
    pub fn signed_power(&mut self, low: f32, high: f32) -> f32 {
        let sign = if self.one() < 0.5 { -1.0 } else { 1.0 };
        sign * self.power(low, high)
    }

    /// A point of the cube of half width `half` around the origin.
    pub fn cube(&mut self, half: f32) -> Vec3 {
        Vec3::from_array(std::array::from_fn(|_| self.between(-half, half)))
    }

    /// A unit direction.
    pub fn direction(&mut self) -> Vec3 {
        warps::sample_sphere(self.0.two())
    }

    /// A unit direction on the side of `n`; every second one grazes, down to `10⁻⁶`.
    pub fn leaving(&mut self, n: Vec3) -> Vec3 {
        let z = if self.one() < 0.5 {
            self.one().max(1e-6)
        } else {
            self.power(-6.0, 0.0)
        };
        let r = (1.0 - z * z).max(0.0).sqrt();
        let (sin, cos) = libm::sincos(TAU * f64::from(self.one()));
        Frame::new(n).to_world(Vec3::new(r * cos as f32, r * sin as f32, z))
    }

    /// Two weights of a point inside a triangle.
    pub fn inside(&mut self) -> [f32; 2] {
        let root = self.one().sqrt();
        let split = self.one();
        [root * (1.0 - split), root * split]
    }

    /// A shape of the size and place given: a sphere, a quad or a triangle in turn.
    pub fn shape(&mut self, kind: usize, center: Vec3, size: f32) -> Shape {
        match kind % 3 {
            0 => Shape::Sphere(Sphere::new(center, size * self.between(0.1, 1.0))),
            1 => loop {
                let [u, v] = [self.cube(size), self.cube(size)].map(Vec3::as_dvec3);
                let corner: DVec3 = center.as_dvec3() - (u + v) * 0.5;
                if let Some(quad) = Quad::new(corner, u, v) {
                    return Shape::Quad(quad);
                }
            },
            _ => loop {
                let [a, b, c] = std::array::from_fn(|_| center + self.cube(size));
                let triangle = Triangle { a, b, c };
                if triangle.is_proper() {
                    return Shape::Triangle(triangle);
                }
            },
        }
    }

    /// A ray from `origin` towards `target`, with unit direction.
    pub fn towards(origin: Vec3, target: Vec3) -> Ray {
        let span = target.as_dvec3() - origin.as_dvec3();
        Ray::new(origin, span.normalize().as_vec3())
    }
}
