//! How integrators look at a scene; every ray they ask for is counted.

use super::motion::InMotion;
use super::{Object, Scene};
use crate::color::Rgb;
use crate::geometry::{Found, Ray, Surface};
use crate::lights::LightSample;
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
    /// The number of its shape: those that stand still come first.
    pub(super) shape: u32,
}

impl Hit<'_> {
    /// Radiance the surface itself emits towards the unit direction `wo`.
    pub fn emitted(&self, wo: Vec3) -> Rgb {
        if self.object.two_sided || self.surface.n.dot(wo) > 0.0 {
            self.object.emission
        } else {
            Rgb::BLACK
        }
    }
}

/// A view of a scene at one moment, which counts the rays it is asked for.
///
/// Where `MOVES` is false it is a view of what stands still alone, and code for motion is not there.
#[derive(Debug)]
pub struct Tracer<'a, const MOVES: bool = true> {
    scene: &'a Scene,
    /// From 0, where the shutter opens, to 1, where it closes.
    time: f32,
    counts: RayCounts,
    lamps_met: u64,
}

impl<'a> Tracer<'a> {
    /// A view at the moment the shutter opens, with all counters at zero.
    pub fn new(scene: &'a Scene) -> Self {
        Tracer {
            scene,
            time: 0.0,
            counts: RayCounts::default(),
            lamps_met: 0,
        }
    }

    /// Looks at what stands still, and counts the rays asked for as its own.
    #[inline]
    pub fn at_rest<R>(&mut self, look: impl FnOnce(&mut Tracer<'a, false>) -> R) -> R {
        let mut still = Tracer {
            scene: self.scene,
            time: 0.0,
            counts: RayCounts::default(),
            lamps_met: 0,
        };
        let answer = look(&mut still);
        self.counts += still.counts;
        self.lamps_met |= still.lamps_met;
        answer
    }
}

impl<'a, const MOVES: bool> Tracer<'a, MOVES> {
    /// The scene.
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// Looks at the scene at `time` from now on: in `[0, 1]`, 0 where the shutter opens and 1 where
    /// it closes.
    pub fn at_time(&mut self, time: f32) {
        debug_assert!((0.0..=1.0).contains(&time), "{time}");
        self.time = time;
    }

    /// The rays asked for so far.
    pub fn counts(&self) -> RayCounts {
        self.counts
    }

    /// Notes that a walk met a lamp where it shines, if that is what it met.
    pub fn note_lamp(&mut self, hit: &Hit, wo: Vec3) {
        if let Some(light) = hit.object.light
            && !hit.emitted(wo).is_black()
        {
            self.lamps_met |= 1 << light.min(Self::LAMPS_NOTED);
        }
    }

    /// Lamps that are noted each for itself, by their index in [`Scene::lights`].
    pub const LAMPS_NOTED: u32 = 63;

    /// One bit for each of the first [`Tracer::LAMPS_NOTED`] lights that was noted, and one for all others.
    pub fn lamps_met(&self) -> u64 {
        self.lamps_met
    }

    /// What a ray from the camera meets.
    pub fn camera_ray(&mut self, ray: &Ray) -> Option<Hit<'a>> {
        self.counts.camera += 1;
        self.first_hit(ray)
    }

    /// What a ray that left a surface meets.
    pub fn secondary_ray(&mut self, ray: &Ray) -> Option<Hit<'a>> {
        self.counts.secondary += 1;
        self.first_hit(ray)
    }

    /// True where nothing stands in the way of a shadow ray.
    pub fn is_free(&mut self, shadow_ray: &Ray) -> bool {
        self.counts.shadow += 1;
        !self.scene.bvh.any(shadow_ray)
            && !matches!(self.in_motion(), Some(m) if m.bvh.any(shadow_ray, self.time))
    }

    /// True where the light `index` is visible along the shadow ray of a sample of it: nothing stands
    /// in the way, and of surfaces within rounding of each other the light is the one that is met.
    #[inline]
    pub fn visible(&mut self, index: usize, sample: &LightSample) -> bool {
        let ray = &sample.shadow_ray;
        self.is_free(ray)
            && match &self.scene.contacts {
                None => true,
                Some(contacts) => {
                    let objects = &self.scene.objects;
                    contacts.is_met(index, sample.part, ray, self.time, objects)
                }
            }
    }

    /// Aims at the light `index` where it is now: [`Light::sample`](crate::lights::Light::sample).
    pub fn sample_light(
        &self,
        index: usize,
        from: &Surface,
        pick: f64,
        u: [f32; 2],
    ) -> Option<LightSample> {
        let light = &self.scene.lights[index];
        match self.light_moved(index) {
            Some(by) => light.sample_moved(by, from, pick, u),
            None => light.sample(from, pick, u),
        }
    }

    /// Density in 1/sr of [`Tracer::sample_light`]: [`Light::pdf`](crate::lights::Light::pdf).
    pub fn pdf_light(&self, index: usize, from: &Surface, wi: Vec3, at: Option<&Surface>) -> f32 {
        let light = &self.scene.lights[index];
        match self.light_moved(index) {
            Some(by) => light.pdf_moved(by, from, wi, at),
            None => light.pdf(from, wi, at),
        }
    }

    /// How far a light has come since the shutter opened; `None` for one that stands still.
    fn light_moved(&self, index: usize) -> Option<Vec3> {
        let span = self.in_motion()?.span_of_light[index];
        (span != Vec3::ZERO).then(|| span * self.time)
    }

    #[inline]
    fn in_motion(&self) -> Option<&'a InMotion> {
        if MOVES {
            self.scene.in_motion.as_ref()
        } else {
            None
        }
    }

    #[inline]
    fn first_hit(&self, ray: &Ray) -> Option<Hit<'a>> {
        let scene = self.scene;
        let still = scene.bvh.first(ray);
        let hit = match self.in_motion() {
            Some(in_motion) => self.first_of_both(in_motion, still, ray),
            None => still.map(|found| scene.hit(ray, &found)),
        };
        match &scene.contacts {
            None => hit,
            Some(contacts) => hit.map(|hit| contacts.met(ray, self.time, hit, &scene.objects)),
        }
    }

    /// What a ray meets first of what stands still, if `still` is the first of that, and of what
    /// moves; of two at the same distance the one that comes first in the file.
    #[inline(never)]
    fn first_of_both(
        &self,
        in_motion: &InMotion,
        still: Option<Found>,
        ray: &Ray,
    ) -> Option<Hit<'a>> {
        let scene = self.scene;
        let t_max = still.map_or(ray.t_max, |found| found.crossing.t);
        let ahead = Ray { t_max, ..*ray };
        if let Some(found) = in_motion.bvh.first(&ahead, self.time) {
            let t = found.crossing.t;
            let object = in_motion.object_of_shape[found.id as usize];
            let first = still.is_none_or(|other| {
                let before = scene.object_of_shape[other.id as usize];
                (t, object) < (other.crossing.t, before)
            });
            if first {
                return Some(Hit {
                    t,
                    surface: found.shape.surface(ray, self.time, found.crossing),
                    object: &scene.objects[object as usize],
                    shape: scene.object_of_shape.len() as u32 + found.id,
                });
            }
        }
        still.map(|found| scene.hit(ray, &found))
    }
}

impl Scene {
    /// The hit of a ray with a shape that stands still.
    #[inline]
    fn hit(&self, ray: &Ray, found: &Found) -> Hit<'_> {
        let object = self.object_of_shape[found.id as usize];
        Hit {
            t: found.crossing.t,
            surface: found.shape.surface(ray, found.crossing),
            object: &self.objects[object as usize],
            shape: found.id,
        }
    }
}
