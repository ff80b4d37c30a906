//! The six integrals of a picture one at a time, each seen in a row of pixels with a closed form.

use halfdisk::integrators::{Distributed, Integral};
use halfdisk::render::{Options, render};
use halfdisk::scene::description::Description;
use halfdisk::scene::read::Source;
use halfdisk::scene::{RayCounts, SceneError, gallery};
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

/// Pixels of each row.
const PIXELS: usize = 24;

/// A row of pixels across what one integral blurs.
#[derive(Clone, Debug)]
pub struct Profile {
    /// The only integral that is drawn.
    pub integral: Integral,
    /// The width of the blur in units of its places, where it has one.
    pub width: Option<f64>,
    /// Where the first pixel's middle is, and how far they are apart; each maker states the unit.
    places: [f64; 2],
    scene: String,
    exact: fn(f64) -> f64,
}

/// What one pixel reads.
#[derive(Clone, Copy, Debug)]
pub struct Reading {
    /// Where it is.
    pub x: f64,
    /// Its samples.
    pub read: Estimate,
    /// The closed form.
    pub exact: f64,
    /// The standard error; where samples are hits and misses at least that of the closed form.
    pub error: f64,
}

impl Reading {
    /// The distance from the closed form in standard errors; roundings count for nothing.
    pub fn z(&self) -> f64 {
        let off = self.read.mean() - self.exact;
        if off.abs() < 2e-6 {
            0.0
        } else {
            off / self.error
        }
    }
}

impl Profile {
    /// One for each integral, in the order of [`Integral::ALL`].
    pub fn all() -> [Profile; 6] {
        [edge(), penumbra(), confusion(), motion(), gloss(), wall()]
    }

    /// Reads the row with `spp` samples for each pixel, after a change to its scene; and the rays.
    pub fn read(
        &self,
        spp: u32,
        seed: u64,
        change: impl FnOnce(&mut Description),
    ) -> Result<(Vec<Reading>, RayCounts), SceneError> {
        let source = Source {
            file: "profile",
            text: &self.scene,
        };
        let scene = gallery::from_text(source, None, change)?;
        let options = Options {
            spp,
            seed,
            fixed: self.integral.others(),
            tile: 1,
            ..Options::default()
        };
        let rendered = render(&scene, &Distributed { max_depth: 2 }, &options, &());
        let [first, step] = self.places;
        let reading = |(i, read): (usize, Estimate)| {
            let x = first + i as f64 * step;
            let exact = (self.exact)(x);
            let by_chance = (exact * (1.0 - exact)).max(0.0) / f64::from(spp);
            let error = match self.integral {
                Integral::Gloss => read.std_error(),
                _ => read.std_error().max(by_chance.sqrt()),
            };
            Reading {
                x,
                read,
                exact,
                error,
            }
        };
        let pixels = rendered.film.pixels().iter().map(|p| p.channels[0]);
        Ok((pixels.enumerate().map(reading).collect(), rendered.rays))
    }

    /// The width of the blur as it was read, and its error; `None` where the profile has no width.
    ///
    /// The area under `V (1 - V)` grows with the width, whatever the form of the rise.
    pub fn width_of(&self, row: &[Reading]) -> Option<(f64, f64)> {
        let width = self.width?;
        let whole: f64 = row.iter().map(|r| r.exact * (1.0 - r.exact)).sum();
        let read = row.iter().map(|r| {
            // The square of a mean is too large by its variance.
            let (v, error) = (r.read.mean(), r.read.std_error());
            v * (1.0 - v) + error * error
        });
        let error = row
            .iter()
            .map(|r| ((1.0 - 2.0 * r.exact) * r.error).powi(2));
        let unit = width / whole;
        Some((read.sum::<f64>() * unit, error.sum::<f64>().sqrt() * unit))
    }
}

