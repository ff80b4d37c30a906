//! How integrators look at a scene; every ray they ask for is counted.

use super::interaction::{Hit, Interaction};
use super::motion::TransformedShapes;
use super::{Object, Scene};
use crate::geometry::{ClosestHit, Ray, Surface};
use crate::lights::{EmissionChoice, EmissionSample, EmissionUniforms, Incident, LightSample};
use crate::sampling::stream::{Purpose, Stream};
use glam::Vec3;
use std::ops::{AddAssign, Sub};

/// Rays asked for, by what they were for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
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

impl Sub for RayCounts {
    type Output = RayCounts;

    fn sub(self, part: RayCounts) -> RayCounts {
        RayCounts {
            camera: self.camera - part.camera,
            secondary: self.secondary - part.secondary,
            shadow: self.shadow - part.shadow,
        }
    }
}

impl AddAssign for RayCounts {
    fn add_assign(&mut self, other: RayCounts) {
        self.camera += other.camera;
        self.secondary += other.secondary;
        self.shadow += other.shadow;
    }
}

/// A view of a scene, which counts the rays it is asked for.
#[derive(Debug)]
pub struct Tracer<'a> {
    scene: &'a Scene,
    counts: RayCounts,
    lights_met: u64,
}

impl<'a> Tracer<'a> {
    /// A view with all counters at zero.
    pub fn new(scene: &'a Scene) -> Self {
        Tracer {
            scene,
            counts: RayCounts::default(),
            lights_met: 0,
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

    /// Counts rays that were asked for elsewhere.
    pub(crate) fn count(&mut self, rays: RayCounts) {
        self.counts += rays;
    }

    /// Notes that a path hit a light where it shines, if that is what it hit.
    pub fn note_light(&mut self, hit: &Interaction) {
        if let Some(light) = hit.object.light
            && !hit.emission.is_black()
        {
            self.lights_met |= 1 << light.min(Self::LIGHTS_NOTED);
        }
    }

    /// Lights that are noted each for itself, by their index in [`Scene::lights`].
    pub const LIGHTS_NOTED: u32 = 63;

    /// One bit for each of the first [`Tracer::LIGHTS_NOTED`] lights that was noted, and one for all others.
    pub fn lights_met(&self) -> u64 {
        self.lights_met
    }

    /// The closest hit of a ray from the camera.
    pub fn camera_ray(&mut self, ray: &Ray) -> Option<Interaction<'a>> {
        self.counts.camera += 1;
        self.first_hit(ray)
    }

    /// The closest hit of a ray that left a surface.
    pub fn secondary_ray(&mut self, ray: &Ray) -> Option<Interaction<'a>> {
        self.counts.secondary += 1;
        self.first_hit(ray)
    }

    /// True where nothing stands in the way of a shadow ray.
    pub fn unoccluded(&mut self, shadow_ray: &Ray) -> bool {
        self.counts.shadow += 1;
        !self.scene.bvh.occluded(shadow_ray)
            && !matches!(&self.scene.transformed, Some(m) if m.bvh.occluded(shadow_ray))
    }

    /// True where the light `index` is visible along the shadow ray of a sample of it: nothing stands
    /// in the way, and of surfaces within rounding of each other the light is the one that is met.
    #[inline]
    pub fn visible(&mut self, index: usize, sample: &LightSample) -> bool {
        let ray = &sample.shadow_ray;
        self.unoccluded(ray)
            && match &self.scene.contacts {
                None => true,
                Some(contacts) => contacts.is_met(index, sample.part, ray, &self.scene.objects),
            }
    }

    /// Samples the light `index` where it is now: [`Light::sample`](crate::lights::Light::sample).
    pub fn light_sample(
        &self,
        index: usize,
        from: &Surface,
        pick: f64,
        u: [f32; 2],
    ) -> Option<LightSample> {
        let light = &self.scene.lights[index];
        let sample = match self.light_moved(index, from.time) {
            Some(by) => light.sample_moved(by, from, pick, u),
            None => light.sample(from, pick, u),
        };
        if self.scene.textured_lights.is_empty() {
            return sample;
        }
        sample.map(|sample| self.scene.textured(index, sample))
    }

