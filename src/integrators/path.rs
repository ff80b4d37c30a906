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

use super::follow::{Everything, Follow};
use super::onward::Onward;
use super::walkable::SolidPoint;
use super::{Entry, Finds, Integrator};
use crate::color::Rgb;
use crate::geometry::{Ray, Surface};
use crate::lights::Incident;
use crate::materials::{Among, kinds};
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::scene::{Hit, Tracer};

/// The production path tracer.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    /// Longest path in segments: the camera ray is the first, the shadow ray, or the ray that hits
    /// a lamp or leaves the scene, the last.
    pub max_depth: u32,
    /// Paths of fewer segments never play roulette. At [`Path::max_depth`] none does.
    pub roulette_from: u32,
}

/// The surface that drew a ray, its normal on the side it was seen from, and the density with which it
/// did.
type Drawn = Option<(Surface, f32)>;

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
    /// Follows one path, and tells `follow` all light it finds.
    pub fn trace(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream, follow: &mut impl Follow) {
        self.kernel::<{ kinds::ALL }, true>(tracer, ray, stream, follow);
    }

    // ANCHOR: path
    /// The walk itself, for scenes whose materials are among `KINDS` (see [`kinds`]) and in which
    /// something moves, or nothing does.
    #[inline]
    fn kernel<const KINDS: u8, const MOVES: bool>(
        &self,
        tracer: &mut Tracer<MOVES>,
        ray: &Ray,
        stream: &Stream,
        follow: &mut impl Follow,
    ) {
        let mut beta = Rgb::WHITE;
        // What surfaces left of the light, of which roulette took no account yet.
        let mut kept = Rgb::WHITE;
        let mut ray = *ray;
        let mut drawn = None;
        let mut hit = tracer.camera_ray(&ray);
        for depth in 1..=self.max_depth {
            // The light that comes along the path by itself.
            follow.arrived(beta * arriving(tracer, &ray, hit.as_ref(), drawn));
            let Some(here) = hit else { break };
            let Some(material) = here.object.material else {
                break;
            };
            if depth == self.max_depth {
                break;
            }

            // The light of one lamp that is scattered once, here.
            let place = u64::from(depth);
            let at = SolidPoint::new(here, ray.direction);
            let seen = here.surface.facing(-ray.direction);
            let onward = Onward::new(tracer.scene(), &at, Among::<KINDS>(material));
            if let Some(last) = onward.smooth.filter(|&last| follow.wants(last)) {
                let numbers = stream.at(place, Purpose::LightPoint);
                follow.aimed(last, beta * aim(tracer, &onward, &seen, numbers));
            }

            // Choose where to look next.
            let mut numbers = stream.at(place, Purpose::Direction);
            let branch = || stream.at(place, Purpose::Branch).one();
            let Some(step) = onward.sample(&mut numbers, branch) else {
                break;
            };
            if !follow.scattered(step.event) {
                break;
            }
            beta *= step.weight;
            kept *= step.kept;

            // Does the path go on? If so, it also stands for those that did not. It is no worse for
            // being one of many that look for focused light, and carry less each.
            if depth >= self.roulette_from {
                let q = kept.max_channel().clamp(LEAST_SURVIVAL, 1.0);
                let survives = numbers.one() < q;
                if !survives {
                    break;
                }
                beta = beta / q;
                kept = kept / q;
            }
            drawn = step.pdf.map(|pdf| (seen, pdf));
            ray = here.surface.spawn(step.direction);
            hit = tracer.secondary_ray(&ray);
        }
    }
    // ANCHOR_END: path
}

// ANCHOR: kernels
impl Integrator for Path {
    /// By the kernel that knows what is in the scene and nothing else. What it leaves out could not
    /// have happened, so the light is that of [`Path::trace`], bit for bit.
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let scene = tracer.scene();
        if scene.is_dark() {
            return Rgb::BLACK;
        }
        match (scene.kinds(), scene.moves()) {
            (kinds::DIFFUSE, false) => self.still::<{ kinds::DIFFUSE }>(tracer, ray, stream),
            (kinds::SPECULAR, false) => self.still::<{ kinds::SPECULAR }>(tracer, ray, stream),
            (kinds::GLOSS, false) => self.still::<{ kinds::GLOSS }>(tracer, ray, stream),
            (_, false) => self.still::<{ kinds::ALL }>(tracer, ray, stream),
            (kinds::DIFFUSE, true) => self.moving::<{ kinds::DIFFUSE }>(tracer, ray, stream),
            (kinds::SPECULAR, true) => self.moving::<{ kinds::SPECULAR }>(tracer, ray, stream),
            (kinds::GLOSS, true) => self.moving::<{ kinds::GLOSS }>(tracer, ray, stream),
            (_, true) => self.moving::<{ kinds::ALL }>(tracer, ray, stream),
        }
    }
}

