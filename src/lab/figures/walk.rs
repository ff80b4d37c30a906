//! Walks of the flat world on paper: the rays they followed and the lines they drew to lamps.

use super::flat;
use crate::color::Rgb;
use crate::flatland::{FlatHit, FlatWorld};
use crate::integrators::world::{Diffuse, DirectLight, FlatTracer, Lights, Step, World};
use crate::lab::drawing::{Dot, RayDrawing, Stroke, StrokeKind};
use crate::sampling::stream::{Purpose, Stream};
use crate::space::{Flat, Ray};
use glam::Vec2;

/// A flat world that draws what it is asked.
#[derive(Clone, Debug)]
pub struct Watched<'a> {
    world: FlatTracer<'a>,
    drawing: RayDrawing,
    /// Each ray from its beginning to its end, in the order in which they were followed.
    pub rays: Vec<[Vec2; 2]>,
}

impl<'a> Watched<'a> {
    /// The world's walls and lamps, and no rays; these lights are sampled.
    pub fn new(world: &'a FlatWorld, lights: Lights) -> Self {
        Watched {
            world: FlatTracer::sampling(world, lights),
            drawing: flat::world(world),
            rays: Vec::new(),
        }
    }

    /// The walls, the lamps, what was asked of lamps, and the rays.
    pub fn drawing(&self) -> RayDrawing {
        let mut drawing = self.drawing.clone();
        for (number, &[from, to]) in self.rays.iter().enumerate() {
            let kind = match number {
                0 => StrokeKind::Camera,
                _ => StrokeKind::Reflected,
            };
            let (from, to) = (wide(from), wide(to));
            drawing.strokes.push(Stroke::arrow(kind, from, to));
            drawing.dots.push(Dot { at: to });
        }
        drawing
    }

    /// How many lines to lamps had something in their way.
    pub fn lost(&self) -> usize {
        let lost = |stroke: &&Stroke| stroke.kind == StrokeKind::Lost;
        self.drawing.strokes.iter().filter(lost).count()
    }

    /// Where a ray ends, or a point out of sight.
    fn draw(&mut self, ray: &Ray<Flat>, hit: Option<Vec2>) {
        let far = ray.origin
            + ray.direction * (2.0 * self.world.world.window.size().as_vec2().element_sum());
        self.rays.push([ray.origin, hit.unwrap_or(far)]);
    }
}

impl World<Flat> for Watched<'_> {
    type Point = FlatHit;

    fn intersect(&mut self, ray: &Ray<Flat>, segment: u32) -> Option<FlatHit> {
        let hit = self.world.intersect(ray, segment);
        self.draw(ray, hit.map(|at| at.surface.p));
        hit
    }

    fn emitted(&self, ray: &Ray<Flat>, hit: Option<&FlatHit>) -> Rgb {
        self.world.emitted(ray, hit)
    }

    fn diffuse(&self, at: &FlatHit) -> Diffuse<Flat> {
        self.world.diffuse(at)
    }

    fn sample_bsdf(&self, at: &FlatHit, vertex: u64, stream: &Stream) -> Option<Step<Flat>> {
        self.world.sample_bsdf(at, vertex, stream)
    }

    fn lights(&self) -> usize {
        self.world.lights()
    }

    fn sample_light(
        &mut self,
        at: &FlatHit,
        lamp: usize,
        vertex: u64,
        stream: &Stream,
    ) -> Option<DirectLight> {
        let before = self.world.rays;
        let aimed = self.world.sample_light(at, lamp, vertex, stream);
        // A shadow ray was sent: to the point that these numbers give.
        if self.world.rays > before {
            let (world, p) = (self.world.world, at.surface.p);
            let to = match world.point_lights.get(lamp) {
                Some(point) => Some(point.position),
                None => {
                    let numbers = stream.at_item(vertex, Purpose::LightPoint, lamp as u32);
                    let glowing = &world.area_lights()[lamp - world.point_lights.len()];
                    let drawn = glowing.sample(p, numbers.clone().one());
                    drawn.map(|drawn| drawn.surface.p)
                }
            };
            let kind = match aimed {
                Some(_) => StrokeKind::Shadow,
                None => StrokeKind::Lost,
            };
            let line = to.map(|to| Stroke::new(kind, wide(p), wide(to)));
            self.drawing.strokes.extend(line);
        }
        aimed
    }

    fn pdf_light(&self, from: &FlatHit, ray: &Ray<Flat>, hit: Option<&FlatHit>) -> f32 {
        self.world.pdf_light(from, ray, hit)
    }
}

fn wide(v: Vec2) -> [f64; 2] {
    v.as_dvec2().to_array()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flatland;
    use crate::integrators::NextEvent;

    #[test]
    fn a_walk_is_drawn_ray_by_ray_and_is_the_same_walk() {
        let room = flatland::load("room").expect("a world");
        let eye = Ray::new(Vec2::new(0.4, 0.6), Vec2::new(0.6, -0.8));
        for i in 0..40 {
            let (walk, stream) = (NextEvent { max_depth: 5 }, Stream::new(3, i, 0));
            let (mut watched, mut plain) =
                (Watched::new(&room, Lights::All), FlatTracer::new(&room));
            let seen = walk.walk(&mut watched, &eye, &stream);
            assert_eq!(seen, walk.walk(&mut plain, &eye, &stream));
            assert_eq!(watched.rays.len(), 5, "a closed room");
            let drawing = watched.drawing();
            let lines = drawing
                .strokes
                .iter()
                .filter(|s| s.kind == StrokeKind::Shadow);
            for line in lines.clone() {
                assert!((line.to[1] - 1.0).abs() < 1e-6, "on the ceiling: {line:?}");
            }
            assert_eq!(lines.count() as u64 + 5, plain.rays);
            for pair in watched.rays.windows(2) {
                assert!(pair[0][1].distance(pair[1][0]) < 1e-4, "a chain: {pair:?}");
            }
        }
    }
}
