//! Few shapes, and sixteen rays at once.
//!
//! Every ray looks at every shape: up to some dozen shapes that is faster than a tree. Quads are looked at in `f32`,
//! with a bound on all roundings. Where the bound leaves no doubt about what is met first, that one shape is
//! intersected as the plain code does it, in `f64` where it does, bit for bit. Where it does leave a doubt, the lane
//! says so, and its ray is for the tree.
//!
//! Triangles, which come in thousands, stay in the tree. Lanes say which rays reach their box at all, and before they
//! meet one of the few.

mod ball;
mod crossing;
mod glance;
mod records;

use super::aabb::EARLIER;
use super::{Aabb, Quad, Shape, Sphere};
use crate::numeric::lanes::{Floats, Mask, Vector, WordRow, Words, bits, floats, mask, words};
pub use crossing::bilinear;
pub use records::Note;

use fearless_simd::prelude::*;
use glance::{Parallel, Scale};
use records::Records;

/// Shapes that are few.
pub const MOST_SHAPES: usize = 64;
/// The number of no shape.
pub const NO_SHAPE: u32 = u32::MAX;

/// Larger coordinates, and reciprocals of smaller edges, are not looked at in lanes: squares of them and their
/// products with roundings stay far from the ends of the range of `f32`.
const LARGEST: f32 = 1e9;

/// Up to [`MOST_SHAPES`] quads and spheres that stand still, each in a slot of its own, and the box of all triangles.
#[derive(Clone, Debug)]
pub struct FewShapes {
    quads: Vec<Parallel>,
    balls: Vec<Ball>,
    records: Records,
    /// How many there are.
    count: usize,
    /// The largest coordinate of a corner, without sign.
    size: f32,
    triangles: Option<Aabb>,
}

/// A sphere in its slot.
#[derive(Clone, Copy, Debug)]
struct Ball {
    slot: u32,
    sphere: Sphere,
}

/// Sixteen rays.
#[derive(Clone, Copy, Debug)]
pub struct Rays<S: Simd> {
    /// Where they start.
    pub origin: Vector<S>,
    /// Where they go; not of any length: see [`FewShapes::intersect`].
    pub direction: Vector<S>,
    /// How far they reach, in units of their directions' length.
    pub t_max: Floats<S>,
    /// The shape that each leaves, off its surface by the bound on its error; [`NO_SHAPE`] for those from the camera.
    pub from: Words<S>,
}

/// What sixteen rays meet first of few shapes.
#[derive(Clone, Copy, Debug)]
pub struct FirstHits<S: Simd> {
    /// Lanes that meet something, certainly.
    pub hit: Mask<S>,
    /// Lanes in doubt: rounding may decide what they meet, or whether they meet anything.
    pub doubt: Mask<S>,
    /// Lanes not in doubt that may meet a triangle before.
    pub at_triangles: Mask<S>,
    /// The distance.
    pub t: Floats<S>,
    /// A quad's first coordinate.
    pub u: Floats<S>,
    /// A quad's second coordinate.
    pub v: Floats<S>,
    /// The shape's number; [`NO_SHAPE`] where none is hit.
    pub id: Words<S>,
    /// Its note: the albedo, and lanes in which it shines.
    pub albedo: Vector<S>,
    /// See [`Note`].
    pub shines: Mask<S>,
    /// The point on it.
    pub p: Vector<S>,
    /// The bound on its error.
    pub error: Vector<S>,
    /// The normal.
    pub n: Vector<S>,
}

/// Whether something stands in the way of sixteen rays.
#[derive(Clone, Copy, Debug)]
pub struct Occlusion<S: Simd> {
    /// Lanes that are certainly blocked.
    pub hit: Mask<S>,
    /// Lanes in doubt.
    pub doubt: Mask<S>,
    /// The other lanes that may be blocked by a triangle.
    pub at_triangles: Mask<S>,
}

/// The nearest hit so far that is certain.
#[derive(Clone, Copy)]
struct Nearest<S: Simd> {
    /// Between which distances it is.
    near: Floats<S>,
    far: Floats<S>,
    slot: Words<S>,
    /// The least distance of any hit that is not certain.
    doubt: Floats<S>,
}

