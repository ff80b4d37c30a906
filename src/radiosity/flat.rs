//! Radiosity in a flat world: patches are pieces of walls, and form factors come from strings.
//!
//! Two walls that nothing comes between see each other by Hottel's crossed strings, exactly and
//! reciprocally. Where a third wall comes between, points of the receiver look at points of the other.
//! The system and its solvers are those of space.

use super::quadrature::gauss_legendre;
use super::system::{Channels, Solved, System};
use super::{Matrix, RadiosityError};
use crate::flatland::exact::form_factor;
use crate::flatland::{FlatSurface, FlatWorld, Shape};
use glam::DVec2;

/// A piece of a wall, seen from its front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlatPatch {
    /// Its ends; the front is on the left of the way from the first to the second.
    pub ends: [DVec2; 2],
    /// The share of light reflected.
    pub albedo: Channels,
    /// The radiance emitted, in W/(m rad).
    pub emission: Channels,
    /// Bound on the rounding of its ends.
    close: f64,
}

impl FlatPatch {
    /// Its length.
    pub fn length(&self) -> f64 {
        self.ends[0].distance(self.ends[1])
    }

    fn at(&self, share: f64) -> DVec2 {
        self.ends[0] + (self.ends[1] - self.ends[0]) * share
    }

    fn normal(&self) -> DVec2 {
        (self.ends[1] - self.ends[0]).perp().normalize()
    }

    fn height(&self, p: DVec2) -> f64 {
        self.normal().dot(p - self.ends[0])
    }

    fn surface(&self, share: f64) -> FlatSurface {
        FlatSurface {
            p: self.at(share).as_vec2(),
            error: glam::Vec2::splat(self.close as f32),
            n: self.normal().as_vec2(),
        }
    }

    /// The part in front of another patch; `None` where that is nothing.
    fn before(&self, other: &FlatPatch) -> Option<FlatPatch> {
        let close = self.close.max(other.close);
        let heights = self.ends.map(|p| other.height(p));
        if heights.iter().all(|h| *h <= close) {
            return None;
        }
        let crossing = self.at((heights[0] / (heights[0] - heights[1])).clamp(0.0, 1.0));
        let [a, b] = self.ends;
        let ends = match heights.map(|h| h >= -close) {
            [true, false] => [a, crossing],
            [false, true] => [crossing, b],
            _ => [a, b],
        };
        Some(FlatPatch { ends, ..*self })
    }
}

/// The light of a flat world on its patches.
#[derive(Clone, Debug)]
pub struct FlatSolution {
    /// The patches.
    pub patches: Vec<FlatPatch>,
    /// The equations.
    pub system: System<f64>,
    /// Their solution.
    pub solved: Solved,
}

/// Points of a receiver, and of what it looks at, where something comes between them.
const POINTS: usize = 8;

impl FlatSolution {
    /// Solves the light of a world of straight walls, each cut into pieces of at most `size`.
    ///
    /// Both sides of a wall reflect, and have patches; walls are cut where others
    /// touch or cross them. Lamps at a point and the light of the background
    /// have none: they are left out.
    pub fn new(world: &FlatWorld, size: f64) -> Result<FlatSolution, RadiosityError> {
        let patches = patches(world, size)?;
        let count = patches.len();
        let row = |i: usize| {
            let others = patches.iter();
            others.map(move |other| (i, other))
        };
        let entries = (0..count).flat_map(row);
        let entries = entries
            .map(|(i, other)| factor(world, &patches[i], other))
            .collect();
        let system = System {
            emission: patches.iter().map(|patch| patch.emission).collect(),
            albedo: patches.iter().map(|patch| patch.albedo).collect(),
            factors: Matrix::new(count, entries),
        };
        Ok(FlatSolution {
            solved: system.gauss_seidel(1e-15),
            patches,
            system,
        })
    }
}

impl FlatSolution {
    /// What arrives at a point from all patches, as a mean of radiances over its half disk: a point of a
    /// surface with unit normal `n`, in a world where nothing comes between.
    pub fn arriving(&self, p: DVec2, n: DVec2) -> Channels {
        let mut sum = [0.0; 3];
        for (patch, radiance) in self.patches.iter().zip(&self.solved.radiance) {
            if patch.height(p) <= patch.close {
                continue;
            }
            let heights = patch.ends.map(|end| n.dot(end - p));
            let crossing = patch.at((heights[0] / (heights[0] - heights[1])).clamp(0.0, 1.0));
            let ends = match heights.map(|h| h > 0.0) {
                [true, true] => patch.ends,
                [true, false] => [patch.ends[0], crossing],
                [false, true] => [crossing, patch.ends[1]],
                [false, false] => continue,
            };
            let factor = sines(p, n, ends);
            (0..3).for_each(|c| sum[c] += factor * radiance[c]);
        }
        sum
    }
}

