//! Whitted's ray tracing: a tree of mirror and glass rays, and shadow rays at its leaves.
//!
//! Simulates the paths `LD?S*E`: light that is seen directly, through any number of perfectly
//! specular bounces, or after exactly one diffuse reflection. An image around the scene is a lamp
//! that diffuse surfaces ask; a background of one colour is only seen. Light that bounces between
//! diffuse surfaces, or is focused on one by glass, is not there. Rough mirrors and rough glass count
//! as diffuse here: they show lamps, and nothing else.
//!
//! Source: Whitted, An Improved Illumination Model for Shaded Display (CACM 23(6), 1980). His
//! lights are points; here a shadow ray aims at a random point of an extended light.

use super::{Entry, Finds, Found, Integrator, RayKind, TreeObserver, TreeRay};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::materials::Branch;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Interaction, Tracer};

const AT_SKIES: &str = "it aims at a sky from rough surfaces only where the sky is an image, and goes no \
                        further";

/// Whitted's integrator.
#[derive(Clone, Copy, Debug)]
pub struct Whitted {
    /// Longest path in segments: the camera ray is the first, the shadow ray the last. The tree
    /// may double with each, so at most [`Whitted::MAX_DEPTH`].
    pub max_depth: u32,
}

impl Whitted {
    /// Its row of the table.
    pub const ENTRY: Entry = Entry {
        longest: Whitted::MAX_DEPTH,
        ..Entry::of_light(
            [
                "whitted",
                "a tree of specular rays, and a shadow ray to each lamp",
                "Shadow, mirror and glass rays; no light between diffuse surfaces",
            ],
            Finds {
                lamps: Found {
                    paths: Some("L(D|G)?S*E"),
                    because: "it aims from the first rough surface of a path and goes no further",
                },
                image: Found {
                    paths: Some("L(D|G)?S*E"),
                    because: AT_SKIES,
                },
                sky: Found {
                    paths: Some("LS*E"),
                    because: AT_SKIES,
                },
                points: Found {
                    paths: Some("L(D|G)S*E"),
                    because: "it aims from the first rough surface of a path and goes no further, and no \
                              aim goes through mirrors or glass",
                },
                by_chance: false,
            },
            |settings| {
                Box::new(Whitted {
                    max_depth: settings.max_depth,
                })
            },
        )
    };
}

impl Whitted {
    /// The deepest tree whose nodes can be numbered.
    pub const MAX_DEPTH: u32 = 63;

    /// The radiance along `ray`, with someone looking on.
    pub fn watch(
        &self,
        tracer: &mut Tracer,
        ray: &Ray,
        stream: &Stream,
        watcher: &mut impl TreeObserver,
    ) -> Rgb {
        debug_assert!(self.max_depth <= Self::MAX_DEPTH);
        let root = TreeRay {
            node: 1,
            depth: 1,
            kind: RayKind::Camera,
            weight: 1.0,
        };
        let hit = tracer.camera_ray(ray);
        self.trace(tracer, ray, hit, &root, stream, watcher)
    }

    // ANCHOR: trace
    /// The radiance that arrives along one ray of the tree.
    fn trace(
        &self,
        tracer: &mut Tracer,
        ray: &Ray,
        hit: Option<Interaction>,
        here: &TreeRay,
        stream: &Stream,
        watcher: &mut impl TreeObserver,
    ) -> Rgb {
        watcher.saw(here, ray, hit.as_ref());
        let Some(hit) = hit else {
            return tracer.scene().background(ray.direction);
        };

        // The light this surface sends towards the eye by itself.
        let mut li = hit.emission;
        if here.depth < self.max_depth {
            li += direct_light(tracer, &hit, here.node, stream);
        }
        watcher.gained(here.node, li);

        // The light it passes on: one ray for each perfectly specular direction.
        if here.depth < self.max_depth
            && let Some(bsdf) = hit.bsdf
        {
            let specular = bsdf.specular(hit.wo);
            let mut branch = |b: Branch, kind, node| {
                let next_ray = hit.surface.spawn(hit.frame.to_world(b.wi).normalize());
                let next = TreeRay {
                    node,
                    depth: here.depth + 1,
                    kind,
                    weight: here.weight * mean(b.weight),
                };
                let next_hit = tracer.secondary_ray(&next_ray);
                b.weight * self.trace(tracer, &next_ray, next_hit, &next, stream, watcher)
            };
            if let Some(b) = specular.reflected {
                li += branch(b, RayKind::Reflected, 2 * here.node);
            }
            if let Some(b) = specular.transmitted {
                li += branch(b, RayKind::Transmitted, 2 * here.node + 1);
            }
        }
        li
    }
    // ANCHOR_END: trace
}

impl Integrator for Whitted {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        self.watch(tracer, ray, stream, &mut ())
    }
}

// ANCHOR: direct_light
/// The light of all lamps that the surface scatters diffusely back; `node` is the place in the tree
/// whose random numbers choose the points on the lamps.
pub fn direct_light(tracer: &mut Tracer, hit: &Interaction, node: u64, stream: &Stream) -> Rgb {
    let Some(bsdf) = hit.bsdf.filter(|bsdf| bsdf.is_smooth()) else {
        return Rgb::BLACK;
    };
    let mut light_out = Rgb::BLACK;
    for i in 0..tracer.scene().sampled_lights() {
        let mut numbers = stream.at_item(node, Purpose::LightPoint, i as u32);
        let (u, pick) = (numbers.two(), numbers.fine());
        let Some(sample) = tracer.light_sample(i, &hit.surface, pick, u) else {
            continue;
        };
        let wi = hit.frame.to_local(sample.wi);
        let f = bsdf.f(hit.wo, wi);
        let cos = wi.z.abs();
        // A shadow ray costs as much as any other: it is not sent where nothing could come of it.
        if !f.is_black() && cos > 0.0 && tracer.visible(i, &sample) {
            light_out += f * sample.incident.facing_irradiance() * cos;
        }
    }
    light_out
}
// ANCHOR_END: direct_light

fn mean(weight: Rgb) -> f64 {
    let [r, g, b] = weight.channels().map(f64::from);
    // A grey weight stays exactly itself.
    if r == g && g == b {
        r
    } else {
        (r + g + b) / 3.0
    }
}