impl<S: Simd> Nearest<S> {
    /// Adds a shape between two distances, that some lanes may cross and some certainly do.
    #[inline(always)]
    fn add(
        &mut self,
        s: S,
        slot: u32,
        (near, far): (Floats<S>, Floats<S>),
        may: Mask<S>,
        does: Mask<S>,
    ) {
        // Of two that are too close to each other to tell, neither is certain.
        let close = does & near.simd_le(self.far) & self.near.simd_le(far);
        let doubted = (may & !does) | close;
        self.doubt = (doubted & near.simd_lt(self.doubt)).select(near, self.doubt);
        let nearer = does & near.simd_lt(self.near);
        self.near = nearer.select(near, self.near);
        self.far = nearer.select(far, self.far);
        self.slot = nearer.select(words(s, slot), self.slot);
    }
}

impl FewShapes {
    /// Shapes with their numbers and notes; `None` where there are too many besides triangles, or they are very large or
    /// small.
    pub fn new(
        shapes: impl Iterator<Item = (u32, Shape)>,
        note: impl Fn(u32) -> Note,
    ) -> Option<FewShapes> {
        let mut few = FewShapes {
            quads: Vec::new(),
            balls: Vec::new(),
            records: Records::default(),
            count: 0,
            size: 0.0,
            triangles: None,
        };
        for (id, shape) in shapes {
            match shape {
                Shape::Quad(quad) => few.add_quad(id, note(id), &quad)?,
                Shape::Sphere(sphere) => {
                    let slot = few.add(id, note(id))?;
                    few.balls.push(Ball { slot, sphere });
                }
                Shape::Triangle(triangle) => {
                    let all = few.triangles.unwrap_or(Aabb::EMPTY);
                    few.triangles = Some(all.union(triangle.bounds()));
                }
            }
        }
        Some(few)
    }

    /// Adds a shape; its slot.
    fn add(&mut self, id: u32, note: Note) -> Option<u32> {
        let slot = self.count;
        (slot < MOST_SHAPES).then(|| self.records.set(slot, id, note))?;
        self.count += 1;
        Some(slot as u32)
    }

    fn add_quad(&mut self, id: u32, note: Note, quad: &Quad) -> Option<()> {
        let slot = self.add(id, note)?;
        let corners = quad.corners();
        let size = corners
            .iter()
            .fold(0.0_f32, |size, c| size.max(c.abs().max_element()));
        self.size = self.size.max(size);
        self.records.set_quad(slot as usize, quad);
        (size < LARGEST && Parallel::add(&mut self.quads, id, slot, quad)).then_some(())
    }

    /// What each ray meets first within `t_max`.
    ///
    /// Rays that are far out, or whose direction is much shorter or longer than 1, are in doubt.
    #[inline(always)]
    pub fn intersect<S: Simd>(&self, s: S, rays: &Rays<S>) -> FirstHits<S> {
        let (scale, wild) = self.scale(s, rays);
        let mut nearest = Nearest {
            near: floats(s, f32::MAX),
            far: floats(s, f32::MAX),
            slot: words(s, NO_SHAPE),
            doubt: floats(s, f32::INFINITY),
        };
        for parallel in &self.quads {
            let at = parallel.incidence(s, rays, scale);
            for quad in &parallel.quads {
                let plane = parallel.meet(s, quad, &at, rays.from, scale);
                let (may, does) = quad.look(s, &at, &plane);
                nearest.add(s, quad.slot, (plane.near, plane.far), may, does);
            }
        }
        for Ball { slot, sphere } in &self.balls {
            let (t, met) = ball::intersect(s, sphere, rays);
            if bits(met) != 0 {
                nearest.add(s, *slot, (t, t), met, met);
            }
        }
        let doubt = nearest.doubt.simd_le(nearest.far) | wild;
        let hit = nearest.slot.simd_lt(words(s, NO_SHAPE)) & !doubt;

        let mut slot = WordRow::default();
        slot.set(nearest.slot);
        let facts = self.records.fetch(s, &slot);
        let crossing = crossing::intersect(s, rays, &facts);
        let mut first = FirstHits {
            hit,
            doubt,
            at_triangles: mask(s, 0),
            t: crossing.t,
            u: crossing.u,
            v: crossing.v,
            id: hit.select(facts.id, words(s, NO_SHAPE)),
            albedo: facts.albedo,
            shines: facts.shines,
            p: crossing::point(s, &facts, crossing.u, crossing.v),
            error: facts.error,
            n: facts.normal,
        };
        let mut is_ball = mask(s, 0);
        for Ball { slot, sphere } in &self.balls {
            let here = hit & nearest.slot.simd_eq(words(s, *slot));
            if bits(here) != 0 {
                is_ball |= here;
                let t = nearest.near;
                first.place(s, here, t, ball::surface(s, sphere, rays, t));
            }
        }
        let refused = hit & crossing.refused & !is_ball;
        first.doubt = doubt | refused;
        first.hit = hit & !refused;
        let t_max = first.hit.select(first.t, rays.t_max);
        first.at_triangles = self.reach_triangles(s, rays, t_max) & !first.doubt;
        first
    }

