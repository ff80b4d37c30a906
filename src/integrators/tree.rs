//! Looking on while a ray tree is traced: counting it, or keeping it whole.

use crate::color::Rgb;
use crate::geometry::Ray;
use crate::materials::Bsdf;
use crate::scene::Interaction;
use glam::Vec3;

/// What a ray of the tree is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum RayKind {
    /// From the eye.
    Camera,
    /// Mirrored.
    Reflected,
    /// Refracted.
    Transmitted,
}

/// One ray of the tree as a watcher sees it.
#[derive(Clone, Copy, Debug)]
pub struct TreeRay {
    /// The root is 1; node `i` reflects into `2 i` and transmits into `2 i + 1`.
    pub node: u64,
    /// Segments from the eye, this one included.
    pub depth: u32,
    /// What it is.
    pub kind: RayKind,
    /// The share of its radiance that reaches the eye, mean over channels, in `f64`.
    pub weight: f64,
}

/// Looks on while a tree is traced. Rendering watches with `()`, which costs nothing.
pub trait TreeObserver {
    /// A ray of the tree met something, or left the scene.
    fn saw(&mut self, here: &TreeRay, ray: &Ray, hit: Option<&Interaction>);
    /// The light that the surface met by the ray numbered `node` emits or scatters diffusely
    /// towards the ray.
    fn gained(&mut self, node: u64, radiance: Rgb);
}

impl TreeObserver for () {
    fn saw(&mut self, _: &TreeRay, _: &Ray, _: Option<&Interaction>) {}
    fn gained(&mut self, _: u64, _: Rgb) {}
}

/// Counts the rays of trees and sums their weights, depth by depth.
#[derive(Clone, Debug, Default)]
pub struct TreeCount {
    /// `levels[d]`: number of rays of depth `d + 1` and the sum of their weights.
    pub levels: Vec<(u64, f64)>,
}

impl TreeObserver for TreeCount {
    fn saw(&mut self, here: &TreeRay, _: &Ray, _: Option<&Interaction>) {
        let level = here.depth as usize - 1;
        if self.levels.len() <= level {
            self.levels.resize(level + 1, (0, 0.0));
        }
        let (count, weights) = &mut self.levels[level];
        *count += 1;
        *weights += here.weight;
    }

    fn gained(&mut self, _: u64, _: Rgb) {}
}

/// Keeps a whole tree: every ray, what it met, and what light it found there.
#[derive(Clone, Debug, Default)]
pub struct TreeRecord {
    /// The rays in the order in which they were traced.
    pub rays: Vec<RecordedRay>,
}

/// A ray that was kept.
#[derive(Clone, Debug)]
pub struct RecordedRay {
    /// Its place in the tree.
    pub node: TreeRay,
    /// Where it started, relative to the camera.
    pub from: Vec3,
    /// Where it ended; for a ray that left the scene, a point on its way.
    pub to: Vec3,
    /// What it met; `None` where it left the scene.
    pub met: Option<Met>,
    /// Radiance emitted or scattered diffusely towards it.
    pub gained: Rgb,
}

/// What a kept ray met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Met {
    /// A surface that emits light.
    Lamp,
    /// A surface that scatters or absorbs.
    Diffuse,
    /// A mirror.
    Mirror,
    /// A glass interface.
    Glass,
}

impl TreeObserver for TreeRecord {
    fn saw(&mut self, here: &TreeRay, ray: &Ray, hit: Option<&Interaction>) {
        let met = hit.map(|h| match h.bsdf {
            _ if h.object.light.is_some() => Met::Lamp,
            Some(Bsdf::Mirror(_)) => Met::Mirror,
            Some(Bsdf::Glass(_)) => Met::Glass,
            _ => Met::Diffuse,
        });
        self.rays.push(RecordedRay {
            node: *here,
            from: ray.origin,
            to: hit.map_or(ray.at(1.0), |h| h.surface.p),
            met,
            gained: Rgb::BLACK,
        });
    }

    fn gained(&mut self, node: u64, radiance: Rgb) {
        if let Some(kept) = self.rays.iter_mut().rev().find(|r| r.node.node == node) {
            kept.gained = radiance;
        }
    }
}
