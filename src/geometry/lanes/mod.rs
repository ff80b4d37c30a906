//! Few shapes, and sixteen rays at once.
//!
//! Every ray looks at every shape: up to some dozen shapes that is faster than a tree. Quads are looked at in `f32`,
//! with a bound on all roundings. Where the bound leaves no doubt about what is met first, that one shape is
//! intersected as the plain code does it, in `f64` where it does, bit for bit. Where it does leave a doubt, the lane
//! says so, and its ray is for the tree.

mod ball;
mod crossing;
mod glance;

use super::{Quad, Shape, Sphere};
use crate::numeric::lanes::{Floats, Mask, Row, Vector, WordRow, Words, bits, floats, mask, words};
pub use crossing::bilinear;

use crossing::Crossings;
use fearless_simd::prelude::*;
use glance::Glance;

/// Shapes that are few.
pub const MOST_SHAPES: usize = 64;
/// The number of no shape.
pub const NO_SHAPE: u32 = u32::MAX;

/// Larger coordinates, and reciprocals of smaller edges, are not looked at in lanes: squares of them and their
/// products with roundings stay far from the ends of the range of `f32`.
const LARGEST: f32 = 1e9;

/// Up to [`MOST_SHAPES`] quads and spheres that stand still.
#[derive(Clone, Debug)]
pub struct FewShapes {
    quads: Vec<Glance>,
    balls: Vec<(u32, Sphere)>,
    crossings: Box<Crossings>,
    /// The largest coordinate of a corner, without sign.
    size: f32,
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

/// What sixteen rays meet first.
#[derive(Clone, Copy, Debug)]
pub struct FirstHits<S: Simd> {
    /// Lanes that meet something, certainly.
    pub hit: Mask<S>,
    /// Lanes in doubt: rounding may decide what they meet, or whether they meet anything.
    pub doubt: Mask<S>,
    /// The distance.
    pub t: Floats<S>,
    /// A quad's first coordinate.
    pub u: Floats<S>,
    /// A quad's second coordinate.
    pub v: Floats<S>,
    /// The shape.
    pub id: WordRow,
    /// The point on it.
    pub p: Vector<S>,
    /// The bound on its error.
    pub error: Vector<S>,
    /// The normal.
    pub n: Vector<S>,
}

/// The nearest hit so far that is certain.
#[derive(Clone, Copy)]
struct Nearest<S: Simd> {
    t: Floats<S>,
    /// Bound on the error of `t`.
    slack: Floats<S>,
    id: Words<S>,
    /// The least distance of any hit that is not certain.
    doubt: Floats<S>,
}

impl<S: Simd> Nearest<S> {
    /// Adds a shape that some lanes may cross and some certainly do.
    #[inline(always)]
    fn add(&mut self, s: S, id: u32, at: Floats<S>, slack: Floats<S>, may: Mask<S>, does: Mask<S>) {
        let near = at - slack;
        // Of two that are too close to each other to tell, neither is certain.
        let close =
            does & near.simd_le(self.t + self.slack) & (self.t - self.slack).simd_le(at + slack);
        let doubted = (may & !does) | close;
        self.doubt = (doubted & near.simd_lt(self.doubt)).select(near, self.doubt);
        let nearer = does & at.simd_lt(self.t);
        self.t = nearer.select(at, self.t);
        self.slack = nearer.select(slack, self.slack);
        self.id = nearer.select(words(s, id), self.id);
    }
}

impl FewShapes {
    /// Shapes with their numbers; `None` where they are too many, of other kinds, or very large or small.
    pub fn new<'a>(shapes: impl Iterator<Item = (u32, &'a Shape)>) -> Option<FewShapes> {
        let mut few = FewShapes {
            quads: Vec::new(),
            balls: Vec::new(),
            crossings: Box::default(),
            size: 0.0,
        };
        for (id, shape) in shapes {
            let at = usize::try_from(id).ok().filter(|at| *at < MOST_SHAPES)?;
            match shape {
                Shape::Quad(quad) => few.add(id, at, quad)?,
                Shape::Sphere(sphere) => few.balls.push((id, *sphere)),
                Shape::Triangle(_) => return None,
            }
        }
        Some(few)
    }

    fn add(&mut self, id: u32, at: usize, quad: &Quad) -> Option<()> {
        let corners = quad.corners();
        let size = corners
            .iter()
            .fold(0.0_f32, |size, c| size.max(c.abs().max_element()));
        self.size = self.size.max(size);
        self.crossings.set(at, quad);
        self.quads
            .push(Glance::new(id, quad).filter(|_| size < LARGEST)?);
        Some(())
    }

    /// What each ray meets first within `t_max`.
    ///
    /// Rays that are far out, or whose direction is much shorter or longer than 1, are in doubt.
    #[inline(always)]
    pub fn intersect<S: Simd>(&self, s: S, rays: &Rays<S>) -> FirstHits<S> {
        let (reach, speed, wild) = self.scale(s, rays);
        let mut nearest = Nearest {
            t: floats(s, f32::MAX),
            slack: floats(s, 0.0),
            id: words(s, NO_SHAPE),
            doubt: floats(s, f32::INFINITY),
        };
        for quad in &self.quads {
            let seen = quad.look(s, rays, reach, speed);
            nearest.add(s, quad.id, seen.t, seen.slack, seen.may, seen.does);
        }
        for (id, sphere) in &self.balls {
            let (t, met) = ball::intersect(s, sphere, rays);
            if bits(met) != 0 {
                nearest.add(s, *id, t, floats(s, 0.0), met, met);
            }
        }
        let doubt = nearest.doubt.simd_le(nearest.t + nearest.slack) | wild;
        let hit = nearest.id.simd_lt(words(s, NO_SHAPE)) & !doubt;

        let mut id = WordRow::default();
        id.set(nearest.id);
        let crossing = self.crossings.intersect(s, rays, &id);
        let (p, error, n) = self.crossings.surface(s, &id, crossing.u, crossing.v);
        let mut first = FirstHits {
            hit,
            doubt,
            t: crossing.t,
            u: crossing.u,
            v: crossing.v,
            id,
            p,
            error,
            n,
        };
        let mut is_ball = mask(s, 0);
        for (ball_id, sphere) in &self.balls {
            let here = hit & nearest.id.simd_eq(words(s, *ball_id));
            if bits(here) != 0 {
                is_ball |= here;
                first.place(
                    s,
                    here,
                    nearest.t,
                    ball::surface(s, sphere, rays, nearest.t),
                );
            }
        }
        let refused = hit & crossing.refused & !is_ball;
        first.doubt = doubt | refused;
        first.hit = hit & !refused;
        first
    }

    /// Lanes that are certainly blocked, and lanes in doubt.
    ///
    /// * `target`: the flat shape just before which the rays end; [`NO_SHAPE`] for none.
    #[inline(always)]
    pub fn occluded<S: Simd>(&self, s: S, rays: &Rays<S>, target: u32) -> (Mask<S>, Mask<S>) {
        let (reach, speed, wild) = self.scale(s, rays);
        let mut hit = mask(s, 0);
        let mut doubt = wild;
        for quad in &self.quads {
            let seen = quad.look(s, rays, reach, speed);
            let before = (seen.t - seen.slack).simd_le(rays.t_max);
            if quad.id == target {
                doubt |= seen.edge_on;
            } else {
                doubt |= seen.may & before;
                hit |= seen.does & (seen.t + seen.slack).simd_le(rays.t_max);
            }
        }
        for (_, sphere) in &self.balls {
            let (_, met) = ball::intersect(s, sphere, rays);
            hit |= met;
        }
        (hit, doubt & !hit)
    }

    /// The largest coordinate of a point near each ray's origin or on a quad, of its direction, and the lanes for
    /// which either is too large or too small.
    #[inline(always)]
    fn scale<S: Simd>(&self, s: S, rays: &Rays<S>) -> (Floats<S>, Floats<S>, Mask<S>) {
        let reach = rays.origin.abs().max_element() + self.size;
        let speed = rays.direction.abs().max_element();
        let tame = reach.simd_lt(floats(s, 2.0 * LARGEST))
            & speed.simd_gt(floats(s, 0.25))
            & speed.simd_lt(floats(s, 4.0));
        (reach, speed, !tame)
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

/// A number of each shape.
pub type Column = [f32; MOST_SHAPES];

/// The number of each lane's shape; of any for [`NO_SHAPE`].
#[inline(always)]
pub fn gather<S: Simd>(s: S, column: &Column, id: &WordRow) -> Floats<S> {
    let mut row = Row::default();
    for (x, id) in row.0.iter_mut().zip(&id.0) {
        *x = column[*id as usize % MOST_SHAPES];
    }
    row.get(s)
}

/// The vector of each lane's shape.
#[inline(always)]
pub fn gather_vector<S: Simd>(s: S, columns: &[Column; 3], id: &WordRow) -> Vector<S> {
    let [x, y, z] = columns;
    Vector {
        x: gather(s, x, id),
        y: gather(s, y, id),
        z: gather(s, z, id),
    }
}

#[cfg(test)]
mod tests;