    /// Whether something blocks the rays of the lanes `asks`.
    ///
    /// * `target`: the flat shape just before which the rays end; [`NO_SHAPE`] for none.
    #[inline(always)]
    pub fn occluded<S: Simd>(
        &self,
        s: S,
        rays: &Rays<S>,
        target: u32,
        asks: Mask<S>,
    ) -> Occlusion<S> {
        let (scale, wild) = self.scale(s, rays);
        let mut hit = mask(s, 0);
        let mut doubt = wild;
        for parallel in &self.quads {
            let at = parallel.incidence(s, rays, scale);
            for quad in &parallel.quads {
                if quad.id == target {
                    doubt |= at.edge_on;
                    continue;
                }
                let plane = parallel.meet(s, quad, &at, rays.from, scale);
                let in_time = plane.ahead & plane.near.simd_le(rays.t_max);
                // As for the walls around a room, beyond which no shadow ray ends.
                if bits(in_time & asks) == 0 {
                    continue;
                }
                let (may, does) = quad.look(s, &at, &plane);
                doubt |= may & in_time;
                hit |= does & plane.far.simd_le(rays.t_max);
            }
        }
        for Ball { sphere, .. } in &self.balls {
            let (_, met) = ball::intersect(s, sphere, rays);
            hit |= met;
        }
        Occlusion {
            hit,
            doubt: doubt & !hit,
            at_triangles: self.reach_triangles(s, rays, rays.t_max) & !(hit | doubt),
        }
    }

    /// The rays that enter the box of all triangles by `t_max`: [`Aabb::entry`].
    #[inline(always)]
    fn reach_triangles<S: Simd>(&self, s: S, rays: &Rays<S>, t_max: Floats<S>) -> Mask<S> {
        let Some(Aabb { min, max }) = self.triangles else {
            return mask(s, 0);
        };
        let (zero, one) = (floats(s, 0.0), floats(s, 1.0));
        let (o, d) = (rays.origin, rays.direction);
        let mut span = (zero, t_max);
        for (origin, direction, min, max) in [
            (o.x, d.x, min.x, max.x),
            (o.y, d.y, min.y, max.y),
            (o.z, d.z, min.z, max.z),
        ] {
            let faces = (floats(s, min), floats(s, max));
            span = clip(s, faces, origin, one / direction, span);
        }
        (span.0 * EARLIER).simd_le(span.1)
    }

    /// The scale of the rays, and the lanes that are too far out, or whose direction is too short or too long.
    #[inline(always)]
    fn scale<S: Simd>(&self, s: S, rays: &Rays<S>) -> (Scale<S>, Mask<S>) {
        let reach = rays.origin.abs().max_element() + self.size;
        let speed = rays.direction.abs().max_element();
        let tame = reach.simd_lt(floats(s, 2.0 * LARGEST))
            & speed.simd_gt(floats(s, 0.25))
            & speed.simd_lt(floats(s, 4.0));
        (Scale { reach, speed }, !tame)
    }
}

impl<S: Simd> FirstHits<S> {
    /// Stores what spheres have in some lanes.
    #[inline(always)]
    fn place(&mut self, s: S, here: Mask<S>, t: Floats<S>, [p, error, n]: [Vector<S>; 3]) {
        let zero = floats(s, 0.0);
        self.t = here.select(t, self.t);
        self.u = here.select(zero, self.u);
        self.v = here.select(zero, self.v);
        self.p = Vector::select(here, p, self.p);
        self.error = Vector::select(here, error, self.error);
        self.n = Vector::select(here, n, self.n);
    }
}

/// What is left of a span of distances between two faces of a box: [`Aabb::entry`].
#[inline(always)]
fn clip<S: Simd>(
    s: S,
    (low, high): (Floats<S>, Floats<S>),
    origin: Floats<S>,
    inverse: Floats<S>,
    (t0, t1): (Floats<S>, Floats<S>),
) -> (Floats<S>, Floats<S>) {
    let back = inverse.simd_lt(floats(s, 0.0));
    let near = (back.select(high, low) - origin) * inverse;
    let far = (back.select(low, high) - origin) * inverse;
    (
        near.simd_gt(t0).select(near, t0),
        far.simd_lt(t1).select(far, t1),
    )
}

#[cfg(test)]
mod tests;
