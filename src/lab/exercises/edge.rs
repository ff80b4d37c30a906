//! Exercise 13: density estimation near the end of a line.

use super::Draw;
use super::exam::mistake;
use super::{Entry, Exam, Question};
use std::f64::consts::PI;

/// The irradiance at a place of a line from 0 to 1, from photons: their places, the flux of each, the place that is
/// asked for, and the radius of the window around it.
pub type Irradiance = fn(&[f64], f64, f64, f64) -> f64;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 13,
    name: "edge",
    title: "estimate a density from photons, also where the line ends",
    page: "ch16-photons",
    points: 10,
    hints: &[
        "Add up the flux of the photons in the window, and divide by the length on which they fell.",
        "A window around the end has a half that no photon can fall on. Which part of it lies on the line?",
    ],
    source: include_str!("../../../examples/exercises/ex13_edge.rs"),
};

const PHOTONS: u32 = 32;
const RADIUS: f64 = 0.2;

/// Photons of density 1, or of density 2 (1 − x).
fn photons(falls: bool, draw: &mut Draw) -> Vec<f64> {
    let place = |u: f64| if falls { 1.0 - (1.0 - u).sqrt() } else { u };
    (0..PHOTONS).map(|_| place(draw.fine())).collect()
}

/// The flux in a window.
fn within(photons: &[f64], flux: f64, at: f64, radius: f64) -> f64 {
    flux * photons.iter().filter(|x| (*x - at).abs() <= radius).count() as f64
}

/// The part of the window on the line, as a length.
fn part(at: f64, radius: f64) -> f64 {
    (at + radius).min(1.0) - (at - radius).max(0.0)
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Irradiance> {
    let slip = mistake::<Irradiance>;
    let ask = |what, truth, falls: bool, at: f64, radius: f64| {
        Question::mean(what, truth, move |a: &Irradiance, d| {
            a(&photons(falls, d), 1.0 / f64::from(PHOTONS), at, radius)
        })
        .of(1 << 14)
    };
    Exam::new(
        &ENTRY,
        vec![
            ask(
                "even light of 1 at the middle of the line",
                1.0,
                false,
                0.5,
                RADIUS,
            ),
            ask(
                "even light of 1, with half of the radius,",
                1.0,
                false,
                0.5,
                0.5 * RADIUS,
            ),
            ask("even light of 1 at the first end", 1.0, false, 0.0, RADIUS),
            ask("even light of 1 at the second end", 1.0, false, 1.0, RADIUS),
            ask(
                "even light of 1 half a radius from the end",
                1.0,
                false,
                0.5 * RADIUS,
                RADIUS,
            ),
            ask(
                "light that falls from 2 to 0, half a radius from its bright end,",
                2.0 - 1.5 * RADIUS,
                true,
                0.5 * RADIUS,
                RADIUS,
            ),
        ],
        vec![
            slip(
                "edge forgotten",
                "that a part of the window lies beyond the end, where no photon can fall",
                |p, flux, at, r| within(p, flux, at, r) / (2.0 * r),
            ),
            slip(
                "second end forgotten",
                "that the line has two ends",
                |p, flux, at, r| within(p, flux, at, r) / (at + r - (at - r).max(0.0)),
            ),
            slip(
                "first end forgotten",
                "that the line has two ends: it begins at 0",
                |p, flux, at, r| within(p, flux, at, r) / ((at + r).min(1.0) - (at - r)),
            ),
            slip(
                "radius for diameter",
                "that the window reaches a radius to both sides: its length is 2 r",
                |p, flux, at, r| within(p, flux, at, r) / (0.5 * part(at, r)),
            ),
            slip(
                "disc of space",
                "that the window of the flat world is a length, and not a disc",
                |p, flux, at, r| within(p, flux, at, r) / (PI * r * r * part(at, r) / (2.0 * r)),
            ),
            slip(
                "half of the window",
                "that the window is as wide as you divide by: photons up to r away count, and not up to r/2",
                |p, flux, at, r| within(p, flux, at, 0.5 * r) / part(at, r),
            ),
            slip(
                "one side of the window",
                "that photons count on both sides",
                |p, flux, at, r| {
                    let count = p.iter().filter(|x| (0.0..=r).contains(&(*x - at))).count();
                    flux * count as f64 / part(at, r)
                },
            ),
            slip(
                "flux forgotten",
                "the flux: each photon carries a part of the light",
                |p, _, at, r| within(p, 1.0, at, r) / part(at, r),
            ),
            slip(
                "every end halved",
                "that only the part beyond the end is lost: it is a half at the end itself, and less beside it",
                |p, flux, at, r| {
                    let is_cut = part(at, r) < 2.0 * r - 1e-12;
                    within(p, flux, at, r) / if is_cut { r } else { 2.0 * r }
                },
            ),
            slip(
                "mirrored at the edge",
                "to divide by the part on the line: photons mirrored at the end do as well for even light, and not for light that falls off",
                |p, flux, at, r| {
                    let mirrored = within(p, flux, -at, r) + within(p, flux, 2.0 - at, r);
                    (within(p, flux, at, r) + mirrored) / (2.0 * r)
                },
            ),
            slip(
                "averaged over the photons",
                "that every photon has its flux already: do not divide by their number again",
                |p, flux, at, r| within(p, flux, at, r) / part(at, r) / p.len() as f64,
            ),
        ],
    )
}