    /// Density in 1/sr of [`Tracer::light_sample`]: [`Light::pdf`](crate::lights::Light::pdf).
    pub fn light_pdf(&self, index: usize, from: &Surface, wi: Vec3, at: Option<&Surface>) -> f32 {
        let light = &self.scene.lights[index];
        match self.light_moved(index, from.time) {
            Some(by) => light.pdf_moved(by, from, wi, at),
            None => light.pdf(from, wi, at),
        }
    }

    /// Draws a light by its power, and a ray along which it emits at a random moment. Its power stands for
    /// that of all lights; `None` where there is none.
    pub fn sample_emission(&self, stream: &Stream) -> Option<EmissionSample> {
        self.sample_emission_at(stream, self.moment(stream))
    }

    /// The same at the moment `time`, in `[0, 1]`.
    pub fn sample_emission_at(&self, stream: &Stream, time: f32) -> Option<EmissionSample> {
        self.emission(&self.scene.emission_choice, stream, time)
    }

    /// Draws a light, and a ray along which it emits towards what focuses light. Its power stands for that of all
    /// such rays of all lights but a sky of one colour.
    pub fn sample_focused(&self, stream: &Stream) -> Option<EmissionSample> {
        self.emission(&self.scene.caustic_choice, stream, self.moment(stream))
    }

    /// A random moment while the shutter is open, where anything moves.
    fn moment(&self, stream: &Stream) -> f32 {
        match self.scene.moves() {
            true => stream.at(0, Purpose::Time).one(),
            false => 0.0,
        }
    }

    fn emission(
        &self,
        choice: &EmissionChoice,
        stream: &Stream,
        time: f32,
    ) -> Option<EmissionSample> {
        let scene = self.scene;
        let mut numbers = stream.at(0, Purpose::Emission);
        let (place, direction) = (numbers.two(), numbers.two());
        let (index, probability, pick) = choice.choose(stream.at(0, Purpose::Branch).fine())?;
        let by = self.light_moved(index, time).unwrap_or(Vec3::ZERO);
        let uniforms = EmissionUniforms {
            pick,
            place,
            direction,
        };
        let (light, around) = (&scene.lights[index], choice.around());
        let sample = match choice.targets() {
            targets if targets.is_empty() => light.sample_emission(around, by, uniforms),
            targets => {
                let aim = stream.at(0, Purpose::Direction).one();
                light.sample_emission_towards(targets, around, by, uniforms, aim)
            }
        }?;
        let emitted = match scene.textured_lights.get(&(index as u32)) {
            None => sample.emitted,
            Some(&object) => {
                let Object {
                    emission, mapping, ..
                } = &scene.objects[object as usize];
                emission.at(|| mapping.at(sample.part, sample.place, sample.n))
            }
        };
        Some(EmissionSample {
            ray: sample.ray.at_time(time),
            emitted,
            over_density: sample.over_density / probability,
            ..sample
        })
    }

    /// How far a light has come at `time` since the shutter opened; `None` for one that stands still.
    #[inline]
    fn light_moved(&self, index: usize, time: f32) -> Option<Vec3> {
        let span = self.scene.transformed.as_ref()?.span_of_light[index];
        (span != Vec3::ZERO).then(|| span * time)
    }

