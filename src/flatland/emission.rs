//! Light as it leaves its source: the first ray of a path that starts at a light of a flat world.

use super::{AreaLight, FlatWorld, Shape};
use crate::color::Rgb;
use crate::numeric::sin_cos;
use crate::sampling::discrete::Discrete;
use crate::sampling::half_disk;
use crate::sampling::stream::{Purpose, Stream};
use crate::space::{Flat, Ray, Space};
use glam::Vec2;
use std::f64::consts::{PI, TAU};

impl FlatWorld {
    /// A circle around all that rays can meet: its centre and radius, 0 in an empty world.
    fn surroundings(&self) -> (Vec2, f32) {
        let mut corners = self.parts.iter().flat_map(|part| part.shape.bounds());
        let Some(first) = corners.next() else {
            return (Vec2::ZERO, 0.0);
        };
        let (min, max) = corners.fold((first, first), |(a, b), p| (a.min(p), b.max(p)));
        let center = 0.5 * min + 0.5 * max;
        let reach = (max - center).length().max((center - min).length());
        (center, reach * (1.0 + 4.0 * f32::EPSILON))
    }

    /// The powers of all its lights in W, mean over channels: points, then walls that shine, then the
    /// background: what of it passes a circle around all walls.
    pub fn powers(&self) -> Vec<f64> {
        let points = self.point_lights.iter().map(|light| mean(light.power));
        let walls = self
            .glowing
            .iter()
            .map(|light| 2.0 * length(light) * mean(light.radiance));
        let around = 2.0 * f64::from(self.surroundings().1);
        let beyond = TAU * around * mean(self.background);
        points.chain(walls).chain([beyond]).collect()
    }

    /// Draws a light by its power, and a ray along which it emits; the power of the ray in W, whose mean is that
    /// of all lights. `None` where nothing shines.
    ///
    /// A point emits uniformly in angle. A point of a wall is uniform in length, and its direction drawn by the
    /// cosine. Light of the background comes from a uniform direction, and passes a uniform point of the
    /// line across the circle around all walls.
    pub fn sample_emission(&self, stream: &Stream) -> Option<(Ray<Flat>, Rgb)> {
        let mut numbers = stream.at(0, Purpose::Emission);
        let (place, turn) = (numbers.one(), numbers.one());
        let by_power = Discrete::new(self.powers())?;
        let chosen = by_power.sample(stream.at(0, Purpose::Branch).fine());
        let towards = |u: f32| {
            let (sin, cos) = sin_cos((TAU * f64::from(u)) as f32);
            Vec2::new(cos, sin)
        };
        let points = self.point_lights.len();
        let (ray, power) = if let Some(point) = self.point_lights.get(chosen.index) {
            (Ray::new(point.position, towards(turn)), point.power)
        } else if let Some(light) = self.glowing.get(chosen.index - points) {
            let surface = match &light.shape {
                Shape::Segment(segment) => segment.surface_at(place),
                Shape::Circle(circle) => circle.surface_towards(towards(place).as_dvec2()),
                Shape::Ellipse(_) => return None,
            };
            let local = half_disk::sample_cosine(turn);
            let direction = Flat::to_world(&Flat::frame(surface.n), local);
            let power = light.radiance * (2.0 * length(light)) as f32;
            (Ray::new(surface.leave(direction), direction), power)
        } else {
            let (center, radius) = self.surroundings();
            let from = towards(turn);
            let aside = from.perp() * (radius * (2.0 * place - 1.0));
            let power = self.background * (TAU * 2.0 * f64::from(radius)) as f32;
            (Ray::new(center + aside + from * radius, -from), power)
        };
        Some((ray, power / chosen.probability))
    }
}

fn mean(rgb: Rgb) -> f64 {
    rgb.channels().map(f64::from).iter().sum::<f64>() / 3.0
}

/// Of a wall that shines; ellipses do not.
fn length(light: &AreaLight) -> f64 {
    match &light.shape {
        Shape::Segment(segment) => {
            let [a, b] = segment.ends().map(|end| end.as_dvec2());
            a.distance(b)
        }
        Shape::Circle(circle) => 2.0 * PI * f64::from(circle.radius),
        Shape::Ellipse(_) => 0.0,
    }
}
