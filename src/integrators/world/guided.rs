//! A scene as the production path tracer sees it: one light is chosen at each surface, and where a scene
//! has mirrors or glass, some of the rays from other surfaces look there.
//!
//! The density of the BSDF is mixed with one towards what focuses light, and every direction counts by
//! the mixture, whichever drew it: Veach, Guibas, Optimally Combining Sampling Techniques for Monte
//! Carlo Rendering (SIGGRAPH 1995), "One-sample model". Where a point sees nothing specular only the
//! BSDF's is left, and no further number is drawn.

use super::{Diffuse, DirectLight, Step, World};
use crate::color::Rgb;
use crate::lights::Incident;
use crate::materials::{Among, Event, kinds};
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{GuideAt, Interaction, Tracer};
use crate::space::{Ray, Solid};
use glam::Vec3;

/// A view of a scene whose BSDFs are among `KINDS`, a constant of [`kinds`]: code for others is not there.
///
/// Lights and BSDFs are sampled at the point that was met last.
#[derive(Debug)]
pub struct Guided<'t, 'a, const KINDS: u8 = { kinds::ALL }> {
    tracer: &'t mut Tracer<'a>,
    /// What focuses light, as the point sees it that was met last.
    seen: GuideAt,
    /// True where caustics that the eye sees are traced from the lights.
    from_lights: bool,
    /// True where the path has met a diffuse surface first: what is focused there is traced from the lights.
    on_caustic: bool,
}

impl<'t, 'a, const KINDS: u8> Guided<'t, 'a, KINDS> {
    /// A view of the tracer's scene; the tracer counts its rays.
    ///
    /// * `from_lights`: true where caustics that the eye sees on diffuse surfaces are traced from the lights.
    pub fn new(tracer: &'t mut Tracer<'a>, from_lights: bool) -> Self {
        Guided {
            tracer,
            seen: GuideAt::default(),
            from_lights,
            on_caustic: false,
        }
    }

    /// The view of a path that may have met a diffuse surface first, at its vertex `hit` at the end of segment `segment`.
    pub(in crate::integrators) fn at_vertex(
        self,
        on_caustic: bool,
        hit: &Interaction<'a>,
        segment: u32,
    ) -> Self {
        let mut here = Guided { on_caustic, ..self };
        here.look_around(hit, segment);
        here
    }

    /// True where the path has met a diffuse surface first, and what is focused there is traced from the lights.
    pub(in crate::integrators) fn on_caustic(&self) -> bool {
        self.on_caustic
    }

    /// Sees what focuses light from the point that was met.
    #[inline]
    fn look_around(&mut self, hit: &Interaction<'a>, segment: u32) {
        let casters = &self.tracer.scene().casters;
        if KINDS & kinds::SPECULAR != 0 && !casters.is_empty() {
            let event = self.smooth_event(hit);
            if segment == 1 {
                self.on_caustic = self.from_lights && event == Some(Event::Diffuse);
            }
            self.seen = match event {
                Some(_) if !self.on_caustic => casters.seen_from(hit.surface.p),
                _ => GuideAt::default(),
            };
        }
    }

    /// The BSDF at a point.
    fn bsdf<'p>(at: &'p Interaction<'a>) -> Option<Among<'p, KINDS>> {
        at.bsdf.as_ref().map(Among)
    }

    /// Density of [`World::sample_bsdf`] at a direction that is not perfectly specular, given that of the
    /// BSDF, in 1/sr.
    fn pdf(&self, by_bsdf: f32, direction: Vec3) -> f32 {
        let seen = &self.seen;
        if seen.is_empty() {
            by_bsdf
        } else {
            (1.0 - seen.share()) * by_bsdf + seen.share() * seen.pdf(direction)
        }
    }
}

