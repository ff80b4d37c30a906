//! Progressive photon mapping: walks from the lights leave photons, and the eye looks at how dense they
//! lie.
//!
//! Simulates the paths `L(D|S|G)*E`, all of them, also of points and directions: what no other integrator
//! finds is light that a mirror or glass focuses and that is seen in a mirror or through glass, the
//! paths `LS+DS+E` of a point. But it blurs them: light that has met a surface before is estimated by the power of
//! the photons on a disc around a point, and so its mean over that disc is what is seen. Caustics are
//! softer than they are, corners and edges darker.
//!
//! Differs from `light-tracer`: no line from a surface to the eye is needed. Walks from the eye follow
//! mirrors and glass to the first surface that is not, and there take what photons there are. Light
//! straight from its source is not left to photons: a shadow ray and the next ray of the walk, both
//! weighted, find it without blur and with less noise, so that shadows are as sharp as they are. Gloss counts
//! as diffuse: the smoother it is, the fewer of the photons on a disc lie in its lobe, and the larger is the noise.
//!
//! Each pass has a map of its own, and smaller discs than the one before: of the mean of all passes noise and
//! blur fall, together as the power -1/3 of the number of passes. It is consistent, at no number of passes
//! unbiased; the scatter of passes tells the noise alone.
//!
//! Sources: Jensen, Global Illumination Using Photon Maps (Rendering Techniques 1996); Hachisuka, Ogaki,
//! Jensen, Progressive Photon Mapping (TOG 27(5), 2008); Knaus, Zwicker, Progressive Photon Mapping: A
//! Probabilistic Approach (TOG 30(3), 2011), whose passes know nothing of each other.

use super::world::{Emitted, PhotonWorld};
use super::{Entry, Finds, Found, Gain, Integrator, Pass, Passes, Prepared, Survival};
use crate::color::Rgb;
use crate::geometry;
use crate::photons::{Kernel, Photon, PhotonMap, radius};
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{RayCounts, Scene, Tracer};
use crate::space::{Ray, Solid, Space};

/// Walks from the lights, and walks from the eye that look at where they land; in either world.
#[derive(Clone, Copy, Debug)]
pub struct Photons {
    /// Longest path in segments, from the light to the eye.
    pub max_depth: u32,
    /// The radius of the first pass in scene units, positive; `None` for [`radius::first`].
    pub radius: Option<f32>,
    /// How fast discs shrink, in `(0, 1)`, or 1 for discs that stay: see [`radius::shrunk`].
    pub alpha: f64,
    /// Walks from the lights in each pass; `None` for as many as there are pixels, and at most
    /// [`Photons::USUAL_WALKS`].
    pub walks: Option<u32>,
    /// How much a photon counts by its distance.
    pub kernel: Kernel,
}

/// From here on roulette decides whether a walk goes on, whatever it meets.
const ROULETTE_FROM: u32 = 5;

impl Photons {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry {
        biased: Some(
            "what photons bring is blurred over discs, which shrink from pass to pass and never vanish",
        ),
        ..Entry::of_light(
            [
                "photons",
                "walks from the lights, looked at where they land",
                "Progressive photon mapping: finds all light, also caustics of points seen in mirrors, but \
                 blurs it; the more samples, the less",
            ],
            Finds {
                lamps: Found::ALL,
                image: Found::ALL,
                sky: Found::ALL,
                points: Found::ALL,
                by_chance: false,
            },
            |settings| {
                Box::new(Photons {
                    radius: settings.radius,
                    walks: settings.walks,
                    ..Photons::new(settings.max_depth)
                })
            },
        )
    };

    /// The most walks of a pass where none are asked for: so many photons fit into some hundred megabytes.
    pub const USUAL_WALKS: u32 = 1 << 18;

    /// The most walks of a pass.
    pub const MOST_WALKS: u32 = 1 << 24;

    /// The photon mapper of scenes whose noise and blur fall fastest together.
    pub fn new(max_depth: u32) -> Self {
        Photons::in_space::<Solid>(max_depth)
    }

    /// The same for either world.
    pub fn in_space<S: Space>(max_depth: u32) -> Self {
        Photons {
            max_depth,
            radius: None,
            alpha: radius::fastest::<S>(),
            walks: None,
            kernel: Kernel::default(),
        }
    }

    /// Walks of a pass over so many pixels, and the radius of the first pass; the rays that looked for it.
    pub fn first(&self, scene: &Scene) -> (u32, f32, RayCounts) {
        let pixels = scene.size[0].saturating_mul(scene.size[1]);
        let walks = self.walks.unwrap_or(pixels.min(Self::USUAL_WALKS));
        let (radius, rays) = match self.radius {
            Some(radius) => (radius, RayCounts::default()),
            None => radius::first(scene, walks),
        };
        (walks, radius, rays)
    }

