//! Form factors between the patches of a scene: Gauss points on the receiver, Lambert's formula for the
//! other patch as each of them sees it, and a shadow ray.
//!
//! The inner integral is exact, so patches may share an edge, where quadrature over both areas fails:
//! its integrand has a pole there. The patches of a closed room tile the hemisphere over each point, so
//! rows add up to 1 whatever the number of points. What a point on the receiver is taken for is its
//! place (collocation): reciprocity holds only as far as the points integrate well.
//!
//! Sources: Wallace, Elmquist, Haines, A Ray Tracing Algorithm for Progressive Radiosity (SIGGRAPH
//! 1989), for shadow rays in form factors; Atkinson, Chien, Seol, Numerical Analysis of the Radiosity
//! Equation Using the Collocation Method (ETNA 11, 2000), for the error.

use super::error::RadiosityError;
use super::lambert::{above_horizon, projected};
use super::patches::Patch;
use super::quadrature::{gauss_legendre, points_on};
use super::{Matrix, Watch};
use crate::geometry::Surface;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Scene, Tracer};
use crate::stats::Estimate;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::atomic::{AtomicU64, Ordering};

/// Seed of the points that shadow rays aim at: the same in every picture.
const SEED: u64 = 0x0070_6174_6368_6573;

/// Form factors of patches in their scene.
#[derive(Clone, Copy, Debug)]
pub struct FormFactors<'a> {
    /// The patches.
    pub patches: &'a [Patch],
    /// What hides them from each other; `None` where nothing is known to.
    pub scene: Option<&'a Scene>,
    /// Points along each side of a receiver, 1 or more.
    pub points: usize,
}

/// What is kept from patch to patch of a row.
struct Desk<'a> {
    tracer: Option<Tracer<'a>>,
    above: Vec<DVec3>,
}

impl<'a> FormFactors<'a> {
    /// The matrix, row by row on all threads; and the shadow rays that it took.
    ///
    /// The same bytes on any number of threads: the points that shadow rays aim at are numbers of their own.
    pub fn matrix(&self, watch: &dyn Watch) -> Result<(Matrix, u64), RadiosityError> {
        let size = self.patches.len();
        let mut entries = vec![0.0_f32; size * size];
        let [done, rays] = [AtomicU64::new(0), AtomicU64::new(0)];
        let fill = |(i, row): (usize, &mut [f32])| {
            if watch.stop() {
                return Err(RadiosityError::Stopped);
            }
            rays.fetch_add(self.fill(i, 0, row), Ordering::Relaxed);
            watch.tell(done.fetch_add(1, Ordering::Relaxed) + 1, size as u64);
            Ok(())
        };
        let rows = entries.par_chunks_mut(size.max(1)).enumerate();
        rows.try_for_each(fill)?;
        Ok((Matrix::new(size, entries), rays.into_inner()))
    }

    /// One row in double precision.
    pub fn row(&self, i: usize) -> Vec<f64> {
        let mut row = vec![0.0; self.patches.len()];
        self.fill(i, 0, &mut row);
        row
    }

    /// The sum of row `i` over so many replicates, each with random points of its own for its shadow rays: in a
    /// closed room its expectation is 1, and [`Estimate::std_error`] says how near to it so many rays come.
    /// Replicate 0 is the row of [`FormFactors::matrix`].
    pub fn row_sum(&self, i: usize, replicates: u32) -> Estimate {
        let mut row = vec![0.0; self.patches.len()];
        let sums = (0..replicates).map(|replicate| {
            row.fill(0.0);
            self.fill(i, replicate, &mut row);
            row.iter().sum()
        });
        sums.collect()
    }