impl<'a, const KINDS: u8> World<Solid> for Guided<'_, 'a, KINDS> {
    type Point = Interaction<'a>;

    #[inline]
    fn intersect(&mut self, ray: &Ray<Solid>, segment: u32) -> Option<Interaction<'a>> {
        let hit = if segment == 1 {
            self.tracer.camera_ray(ray)?
        } else {
            self.tracer.secondary_ray(ray)?
        };
        self.look_around(&hit, segment);
        Some(hit)
    }

    fn emitted(&self, ray: &Ray<Solid>, hit: Option<&Interaction<'a>>) -> Rgb {
        self.tracer.emitted(ray, hit)
    }

    fn diffuse(&self, at: &Interaction<'a>) -> Diffuse<Solid> {
        self.tracer.diffuse(at)
    }

    #[inline]
    fn smooth_event(&self, at: &Interaction<'a>) -> Option<Event> {
        Self::bsdf(at)?.smooth_event()
    }

    #[inline]
    fn sample_bsdf(
        &self,
        at: &Interaction<'a>,
        vertex: u64,
        stream: &Stream,
    ) -> Option<Step<Solid>> {
        let bsdf = Self::bsdf(at)?;
        let mut numbers = stream.at(vertex, Purpose::Direction);
        let (u, choice, left) = (numbers.two(), numbers.one(), numbers.one());
        let seen = &self.seen;
        if seen.is_empty() {
            let drawn = bsdf.scatter(at.wo, choice, u)?;
            let direction = at.frame.to_world(drawn.wi).normalize();
            return Some(Step {
                ray: at.surface.spawn(direction),
                weight: drawn.weight,
                bsdf_weight: drawn.weight,
                pdf: drawn.pdf,
                event: drawn.event,
                left,
            });
        }
        let (wi, direction) = if stream.at(vertex, Purpose::Branch).one() < seen.share() {
            let direction = seen.sample(choice, u).normalize();
            (at.frame.to_local(direction), direction)
        } else {
            let drawn = bsdf.scatter(at.wo, choice, u)?;
            let direction = at.frame.to_world(drawn.wi).normalize();
            if drawn.pdf.is_none() {
                return Some(Step {
                    ray: at.surface.spawn(direction),
                    weight: drawn.weight / (1.0 - seen.share()),
                    bsdf_weight: drawn.weight,
                    pdf: None,
                    event: drawn.event,
                    left,
                });
            }
            (drawn.wi, direction)
        };
        let event = bsdf.smooth_event()?;
        let scattered = bsdf.f(at.wo, wi) * wi.z.abs();
        let by_bsdf = bsdf.pdf(at.wo, wi);
        let pdf = self.pdf(by_bsdf, direction);
        (!scattered.is_black() && pdf > 0.0).then(|| Step {
            ray: at.surface.spawn(direction),
            weight: scattered / pdf,
            bsdf_weight: scattered / if by_bsdf > 0.0 { by_bsdf } else { pdf },
            pdf: Some(pdf),
            event,
            left,
        })
    }

    /// One: it stands for all of them.
    fn lights(&self) -> usize {
        1
    }

    // ANCHOR: choose
    /// Chooses a light by what it may give at the point.
    #[inline]
    fn sample_light(
        &mut self,
        at: &Interaction<'a>,
        _: usize,
        vertex: u64,
        stream: &Stream,
    ) -> Option<DirectLight> {
        let bsdf = Self::bsdf(at)?;
        // A two-sided surface is lit on the side that is seen, and by nothing from behind.
        let from = at.surface.facing(at.back);
        let mut numbers = stream.at(vertex, Purpose::LightPoint);
        let (u, pick) = (numbers.two(), numbers.fine());
        let (index, sample) = self.tracer.chosen_light_sample(&from, pick, u)?;
        let wi = at.frame.to_local(sample.wi);
        let (f, cos) = (bsdf.f(at.wo, wi), wi.z.abs());
        if f.is_black() || cos == 0.0 || !self.tracer.visible(index, &sample) {
            return None;
        }
        let (li, irradiance, pdf) = match sample.incident {
            Incident::Radiance { li, pdf } => (li, li * (1.0 / pdf), Some(pdf)),
            Incident::Irradiance(e) => (e, e, None),
        };
        Some(DirectLight {
            f,
            cos,
            li,
            irradiance,
            pdf,
            pdf_bsdf: self.pdf(bsdf.pdf(at.wo, wi), sample.wi),
        })
    }
    // ANCHOR_END: choose

    // ANCHOR: density
    #[inline]
    fn pdf_light(
        &self,
        from: &Interaction<'a>,
        ray: &Ray<Solid>,
        hit: Option<&Interaction<'a>>,
    ) -> f32 {
        let from = from.surface.facing(from.back);
        self.tracer.chosen_light_pdf(&from, ray.direction, hit)
    }
    // ANCHOR_END: density
}
