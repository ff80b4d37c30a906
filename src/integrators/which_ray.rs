//! The slides' algorithm: at each surface one ray to every lamp, and one further ray that is diffuse
//! or specular or transmitted.
//!
//! Simulates the paths `L(S|G|D)*E` of lamps with extent and of the background, and of point and
//! directional lights `L(D|G)(S|G|D)*E`, like `next_event` and with the same expected value.
//!
//! Differs from `whitted`: where that follows the mirrored and the transmitted ray and no diffuse one,
//! this follows one of the three, so that a path stays a path. Differs from `next_event`: how the
//! kind of the one ray is chosen is open; each choice is right, and each has its own variance. What
//! the choice made likelier counts less: the weight is `k/p`, which the slides leave out. Light of
//! the lamps counts by the shadow rays after a diffuse choice, and where the path meets it after a
//! specular one.
//!
//! Sources: Kajiya, The Rendering Equation (SIGGRAPH 1986), for one ray in vertex of a tree; Lafortune,
//! Willems, Using the Modified Phong Reflectance Model for Physically Based Rendering (Report CW 197,
//! KU Leuven 1994), section 4, for the weight.

use super::world::{World, next_event};
use super::{Entry, Finds, Integrator};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::materials::{Bsdf, BsdfSample, Choice};
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Interaction, Tracer};

/// The walk that chooses what kind of ray to follow.
#[derive(Clone, Copy, Debug)]
pub struct WhichRay {
    /// Longest path in segments: the camera ray is the first, the shadow ray, or the ray that hits
    /// a lamp or leaves the scene, the last.
    pub max_depth: u32,
    /// With which probabilities the parts of a mixture are chosen. Other materials choose by what
    /// their parts reflect.
    pub choice: Choice,
}

impl WhichRay {
    /// Its row of the table; the choice follows the mean of the shares.
    pub const ENTRY: Entry = Entry::of_light(
        [
            "which-ray",
            "next-event, the kind of the next ray chosen by the shares",
            "A shadow ray to each lamp and one ray that is diffuse or specular or transmitted, chosen by \
             the shares of a mixture: the light of next-event",
        ],
        Finds::BY_AIMING,
        |settings| {
            Box::new(WhichRay {
                max_depth: settings.max_depth,
                choice: Choice::ByMean,
            })
        },
    );
}

impl Integrator for WhichRay {
    // ANCHOR: which_ray
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        // The surface that asked for the light along the ray. Nobody did along one from the eye.
        let mut asked = None;
        for depth in 1..=self.max_depth {
            let hit = tracer.intersect(&ray, depth);

            // The light that comes along the path by itself, unless it was asked for.
            let was_sampled = |from| tracer.pdf_light(&from, &ray, hit.as_ref()) > 0.0;
            if !asked.is_some_and(was_sampled) {
                li += beta * tracer.emitted(&ray, hit.as_ref());
            }
            let Some(here) = hit else { break };
            if depth == self.max_depth {
                break;
            }

            // One ray to each lamp.
            let vertex = u64::from(depth);
            li += beta * next_event(tracer, &here, vertex, stream);

            // One further ray: diffuse, specular or transmitted.
            let Some(next) = self.further(&here, vertex, stream) else {
                break;
            };
            beta *= next.weight;
            asked = next.pdf.map(|_| here);
            let direction = here.frame.to_world(next.wi).normalize();
            ray = here.surface.spawn(direction);
        }
        li
    }
    // ANCHOR_END: which_ray
}

impl WhichRay {
    // ANCHOR: further
    /// Chooses the further ray; `None` where the light is absorbed.
    pub fn further(&self, here: &Interaction, vertex: u64, stream: &Stream) -> Option<BsdfSample> {
        let choice = stream.at(vertex, Purpose::Branch).one();
        let u = stream.at(vertex, Purpose::Direction).two();
        match here.bsdf? {
            Bsdf::Mixture(m) => m.scatter_by(self.choice, here.wo, choice, u),
            other => other.scatter(here.wo, choice, u),
        }
    }
    // ANCHOR_END: further
}
