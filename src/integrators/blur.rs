//! How much photons blur: what two radii read of the same photons.
//!
//! The blur of a disc is proportional to its squared radius where the light is smooth, so what a disc reads more
//! than half of it is half of its bias. Near the edge of a surface or of a shadow the bias is proportional
//! to the radius, and this estimate has 0.6 of it.
//!
//! Source: Hachisuka, Jarosz, Jensen, A Progressive Error Estimation Framework for Photon Density Estimation
//! (SIGGRAPH Asia 2010), for the bias as a squared radius times second derivatives, estimated by
//! differences.

use super::world::World;
use super::{Integrator, Pass, Passes, Photons, Prepared};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::photons::{PhotonMap, radius};
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};
use crate::space::Solid;
use std::f32::consts::SQRT_2;

/// Samples of the bias of a picture by photons, in place of its light: each may be negative, and their mean is
/// the bias of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct PhotonBlur {
    /// Whose discs are as large in each pass as those of the whole picture in the root mean square.
    photons: Photons,
}

impl PhotonBlur {
    /// The bias of a picture of `scene` with so many samples per pixel.
    pub fn new(photons: &Photons, scene: &Scene, spp: u32) -> Self {
        let (walks, first, _) = photons.first(scene);
        let mean = f64::from(first) * radius::mean::<Solid>(photons.alpha, spp);
        PhotonBlur {
            photons: Photons {
                radius: Some(mean as f32),
                alpha: 1.0,
                walks: Some(walks),
                ..*photons
            },
        }
    }
}

impl Integrator for PhotonBlur {
    fn li(&self, _: &mut Tracer, _: &Ray, _: &Stream) -> Rgb {
        Rgb::BLACK
    }

    fn passes(&self, _: &Scene) -> Option<&dyn Passes> {
        Some(self)
    }
}

impl Passes for PhotonBlur {
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        let (map, rays) = self.photons.map(pass)?;
        let (photons, time) = (&self.photons, pass.moment());
        Some(Prepared {
            eye: Some(Box::new(Differing { photons, time, map })),
            rays,
            ..Prepared::default()
        })
    }
}

struct Differing<'a> {
    photons: &'a Photons,
    time: f32,
    map: PhotonMap,
}

impl Integrator for Differing<'_> {
    // ANCHOR: blur
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut bias = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = ray.at_time(self.time);
        let whole = self.map.radius();
        for depth in 1..self.photons.max_depth {
            let Some(here) = tracer.intersect(&ray, depth) else {
                break;
            };
            if tracer.smooth_event(&here).is_some() {
                let most_segments = self.photons.max_depth - depth;
                let [by_whole, by_half] = [whole, whole / SQRT_2].map(|radius| {
                    Photons::radiance(&self.map, tracer, &here, radius, most_segments)
                });
                // Of the same photons half of the disc has half of the bias.
                bias += beta * (by_whole - by_half) * 2.0;
            }
            // On through mirrors and glass alone: no photons are looked at behind another surface.
            let step = tracer.sample_bsdf(&here, u64::from(depth), stream);
            let Some(step) = step.filter(|step| step.pdf.is_none()) else {
                break;
            };
            beta *= step.weight;
            ray = step.ray;
        }
        bias
    }
    // ANCHOR_END: blur
}
