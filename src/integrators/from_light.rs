//! What walks from the lights have in common: what light gains where it is refracted, and how it comes to the eye.

use crate::color::Rgb;
use crate::materials::Bsdf;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Interaction, Tracer};
use glam::Vec3;

/// What a walk from a light gains on its way through glass.
///
/// Radiance in glass of index `n` is told as it would be in air, `L / n²`: so it stays the same where light goes
/// through a surface, and walks from the eye need no factor for that. Walks from the lights do, for a cone that
/// leaves glass grows wider and the power in it stays: they gain the square of the ratio of the indices, and lose
/// it where they enter. It cancels for all light but that of lamps in glass, and that which is seen from within. The power
/// of a point or a direction is what it is wherever it stands: of these a walk gains no more than it has lost.
///
/// Source: Veach, Robust Monte Carlo Methods for Light Transport Simulation (1997), section 5.2: the adjoint of a
/// BSDF that refracts.
#[derive(Clone, Copy, Debug)]
pub struct Gain {
    index_ratio2: f32,
    is_delta: bool,
}

impl Gain {
    /// At the light, which may be one without extent.
    pub fn new(is_delta: bool) -> Self {
        Gain {
            index_ratio2: 1.0,
            is_delta,
        }
    }

    /// After a surface that light reached from `wo` and left towards `wi`, in local coordinates.
    #[must_use]
    pub fn through(self, bsdf: &Bsdf, wo: Vec3, wi: Vec3) -> Self {
        Gain {
            index_ratio2: self.index_ratio2 * bsdf.index_ratio2(wo, wi),
            ..self
        }
    }

    /// The factor of the power that the walk carries.
    pub fn factor(self) -> f32 {
        match self.is_delta {
            true => self.index_ratio2.min(1.0),
            false => self.index_ratio2,
        }
    }
}

// ANCHOR: to_eye
/// Where on the film the light arrives that a surface scatters to the eye, and how much of each watt that
/// falls on the surface: `f cos θ / d²` times what the film makes of it and what the walk gains. `None` where none
/// arrives.
pub(super) fn to_eye(
    tracer: &mut Tracer,
    at: &Interaction,
    gain: Gain,
    vertex: u64,
    stream: &Stream,
) -> Option<([f32; 2], Rgb)> {
    let bsdf = at.bsdf.as_ref().filter(|bsdf| bsdf.is_smooth())?;
    let u = stream.at(vertex, Purpose::Lens).two();
    let eye = tracer.scene().camera.connect(at.surface.p, u)?;
    let toward = (eye.point.as_dvec3() - at.surface.p.as_dvec3()).as_vec3();
    let distance2 = toward.length_squared();
    let wi = at.frame.to_local(toward / distance2.sqrt());
    let gained = gain.through(bsdf, at.wo, wi).factor();
    let received = bsdf.f(at.wo, wi) * (gained * wi.z.abs() / distance2 * eye.importance);
    let arrives = !received.is_black()
        && received.is_finite()
        && tracer.unoccluded(&at.surface.spawn_to_point(eye.point));
    arrives.then_some((eye.film, received))
}
// ANCHOR_END: to_eye
