//! Random numbers and what they are bent into.
//!
//! A sampling routine is a pure function of its uniforms `u` in `[0, 1)`; where they come from is
//! [`stream`]'s business. Each `sample_x` has its density `pdf_x` beside it, and both are tested
//! together: by quadrature (the density integrates to one) and by chi-square (the samples follow
//! it).

pub mod frame;
pub mod hemisphere;
pub mod stream;
pub mod warps;