    // ANCHOR: leave
    /// Traces one path from a light at the moment `time`, in `[0, 1]`, and calls `leave` with its
    /// photons: one at each surface that is not perfectly specular.
    pub fn trace<S: Space, W: PhotonWorld<S>>(
        &self,
        world: &mut W,
        time: f32,
        stream: &Stream,
        leave: &mut dyn FnMut(Photon<S>),
    ) {
        if let Some(start) = world.emit(time, stream) {
            self.follow(world, start, stream, leave);
        }
    }

    /// The same for a path that has just left a light.
    pub fn follow<S: Space, W: PhotonWorld<S>>(
        &self,
        world: &mut W,
        start: Emitted<S>,
        stream: &Stream,
        leave: &mut dyn FnMut(Photon<S>),
    ) {
        let Emitted {
            mut ray,
            mut power,
            is_delta,
        } = start;
        let mut gain = Gain::new(is_delta);
        let mut throughput = Rgb::WHITE;
        for segments in 1..self.max_depth {
            let Some(here) = world.land(&ray) else {
                break;
            };
            if world.smooth_event(&here).is_some() {
                leave(world.photon(&here, power * gain.factor(), segments));
            }
            let vertex = u64::from(segments);
            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            gain = world.gain(gain, &here, &step.ray);
            power *= step.weight;
            throughput *= step.weight;
            ray = step.ray;

            // A surface that keeps half of the light keeps half of the photons, so that all have about
            // the same power.
            if step.pdf.is_some() || segments >= ROULETTE_FROM {
                let q = Survival::Throughput(0.05).probability(throughput);
                let survives = stream.at(vertex, Purpose::Survival).one() < q;
                if !survives {
                    break;
                }
                power = power / q;
                throughput = throughput / q;
            }
        }
    }
    // ANCHOR_END: leave

    // ANCHOR: radiance
    /// The radiance that a point scatters to where it is seen from, of photons whose paths have at most so
    /// many segments, by discs of this radius.
    pub fn radiance<S: Space, W: PhotonWorld<S>>(
        map: &PhotonMap<S>,
        world: &W,
        at: &W::Point,
        radius: f32,
        most_segments: u32,
    ) -> Rgb {
        let (p, n) = world.place(at);
        // The cosine of a photon's direction is in its power already.
        map.estimate(p, n, radius, |photon| {
            if photon.segments > most_segments {
                return Rgb::BLACK;
            }
            world.f(at, photon.wi) * photon.power
        })
    }
    // ANCHOR_END: radiance

    // ANCHOR: look
    /// One estimate of the radiance along a ray from the eye; `photons` says what those of a pass bring
    /// to a point by paths of at most so many segments.
    pub(super) fn walk<S: Space, W: PhotonWorld<S>>(
        &self,
        world: &mut W,
        ray: &Ray<S>,
        stream: &Stream,
        photons: impl Fn(&W, &W::Point, u32) -> Rgb,
    ) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        // The surface with photons that the ray left, and with what density.
        let mut looked: Option<(W::Point, f32)> = None;
        for depth in 1..=self.max_depth {
            let hit = world.intersect(&ray, depth);

            // The light that comes along the path by itself: shadow rays could have found it, too.
            let weight = looked.as_ref().map_or(1.0, |(from, pdf)| {
                Heuristic::Power.weight(*pdf, world.pdf_light(from, &ray, hit.as_ref()))
            });
            li += beta * world.emitted(&ray, hit.as_ref()) * weight;
            let Some(here) = hit else { break };
            if looked.is_some() || depth == self.max_depth {
                break;
            }

            let vertex = u64::from(depth);
            if world.smooth_event(&here).is_some() {
                // Light that has met no surface before.
                for light in 0..world.lights() {
                    if let Some(direct) = world.sample_light(&here, light, vertex, stream) {
                        li += beta * direct.weighted(Heuristic::Power);
                    }
                }
                // Light that has.
                li += beta * photons(world, &here, self.max_depth - depth);
            }

            let Some(step) = world.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            beta *= step.weight;
            if depth >= ROULETTE_FROM {
                let q = Survival::Throughput(0.05).probability(beta);
                let survives = stream.at(vertex, Purpose::Survival).one() < q;
                if !survives {
                    break;
                }
                beta = beta / q;
            }
            ray = step.ray;
            if let Some(pdf) = step.pdf {
                looked = Some((here, pdf));
            }
        }
        li
    }
    // ANCHOR_END: look

    /// One estimate of the radiance along a ray from the eye, by the photons of a pass.
    ///
    /// * `map`: photons of paths with two segments or more; light straight from the lights is found otherwise.
    pub fn look<S: Space, W: PhotonWorld<S>>(
        &self,
        map: &PhotonMap<S>,
        world: &mut W,
        ray: &Ray<S>,
        stream: &Stream,
    ) -> Rgb {
        self.walk(world, ray, stream, |world, at, most_segments| {
            Self::radiance(map, world, at, map.radius(), most_segments)
        })
    }

    /// The photons of one pass over a scene, in a map of its discs, and the rays they took; `None` where
    /// it was stopped.
    pub(super) fn map(&self, pass: &Pass) -> Option<(PhotonMap, RayCounts)> {
        let (walks, first, mut rays) = self.first(pass.scene);
        let radius = f64::from(first) * radius::shrunk::<Solid>(self.alpha, pass.sample);
        // Photons lie where surfaces are at one moment, and are looked at there.
        let time = pass.moment();
        let (photons, traced) = pass.trace(0..walks, |tracer, stream, leave| {
            // Light straight from its source is found otherwise.
            self.trace(tracer, time, stream, &mut |photon| {
                if photon.segments > 1 {
                    leave(photon);
                }
            });
        })?;
        rays += traced;
        Some((
            PhotonMap::new(photons, walks, radius as f32, self.kernel),
            rays,
        ))
    }
}

