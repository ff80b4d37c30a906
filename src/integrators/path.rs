//! Path tracing as one would use it: all materials, lamps and cameras, one shadow ray at each
//! surface, both techniques combined, and an end by roulette.
//!
//! Simulates the paths `L(S|G|D)*E` of lamps with extent, of the background and the environment, and
//! of point and directional lights `L(D|G)(S|G|D)*E` and `LS(S|G|D)*(D|G)E`: the light of `combine`, and what
//! mirrors and glass focus of points.
//!
//! Differs from `combine`: one lamp is chosen by what it may give at the point, where that asks all,
//! so that a scene may have thousands; a sky of one colour is aimed at now and then; a path that carries
//! little may end before the depth cut. Where a scene has mirrors or glass, what they focus onto surfaces that
//! the eye sees is traced from the lights ([`Caustics`]); what is focused and seen in a mirror or through glass
//! is not found that way, and there some of the rays from other surfaces look towards what focuses light.
//! It is the ladder's last rung and puts its steps together; most have a rung of their own.
//!
//! Sources: Kajiya, The Rendering Equation (SIGGRAPH 1986); Arvo, Kirk, Particle Transport and Image
//! Synthesis (SIGGRAPH 1990); Veach, Guibas, Optimally Combining Sampling Techniques for Monte Carlo
//! Rendering (SIGGRAPH 1995); Jensen, Global Illumination Using Photon Maps (Rendering Techniques
//! 1996), "Projection maps", for looking where light is focused.

use super::observer::{AllLight, FromEye, PathObserver};
use super::world::{Guided, World};
use super::{
    Arrival, Caustics, Entry, Finds, Found, Integrator, Pass, Passes, PathInLanes, Prepared,
};
use crate::color::Rgb;
use crate::geometry;
use crate::materials::kinds;
use crate::notation::Letter;
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};
use crate::space::{Ray, Space};

/// The production path tracer.
#[derive(Clone, Copy, Debug)]
pub struct Path {
    /// Longest path in segments: the camera ray is the first, the shadow ray, or the ray that hits
    /// a lamp or leaves the scene, the last.
    pub max_depth: u32,
    /// Paths of fewer segments never play roulette. At [`Path::max_depth`] none does.
    pub roulette_from: u32,
    /// Paths from the lights in each sample of all pixels, where the scene calls for them: see [`Caustics`].
    /// `None` for one for every [`Path::PIXELS_PER_LIGHT_PATH`] pixels; with 0 of them all light is looked for from
    /// the eye.
    pub light_paths: Option<u32>,
}

/// Even a path that carries next to nothing survives roulette with this probability, so no survivor is
/// weighted up by more than its reciprocal.
pub(super) const LEAST_SURVIVAL: f32 = 0.05;

impl Path {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry::of_light(
        [
            "path",
            "all of it: one lamp, weighted, roulette",
            "Path tracing with everything: shadow rays, both techniques weighted, roulette; all \
             materials, lamps and cameras",
        ],
        Finds {
            points: Found {
                paths: Some("L((D|G)(D|S|G)*|S(D|S|G)*(D|G))E"),
                because: "where it comes and is seen through mirrors or glass, walks from the eye and from the \
                          light are both bound to single directions, and cannot be joined",
            },
            ..Finds::BY_AIMING
        },
        |settings| {
            Box::new(Path {
                light_paths: settings.light_paths,
                ..Path::new(settings.max_depth)
            })
        },
    );

    /// Pixels for which one path starts at the lights. What such paths bring has so little noise that more of
    /// them would only take the time of paths from the eye: for the same error one for 8 pixels takes from 0.80 to 0.99 of
    /// the time of one for 4, in the scenes `spheres`, `caustic`, `final`, `room`, `whitted`, `mixture` and
    /// `courtyard`; one for 16 takes from 0.71 to 1.07.
    pub const PIXELS_PER_LIGHT_PATH: u32 = 8;

    /// Up to here every number of paths is exact in `f32`, in which their light is scaled.
    pub const MOST_LIGHT_PATHS: u32 = 1 << 24;

    /// A path tracer whose roulette starts with the fifth segment.
    pub fn new(max_depth: u32) -> Self {
        Path {
            max_depth,
            roulette_from: 5,
            light_paths: None,
        }
    }

    /// The path tracer that looks for all light from the eye.
    pub fn from_eye(max_depth: u32) -> Self {
        Path {
            light_paths: Some(0),
            ..Path::new(max_depth)
        }
    }

    /// Paths from the lights in each sample of all pixels of a scene; 0 where caustics are not traced from there.
    pub fn light_paths_of(&self, scene: &Scene) -> u32 {
        let pixels = scene.size[0].saturating_mul(scene.size[1]);
        let usual = pixels.div_ceil(Path::PIXELS_PER_LIGHT_PATH);
        match self.traces_caustics(scene) {
            true => self.light_paths.unwrap_or(usual),
            false => 0,
        }
    }

    /// The same, where nobody asked for their number.
    pub(super) fn free_light_paths(&self, scene: &Scene) -> Option<u32> {
        let free = self.light_paths.is_none() && self.traces_caustics(scene);
        free.then(|| self.light_paths_of(scene))
    }

    /// The same path tracer with so many paths from the lights.
    #[must_use]
    pub fn with(self, light_paths: u32) -> Path {
        Path {
            light_paths: Some(light_paths),
            ..self
        }
    }

