//! Path tracing as a pure random walk: one ray in, one ray out, until a light happens to be hit.
//!
//! Simulates the paths `L(S|D)*E` of lamps with extent and of the background: all there are, up to
//! the depth cut. Point and directional lights have no extent, so no walk ever meets them; a scene
//! lit by nothing else is black.
//!
//! Differs from `whitted`: where that follows every branch of a tree and asks every lamp, this
//! chooses one direction, diffuse ones too, and asks nobody. A path costs as many rays as it has
//! segments; small lamps are found rarely, and the picture is as noisy as they are small.
//!
//! Source: Kajiya, The Rendering Equation (SIGGRAPH 1986), without his rays to the lights: those
//! are the next stage, `next_event`.

use super::Integrator;
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::sampling::frame::Frame;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::Tracer;

/// The pure random walk.
#[derive(Clone, Copy, Debug)]
pub struct Kajiya {
    /// Longest path in segments: the camera ray is the first, the one that hits a lamp or leaves
    /// the scene the last.
    pub max_depth: u32,
}

impl Integrator for Kajiya {
    // ANCHOR: kajiya
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        let mut hit = tracer.camera_ray(&ray);
        for depth in 1.. {
            let Some(here) = hit else {
                return li + beta * tracer.scene().background;
            };

            // The light this surface sends along the path by itself.
            li += beta * here.emitted(-ray.direction);
            let Some(material) = here.object.material else {
                break;
            };
            if depth >= self.max_depth {
                break;
            }

            // Choose where to look next: any direction of the smooth part, or one of the few
            // specular ones.
            let bounce = u64::from(depth);
            let frame = Frame::new(here.surface.n);
            let wo = frame.to_local(-ray.direction);
            let u = stream.at(bounce, Purpose::Direction).two();
            let (wi, weight) = if let Some(s) = material.sample(wo, u) {
                let cos = s.wi.z.abs();
                (s.wi, s.f * cos / s.pdf)
            } else {
                let u = stream.at(bounce, Purpose::Branch).one();
                let Some(branch) = material.specular(wo).choose(u) else {
                    break;
                };
                (branch.wi, branch.weight)
            };
            beta *= weight;
            ray = here.surface.spawn(frame.to_world(wi).normalize());
            hit = tracer.secondary_ray(&ray);
        }
        li
    }
    // ANCHOR_END: kajiya
}