impl Integrator for Photons {
    /// What is found without photons: lights that are seen, and light that has met one surface which is no
    /// mirror or glass.
    fn li(&self, tracer: &mut Tracer, ray: &geometry::Ray, stream: &Stream) -> Rgb {
        self.walk(tracer, ray, stream, |_, _, _| Rgb::BLACK)
    }

    fn passes(&self, _: &Scene) -> Option<&dyn Passes> {
        Some(self)
    }

    fn photons(&self) -> Option<&Photons> {
        Some(self)
    }
}

impl Passes for Photons {
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        let (map, rays) = self.map(pass)?;
        let time = pass.moment();
        Some(Prepared {
            eye: Some(Box::new(Looking {
                photons: self,
                time,
                map,
            })),
            rays,
            ..Prepared::default()
        })
    }
}

/// The photon mapper of one pass.
struct Looking<'a> {
    photons: &'a Photons,
    time: f32,
    map: PhotonMap,
}

impl Integrator for Looking<'_> {
    fn li(&self, tracer: &mut Tracer, ray: &geometry::Ray, stream: &Stream) -> Rgb {
        let ray = ray.at_time(self.time);
        self.photons.look(&self.map, tracer, &ray, stream)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::Path;
    use crate::render::{Film, Options, render};
    use crate::scene::{Scene, gallery, read::Source};

    /// A floor that rises a little under a ceiling with a lamp.
    const RISING: &str = "name = 'test'\nfilm.size = [8, 8]\nmaterials.half.lambert.albedo = 0.5\n\
        [camera]\nfrom = [0, 2, 0]\nto = [0, 0, 0]\nup = [0, 0, 1]\nfov = 40\nshutter = [0, 1]\n\
        [[objects]]\nmaterial = 'half'\nmotion = [0, 0.4, 0]\n\
        quad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n\
        [[objects]]\nmaterial = 'half'\n\
        quad = { corner = [-9, 3, -9], u = [18, 0, 0], v = [0, 0, 18] }\n\
        [[lights]]\npoint = { position = [0, 2.5, 0], intensity = 1 }\n";

    fn film(scene: &Scene, integrator: &dyn Integrator, spp: u32) -> Film {
        let options = Options {
            spp,
            ..Options::default()
        };
        render(scene, integrator, &options, &()).film
    }

    #[test]
    fn photons_are_looked_at_where_surfaces_were_when_they_landed() {
        let source = Source {
            file: "test.toml",
            text: RISING,
        };
        let scene = gallery::from_text(source, None, |_| {}).expect("a scene");
        // Light by way of the ceiling, and nothing else: a third of the light.
        let truth = film(&scene, &Path::new(3), 512).mean().0;
        let direct = film(&scene, &Path::new(2), 512).mean().0;
        let photons = Photons {
            radius: Some(0.1),
            walks: Some(1 << 11),
            ..Photons::new(3)
        };
        let ours = film(&scene, &photons, 1024).mean().0;
        println!("{ours} for {truth}; {direct} comes straight from the lamp");
        assert!(direct < 0.9 * truth, "{direct} {truth}");
        assert!((ours / truth - 1.0).abs() < 0.03, "{ours} {truth}");
    }
}
