//! How integrators look at a scene; every ray they ask for is counted.

use super::{Object, Scene};
use crate::color::Rgb;
use crate::geometry::{Ray, Surface};
use glam::Vec3;
use std::ops::AddAssign;

/// Rays asked for, by what they were for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct RayCounts {
    /// Rays from the camera.
    pub camera: u64,
    /// Rays that leave a surface to see what is there.
    pub secondary: u64,
    /// Rays that ask whether a light is visible.
    pub shadow: u64,
}

impl RayCounts {
    /// All of them.
    pub fn total(&self) -> u64 {
        self.camera + self.secondary + self.shadow
    }
}

impl AddAssign for RayCounts {
    fn add_assign(&mut self, other: RayCounts) {
        self.camera += other.camera;
        self.secondary += other.secondary;
        self.shadow += other.shadow;
    }
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug)]
pub struct Hit<'a> {
    /// Distance along the ray.
    pub t: f32,
    /// The point, its error bound and its normal.
    pub surface: Surface,
    /// The object it belongs to.
    pub object: &'a Object,
}

impl Hit<'_> {
    /// Radiance the surface itself emits towards the unit direction `wo`.
    pub fn emitted(&self, wo: Vec3) -> Rgb {
        if self.surface.n.dot(wo) > 0.0 {
            self.object.emission
        } else {
            Rgb::BLACK
        }
    }
}

/// A view of a scene that counts the rays it is asked for.
#[derive(Debug)]
pub struct Tracer<'a> {
    scene: &'a Scene,
    counts: RayCounts,
}

impl<'a> Tracer<'a> {
    /// A view with all counters at zero.
    pub fn new(scene: &'a Scene) -> Self {
        Tracer {
            scene,
            counts: RayCounts::default(),
        }
    }

    /// The scene.
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// The rays asked for so far.
    pub fn counts(&self) -> RayCounts {
        self.counts
    }

    /// What a ray from the camera meets.
    pub fn camera_ray(&mut self, ray: &Ray) -> Option<Hit<'a>> {
        self.counts.camera += 1;
        self.scene.first_hit(ray)
    }

    /// What a ray that left a surface meets.
    pub fn secondary_ray(&mut self, ray: &Ray) -> Option<Hit<'a>> {
        self.counts.secondary += 1;
        self.scene.first_hit(ray)
    }

    /// True where nothing stands in the way of a shadow ray.
    pub fn is_free(&mut self, shadow_ray: &Ray) -> bool {
        self.counts.shadow += 1;
        !self.scene.bvh.any(shadow_ray)
    }
}

impl Scene {
    fn first_hit(&self, ray: &Ray) -> Option<Hit<'_>> {
        let found = self.bvh.first(ray)?;
        let object = self.object_of_shape[found.id as usize];
        Some(Hit {
            t: found.crossing.t,
            surface: found.shape.surface(ray, found.crossing),
            object: &self.objects[object as usize],
        })
    }
}
