//! Exercise 15: an open one, to beat a given price.

use super::Draw;
use super::exam::mistake;
use super::{Entry, Exam, Question};
use crate::numeric::sin_cos;
use crate::sampling::half_disk;
use crate::sampling::stream::Numbers;
use glam::Vec2;

/// A sky of the flat world with a small bright lamp in it.
#[derive(Clone, Copy, Debug)]
pub struct Sky {
    /// The lamp reaches from the first of these angles to the second, in radians from the tangent.
    pub lamp: [f32; 2],
    radiance: [f64; 2],
    looks: u32,
}

impl Sky {
    /// The radiance in a direction. Each look counts as one ray.
    pub fn look(&mut self, w: Vec2) -> f64 {
        self.looks += 1;
        let theta = libm::atan2f(w.y, w.x);
        match (self.lamp[0]..self.lamp[1]).contains(&theta) {
            _ if w.y < 0.0 => 0.0,
            true => self.radiance[1],
            // The sky gets brighter to the right.
            false => self.radiance[0] * (1.0 + 0.5 * f64::from(w.x)),
        }
    }
}

/// One estimate of the irradiance under a sky.
pub type Irradiance = fn(&mut Sky, &mut Numbers) -> f64;

/// How it is listed.
pub const ENTRY: Entry = Entry {
    number: 15,
    name: "open",
    title: "beat a price: the least variance for the rays that you shoot",
    page: "ch18-cost",
    points: 15,
    hints: &[
        "You know where the lamp is, and not how bright it is. Aim some rays at it, and the others elsewhere.",
        "Two techniques and their weights are one way. Two separate integrals are another: over the lamp's angles, and over all others.",
        "Strata make both better: draw the rays of one estimate from equal parts of the uniforms.",
    ],
    source: include_str!("../../../examples/exercises/ex15_open.rs"),
};

/// The skies that are asked about: one to tune for, and one that nobody knows.
const KNOWN: Sky = Sky {
    lamp: [1.9, 2.1],
    radiance: [1.0, 60.0],
    looks: 0,
};
const UNKNOWN: Sky = Sky {
    lamp: [0.6, 0.9],
    radiance: [2.0, 25.0],
    looks: 0,
};

/// Uniform directions cost so many times what is enough.
const GAIN: f64 = 20.0;

fn antiderivative(theta: f64) -> [f64; 2] {
    // Of sin θ, and of sin θ (1 + cos θ / 2).
    let (sin, cos) = (libm::sin(theta), libm::cos(theta));
    [-cos, -cos + 0.25 * sin * sin]
}

fn truth(sky: &Sky) -> f64 {
    let [from, to] = sky.lamp.map(|theta| antiderivative(theta.into()));
    let whole = antiderivative(std::f64::consts::PI)[1] - antiderivative(0.0)[1];
    sky.radiance[1] * (to[0] - from[0]) + sky.radiance[0] * (whole - (to[1] - from[1]))
}

/// The variance of one uniform direction, times its one ray.
fn of_uniform(sky: &Sky) -> f64 {
    let pi = std::f64::consts::PI;
    let second = super::samplers::mean_over(1 << 14, |t| {
        let theta = pi * t;
        let w = Vec2::new(libm::cos(theta) as f32, libm::sin(theta) as f32);
        let mut sky = *sky;
        (pi * sky.look(w) * libm::sin(theta)).powi(2)
    });
    second - truth(sky).powi(2)
}

fn at_angle(theta: f32) -> Vec2 {
    let (sin, cos) = sin_cos(theta);
    Vec2::new(cos, sin)
}

fn ask(answer: &Irradiance, sky: &Sky, draw: &mut Draw) -> (f64, f64) {
    let mut sky = *sky;
    let value = answer(&mut sky, draw.numbers());
    (value, sky.looks.into())
}

fn uniform(sky: &mut Sky, u: &mut Numbers) -> f64 {
    let w = half_disk::sample_uniform(u.one());
    sky.look(w) * f64::from(w.y / half_disk::pdf_uniform(w))
}

fn cosine(sky: &mut Sky, u: &mut Numbers) -> f64 {
    2.0 * sky.look(half_disk::sample_cosine(u.one()))
}

/// The lamp's part, by one direction.
fn aimed(sky: &mut Sky, u: &mut Numbers) -> f64 {
    let [from, to] = sky.lamp;
    let w = at_angle(from + (to - from) * u.one());
    sky.look(w) * f64::from(w.y * (to - from))
}

/// The part of all else, by one direction.
fn around(sky: &mut Sky, u: &mut Numbers) -> f64 {
    let w = half_disk::sample_cosine(u.one());
    let theta = libm::atan2f(w.y, w.x);
    let is_lamp = (sky.lamp[0]..sky.lamp[1]).contains(&theta);
    let li = sky.look(w);
    if is_lamp { 0.0 } else { 2.0 * li }
}

/// Its questions and mistakes.
pub fn exam() -> Exam<Irradiance> {
    let slip = mistake::<Irradiance>;
    let mean = |what, sky: Sky| {
        Question::mean(what, truth(&sky), move |a: &Irradiance, d| {
            ask(a, &sky, d).0
        })
    };
    let price = |what, sky: Sky| {
        Question::variance(
            what,
            truth(&sky),
            of_uniform(&sky) / GAIN,
            move |a: &Irradiance, d| ask(a, &sky, d),
        )
    };
    Exam::new(
        &ENTRY,
        vec![
            Question::never(
                "estimates without a single look at the sky",
                |a: &Irradiance, d| ask(a, &KNOWN, d).1 == 0.0,
            )
            .of(64),
            mean("the irradiance under the first sky", KNOWN),
            mean("the irradiance under another sky", UNKNOWN),
            price("the variance times the rays under the first sky", KNOWN),
            price("the variance times the rays under another sky", UNKNOWN),
        ],
        vec![
            slip(
                "uniform directions",
                "to use what you know: uniform directions seldom meet the lamp",
                uniform,
            ),
            slip(
                "directions by the cosine",
                "the lamp: the cosine helps, and the lamp is still met by chance only",
                cosine,
            ),
            slip(
                "lamp alone",
                "the rest of the sky, which is not black",
                aimed,
            ),
            slip("rest alone", "the lamp", around),
            slip(
                "lamp counted twice",
                "that directions around may meet the lamp as well: its light is counted twice",
                |sky, u| aimed(sky, u) + cosine(sky, u),
            ),
            slip(
                "half of each",
                "weights: half of each technique is half of the lamp and half of the rest",
                |sky, u| 0.5 * (aimed(sky, u) + around(sky, u)),
            ),
            slip(
                "one of the two, unweighted",
                "to divide by the probability of the choice",
                |sky, u| {
                    if u.one() < 0.5 {
                        aimed(sky, u)
                    } else {
                        around(sky, u)
                    }
                },
            ),
            slip(
                "lamp's width forgotten",
                "to divide by the density of the angle, which is one over the lamp's width",
                |sky, u| {
                    let width = f64::from(sky.lamp[1] - sky.lamp[0]);
                    aimed(sky, u) / width + around(sky, u)
                },
            ),
            slip(
                "lamp's cosine forgotten",
                "the cosine where you aim at the lamp",
                |sky, u| {
                    let [from, to] = sky.lamp;
                    let w = at_angle(from + (to - from) * u.one());
                    sky.look(w) * f64::from(to - from) + around(sky, u)
                },
            ),
        ],
    )
}
