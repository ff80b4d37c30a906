//! Chapter 04: the half disk over a tilted surface, turned by the right matrix and by its transpose.

use crate::within;
use halfdisk::flatland::frame;
use halfdisk::glam::{Mat2, Vec2};
use halfdisk::lab::mistakes::{self, Exam, Variant};
use halfdisk::sampling::half_disk;
use halfdisk::space::{Dimension, Flat, Space};

/// The tilt of the normal, in degrees, to the right.
pub const TILT: [f64; 2] = [0.0, 90.0];
/// Directions in each drawing, one in each of so many equal parts.
pub const RAYS: u32 = 48;
/// Gathers of 16 directions behind each reading.
const GATHERS: u32 = 400;

/// Seven numbers: mean, standard error and exact value of what a white surface reads under a white sky, by the right
/// matrix and by its transpose; and the share of rays that the transpose sends below the surface. Then `x` and `y` of
/// [`RAYS`] directions by the right matrix, and of as many by its transpose.
pub fn run(tilt: f64, seed: u32) -> Vec<f64> {
    let exam = Exam {
        tilt: within(tilt, TILT).to_radians() as f32,
        ..Exam::default()
    };
    let n = Flat::tilted(exam.tilt);
    let right = mistakes::right(Dimension::Flat);
    let mut numbers = reading(&right, &exam, seed);
    let transposed = mistakes::all(Dimension::Flat)
        .into_iter()
        .find(|variant| variant.name == "matrix transposed, cosine clamped");
    numbers.extend(transposed.iter().flat_map(|v| reading(v, &exam, seed)));
    let (turned, wrong) = (rays(frame(n)), rays(frame(n).transpose()));
    let below = wrong.iter().filter(|w| w.dot(n) < 0.0).count();
    numbers.push(below as f64 / f64::from(RAYS));
    let both = turned.into_iter().chain(wrong);
    numbers.extend(both.flat_map(|w| w.as_dvec2().to_array()));
    numbers
}

fn reading(variant: &Variant, exam: &Exam, seed: u32) -> Vec<f64> {
    let read = variant.measure(exam, GATHERS, seed.into());
    vec![read.mean(), read.std_error(), variant.reading(exam)]
}

fn rays(turn: Mat2) -> Vec<Vec2> {
    let part = |i: u32| half_disk::sample_uniform((i as f32 + 0.5) / RAYS as f32);
    (0..RAYS).map(|i| turn * part(i)).collect()
}
