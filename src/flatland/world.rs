//! The flat world: what a ray meets first, and what sees what.

use super::{AreaLight, FlatSpecular, FlatSurface, PointLight, Shape};
use crate::color::Rgb;
use glam::{DVec2, Vec2};

/// A flat world ready to be asked.
///
/// Rays are tried against all shapes one by one: a world that can be drawn has few.
#[derive(Clone, Debug)]
pub struct FlatWorld {
    /// Its name.
    pub name: String,
    /// What it shows, in a sentence; may be empty.
    pub about: String,
    /// Radiance of rays that leave the world, in W/(m·rad).
    pub background: Rgb,
    /// Lamps without a surface, in the order of the file.
    pub point_lights: Vec<PointLight>,
    /// The point P whose half disk is drawn, if the file names one; its normal is on the side that
    /// the file wants.
    pub probe: Option<FlatHit>,
    /// The part of the plane that drawings show.
    pub window: Window,
    pub(super) objects: Vec<Object>,
    pub(super) parts: Vec<Part>,
    pub(super) glowing: Vec<AreaLight>,
}

/// What all points of an object have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Share of the light reflected, diffusely and on both sides.
    pub albedo: Rgb,
    /// What it is, where it is perfectly smooth; its albedo is black then.
    pub specular: Option<FlatSpecular>,
    /// Radiance emitted on the front side, in W/(m·rad); black for most.
    pub emission: Rgb,
}

/// A shape and the object it belongs to; a polyline has many.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Its outline.
    pub shape: Shape,
    /// Index into [`FlatWorld::objects`].
    pub object: usize,
}

/// An upright rectangle of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Lower left corner.
    pub min: Vec2,
    /// Upper right corner.
    pub max: Vec2,
}

/// A point that a ray has met: where it is, and what it does with light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatHit {
    /// Distance along the ray in units of its direction's length.
    pub t: f32,
    /// The point, its error bound and its normal.
    pub surface: FlatSurface,
    /// The unit direction that it is seen from.
    pub wo: Vec2,
    /// Share of the light reflected, diffusely and on both sides.
    pub albedo: Rgb,
    /// What it is, where it is perfectly smooth.
    pub specular: Option<FlatSpecular>,
    /// The unit normal on the front, whichever side is seen.
    pub front: Vec2,
    /// Radiance emitted on the front side, in W/(m·rad); [`FlatHit::emitted`] asks which side.
    pub emission: Rgb,
    /// Index into [`FlatWorld::objects`].
    pub object: usize,
    /// Index into [`FlatWorld::parts`].
    pub part: usize,
}

impl FlatHit {
    /// The same point with the normal of the side that the direction `w` leaves on; the back emits
    /// nothing.
    #[must_use]
    pub fn seen_from(self, w: Vec2) -> FlatHit {
        FlatHit {
            emission: self.emitted(w),
            wo: w,
            surface: FlatSurface {
                n: self.surface.normal_towards(w),
                ..self.surface
            },
            ..self
        }
    }

    /// Radiance the surface itself emits towards the unit direction `wo`.
    pub fn emitted(&self, wo: Vec2) -> Rgb {
        if self.surface.n.dot(wo) > 0.0 {
            self.emission
        } else {
            Rgb::BLACK
        }
    }
}

impl FlatWorld {
    /// The objects, in the order of the file.
    pub fn objects(&self) -> &[Object] {
        &self.objects
    }

    /// All shapes, object by object.
    pub fn parts(&self) -> &[Part] {
        &self.parts
    }

    /// The parts that emit light, in the order of the file.
    pub fn area_lights(&self) -> &[AreaLight] {
        &self.glowing
    }

    /// What the ray from `origin` in `direction` meets first; of two things at the same distance
    /// the one that comes first in the file. Rays that are not finite or go nowhere meet nothing.
    ///
    /// `origin` is off all surfaces, such as a camera or what [`FlatSurface::leave`] gives.
    pub fn first_hit(&self, origin: Vec2, direction: Vec2) -> Option<FlatHit> {
        let (origin, direction) = (origin.as_dvec2(), direction.as_dvec2());
        let mut nearest = None;
        let mut reach = f64::INFINITY;
        for (number, part) in self.parts.iter().enumerate() {
            if let Some(intersection) = part.shape.intersect(origin, direction, reach) {
                reach = intersection.t;
                nearest = Some((intersection, number, part));
            }
        }
        let (intersection, number, part) = nearest?;
        let object = self.objects[part.object];
        let surface = part.shape.surface(intersection.p);
        Some(FlatHit {
            t: intersection.t as f32,
            surface,
            wo: -direction.as_vec2(),
            front: surface.n,
            albedo: object.albedo,
            specular: object.specular,
            emission: object.emission,
            object: part.object,
            part: number,
        })
    }

    /// True where nothing stands between a surface and a free point, such as a lamp.
    pub fn sees_point(&self, surface: &FlatSurface, point: Vec2) -> bool {
        self.is_free(surface.leave(point - surface.p), point)
    }

    /// True where nothing stands between two points on surfaces, the surfaces themselves
    /// included: neither sees the other through its own back.
    pub fn sees(&self, a: &FlatSurface, b: &FlatSurface) -> bool {
        let way = b.p - a.p;
        self.is_free(a.leave(way), b.leave(-way))
    }

    /// True where the open segment between two points off all surfaces is free. Its direction is
    /// never rounded to `f32`, so it ends exactly where it should.
    fn is_free(&self, from: Vec2, to: Vec2) -> bool {
        let (from, to) = (from.as_dvec2(), to.as_dvec2());
        let blocks = |part: &Part| part.shape.intersect(from, to - from, 1.0).is_some();
        !self.parts.iter().any(blocks)
    }

    /// The largest absolute coordinate of any shape; 0 in an empty world.
    pub fn reach(&self) -> f32 {
        let corners = self.parts.iter().flat_map(|part| part.shape.bounds());
        corners.map(|c| c.abs().max_element()).fold(0.0, f32::max)
    }
}

impl Window {
    /// A window around all `points` with a margin of a twelfth of the longer side; the square of
    /// the unit disk where there is nothing to be seen.
    pub fn around(points: impl IntoIterator<Item = Vec2>) -> Self {
        let grow = |w: Option<Window>, p: Vec2| {
            Some(w.map_or(Window { min: p, max: p }, |w| Window {
                min: w.min.min(p),
                max: w.max.max(p),
            }))
        };
        let tight = points.into_iter().fold(None, grow).unwrap_or(Window {
            min: Vec2::ZERO,
            max: Vec2::ZERO,
        });
        let longer = (tight.max - tight.min).max_element();
        let margin = if longer > 0.0 { longer / 12.0 } else { 1.0 };
        Window {
            min: tight.min - margin,
            max: tight.max + margin,
        }
    }

    /// Width and height.
    pub fn size(&self) -> DVec2 {
        self.max.as_dvec2() - self.min.as_dvec2()
    }
}
