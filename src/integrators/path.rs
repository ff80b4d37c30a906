//! Path tracing as one would use it: all materials, lamps and cameras, one shadow ray at each
//! surface, both techniques combined, and an end by roulette.
//!
//! Simulates the paths `L(S|G|D)*E` of lamps with extent, of the background and the environment, and
//! of point and directional lights `L(D|G)(S|G|D)*E`: the same light as `combine`.
//!
//! Differs from `combine`: one lamp is chosen by what it may give at the point, where that asks all,
//! so that a scene may have thousands; a sky of one colour is aimed at now and then; a path that carries
//! little may end before the depth cut; and where a scene has
//! mirrors or glass, some of the rays from other surfaces look there, for no shadow ray finds the
//! light they focus. It is the ladder's last rung and puts its steps together; most have a rung of
//! their own.
//!
//! Sources: Kajiya, The Rendering Equation (SIGGRAPH 1986); Arvo, Kirk, Particle Transport and Image
//! Synthesis (SIGGRAPH 1990); Veach, Guibas, Optimally Combining Sampling Techniques for Monte Carlo
//! Rendering (SIGGRAPH 1995); Jensen, Global Illumination Using Photon Maps (Rendering Techniques
//! 1996), "Projection maps", for looking where light is focused.

use super::observer::{AllLight, PathObserver};
use super::world::{Guided, World};
use super::{Entry, Finds, Integrator};
use crate::color::Rgb;
use crate::geometry;
use crate::materials::kinds;
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::Stream;
use crate::scene::Tracer;
use crate::space::{Ray, Space};

/// The production path tracer.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    /// Longest path in segments: the camera ray is the first, the shadow ray, or the ray that hits
    /// a lamp or leaves the scene, the last.
    pub max_depth: u32,
    /// Paths of fewer segments never play roulette. At [`Path::max_depth`] none does.
    pub roulette_from: u32,
}

/// Even a path that carries next to nothing lives on with this probability: what it may still find
/// is not weighted up by more than its reciprocal.
const LEAST_SURVIVAL: f32 = 0.05;

impl Path {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry::of_light(
        [
            "path",
            "all of it: one lamp, weighted, roulette",
            "Path tracing with everything: shadow rays, both techniques weighted, roulette; all \
             materials, lamps and cameras",
        ],
        Finds::BY_AIMING,
        |max_depth| Box::new(Path::new(max_depth)),
    );

    /// A path tracer whose roulette starts with the fifth segment.
    pub fn new(max_depth: u32) -> Self {
        Path {
            max_depth,
            roulette_from: 5,
        }
    }
}

impl Path {
    // ANCHOR: path
    /// Traces one path from the eye, and tells `follow` all light that it finds.
    #[inline]
    pub fn walk<S: Space>(
        &self,
        world: &mut impl World<S>,
        ray: &Ray<S>,
        stream: &Stream,
        follow: &mut impl PathObserver,
    ) {
        let mut beta = Rgb::WHITE;
        // The throughput of which roulette took no account yet.
        let mut rr_beta = Rgb::WHITE;
        let mut ray = *ray;
        // The surface where the ray was sampled, and with what density; nobody else could have sampled
        // one from the eye or after a mirror.
        let mut sampled = None;
        for depth in 1..=self.max_depth {
            let hit = world.intersect(&ray, depth);

            // The light that comes along the path by itself: the sampling of lights could have found it.
            let mut li = world.emitted(&ray, hit.as_ref());
            if let Some((from, pdf)) = &sampled
                && !li.is_black()
            {
                let pdf_light = world.pdf_light(from, &ray, hit.as_ref());
                li = li * Heuristic::Power.weight(*pdf, pdf_light);
            }
            follow.arrived(beta * li);
            let Some(here) = hit else { break };
            if depth == self.max_depth {
                break;
            }

            // The light of light sources that is scattered once, here: the path could have found it.
            let vertex = u64::from(depth);
            if let Some(last) = world.smooth_event(&here).filter(|&e| follow.wants(e)) {
                for light in 0..world.lights() {
                    if let Some(direct) = world.sample_light(&here, light, vertex, stream) {
                        follow.aimed(last, beta * direct.weighted(Heuristic::Power));
                    }
                }
            }

            // Choose where to look next.
            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            if !follow.scattered(step.event) {
                break;
            }
            beta *= step.weight;
            rr_beta *= step.bsdf_weight;

            // Does the path go on? If so, it also stands for those that did not. It is no worse for
            // being one of many that look for focused light, and carry less each.
            if depth >= self.roulette_from {
                let q = rr_beta.max_channel().clamp(LEAST_SURVIVAL, 1.0);
                let survives = step.left < q;
                if !survives {
                    break;
                }
                beta = beta / q;
                rr_beta = rr_beta / q;
            }
            sampled = step.pdf.map(|pdf| (here, pdf));
            ray = step.ray;
        }
    }
    // ANCHOR_END: path

