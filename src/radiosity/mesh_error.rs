//! How far a picture from patches is off because they are as large as they are: two meshes compared.

use super::Watch;
use super::error::RadiosityError;
use super::patches::{Patch, PatchSize};
use super::quadrature::{gauss_legendre, points_on};
use super::solution::{Effort, Solution};
use super::system::Channels;
use crate::geometry::Surface;
use crate::sampling::frame::Frame;
use crate::sampling::hemisphere;
use crate::sampling::stream::{Purpose, Stream};
use crate::scene::{Scene, Tracer};

/// What was found out while patches were lit.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Report {
    /// What it took.
    pub effort: Effort,
    /// Pieces of surface left out because others lie in their very place: those that rays do not meet,
    /// by any other integrator either. So the scene is not refused.
    pub hidden: usize,
    /// At most about the root mean square error of the indirect light that comes of the patches' size,
    /// relative to its mean; `None` where the patches cannot be any larger, to compare with.
    pub mesh_error: Option<f64>,
}

impl Report {
    /// Measures the error of a solution.
    pub fn new(
        scene: &Scene,
        solution: &Solution,
        watch: &dyn Watch,
    ) -> Result<Self, RadiosityError> {
        Ok(Report {
            effort: solution.effort,
            hidden: solution.patches.hidden,
            mesh_error: estimate(scene, solution, watch)?,
        })
    }
}

/// Points at which the light is compared.
const POINTS: usize = 512;
/// Directions from each; half of them for each of two estimates.
const DIRECTIONS: u32 = 64;
/// Seed of points and directions.
const SEED: u64 = 0x6d65_7368;

/// The root mean square error of the indirect light that a final gather shows, relative to its mean, as the
/// distance from the solution on a quarter of the patches; `None` where there is no such solution.
///
/// Where the error falls at least as fast as the size of the patches it is at most about that distance.
/// Both solutions are asked along the same rays. The product of the mean differences of two halves of them
/// has the squared distance as its expectation, whatever the noise of either.
fn estimate(
    scene: &Scene,
    fine: &Solution,
    watch: &dyn Watch,
) -> Result<Option<f64>, RadiosityError> {
    let fewer = PatchSize::Number(fine.patches.all.len() / 4);
    let coarse = match Solution::new(scene, fewer, &Stops(watch)) {
        Ok(coarse) => coarse,
        Err(RadiosityError::TooFew { .. }) => return Ok(None),
        Err(error) => return Err(error),
    };
    let all = &fine.patches.all;
    let mut tracer = Tracer::new(scene);
    let [mut squares, mut light, mut areas] = [0.0; 3];
    for i in (0..all.len()).step_by(all.len().div_ceil(POINTS).max(1)) {
        let patch = &all[i];
        let halves = [0, 1].map(|half| compare(&mut tracer, [fine, &coarse], i as u32, half));
        for c in 0..3 {
            let [first, second] = halves.map(|half| half.map(|of| of[c] * patch.albedo[c]));
            squares += patch.area * (first[0] - first[1]) * (second[0] - second[1]);
            light += patch.area * 0.5 * (first[0] + second[0]);
        }
        areas += 3.0 * patch.area;
    }
    let mean = light / areas;
    Ok((mean > 0.0).then(|| (squares / areas).max(0.0).sqrt() / mean))
}

/// What arrives at a point of a patch by both solutions, along one half of the directions.
fn compare(tracer: &mut Tracer, both: [&Solution; 2], number: u32, half: u32) -> [Channels; 2] {
    let here = point(&both[0].patches.all[number as usize]);
    let frame = Frame::new(here.n);
    let mut sums = [[0.0; 3]; 2];
    for sample in 0..DIRECTIONS / 2 {
        let stream = Stream::new(SEED, number, 2 * sample + half);
        let up = hemisphere::sample_cosine(stream.at(0, Purpose::Direction).two());
        let direction = frame.to_world(up).normalize();
        let Some(there) = tracer.secondary_ray(&here.spawn(direction)) else {
            continue;
        };
        let (p, front) = (there.surface.p.as_dvec3(), there.wo.z > 0.0);
        for (sum, solution) in sums.iter_mut().zip(both) {
            let reflected = solution.constant(there.shape, p, front);
            (0..3).for_each(|c| sum[c] += reflected[c] / f64::from(DIRECTIONS / 2));
        }
    }
    sums
}

/// The middle of a patch.
fn point(patch: &Patch) -> Surface {
    let middle: glam::DVec3 = points_on(&patch.polygon, &gauss_legendre(1))
        .iter()
        .map(|(p, weight)| *p * *weight)
        .sum();
    Surface {
        p: middle.as_vec3(),
        error: glam::Vec3::splat(patch.close as f32),
        n: patch.normal.as_vec3(),
        time: 0.0,
    }
}

/// Passes on a wish to stop, and tells nothing.
struct Stops<'a>(&'a dyn Watch);

impl Watch for Stops<'_> {
    fn tell(&self, _: u64, _: u64) {}
    fn stop(&self) -> bool {
        self.0.stop()
    }
}