    /// Chooses a light by what it may give at the surface `from`, and samples it there. The sample's density, or its
    /// irradiance, knows of the choice.
    ///
    /// * `pick` in `[0, 1)`, of 53 bits; `u` in `[0, 1)²`.
    /// * Density: [`Tracer::chosen_light_pdf`].
    #[inline]
    pub fn chosen_light_sample(
        &self,
        from: &Surface,
        pick: f64,
        u: [f32; 2],
    ) -> Option<(usize, LightSample)> {
        let chosen = self.scene.light_choice.choose(from.p, pick)?;
        let sample = self.light_sample(chosen.index, from, chosen.rest, u)?;
        let incident = match sample.incident {
            Incident::Radiance { li, pdf } => Incident::Radiance {
                li,
                pdf: pdf * chosen.probability,
            },
            Incident::Irradiance(e) => Incident::Irradiance(e / chosen.probability),
        };
        Some((chosen.index, LightSample { incident, ..sample }))
    }

    /// Density in 1/sr with which a light is chosen at the surface `from` and aimed at in the unit direction `wi`, where
    /// the ray in that direction hits `hit`, or leaves the scene.
    #[inline]
    pub fn chosen_light_pdf(&self, from: &Surface, wi: Vec3, hit: Option<&Interaction>) -> f32 {
        let light = match hit {
            Some(hit) => hit.object.light.map(|light| light as usize),
            None => self.scene.beyond_light(),
        };
        let Some(index) = light else {
            return 0.0;
        };
        let at = hit.map(|hit| &hit.surface);
        self.scene.light_choice.probability(from.p, index) * self.light_pdf(index, from, wi, at)
    }

    #[inline]
    fn first_hit(&self, ray: &Ray) -> Option<Interaction<'a>> {
        let scene = self.scene;
        let still = scene.bvh.first_hit(ray);
        let hit = match &scene.transformed {
            Some(transformed) => scene.first_of_both(transformed, still, ray),
            None => still.map(|found| scene.hit(ray, &found)),
        }?;
        let hit = match &scene.contacts {
            None => hit,
            Some(contacts) => contacts.met(ray, hit, &scene.objects),
        };
        Some(Interaction::new(&scene.objects, ray, &hit))
    }
}

impl Scene {
    /// What a ray hits first of what stands still, if `still` is the first of that, and of what
    /// moves; of two at the same distance the one that comes first in the file.
    #[inline(never)]
    fn first_of_both(
        &self,
        transformed: &TransformedShapes,
        still: Option<ClosestHit>,
        ray: &Ray,
    ) -> Option<Hit> {
        let t_max = still.map_or(ray.t_max, |found| found.intersection.t);
        let ahead = Ray { t_max, ..*ray };
        if let Some(found) = transformed.bvh.first_hit(&ahead) {
            let t = found.intersection.t;
            let object = transformed.object_of_shape[found.id as usize];
            let first = still.is_none_or(|other| {
                let before = self.object_of_shape[other.id as usize];
                (t, object) < (other.intersection.t, before)
            });
            if first {
                // Shapes in motion have numbers of their own, those of an instance are its parts' beyond all.
                let number = transformed.moving.len().min(found.id as usize) as u32;
                return Some(Hit {
                    intersection: found.intersection,
                    surface: found.surface(ray),
                    object,
                    shape: self.object_of_shape.len() as u32 + number + found.intersection.part,
                });
            }
        }
        still.map(|found| self.hit(ray, &found))
    }

    /// A sample of a light with the radiance of the very point, where the radiance is a texture.
    fn textured(&self, light: usize, sample: LightSample) -> LightSample {
        let object = self.textured_lights.get(&(light as u32));
        let (Some(&object), Incident::Radiance { pdf, .. }) = (object, sample.incident) else {
            return sample;
        };
        let Object {
            emission, mapping, ..
        } = &self.objects[object as usize];
        let li = emission.at(|| mapping.at(sample.part, sample.place, sample.n));
        LightSample {
            incident: Incident::Radiance { li, pdf },
            ..sample
        }
    }

    /// The hit of a ray with a shape that stands still.
    #[inline]
    fn hit(&self, ray: &Ray, found: &ClosestHit) -> Hit {
        Hit {
            intersection: found.intersection,
            surface: found.surface(ray),
            object: self.object_of_shape[found.id as usize],
            shape: found.id,
        }
    }
}
