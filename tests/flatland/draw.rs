//! Random inputs of the flat world, from fixed seeds.

use glam::Vec2;
use halfdisk::flatland::{FlatWorld, gallery};
use halfdisk::numeric::sin_cos;
use halfdisk::sampling::stream::{Numbers, Purpose, Stream};
use halfdisk::scene::read::Source;
use std::f32::consts::{PI, TAU};

/// A run of random inputs.
pub struct Draw(Numbers);

impl Draw {
    /// The run number `index` of a test's seed.
    pub fn new(seed: u64, index: u32) -> Self {
        Draw(Stream::new(seed, index, 0).at(0, Purpose::Direction))
    }

    /// A uniform in `[0, 1)`.
    pub fn one(&mut self) -> f32 {
        self.0.one()
    }

    /// A uniform between two numbers.
    pub fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.one()
    }

    /// A point of the square of half width `half` around the origin.
    pub fn square(&mut self, half: f32) -> Vec2 {
        let x = self.between(-half, half);
        Vec2::new(x, self.between(-half, half))
    }

    /// A unit direction.
    pub fn direction(&mut self) -> Vec2 {
        let (sin, cos) = sin_cos(TAU * self.one());
        Vec2::new(cos, sin)
    }

    /// A unit direction on the side of `n`, uniform in angle.
    pub fn uniform(&mut self, n: Vec2) -> Vec2 {
        // Half a step from the rim: at zero the sine would be, too.
        let (sin, cos) = sin_cos(PI * (self.one() + 0.5 / 16_777_216.0));
        halfdisk::flatland::frame(n) * Vec2::new(cos, sin)
    }

    /// A unit direction on the side of `n`, proportionally to the cosine.
    pub fn cosine(&mut self, n: Vec2) -> Vec2 {
        let u = self.one();
        let cos = 2.0 * (u * (1.0 - u)).sqrt().max(1e-4);
        halfdisk::flatland::frame(n) * Vec2::new(2.0 * u - 1.0, cos).normalize()
    }

    /// A unit direction on the side of `n`; every second one grazes, down to `10⁻⁶`.
    pub fn leaving(&mut self, n: Vec2) -> Vec2 {
        let cos = if self.one() < 0.5 {
            self.one().max(1e-6)
        } else {
            libm::pow(10.0, f64::from(self.between(-6.0, 0.0))) as f32
        };
        let side = if self.one() < 0.5 { -1.0 } else { 1.0 };
        let sin = side * (1.0 - cos * cos).max(0.0).sqrt();
        halfdisk::flatland::frame(n) * Vec2::new(sin, cos)
    }
}

/// The world of these objects, each the line that describes its shape.
pub fn world(shapes: &[String]) -> FlatWorld {
    let objects = shapes
        .iter()
        .map(|s| format!("[[objects]]\nalbedo = 0.5\n{s}\n"));
    let text = format!("name = \"drawn\"\n{}", objects.collect::<String>());
    let file = "drawn.toml";
    gallery::from_text(Source { file, text: &text }).expect("a proper world")
}

pub fn segment(a: Vec2, b: Vec2) -> String {
    let [a, b] = [a, b].map(|v| v.as_dvec2().to_array());
    format!("segment = {{ from = {a:?}, to = {b:?} }}")
}

pub fn circle(center: Vec2, radius: f32) -> String {
    let center = center.as_dvec2().to_array();
    format!(
        "circle = {{ center = {center:?}, radius = {:?} }}",
        f64::from(radius)
    )
}

pub fn polygon(points: &[Vec2]) -> String {
    let points: Vec<[f64; 2]> = points.iter().map(|p| p.as_dvec2().to_array()).collect();
    format!("polyline = {{ points = {points:?}, closed = true }}")
}