fn patches(world: &FlatWorld, size: f64) -> Result<Vec<FlatPatch>, RadiosityError> {
    if !(size > 0.0 && size.is_finite()) {
        return Err(RadiosityError::Size(size));
    }
    let mut patches = Vec::new();
    let mut round = 0;
    for part in world.parts() {
        let Shape::Segment(segment) = part.shape else {
            round += 1;
            continue;
        };
        let object = &world.objects()[part.object];
        let [albedo, emission] =
            [object.albedo, object.emission].map(|rgb| rgb.channels().map(f64::from));
        let [a, b] = segment.ends().map(|p| p.as_dvec2());
        let close = rounding([a, b]);
        let touched = touched([a, b], close, world);
        for interval in touched.windows(2) {
            let long = (interval[1] - interval[0]) * a.distance(b);
            let pieces = (long / size - 1e-6).ceil().max(1.0);
            if pieces > super::MOST_PATCHES as f64 {
                return Err(RadiosityError::TooMany {
                    patches: pieces as usize,
                });
            }
            for k in 0..pieces as u32 {
                let at = |k: u32| {
                    let share = f64::from(k) / pieces;
                    a + (b - a) * (interval[0] + (interval[1] - interval[0]) * share)
                };
                let front = FlatPatch {
                    ends: [at(k), at(k + 1)],
                    albedo,
                    emission,
                    close,
                };
                let back = FlatPatch {
                    ends: [at(k + 1), at(k)],
                    emission: [0.0; 3],
                    ..front
                };
                patches.extend([front, back]);
            }
        }
    }
    match round {
        0 => Ok(patches),
        n => Err(RadiosityError::Spheres(n)),
    }
}

/// A bound on how far rounding to `f32` moves a point, in scene units.
fn rounding(points: [DVec2; 2]) -> f64 {
    let largest = points.map(|p| p.abs().max_element());
    f64::from(crate::numeric::gamma(16)) * largest[0].max(largest[1])
}

/// Where a wall is cut: its ends, and between them the places where other walls touch or cross it, as
/// shares of its length, in order. Light changes its course there: a wall that stands on the floor lights one side.
fn touched([a, b]: [DVec2; 2], close: f64, world: &FlatWorld) -> Vec<f64> {
    let (along, length) = (b - a, a.distance(b));
    let mut cuts = vec![0.0, 1.0];
    for part in world.parts() {
        let Shape::Segment(other) = part.shape else {
            continue;
        };
        let ends = other.ends().map(|p| p.as_dvec2());
        let close = close.max(rounding(ends));
        let heights = ends.map(|p| along.perp_dot(p - a) / length);
        let share = |p: DVec2| along.dot(p - a) / (length * length);
        let mut cut = |share: f64| {
            let inside = share * length > close && (1.0 - share) * length > close;
            if inside {
                cuts.push(share);
            }
        };
        let touches = heights.map(|h| h.abs() <= close);
        for (p, touches) in ends.into_iter().zip(touches) {
            if touches {
                cut(share(p));
            }
        }
        if touches == [false; 2] && heights[0] * heights[1] < 0.0 {
            let [p, q] = ends;
            cut(share(
                p + (q - p) * (heights[0] / (heights[0] - heights[1])),
            ));
        }
    }
    cuts.sort_by(f64::total_cmp);
    let mut apart = vec![0.0];
    for share in cuts {
        if apart
            .last()
            .is_some_and(|last| (share - last) * length > close)
        {
            apart.push(share);
        }
    }
    apart
}

/// The form factor between two patches.
fn factor(world: &FlatWorld, from: &FlatPatch, to: &FlatPatch) -> f64 {
    let (Some(seen), Some(seeing)) = (to.before(from), from.before(to)) else {
        return 0.0;
    };
    // The part behind the other's plane gets nothing, and is in the mean all the same.
    let share = seeing.length() / from.length();
    if is_free(world, &seeing, &seen) {
        return share * form_factor(seeing.ends, seen.ends).max(0.0);
    }
    let rule = gauss_legendre(POINTS);
    let mut sum = 0.0;
    for [s, weight] in &rule {
        let here = seeing.surface(*s);
        let p = seeing.at(*s);
        for k in 0..POINTS {
            let part = [k, k + 1].map(|k| seen.at(k as f64 / POINTS as f64));
            let there = seen.surface((k as f64 + 0.5) / POINTS as f64);
            if world.sees(&here, &there) {
                sum += weight * sines(p, seeing.normal(), part);
            }
        }
    }
    share * sum
}

/// The form factor of a point to a segment: half the difference of the sines of the angles it is seen in.
fn sines(p: DVec2, n: DVec2, ends: [DVec2; 2]) -> f64 {
    let sine = ends.map(|end| (end - p).perp_dot(n) / (end - p).length());
    0.5 * (sine[1] - sine[0]).abs()
}

/// True where no wall comes into the convex hull of two patches, but along its rim.
fn is_free(world: &FlatWorld, a: &FlatPatch, b: &FlatPatch) -> bool {
    let hull = [a.ends[0], a.ends[1], b.ends[0], b.ends[1]];
    let close = a.close.max(b.close);
    world.parts().iter().all(|part| match part.shape {
        Shape::Segment(wall) => {
            let [p, q] = wall.ends().map(|end| end.as_dvec2());
            !crosses([p, q], hull, close)
        }
        Shape::Circle(_) | Shape::Ellipse(_) => false,
    })
}

/// True where a segment passes through the inside of a convex quadrilateral, wound counter-clockwise.
fn crosses([p, q]: [DVec2; 2], hull: [DVec2; 4], close: f64) -> bool {
    let [mut from, mut to] = [0.0_f64, 1.0_f64];
    for i in 0..4 {
        let edge = hull[(i + 1) % 4] - hull[i];
        let length = edge.length();
        if length <= close {
            continue;
        }
        let [start, end] = [p, q].map(|x| edge.perp_dot(x - hull[i]) / length - close);
        if start <= 0.0 && end <= 0.0 {
            return false;
        }
        let crossing = start / (start - end);
        if start < 0.0 {
            from = from.max(crossing);
        } else if end < 0.0 {
            to = to.min(crossing);
        }
    }
    to > from
}
