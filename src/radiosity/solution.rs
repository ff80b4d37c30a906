//! The light of a scene on its patches, solved once and looked at from anywhere.

use super::error::{RadiosityError, bytes};
use super::factors::{FormFactors, View};
use super::patches::{PatchSize, Patches};
use super::quadrature::parallelogram;
use super::system::{Channels, Solved, System};
use super::{Watch, direct};
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};
use glam::DVec3;

/// Points along each side of a receiver.
pub const POINTS: usize = 2;
/// Sweeps end where they change nothing by more of the largest radiance: below the rounding of the
/// matrix.
const TOLERANCE: f64 = 1e-7;
/// A sweep that still changes more than this has not settled.
const SETTLED: f64 = 1e-6;

/// The radiance of a scene's patches.
#[derive(Clone, Debug)]
pub struct Solution {
    /// The patches.
    pub patches: Patches,
    /// Radiance that each of them reflects, without what it emits, in W/(m² sr).
    pub reflected: Vec<Channels>,
    /// What it took.
    pub effort: Effort,
}

/// What a solution took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Effort {
    /// Patches.
    pub patches: usize,
    /// Bytes of the matrix.
    pub bytes: u64,
    /// Shadow rays for the form factors.
    pub rays: u64,
    /// Sweeps of the solver.
    pub sweeps: u32,
}

impl Solution {
    /// Solves the light of `scene` on patches of a size.
    pub fn new(scene: &Scene, size: PatchSize, watch: &dyn Watch) -> Result<Self, RadiosityError> {
        let patches = Patches::new(scene, size)?;
        let (system, rays) = system(scene, &patches, POINTS, watch)?;
        let Solved {
            radiance,
            sweeps,
            change,
        } = system.gauss_seidel(TOLERANCE);
        if change > SETTLED || radiance.iter().flatten().any(|r| !r.is_finite()) {
            return Err(RadiosityError::Unsettled);
        }
        let emitted = patches.all.iter().map(|patch| patch.emission);
        let pairs = radiance.iter().zip(emitted);
        Ok(Solution {
            reflected: pairs
                .map(|(all, own)| [0, 1, 2].map(|c| all[c] - own[c]))
                .collect(),
            effort: Effort {
                patches: patches.all.len(),
                bytes: bytes(patches.all.len()) as u64,
                rays,
                sweeps,
            },
            patches,
        })
    }

    /// The reflected radiance at a point of a shape, the same all over its patch; black where there is
    /// no patch.
    ///
    /// * `shape`: its number, as in [`Interaction::shape`](crate::scene::Interaction::shape).
    /// * `front`: the side that is looked at.
    pub fn constant(&self, shape: u32, p: DVec3, front: bool) -> Channels {
        let patch = self.patches.at(shape, p, front);
        patch.map_or([0.0; 3], |i| self.reflected[i])
    }

    /// The same, bilinear between the middles of patches that are parallelograms.
    pub fn smooth(&self, shape: u32, p: DVec3, front: bool) -> Channels {
        let Some(here) = self.patches.at(shape, p, front) else {
            return [0.0; 3];
        };
        let Some([corner, u, v]) = parallelogram(&self.patches.all[here].polygon) else {
            return self.reflected[here];
        };
        // How far from the middle, in edges: towards the next patch on that side.
        let from = p - (corner + 0.5 * (u + v));
        let normal = u.cross(v);
        let square = normal.length_squared();
        let s = from.cross(v).dot(normal) / square;
        let t = u.cross(from).dot(normal) / square;
        let beside = |ds: f64, dt: f64| {
            let there = corner + 0.5 * (u + v) + u * ds + v * dt;
            let found = self.patches.at(shape, there, front);
            self.reflected[found.unwrap_or(here)]
        };
        let [ds, dt] = [s, t].map(f64::signum);
        let [ws, wt] = [s, t].map(|x| x.abs().min(1.0));
        let near = [
            (beside(0.0, 0.0), (1.0 - ws) * (1.0 - wt)),
            (beside(ds, 0.0), ws * (1.0 - wt)),
            (beside(0.0, dt), (1.0 - ws) * wt),
            (beside(ds, dt), ws * wt),
        ];
        [0, 1, 2].map(|c| near.iter().map(|(of, weight)| of[c] * weight).sum())
    }

    // ANCHOR: gathered
    /// What arrives at a point from all patches that reflect, as a mean of radiances over its hemisphere:
    /// the albedo there times this is the radiance of the indirect light.
    ///
    /// The patches are seen exactly, one shadow ray to each says whether they are. Its cost is theirs,
    /// its error falls faster than that of the patches.
    ///
    /// * `scene`: what hides patches; `None` where nothing does.
    pub fn gathered(
        &self,
        scene: Option<&Scene>,
        [shape, side]: [u32; 2],
        p: DVec3,
        aim: Stream,
    ) -> Channels {
        let mut sum = [0.0; 3];
        let Some(own) = self.patches.at(shape, p, side == 1) else {
            return sum;
        };
        let mut view = View::new(scene.map(Tracer::new), &self.patches.all[own], p);
        for (j, patch) in self.patches.all.iter().enumerate() {
            let reflected = self.reflected[j];
            if reflected == [0.0; 3] {
                continue;
            }
            let factor = view.of(patch, j as u64, aim);
            (0..3).for_each(|c| sum[c] += factor * reflected[c]);
        }
        sum
    }
    // ANCHOR_END: gathered

    /// The same solution in coordinates whose origin is `by` further.
    #[must_use]
    pub fn moved(mut self, by: DVec3) -> Self {
        self.patches.move_by(by);
        self
    }
}

/// The system of a scene on its patches, and the shadow rays that it took.
///
/// Lamps whose shapes have patches are patches; the light of all others is asked for at points of each
/// patch.
pub fn system(
    scene: &Scene,
    patches: &Patches,
    points: usize,
    watch: &dyn Watch,
) -> Result<(System, u64), RadiosityError> {
    let factors = FormFactors {
        patches: &patches.all,
        scene: Some(scene),
        points,
    };
    let arriving = direct::arriving(scene, patches);
    let (factors, rays) = factors.matrix(watch)?;
    let sent = patches.all.iter().zip(arriving);
    let sent = sent.map(|(patch, arrives)| {
        [0, 1, 2].map(|c| patch.emission[c] + patch.albedo[c] * arrives[c])
    });
    let system = System {
        emission: sent.collect(),
        albedo: patches.all.iter().map(|patch| patch.albedo).collect(),
        factors,
    };
    Ok((system, rays))
}