/// The text of a camera above or before the origin that sees [`PIXELS`] pixels, each `pixel` wide.
fn row(from: [f64; 3], to: [f64; 3], up: [f64; 3], pixel: f64, more: &str) -> String {
    let distance = [0, 1, 2].map(|i| (to[i] - from[i]).abs());
    let distance = distance.iter().fold(0.0, |far, d| d.max(far));
    let fov = (2.0 * libm::atan(0.5 * pixel / distance)).to_degrees();
    format!(
        "name = 'profile'\nfilm.size = [{PIXELS}, 1]\nmaterials.white.lambert.albedo = 1\n\
         materials.black.lambert.albedo = 0\n\
         camera = {{ from = {from:?}, to = {to:?}, up = {up:?}, fov = {fov:?}{more} }}\n"
    )
}

/// Middles of pixels of this width, the row around `middle`.
fn places(middle: f64, pixel: f64) -> [f64; 2] {
    [middle - 0.5 * (PIXELS - 1) as f64 * pixel, pixel]
}

const TOWARDS: [[f64; 3]; 3] = [[0.0, 0.0, 10.0], [0.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn before(pixel: f64, more: &str) -> String {
    row(TOWARDS[0], TOWARDS[1], TOWARDS[2], pixel, more)
}

fn above(x: f64, height: f64, pixel: f64) -> String {
    row([x, height, 0.0], [x, 0.0, 0.0], [0.0, 0.0, -1.0], pixel, "")
}

/// A slanted edge: eight pixels to the side in the height of the row.
fn edge() -> Profile {
    let plate = "[[objects]]\nemits = 1\nquad = { corner = [-16, -3, 0], u = [40, 0, 0], v = [-48, 6, 0] }\n";
    // The integral of what a pixel of width one shows of the left of an edge.
    fn shown(edge: f64) -> f64 {
        if edge < 1.0 {
            0.5 * edge.max(0.0).powi(2)
        } else {
            edge - 0.5
        }
    }
    Profile {
        integral: Integral::Pixel,
        width: None,
        // Pixels.
        places: places(0.0, 1.0),
        scene: before(1.0, "") + plate,
        exact: |x| (shown(4.5 - x) - shown(-3.5 - x)) / 8.0,
    }
}

/// Half the size of the lamp, its height, and that of the blocker.
const LAMP: [f64; 3] = [0.3, 4.0, 1.0];

/// The shadow that a half plane casts in the light of a square lamp.
fn penumbra() -> Profile {
    let [half, height, blocker] = LAMP;
    let radiance = PI / lamp_light(-half, half);
    let objects = format!(
        "[[objects]]\nmaterial = 'white'\nquad = {{ corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n\
         [[objects]]\nmaterial = 'black'\nquad = {{ corner = [-9, {blocker:?}, 9], u = [9, 0, 0], v = [0, 0, -18] }}\n\
         [[objects]]\nemits = {radiance:?}\n\
         quad = {{ corner = [{:?}, {height:?}, {:?}], u = [{:?}, 0, 0], v = [0, 0, {:?}] }}\n",
        -half,
        -half,
        2.0 * half,
        2.0 * half
    );
    Profile {
        integral: Integral::Light,
        width: Some(2.0 * half * blocker / (height - blocker)),
        // Scene units.
        places: places(0.0, 0.0125),
        scene: above(0.0, 0.5, 0.0125) + &objects,
        exact: |x| {
            let [half, height, blocker] = LAMP;
            let hidden = (-x * (height - blocker) / blocker).clamp(-half, half);
            lamp_light(hidden - x, half - x) / lamp_light(-half, half)
        },
    }
}

/// `∫ cos cos / d²` over the part of the lamp between two places to the right of the point below.
fn lamp_light(left: f64, right: f64) -> f64 {
    let [half, height, _] = LAMP;
    let side = |x: f64, y: f64| {
        let r = (1.0 + x * x).sqrt();
        x / r * libm::atan(y / r)
    };
    let corner = |x: f64, y: f64| 0.5 * (side(x, y) + side(y, x));
    2.0 * (corner(right / height, half / height) - corner(left / height, half / height))
}

/// An edge behind the plane of focus: a lens of radius 1/2, focused at 4, at distance 10.
fn confusion() -> Profile {
    let plate = "[[objects]]\nemits = 1\nquad = { corner = [-40, -20, 0], u = [40, 0, 0], v = [0, 40, 0] }\n";
    Profile {
        integral: Integral::Lens,
        width: Some(1.5),
        // Scene units in the plane of the edge.
        places: places(0.0, 0.1),
        scene: before(0.1, ", lens_radius = 0.5, focus = 4") + plate,
        // The part of a disk of radius 3/4 that lies left of the edge.
        exact: |x| {
            let t = (-x / 0.75).clamp(-1.0, 1.0);
            0.5 + (t * (1.0 - t * t).sqrt() + libm::asin(t)) / PI
        },
    }
}

/// An edge that moves by 3/2 while the shutter is open.
fn motion() -> Profile {
    let plate = "[[objects]]\nemits = 1\nmotion = [1.5, 0, 0]\n\
                 quad = { corner = [-41.5, -20, 0], u = [40, 0, 0], v = [0, 40, 0] }\n";
    Profile {
        integral: Integral::Time,
        width: Some(1.5),
        // Scene units.
        places: places(0.0, 0.1),
        scene: before(0.1, ", shutter = [0.5, 1.5]") + plate,
        exact: |x| ((0.75 - x) / 1.5).clamp(0.0, 1.0),
    }
}

/// Plates of growing roughness under a white sky, seen from straight above.
fn gloss() -> Profile {
    let first = -0.5 * PIXELS as f64;
    let plate = |i: usize| {
        let roughness = (i + 1) as f64 / PIXELS as f64;
        format!(
            "[materials.m{i}]\nglossy = {{ reflectance = 1, roughness = {roughness:?} }}\n\
             [[objects]]\nmaterial = 'm{i}'\n\
             quad = {{ corner = [{:?}, 0, 1], u = [1, 0, 0], v = [0, 0, -2] }}\n",
            first + i as f64
        )
    };
    let plates: String = (0..PIXELS).map(plate).collect();
    let step = 1.0 / PIXELS as f64;
    Profile {
        integral: Integral::Gloss,
        width: None,
        // Roughness.
        places: [step, step],
        scene: format!("background = 1\n{}{plates}", above(0.0, 1000.0, 1.0)),
        exact: lobe_energy,
    }
}

/// The share of light that a GGX surface of this roughness sends back, seen from straight above;
/// `1 - ln 2` for roughness 1.
///
/// `∫ G1(2θ) du` over the facets that mirror light upwards, with `tan² θ = α² u / (1 - u)`: by the
/// midpoint rule.
pub fn lobe_energy(alpha: f64) -> f64 {
    const STEPS: u32 = 20_000;
    let last = 1.0 / (1.0 + alpha * alpha);
    let share = |i: u32| {
        let u = last * (f64::from(i) + 0.5) / f64::from(STEPS);
        let tan2 = alpha * alpha * u / (1.0 - u);
        // tan² 2θ
        let double = 4.0 * tan2 / (1.0 - tan2).powi(2);
        2.0 / (1.0 + (1.0 + alpha * alpha * double).sqrt())
    };
    (0..STEPS).map(share).sum::<f64>() * last / f64::from(STEPS)
}

/// The sky over the ground beside a wall of height 1 without end.
fn wall() -> Profile {
    let pixel = 4.0 / PIXELS as f64;
    let objects = "[[objects]]\nmaterial = 'white'\n\
                   quad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n\
                   [[objects]]\nmaterial = 'black'\n\
                   quad = { corner = [0, 0, 2000], u = [0, 0, -4000], v = [0, 1, 0] }\n";
    Profile {
        integral: Integral::Hemisphere,
        width: None,
        // Distance from the wall in its heights.
        places: places(2.0, pixel),
        scene: format!("background = 1\n{}{objects}", above(2.0, 5.0, pixel)),
        exact: |x| 0.5 * (1.0 + x / (x * x + 1.0).sqrt()),
    }
}