    /// True where caustics of the scene are traced from the lights: it has lights, what focuses their light, and what shows
    /// it.
    pub fn traces_caustics(&self, scene: &Scene) -> bool {
        self.light_paths != Some(0) && self.max_depth > 2 && !scene.caustic_choice.is_dark()
    }

    /// The light of a pass that is traced from the lights: see [`Caustics::prepare`].
    pub fn caustics(
        &self,
        pass: &Pass,
        arrival: impl Fn(&[Letter]) -> Arrival + Sync,
    ) -> Option<Prepared<'static>> {
        let max_depth = self.max_depth;
        let paths = self.light_paths_of(pass.scene);
        Caustics { max_depth }.prepare(pass, paths, arrival)
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
        // Throughput that Russian roulette has not accounted for yet.
        let mut rr_beta = Rgb::WHITE;
        let mut ray = *ray;
        // The surface that drew the ray, and with what density; nobody else could have drawn one
        // from the eye or after a mirror.
        let mut drawn = None;
        for depth in 1..=self.max_depth {
            let hit = world.intersect(&ray, depth);

            // The light that comes along the path by itself: aiming could have found it, too.
            let mut li = world.emitted(&ray, hit.as_ref());
            if let Some((from, pdf)) = &drawn
                && !li.is_black()
            {
                let pdf_light = world.pdf_light(from, &ray, hit.as_ref());
                li = li * Heuristic::Power.weight(*pdf, pdf_light);
            }
            follow.arrived(beta * li, hit.is_none());
            let Some(here) = hit else { break };
            if depth == self.max_depth {
                break;
            }

            // The light of lamps that is scattered once, here: chance could have found it.
            let vertex = u64::from(depth);
            if let Some(last) = world.smooth_event(&here).filter(|&e| follow.wants(e)) {
                for lamp in 0..world.lights() {
                    if let Some(direct) = world.sample_light(&here, lamp, vertex, stream) {
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

            // Russian roulette: a survivor also stands for the paths that ended here. Its chance is
            // what the surfaces left of the light, whichever density drew the directions.
            if depth >= self.roulette_from {
                let q = rr_beta.max_channel().clamp(LEAST_SURVIVAL, 1.0);
                let survives = step.left < q;
                if !survives {
                    break;
                }
                beta = beta / q;
                rr_beta = rr_beta / q;
            }
            drawn = step.pdf.map(|pdf| (here, pdf));
            ray = step.ray;
        }
    }
    // ANCHOR_END: path

    /// Traces one path in a scene, and tells `follow` all light that it finds and that is not traced from the
    /// lights.
    pub fn trace(
        &self,
        tracer: &mut Tracer,
        ray: &geometry::Ray,
        stream: &Stream,
        follow: &mut impl PathObserver,
    ) {
        self.among::<{ kinds::ALL }>(tracer, ray, stream, follow);
    }

    /// The same in a scene whose BSDFs are among `KINDS` (see [`kinds`]).
    fn among<const KINDS: u8>(
        &self,
        tracer: &mut Tracer,
        ray: &geometry::Ray,
        stream: &Stream,
        follow: &mut impl PathObserver,
    ) {
        let scene = tracer.scene();
        let from_lights = KINDS & kinds::SPECULAR != 0 && self.traces_caustics(scene);
        let mut world = Guided::<KINDS>::new(tracer, from_lights);
        if from_lights {
            self.walk(&mut world, ray, stream, &mut FromEye::new(scene, follow));
        } else {
            self.walk(&mut world, ray, stream, follow);
        }
    }
}

// ANCHOR: kernels
impl Integrator for Path {
    /// By code for the BSDFs that are in the scene, and no others. What it leaves out could not have
    /// happened, so the light is that of [`Path::trace`], bit for bit.
    fn li(&self, tracer: &mut Tracer, ray: &geometry::Ray, stream: &Stream) -> Rgb {
        let scene = tracer.scene();
        let mut all = AllLight::default();
        match scene.kinds() {
            _ if scene.is_dark() => {}
            kinds::DIFFUSE => self.among::<{ kinds::DIFFUSE }>(tracer, ray, stream, &mut all),
            kinds::SPECULAR => self.among::<{ kinds::SPECULAR }>(tracer, ray, stream, &mut all),
            kinds::GLOSS => self.among::<{ kinds::GLOSS }>(tracer, ray, stream, &mut all),
            _ => self.among::<{ kinds::ALL }>(tracer, ray, stream, &mut all),
        }
        all.li
    }

    fn in_lanes<'s>(&self, scene: &'s Scene) -> Option<PathInLanes<'s>> {
        PathInLanes::new(self, scene)
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        self.traces_caustics(scene).then_some(self)
    }
}
// ANCHOR_END: kernels

impl Passes for Path {
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        self.caustics(pass, |_| Arrival::Counts)
    }

    fn light_paths(&self, scene: &Scene) -> Option<u32> {
        self.free_light_paths(scene)
    }

    fn with_light_paths(&self, light_paths: u32) -> Option<Box<dyn Integrator + '_>> {
        Some(Box::new(self.with(light_paths)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Film, Options, render};
    use crate::scene::gallery;

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
            let mut all = AllLight::default();
            path.among::<{ kinds::DIFFUSE }>(t, r, s, &mut all);
            all.li
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