    /// Traces one path in a scene, and tells `follow` all light that it finds.
    pub fn trace(
        &self,
        tracer: &mut Tracer,
        ray: &geometry::Ray,
        stream: &Stream,
        follow: &mut impl PathObserver,
    ) {
        self.walk(
            &mut Guided::<{ kinds::ALL }>::new(tracer),
            ray,
            stream,
            follow,
        );
    }
}

// ANCHOR: kernels
impl Integrator for Path {
    /// By code for the BSDFs that are in the scene, and no others. What it leaves out could not have
    /// happened, so the light is that of [`Path::trace`], bit for bit.
    fn li(&self, tracer: &mut Tracer, ray: &geometry::Ray, stream: &Stream) -> Rgb {
        let scene = tracer.scene();
        if scene.is_dark() {
            return Rgb::BLACK;
        }
        match scene.kinds() {
            kinds::DIFFUSE => self.among::<{ kinds::DIFFUSE }>(tracer, ray, stream),
            kinds::SPECULAR => self.among::<{ kinds::SPECULAR }>(tracer, ray, stream),
            kinds::GLOSS => self.among::<{ kinds::GLOSS }>(tracer, ray, stream),
            _ => self.among::<{ kinds::ALL }>(tracer, ray, stream),
        }
    }
}

impl Path {
    /// The light of one path in a scene whose BSDFs are among `KINDS` (see [`kinds`]).
    fn among<const KINDS: u8>(
        &self,
        tracer: &mut Tracer,
        ray: &geometry::Ray,
        stream: &Stream,
    ) -> Rgb {
        let mut all = AllLight::default();
        self.walk(&mut Guided::<KINDS>::new(tracer), ray, stream, &mut all);
        all.li
    }
}
// ANCHOR_END: kernels

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Film, Options, render};
    use crate::scene::{Scene, gallery};

    /// A path tracer that always takes one kernel.
    struct Always<F>(F);

    impl<F: Fn(&mut Tracer, &geometry::Ray, &Stream) -> Rgb + Sync> Integrator for Always<F> {
        fn li(&self, tracer: &mut Tracer, ray: &geometry::Ray, stream: &Stream) -> Rgb {
            self.0(tracer, ray, stream)
        }
    }

    fn film(scene: &Scene, integrator: &impl Integrator) -> Film {
        let options = Options {
            spp: 4,
            ..Options::default()
        };
        render(scene, integrator, &options, &()).film
    }

    #[test]
    fn a_kernel_without_something_that_is_there_is_noticed() {
        let path = Path::new(6);
        let load = |name| gallery::load(name).expect(name).sized([16, 12]);
        let diffuse = Always(|t: &mut Tracer, r: &geometry::Ray, s: &Stream| {
            path.among::<{ kinds::DIFFUSE }>(t, r, s)
        });
        for scene in ["gloss", "caustic", "mixture"].map(load) {
            assert_ne!(
                film(&scene, &path),
                film(&scene, &diffuse),
                "{}",
                scene.name
            );
        }
        let cornell = load("cornell");
        assert_eq!(film(&cornell, &path), film(&cornell, &diffuse));
    }
}
