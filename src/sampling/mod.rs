//! Random numbers and what they are bent into.
//!
//! A sampling routine is a pure function of its uniforms `u` in `[0, 1)`; where they come from is
//! [`stream`]'s business. Each `sample_x` has its density `pdf_x` beside it, and both are tested
//! together: by quadrature (the density integrates to one) and by chi-square (the samples follow
//! it).
//!
//! [`half_disk`] and [`hemisphere`] are twins: the same functions in the same order, in the flat
//! world and in space. Read them side by side.

pub mod discrete;
pub mod flat_frame;
pub mod frame;
pub mod half_disk;
pub mod hemisphere;
pub mod lanes;
pub mod mis;
mod sobol;
pub mod spherical_rectangle;
pub mod spherical_triangle;
pub mod stream;
pub mod warps;

/// The largest uniform: below 1 by one step of the 24 bits a uniform has.
pub const LAST_UNIFORM: f32 = 1.0 - f32::EPSILON / 2.0;

/// A number of `[0, 1]` as a uniform: rounding may have lifted it to 1, where no uniform lies.
pub(crate) fn as_uniform(x: f32) -> f32 {
    x.clamp(0.0, LAST_UNIFORM)
}