impl Path {
    fn still<const KINDS: u8>(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut all = Everything::default();
        tracer.at_rest(|still| self.kernel::<KINDS, false>(still, ray, stream, &mut all));
        all.li
    }

    fn moving<const KINDS: u8>(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut all = Everything::default();
        self.kernel::<KINDS, true>(tracer, ray, stream, &mut all);
        all.li
    }
}
// ANCHOR_END: kernels
/// What the ray found at its end, weighted by how likely aiming was to find it.
fn arriving<const MOVES: bool>(
    tracer: &Tracer<MOVES>,
    ray: &Ray,
    hit: Option<&Hit>,
    drawn: Drawn,
) -> Rgb {
    let scene = tracer.scene();
    let (radiance, light) = match hit {
        Some(hit) => {
            let light = hit.object.light.map(|light| light as usize);
            (hit.emitted(-ray.direction), light)
        }
        None => (scene.background(ray.direction), scene.beyond_light()),
    };
    match (drawn, light) {
        (Some((from, pdf)), Some(index)) if !radiance.is_black() => {
            let at = hit.map(|hit| &hit.surface);
            let pdf_aim = scene.light_choice.probability(from.p, index)
                * tracer.pdf_light(index, &from, ray.direction, at);
            radiance * Heuristic::Power.weight(pdf, pdf_aim)
        }
        _ => radiance,
    }
}

/// The light of all lamps that a surface scatters back, estimated by one of them.
fn aim<const KINDS: u8, const MOVES: bool>(
    tracer: &mut Tracer<MOVES>,
    onward: &Onward<KINDS>,
    from: &Surface,
    mut numbers: Numbers,
) -> Rgb {
    let scene = tracer.scene();
    let at = onward.at;
    let (u, pick) = (numbers.two(), numbers.fine());
    let Some(chosen) = scene.light_choice.choose(from.p, pick) else {
        return Rgb::BLACK;
    };
    let Some(sample) = tracer.sample_light(chosen.index, from, chosen.rest, u) else {
        return Rgb::BLACK;
    };
    let wi = at.frame.to_local(sample.wi);
    let scattered = onward.material.f(at.wo, wi) * wi.z.abs();
    if scattered.is_black() || !tracer.visible(chosen.index, &sample) {
        return Rgb::BLACK;
    }
    scattered
        * match sample.incident {
            Incident::Radiance { li, pdf } => {
                let pdf_aim = pdf * chosen.probability;
                let weight = Heuristic::Power.weight(pdf_aim, onward.pdf(wi, sample.wi));
                li * (weight / pdf_aim)
            }
            Incident::Irradiance(e) => e / chosen.probability,
        }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Film, Options, render};
    use crate::scene::{Scene, gallery};

    /// A path tracer that always takes one kernel.
    struct Always<F>(F);

    impl<F: Fn(&mut Tracer, &Ray, &Stream) -> Rgb + Sync> Integrator for Always<F> {
        fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
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
        let diffuse =
            Always(|t: &mut Tracer, r: &Ray, s: &Stream| path.still::<{ kinds::DIFFUSE }>(t, r, s));
        let no_motion =
            Always(|t: &mut Tracer, r: &Ray, s: &Stream| path.still::<{ kinds::ALL }>(t, r, s));
        for scene in ["gloss", "caustic", "mixture"].map(load) {
            assert_ne!(
                film(&scene, &path),
                film(&scene, &diffuse),
                "{}",
                scene.name
            );
        }
        let motion = load("motion");
        assert_ne!(film(&motion, &path), film(&motion, &no_motion));
        let cornell = load("cornell");
        assert_eq!(film(&cornell, &path), film(&cornell, &diffuse));
    }
}
