//! Path tracing with next-event estimation: the walk of `kajiya`, which asks every lamp on its way.
//!
//! Simulates the paths `L(S|D)*E` of lamps with extent and of the background, like `kajiya` and
//! with the same expected value. Of point and directional lights it has the paths `LD(S|D)*E`:
//! their light through glass or by a mirror onto a diffuse surface is on no path it can find.
//!
//! Differs from `kajiya`: at each diffuse hit a shadow ray goes to every lamp. Their light is then
//! in the sum, and must not count again where the walk meets a lamp by chance, except straight from
//! the eye or after a mirror or glass, where no shadow ray could ask for it. The background is no
//! lamp one aims at: it counts wherever the walk leaves the scene. Less noise where lamps are small
//! or far; more close to large ones, because their points are drawn uniformly in area: where two
//! lamps, or a lamp and a wall before it, meet in an edge, the variance is infinite.
//!
//! Source: Kajiya, The Rendering Equation (SIGGRAPH 1986); Shirley, Wang, Zimmerman, Monte Carlo
//! Techniques for Direct Lighting Calculations (TOG 15(1), 1996).

use super::{Integrator, direct_light};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::sampling::frame::Frame;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::Tracer;

/// The random walk with shadow rays.
#[derive(Clone, Copy, Debug)]
pub struct NextEvent {
    /// Longest path in segments: the camera ray is the first, the shadow ray, or the ray that hits
    /// a lamp or leaves the scene, the last.
    pub max_depth: u32,
}

impl Integrator for NextEvent {
    // ANCHOR: next_event
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let mut li = Rgb::BLACK;
        let mut beta = Rgb::WHITE;
        let mut ray = *ray;
        let mut hit = tracer.camera_ray(&ray);
        // Nobody asked for the light along a ray from the eye.
        let mut asked = false;
        for depth in 1.. {
            let Some(here) = hit else {
                return li + beta * tracer.scene().background;
            };

            // The light this surface sends along the path by itself, unless it was asked for.
            if !asked {
                li += beta * here.emitted(-ray.direction);
            }
            let Some(material) = here.object.material else {
                break;
            };
            if depth >= self.max_depth {
                break;
            }

            // The light of all lamps that is scattered once, here.
            let bounce = u64::from(depth);
            li += beta * direct_light(tracer, &ray, &here, bounce, stream);

            // Choose where to look next: any direction of the smooth part, or one of the few
            // specular ones.
            let frame = Frame::new(here.surface.n);
            let wo = frame.to_local(-ray.direction);
            let u = stream.at(bounce, Purpose::Direction).two();
            let (wi, weight) = if let Some(s) = material.sample(wo, u) {
                asked = true;
                let cos = s.wi.z.abs();
                (s.wi, s.f * cos / s.pdf)
            } else {
                asked = false;
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
    // ANCHOR_END: next_event
}
