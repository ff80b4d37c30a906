//! Random walks with the usual mistakes, which the tests must reject.

use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, direct_light};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::scene::Tracer;

/// What `NextEvent` may get wrong.
#[derive(Clone, Copy, PartialEq)]
pub enum Slip {
    /// Lamps count where they are met by chance, too.
    CountTwice,
    /// Lamps count straight from the eye only.
    NeverAfterSpecular,
    /// The weight of the chosen branch is not divided by its probability.
    NoProbability,
    /// The chosen branch counts as if it were the only one, and lost nothing.
    NoWeight,
}

/// `NextEvent` with a mistake.
pub struct Wrong {
    pub slip: Slip,
    pub max_depth: u32,
}

impl Integrator for Wrong {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let (mut li, mut beta, mut ray) = (Rgb::BLACK, Rgb::WHITE, *ray);
        let mut hit = tracer.camera_ray(&ray);
        let mut asked = false;
        for depth in 1.. {
            let Some(here) = hit else {
                return li + beta * tracer.scene().background(ray.direction);
            };
            if !asked || self.slip == Slip::CountTwice {
                li += beta * here.emission;
            }
            let Some(bsdf) = here.bsdf.filter(|_| depth < self.max_depth) else {
                break;
            };
            let bounce = u64::from(depth);
            li += beta * direct_light(tracer, &here, bounce, stream);
            let (frame, wo) = (here.frame, here.wo);
            let u = stream.at(bounce, Purpose::Direction).two();
            let u_branch = stream.at(bounce, Purpose::Branch).one();
            let Some(next) = bsdf.scatter(wo, u_branch, u) else {
                break;
            };
            asked = next.pdf.is_some() || self.slip == Slip::NeverAfterSpecular;
            let all = bsdf.specular(wo);
            let mirrored = (next.wi.z > 0.0) == (wo.z > 0.0);
            let branch = if mirrored {
                all.reflected
            } else {
                all.transmitted
            };
            beta *= match branch {
                Some(own) if self.slip == Slip::NoProbability => own.weight,
                _ if self.slip == Slip::NoWeight => Rgb::WHITE,
                _ => next.weight,
            };
            ray = here.surface.spawn(frame.to_world(next.wi).normalize());
            hit = tracer.secondary_ray(&ray);
        }
        li
    }
}
