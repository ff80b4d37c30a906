//! A scene, as paths see it: every light is sampled at every surface.

use super::{Diffuse, DirectLight, Step, World};
use crate::color::Rgb;
use crate::geometry::Surface;
use crate::lights::{Incident, LightSample};
use crate::materials::{Bsdf, Event};
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Interaction, Tracer};
use crate::space::{Ray, Solid};

impl<'a> World<Solid> for Tracer<'a> {
    type Point = Interaction<'a>;

    fn intersect(&mut self, ray: &Ray<Solid>, segment: u32) -> Option<Interaction<'a>> {
        let hit = if segment == 1 {
            self.camera_ray(ray)?
        } else {
            self.secondary_ray(ray)?
        };
        self.note_light(&hit);
        Some(hit)
    }

    fn emitted(&self, ray: &Ray<Solid>, hit: Option<&Interaction<'a>>) -> Rgb {
        match hit {
            Some(at) => at.emission,
            None => self.scene().background(ray.direction),
        }
    }

    fn diffuse(&self, at: &Interaction<'a>) -> Diffuse<Solid> {
        let Surface { p, error, n, time } = at.surface;
        Diffuse {
            p,
            error,
            n: if at.wo.z > 0.0 { n } else { -n },
            time,
            albedo: match at.bsdf {
                Some(Bsdf::Lambert(lambert)) => lambert.albedo,
                _ => Rgb::BLACK,
            },
        }
    }

    fn smooth_event(&self, at: &Interaction<'a>) -> Option<Event> {
        at.bsdf.as_ref()?.smooth_event()
    }

    fn sample_bsdf(
        &self,
        at: &Interaction<'a>,
        vertex: u64,
        stream: &Stream,
    ) -> Option<Step<Solid>> {
        let choice = stream.at(vertex, Purpose::Branch).one();
        let mut numbers = stream.at(vertex, Purpose::Direction);
        let drawn = at.bsdf.as_ref()?.scatter(at.wo, choice, numbers.two())?;
        let direction = at.frame.to_world(drawn.wi).normalize();
        Some(Step {
            ray: at.surface.spawn(direction),
            weight: drawn.weight,
            bsdf_weight: drawn.weight,
            pdf: drawn.pdf,
            event: drawn.event,
            left: numbers.one(),
        })
    }

    fn lights(&self) -> usize {
        self.scene().sampled_lights()
    }

    fn sample_light(
        &mut self,
        at: &Interaction<'a>,
        light: usize,
        vertex: u64,
        stream: &Stream,
    ) -> Option<DirectLight> {
        let bsdf = at.bsdf.as_ref()?;
        let mut numbers = stream.at_item(vertex, Purpose::LightPoint, light as u32);
        let (u, pick) = (numbers.two(), numbers.fine());
        let sample = self.light_sample(light, &at.surface, pick, u)?;
        let wi = at.frame.to_local(sample.wi);
        let f = bsdf.f(at.wo, wi);
        let cos = wi.z.abs();
        // A shadow ray costs as much as any other: it is not sent where nothing could come of it.
        if f.is_black() || cos == 0.0 || !self.visible(light, &sample) {
            return None;
        }
        let LightSample { incident, .. } = sample;
        let (li, pdf) = match incident {
            Incident::Radiance { li, pdf } => (li, Some(pdf)),
            Incident::Irradiance(e) => (e, None),
        };
        Some(DirectLight {
            f,
            cos,
            li,
            irradiance: incident.facing_irradiance(),
            pdf,
            pdf_bsdf: bsdf.pdf(at.wo, wi),
        })
    }

    fn pdf_light(
        &self,
        from: &Interaction<'a>,
        ray: &Ray<Solid>,
        hit: Option<&Interaction<'a>>,
    ) -> f32 {
        let light = match hit {
            Some(at) => at.object.light.map(|light| light as usize),
            None => self.scene().environment_light,
        };
        let at = hit.map(|at| &at.surface);
        light.map_or(0.0, |light| {
            self.light_pdf(light, &from.surface, ray.direction, at)
        })
    }
}
