//! Distribution ray tracing: one ray where an integral was, and the same ray for all of them.
//!
//! Simulates the paths `L(S|G|D)*E` of lamps with extent and of the background, and of point and
//! directional lights `L(D|G)(S|G|D)*E`, cut at a depth: the same light as `next_event`.
//!
//! Differs from `whitted`: shadow rays aim at drawn points of the lamps, and one secondary ray goes
//! on in a drawn direction. A sample draws the place in the pixel, the point of the lens, the moment,
//! the points of the lamps, the facets of gloss and the directions of diffuse light at once, so it
//! costs as many rays with all integrals as with one. Each draws numbers of its own, and is left out
//! where these are fixed at 1/2: a point then stands for the integral.
//!
//! Source: Cook, Porter, Carpenter, Distributed Ray Tracing (SIGGRAPH 1984); they have no diffuse
//! secondary rays, which came with Kajiya, The Rendering Equation (SIGGRAPH 1986).

use super::Integrator;
use crate::color::Rgb;
use crate::geometry::{Ray, Surface};
use crate::materials::{Bsdf, Event};
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Interaction, Tracer};

/// What a sample integrates over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integral {
    /// The area of the pixel: smooth edges.
    Pixel,
    /// The area of lamps: soft shadows.
    Light,
    /// The area of the lens: depth of field.
    Lens,
    /// The time the shutter is open: motion blur.
    Time,
    /// The facets of rough surfaces: blurred reflections.
    Gloss,
    /// The directions above diffuse surfaces: indirect light.
    Hemisphere,
}

impl Integral {
    /// All six.
    pub const ALL: [Integral; 6] = [
        Integral::Pixel,
        Integral::Light,
        Integral::Lens,
        Integral::Time,
        Integral::Gloss,
        Integral::Hemisphere,
    ];

    /// All purposes, to leave out every integral.
    pub const NONE: &[Purpose] = &[
        Purpose::Pixel,
        Purpose::LightPoint,
        Purpose::Lens,
        Purpose::Time,
        Purpose::Facet,
        Purpose::Direction,
    ];

    // ANCHOR: purpose
    /// The purpose of its random numbers.
    pub fn purpose(self) -> Purpose {
        match self {
            Integral::Pixel => Purpose::Pixel,
            Integral::Light => Purpose::LightPoint,
            Integral::Lens => Purpose::Lens,
            Integral::Time => Purpose::Time,
            Integral::Gloss => Purpose::Facet,
            Integral::Hemisphere => Purpose::Direction,
        }
    }
    // ANCHOR_END: purpose

    /// The purposes of all others, to leave those out.
    pub fn others(self) -> &'static [Purpose] {
        use Purpose::{Direction, Facet, Lens, LightPoint, Pixel, Time};
        match self {
            Integral::Pixel => &[LightPoint, Lens, Time, Facet, Direction],
            Integral::Light => &[Pixel, Lens, Time, Facet, Direction],
            Integral::Lens => &[Pixel, LightPoint, Time, Facet, Direction],
            Integral::Time => &[Pixel, LightPoint, Lens, Facet, Direction],
            Integral::Gloss => &[Pixel, LightPoint, Lens, Time, Direction],
            Integral::Hemisphere => &[Pixel, LightPoint, Lens, Time, Facet],
        }
    }

    /// The integral over the directions of a surface of this material.
    fn at(bsdf: &Bsdf) -> Integral {
        match bsdf.smooth_event() {
            Some(Event::Gloss) => Integral::Gloss,
            _ => Integral::Hemisphere,
        }
    }
}

/// Distribution ray tracing.
#[derive(Clone, Copy, Debug)]
pub struct Distributed {
    /// Longest path in segments: the camera ray is the first, the shadow ray, or the ray that leaves
    /// the scene, the last.
    pub max_depth: u32,
}

impl Integrator for Distributed {
    // ANCHOR: distributed
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        // The surface whose shadow rays asked for the light along the ray.
        let mut asked = None;
        let mut hit = tracer.camera_ray(&ray);
        for depth in 1..=self.max_depth {
            li += beta * arriving(tracer, &ray, hit.as_ref(), asked);
            let Some(here) = hit else { break };
            let Some(bsdf) = here.bsdf.filter(|_| depth < self.max_depth) else {
                break;
            };
            let place = u64::from(depth);

            // One point of each lamp.
            for lamp in 0..tracer.scene().sampled_lights() {
                let mut u = stream.at_item(place, Integral::Light.purpose(), lamp as u32);
                let (u, pick) = (u.two(), u.fine());
                if let Some(sample) = tracer.light_sample(lamp, &here.surface, pick, u)
                    && tracer.visible(lamp, &sample)
                {
                    let wi = here.frame.to_local(sample.wi);
                    let f_cos = bsdf.f(here.wo, wi) * wi.z.abs();
                    li += beta * f_cos * sample.incident.facing_irradiance();
                }
            }

            // One direction, by the numbers of its own integral.
            let choice = stream.at(place, Purpose::Branch).one();
            let u = stream.at(place, Integral::at(&bsdf).purpose()).two();
            let Some(step) = bsdf.scatter(here.wo, choice, u) else {
                break;
            };
            asked = step.pdf.map(|_| here.surface);
            beta *= step.weight;
            ray = here.surface.spawn(here.frame.to_world(step.wi).normalize());
            hit = tracer.secondary_ray(&ray);
        }
        li
    }
    // ANCHOR_END: distributed
}

/// What comes along the ray by itself, but for what a shadow ray from `asked` has asked for.
fn arriving(tracer: &Tracer, ray: &Ray, hit: Option<&Interaction>, asked: Option<Surface>) -> Rgb {
    let scene = tracer.scene();
    let (radiance, light) = match hit {
        Some(hit) => {
            let light = hit.object.light.map(|light| light as usize);
            (hit.emission, light)
        }
        None => (scene.background(ray.direction), scene.environment_light),
    };
    match (asked, light) {
        (Some(from), Some(lamp))
            if tracer.light_pdf(lamp, &from, ray.direction, hit.map(|h| &h.surface)) > 0.0 =>
        {
            Rgb::BLACK
        }
        _ => radiance,
    }
}
