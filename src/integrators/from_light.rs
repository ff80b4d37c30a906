//! What walks from the lights have in common: how light goes on from a surface that it has reached, and how it
//! comes to the eye from there.
//!
//! Radiance in glass of index `n` is told as it would be in air, `L / n²`: so it stays the same where light goes
//! through a surface, and walks from the eye need no factor for that. Walks from the lights do, for a cone that
//! leaves glass grows wider and the power in it stays: they gain the square of the ratio of the indices, and lose
//! it where they enter. It cancels for all light but that of lamps in glass, or that is seen from within.
//!
//! Source: Veach, Robust Monte Carlo Methods for Light Transport Simulation (1997), section 5.2: the adjoint of a
//! BSDF that refracts.

use super::world::{Step, World};
use crate::color::Rgb;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Interaction, Tracer};
use crate::space::Solid;

/// Chooses where light goes from a surface: [`World::sample_bsdf`], its weight that of light that goes on.
pub(super) fn scatter(
    tracer: &Tracer,
    at: &Interaction,
    vertex: u64,
    stream: &Stream,
) -> Option<Step<Solid>> {
    let step = tracer.sample_bsdf(at, vertex, stream)?;
    let wi = at.frame.to_local(step.ray.direction);
    let gained = at.bsdf.as_ref()?.index_ratio2(at.wo, wi);
    Some(Step {
        weight: step.weight * gained,
        ..step
    })
}

// ANCHOR: to_eye
/// Where on the film the light arrives that a surface scatters to the eye, and how much of each watt that
/// falls on the surface: `f cos θ / d²` times what the film makes of it. `None` where none arrives.
pub(super) fn to_eye(
    tracer: &mut Tracer,
    at: &Interaction,
    vertex: u64,
    stream: &Stream,
) -> Option<([f32; 2], Rgb)> {
    let bsdf = at.bsdf.as_ref().filter(|bsdf| bsdf.is_smooth())?;
    let u = stream.at(vertex, Purpose::Lens).two();
    let eye = tracer.scene().camera.connect(at.surface.p, u)?;
    let toward = (eye.point.as_dvec3() - at.surface.p.as_dvec3()).as_vec3();
    let distance2 = toward.length_squared();
    let wi = at.frame.to_local(toward / distance2.sqrt());
    let gained = bsdf.index_ratio2(at.wo, wi);
    let received = bsdf.f(at.wo, wi) * (gained * wi.z.abs() / distance2 * eye.importance);
    let arrives = !received.is_black()
        && received.is_finite()
        && tracer.unoccluded(&at.surface.spawn_to_point(eye.point));
    arrives.then_some((eye.film, received))
}
// ANCHOR_END: to_eye
