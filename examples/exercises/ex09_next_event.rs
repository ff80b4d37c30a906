//! Exercise 9: next-event estimation.
//!
//! A rectangular lamp lights a point `p` of a surface with the unit normal `n`. Estimate the irradiance there from one
//! point of the lamp: draw it uniformly in area, and ask by a shadow ray whether it is seen.
//!
//! The lamp has a `corner`, two `edges` that begin there, and a unit `normal` on the side that shines; the other side
//! is dark. Every point of it has the `radiance`, in every direction. `lamp.is_visible(p, q)` is the shadow ray.
//!
//! Light from below the surface does not count.

use halfdisk::glam::Vec3;
use halfdisk::lab::exercises::{self, next_event};
use next_event::Lamp;
use std::process::ExitCode;

/// One estimate of the irradiance at `p`, from two uniforms in [0, 1).
pub fn direct(lamp: &Lamp, p: Vec3, n: Vec3, u: [f32; 2]) -> f32 {
    // BEGIN SOLUTION
    let [a, b] = lamp.edges;
    let q = lamp.corner + a * u[0] + b * u[1];
    if !lamp.is_visible(p, q) {
        return 0.0;
    }
    let way = q - p;
    let wi = way.normalize();
    let cos = n.dot(wi).max(0.0);
    let cos_lamp = lamp.normal.dot(-wi).max(0.0);
    // The point has the density 1 / area.
    let area = a.cross(b).length();
    lamp.radiance * cos * cos_lamp * area / way.length_squared()
    // END SOLUTION
}

/// What is graded.
pub const ANSWER: next_event::Direct = direct;

fn main() -> ExitCode {
    exercises::main(&next_event::exam(), &ANSWER)
}
