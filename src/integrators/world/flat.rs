//! A flat world, as paths see it.

use super::{Diffuse, DirectLight, Step, World};
use crate::color::Rgb;
use crate::flatland::{FlatHit, FlatSurface, FlatWorld};
use crate::materials::Event;
use crate::sampling::half_disk;
use crate::sampling::stream::{Purpose, Stream};
use crate::space::{Flat, Ray, Space};
use glam::Vec2;

/// A view of a flat world, which counts the rays it is asked for.
#[derive(Clone, Copy, Debug)]
pub struct FlatTracer<'a> {
    /// The world.
    pub world: &'a FlatWorld,
    /// Rays so far, shadow rays included.
    pub rays: u64,
    lights: Lights,
}

/// Which lights of a flat world are sampled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lights {
    /// All of them.
    All,
    /// Those without extent, which no ray can meet.
    Points,
}

impl<'a> FlatTracer<'a> {
    /// The world, with no ray traced; all its lights are sampled.
    pub fn new(world: &'a FlatWorld) -> Self {
        FlatTracer::sampling(world, Lights::All)
    }

    /// The world, with no ray traced; the others of its lights are found by chance.
    pub fn sampling(world: &'a FlatWorld, lights: Lights) -> Self {
        FlatTracer {
            world,
            rays: 0,
            lights,
        }
    }
}

/// Where a shadow ray ends.
enum Target {
    Point(Vec2),
    Surface(FlatSurface),
}

impl World<Flat> for FlatTracer<'_> {
    type Point = FlatHit;

    fn intersect(&mut self, ray: &Ray<Flat>, _: u32) -> Option<FlatHit> {
        self.rays += 1;
        let hit = self.world.first_hit(ray.origin, ray.direction)?;
        Some(hit.seen_from(-ray.direction))
    }

    fn emitted(&self, _: &Ray<Flat>, hit: Option<&FlatHit>) -> Rgb {
        hit.map_or(self.world.background, |at| at.emission)
    }

    fn diffuse(&self, at: &FlatHit) -> Diffuse<Flat> {
        let FlatSurface { p, error, n } = at.surface;
        Diffuse {
            p,
            error,
            n,
            time: 0.0,
            albedo: at.albedo,
        }
    }

    fn smooth_event(&self, at: &FlatHit) -> Option<Event> {
        at.specular.is_none().then_some(Event::Diffuse)
    }

    fn sample_bsdf(&self, at: &FlatHit, vertex: u64, stream: &Stream) -> Option<Step<Flat>> {
        if let Some(specular) = &at.specular {
            let axes = Flat::frame(at.front);
            let both = specular.specular(Flat::to_local(&axes, at.wo));
            let branch = both.choose(stream.at(vertex, Purpose::Branch).one())?;
            let local = Vec2::new(branch.wi.x, branch.wi.z);
            let direction = Flat::to_world(&axes, local).normalize();
            return Some(Step {
                ray: Ray::new(at.surface.leave(direction), direction),
                weight: branch.weight,
                bsdf_weight: branch.weight,
                pdf: None,
                event: Event::Specular,
                left: stream.at(vertex, Purpose::Direction).one(),
            });
        }
        if at.albedo.is_black() {
            return None;
        }
        let mut numbers = stream.at(vertex, Purpose::Direction);
        let local = half_disk::sample_cosine(numbers.one());
        let direction = Flat::to_world(&Flat::frame(at.surface.n), local);
        Some(Step {
            ray: Ray::new(at.surface.leave(direction), direction),
            weight: at.albedo,
            bsdf_weight: at.albedo,
            pdf: Some(half_disk::pdf_cosine(local)),
            event: Event::Diffuse,
            left: numbers.one(),
        })
    }

    fn lights(&self) -> usize {
        let points = self.world.point_lights.len();
        match self.lights {
            Lights::All => points + self.world.area_lights().len(),
            Lights::Points => points,
        }
    }

    fn sample_light(
        &mut self,
        at: &FlatHit,
        light: usize,
        vertex: u64,
        stream: &Stream,
    ) -> Option<DirectLight> {
        let surface = &at.surface;
        let points = &self.world.point_lights;
        let (wi, li, irradiance, pdf, target) = if let Some(point) = points.get(light) {
            let arrives = point.light_at(surface.p)?;
            let irradiance = arrives.irradiance;
            let target = Target::Point(point.position);
            (arrives.wi, irradiance, irradiance, None, target)
        } else {
            let mut numbers = stream.at_item(vertex, Purpose::LightPoint, light as u32);
            let glowing = &self.world.area_lights()[light - points.len()];
            let drawn = glowing.sample(surface.p, numbers.one())?;
            let (li, target) = (glowing.radiance, Target::Surface(drawn.surface));
            (drawn.wi, li, li / drawn.pdf, Some(drawn.pdf), target)
        };
        let cos = surface.n.dot(wi);
        if cos <= 0.0 || at.albedo.is_black() {
            return None;
        }
        self.rays += 1;
        let visible = match target {
            Target::Point(p) => self.world.sees_point(surface, p),
            Target::Surface(there) => self.world.sees(surface, &there),
        };
        visible.then(|| DirectLight {
            f: at.albedo * Flat::LAMBERT,
            cos,
            li,
            irradiance,
            pdf,
            pdf_bsdf: half_disk::pdf_cosine(Vec2::new(0.0, cos)),
        })
    }

    fn pdf_light(&self, from: &FlatHit, _: &Ray<Flat>, hit: Option<&FlatHit>) -> f32 {
        let (Some(hit), Lights::All) = (hit, self.lights) else {
            return 0.0;
        };
        let same = self.world.area_lights().iter().find(|g| g.part == hit.part);
        same.map_or(0.0, |glowing| glowing.pdf(from.surface.p))
    }
}
