//! Radiosity against what is known exactly, and against the other integrators. Each test names a mistake
//! that it rejects.

mod agreement;
mod closed;
mod forms;
mod input;
mod rates;
mod rooms;
mod system;

use glam::DVec3;
use halfdisk::radiosity::{Channels, FormFactors, Patch, PatchSize, Patches, Solution};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, gallery};

/// A scene that is seen from its middle.
fn scene(text: &str) -> Scene {
    let start = "name = 'test'\nfilm.size = [24, 24]\nrender.max_depth = 60\n\
                 camera = { from = [0.5, 0.45, 0.55], to = [0.2, 0, 0.1], fov = 70 }\n\
                 materials.half.lambert.albedo = 0.5\nmaterials.red.lambert.albedo = [0.7, 0.2, 0.1]\n\
                 materials.mirror.mirror.reflectance = 0.9\n";
    let text = start.to_owned() + text;
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).expect("a proper scene")
}

/// The unit cube from within, half reflecting; its ceiling shines.
const CUBE: &str = "
[[objects]]
material = 'half'
quad = { corner = [0, 0, 0], u = [0, 0, 1], v = [1, 0, 0] }
[[objects]]
material = 'half'
emits = 1
quad = { corner = [0, 1, 0], u = [1, 0, 0], v = [0, 0, 1] }
[[objects]]
material = 'half'
quad = { corner = [0, 0, 0], u = [1, 0, 0], v = [0, 1, 0] }
[[objects]]
material = 'half'
quad = { corner = [0, 0, 1], u = [0, 1, 0], v = [1, 0, 0] }
[[objects]]
material = 'half'
quad = { corner = [0, 0, 0], u = [0, 1, 0], v = [0, 0, 1] }
[[objects]]
material = 'half'
quad = { corner = [1, 0, 0], u = [0, 0, 1], v = [0, 1, 0] }
";

/// A block in the cube, and one that floats.
const BLOCKS: &str = "[[objects]]\nmaterial = 'red'\n\
    box = { min = [0.55, 0, 0.1], max = [0.85, 0.4, 0.4] }\n\
    [[objects]]\nmaterial = 'red'\nbox = { min = [0.1, 0.55, 0.1], max = [0.3, 0.7, 0.3] }\n";

/// The cube's patches, `n` along each edge; the floor's come first.
fn cube(n: u32) -> Vec<Patch> {
    let size = PatchSize::Length(1.0 / f64::from(n));
    let patches = Patches::new(&scene(CUBE), size).expect("patches").all;
    assert_eq!(patches.len(), 6 * (n * n) as usize);
    patches
}

/// Factors of patches that nothing comes between.
fn bare(patches: &[Patch], points: usize) -> FormFactors<'_> {
    FormFactors {
        patches,
        scene: None,
        points,
    }
}

fn solve(scene: &Scene, size: PatchSize) -> Solution {
    Solution::new(scene, size, &()).expect("a solution")
}

/// An axis-parallel rectangle from its lowest to its highest corner, in the plane across `axis`, with its
/// normal up that axis or down.
fn rectangle(axis: usize, low: [f64; 3], high: [f64; 3], up: bool) -> Patch {
    let [a, b] = [(axis + 1) % 3, (axis + 2) % 3];
    let corner = |x: [f64; 3], y: [f64; 3]| {
        let mut p = low;
        p[a] = x[a];
        p[b] = y[b];
        DVec3::from(p)
    };
    let mut polygon = vec![
        corner(low, low),
        corner(high, low),
        corner(high, high),
        corner(low, high),
    ];
    if !up {
        polygon.reverse();
    }
    Patch::new(polygon, [0.5; 3], [0.0; 3]).expect("an area")
}

/// The largest difference.
fn worst(a: &[Channels], b: &[Channels]) -> f64 {
    let pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}
