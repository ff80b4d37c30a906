//! What one writes first: the plain form of each computation that this project does with care.
//!
//! Each is right on paper, and wrong somewhere in `f32`. They are kept so that tests can show where
//! ours hold and these do not, and so that benches can say what the care costs. No renderer code
//! calls them. Estimators with one thing wrong live in `lab::mistakes`.

mod film;
mod geometry;
mod sampling;
mod scattering;

pub use film::{level, mean, pixels, running_mean, variance};
pub use geometry::{
    angle, hit_point, hit_point_off, matrix_between, offset_by, slab, sphere, sphere_after,
    triangle,
};
pub use sampling::{
    basis, cosine_flat, cumulative, lifted, one_minus_cos, power_weight, radical_inverse, survival,
    uniform, uniform_flat,
};
pub use scattering::{absorption, fresnel, ggx, refract, schlick};