    // ANCHOR: row
    /// Fills the row of patch `i`: for each other patch the mean over points of `i` of the part of the
    /// view that it takes up, where it is visible. Returns the number of shadow rays.
    fn fill<T: FromFactor>(&self, i: usize, replicate: u32, row: &mut [T]) -> u64 {
        let receiver = &self.patches[i];
        let points = points_on(&receiver.polygon, &gauss_legendre(self.points));
        let mut desk = Desk {
            tracer: self.scene.map(Tracer::new),
            above: Vec::with_capacity(8),
        };
        for (j, (other, entry)) in self.patches.iter().zip(row).enumerate() {
            if j == i || !other.is_before(receiver) || !receiver.is_before(other) {
                continue;
            }
            let mut factor = 0.0;
            for (g, (p, weight)) in points.iter().enumerate() {
                let aim = Stream::new(SEED, i as u32, replicate * points.len() as u32 + g as u32);
                factor += weight * desk.seen(receiver, *p, other, j as u64, aim);
            }
            *entry = T::from_factor(factor);
        }
        desk.tracer.map_or(0, |tracer| tracer.counts().shadow)
    }
    // ANCHOR_END: row
}

/// What a point sees of patches.
pub(super) struct View<'a, 'b> {
    desk: Desk<'a>,
    from: &'b Patch,
    p: DVec3,
}

impl<'a, 'b> View<'a, 'b> {
    /// The view from a point of a patch, whose size bounds the point's rounding; `tracer` is lent.
    pub fn new(tracer: Option<Tracer<'a>>, from: &'b Patch, p: DVec3) -> Self {
        View {
            desk: Desk {
                tracer,
                above: Vec::with_capacity(8),
            },
            from,
            p,
        }
    }

    /// The form factor to a patch, the `number`-th of all, where one random point of it is visible.
    pub fn of(&mut self, other: &Patch, number: u64, aim: Stream) -> f64 {
        if !other.is_before(self.from) {
            return 0.0;
        }
        self.desk.seen(self.from, self.p, other, number, aim)
    }
}

impl Desk<'_> {
    fn seen(&mut self, from: &Patch, p: DVec3, other: &Patch, number: u64, aim: Stream) -> f64 {
        let close = other.close.max(from.close);
        if other.height(p) <= close {
            return 0.0;
        }
        above_horizon(p, from.normal, &other.polygon, &mut self.above);
        let factor = projected(from.normal, &self.above);
        let Some(tracer) = self.tracer.as_mut().filter(|_| factor > 0.0) else {
            return factor;
        };
        let mut numbers = aim.at(number, Purpose::LightPoint);
        let target = p + point_in(&self.above, numbers.two());
        let [here, there] = [surface(from, p), surface(other, target)];
        match tracer.unoccluded(&here.spawn_to(&there)) {
            true => factor,
            false => 0.0,
        }
    }
}

/// A point of a patch as rays leave it.
fn surface(patch: &Patch, p: DVec3) -> Surface {
    Surface {
        p: p.as_vec3(),
        error: glam::Vec3::splat(patch.close as f32),
        n: patch.normal.as_vec3(),
        time: 0.0,
    }
}

/// A point of a convex polygon, uniformly where `u` is.
fn point_in(polygon: &[DVec3], [u, v]: [f32; 2]) -> DVec3 {
    let first = polygon[0];
    let fan = || polygon.windows(2).skip(1);
    let twice = |pair: &[DVec3]| (pair[0] - first).cross(pair[1] - first).length();
    let mut left = f64::from(u) * fan().map(twice).sum::<f64>();
    let mut chosen = [first; 2];
    let mut share = 0.0;
    for pair in fan() {
        let area = twice(pair);
        chosen = [pair[0], pair[1]];
        share = if area > 0.0 {
            (left / area).min(1.0)
        } else {
            0.0
        };
        if left <= area {
            break;
        }
        left -= area;
    }
    // The square folded onto the triangle, with its first side drawn together.
    let s = share.sqrt();
    let [a, b] = chosen.map(|corner| corner - first);
    first + a * (s * (1.0 - f64::from(v))) + b * (s * f64::from(v))
}

/// A number that a form factor is kept as.
trait FromFactor {
    fn from_factor(factor: f64) -> Self;
}

impl FromFactor for f32 {
    fn from_factor(factor: f64) -> f32 {
        factor as f32
    }
}

impl FromFactor for f64 {
    fn from_factor(factor: f64) -> f64 {
        factor
    }
}
