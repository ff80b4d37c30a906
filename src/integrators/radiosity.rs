//! Radiosity as an integrator: direct light asked for at every point, all other light from patches.
//!
//! Simulates the paths `LD*(S|G)*E`. The matrix has no place for mirrors, glass and gloss: between two
//! diffuse surfaces they only stand in the way. The eye's own rays follow them, and end at the first
//! diffuse surface. Gloss is lit on the way by shadow rays and by the ray that follows it, both weighted.
//! What is seen at the end is light that comes straight from lamps, by a shadow ray to each, and light from
//! other patches, by one random direction in which the patch is looked up: the final gather of the solution.
//! Its noise goes away with samples; the error of the patches does not.
//!
//! Sources: Goral, Torrance, Greenberg, Battaile, Modeling the Interaction of Light Between Diffuse
//! Surfaces (SIGGRAPH 1984); Reichert, A Two-Pass Radiosity Method Driven by Lights and Viewer Position
//! (MSc thesis, Cornell 1992), for the final gather.

use super::world::World;
use super::{Entry, Finds, Found, Integrator};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::materials::{Bsdf, Event};
use crate::radiosity::{PatchSize, RadiosityError, Report, Solution, Watch};
use crate::sampling::hemisphere;
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Interaction, Scene, Tracer};
use glam::{DVec3, Vec3};

/// Light from patches.
#[derive(Clone, Debug)]
pub struct Radiosity {
    /// The longest path of the eye's own rays in segments. Light between patches goes on to its end.
    pub max_depth: u32,
    solution: Solution,
    report: Report,
}

/// Why it finds no other light.
const BECAUSE: &str = "patches hold diffuse light alone, and only rays from the eye follow mirrors, glass and \
                       gloss";

/// Why its scatter is not all of its error.
const BIAS: &str = "the light that patches hold is off by the size of the patches";

impl Radiosity {
    /// Its row of the table.
    pub const ENTRY: Entry = {
        let all = Found {
            paths: Some("LD*(S|G)*E"),
            because: BECAUSE,
        };
        Entry {
            is_endless: true,
            biased: Some(BIAS),
            ..Entry::of_solved_light(
                [
                    "radiosity",
                    "light solved on patches, and shadow rays",
                    "Light between diffuse surfaces solved on patches beforehand, once for all views: \
                     LD*(S|G)*E, with an error that comes of the size of the patches",
                ],
                Finds {
                    lamps: all,
                    image: all,
                    sky: all,
                    points: Found {
                        paths: Some("L(D+|G)(S|G)*E"),
                        because: BECAUSE,
                    },
                    by_chance: false,
                },
                |scene, settings| {
                    let (depth, size) = (settings.max_depth, settings.patches);
                    Ok(Box::new(Radiosity::new(
                        scene,
                        depth,
                        size,
                        settings.watch,
                    )?))
                },
            )
        }
    };

    /// Solves a scene.
    pub fn new(
        scene: &Scene,
        max_depth: u32,
        size: PatchSize,
        watch: &dyn Watch,
    ) -> Result<Self, RadiosityError> {
        let solution = Solution::new(scene, size, watch)?;
        let report = Report::new(scene, &solution, watch)?;
        Ok(Radiosity {
            max_depth,
            solution,
            report,
        })
    }

    /// The light on the patches.
    pub fn solution(&self) -> &Solution {
        &self.solution
    }

    // ANCHOR: radiosity
    /// The light along a ray from the eye.
    fn walk(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        // The glossy surface that drew the ray, and with what density.
        let mut drawn: Option<(Interaction, f32)> = None;
        for depth in 1..=self.max_depth {
            let hit = tracer.intersect(&ray, depth);
            let weight = drawn.map_or(1.0, |(from, pdf)| {
                Heuristic::Power.weight(pdf, tracer.pdf_light(&from, &ray, hit.as_ref()))
            });
            li += beta * tracer.emitted(&ray, hit.as_ref()) * weight;
            let Some(here) = hit else { break };

            let vertex = u64::from(depth);
            let albedo = diffuse_albedo(&here);
            let is_diffuse = !albedo.is_black();
            if is_diffuse {
                let lights = 0..tracer.scene().lights.len();
                let direct = lights.filter_map(|l| tracer.sample_light(&here, l, vertex, stream));
                let direct: Rgb = direct.map(|light| light.scattered()).sum();
                li += beta * (direct + albedo * self.gather(tracer, &here, vertex, stream));
            }

            // Mirrors, glass and gloss are followed; gloss is also lit by shadow rays.
            if depth == self.max_depth {
                break;
            }
            if !is_diffuse {
                li += beta * lit(tracer, &here, vertex, stream);
            }
            let Some(step) = tracer.sample_bsdf(&here, vertex, stream) else {
                break;
            };
            if is_diffuse && step.event == Event::Diffuse {
                break;
            }
            drawn = step.pdf.map(|pdf| (here, pdf));
            beta *= step.weight;
            ray = step.ray;
        }
        li
    }

    /// What arrives from the patches, as a mean of radiances over the hemisphere: the radiance that the
    /// patch reflects which is met in a random direction.
    fn gather(&self, tracer: &mut Tracer, here: &Interaction, vertex: u64, stream: &Stream) -> Rgb {
        let u = stream.at_item(vertex, Purpose::Direction, 1).two();
        let up = hemisphere::sample_cosine(u);
        let local = Vec3::new(up.x, up.y, up.z * here.wo.z.signum());
        let direction = here.frame.to_world(local).normalize();
        let met = tracer.secondary_ray(&here.surface.spawn(direction));
        met.map_or(Rgb::BLACK, |there| {
            let front = there.wo.z > 0.0;
            let p = there.surface.p.as_dvec3();
            let reflected = self.solution.constant(there.shape, p, front);
            Rgb::from(reflected.map(|x| x as f32))
        })
    }
    // ANCHOR_END: radiosity
}

/// What a surface that is followed scatters of the light of all lights, by a shadow ray to each: its share, for
/// the ray that follows it finds them, too.
fn lit<'a>(tracer: &mut Tracer<'a>, here: &Interaction<'a>, vertex: u64, stream: &Stream) -> Rgb {
    let mut sum = Rgb::BLACK;
    for light in 0..tracer.lights() {
        if let Some(direct) = tracer.sample_light(here, light, vertex, stream) {
            let share = |pdf| Heuristic::Power.weight(pdf, direct.pdf_bsdf);
            sum += direct.scattered() * direct.pdf.map_or(1.0, share);
        }
    }
    sum
}

/// The share of light that a point scatters ideally diffusely.
fn diffuse_albedo(at: &Interaction) -> Rgb {
    match at.bsdf {
        Some(Bsdf::Lambert(lambert)) => lambert.albedo,
        Some(Bsdf::Mixture(mixture)) => mixture.kd,
        _ => Rgb::BLACK,
    }
}

impl Integrator for Radiosity {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        self.walk(tracer, ray, stream)
    }

    fn solved(&self) -> Option<&Report> {
        Some(&self.report)
    }

    fn moved(&self, by: DVec3) -> Option<Box<dyn Integrator>> {
        let solution = self.solution.clone().moved(by);
        Some(Box::new(Radiosity { solution, ..*self }))
    }
}
