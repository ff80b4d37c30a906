//! The tree of one pixel: as a tree, and as rays seen from above.

use halfdisk::chart::{
    Bounds, ChartError, Circle, EdgeKind, Label, RayDrawing, Stroke, StrokeKind, TreeDrawing,
    TreeNode,
};
use halfdisk::integrators::{Met, RayKind, RecordedRay, TreeRecord};

/// The pixel, as a film position: at the edge of the glass sphere, where some light comes by way of the mirror.
pub const PIXEL: [f32; 2] = [0.25, 0.64];

pub const TREE: &str = "The ray tree of one pixel on the glass sphere. Weights on the edges say how \
    much of a ray's light reaches the eye.";
pub const PLAN: &str = "The same rays seen from above: the eye is at the bottom, the circles are the \
    glass, the mirror and the dull sphere.";

/// The scene's spheres: name, x and z of the centre relative to the camera, radius.
const SPHERES: [(&str, f32, f32, f64); 3] = [
    ("glass", -0.75, -6.0, 0.9),
    ("mirror", 1.5, -8.2, 1.1),
    ("dull", -2.4, -9.0, 0.7),
];

/// Weights below this share are left out of the drawings.
const FAINT: f64 = 0.002;

/// The tree with its weights.
pub fn tree(record: &TreeRecord) -> Result<String, ChartError> {
    let nodes = visible(record).map(|kept| {
        let kind = match kept.node.kind {
            RayKind::Camera => EdgeKind::Camera,
            RayKind::Reflected => EdgeKind::Reflected,
            RayKind::Transmitted => EdgeKind::Transmitted,
        };
        let label = match kept.met {
            None => "sky",
            Some(Met::Lamp) => "lamp",
            Some(Met::Diffuse) => "diffuse",
            Some(Met::Mirror) => "mirror",
            Some(Met::Glass) => "glass",
        };
        TreeNode::new(
            kept.node.node,
            kind,
            label,
            &format!("{:.3}", kept.node.weight),
        )
    });
    TreeDrawing {
        title: "One pixel's tree".to_owned(),
        nodes: nodes.collect(),
    }
    .to_svg()
}

/// The rays in plan view, camera at the origin.
pub fn plan(record: &TreeRecord) -> Result<String, ChartError> {
    // Seen from above: x to the right, the direction of view upwards.
    let place = |x: f32, z: f32| [f64::from(x), f64::from(-z)];
    let strokes = visible(record)
        .map(|kept| {
            let kind = match kept.node.kind {
                RayKind::Camera => StrokeKind::Camera,
                RayKind::Reflected => StrokeKind::Reflected,
                RayKind::Transmitted => StrokeKind::Transmitted,
            };
            let (a, b) = (kept.from, kept.to);
            Stroke::arrow(kind, place(a.x, a.z), place(b.x, b.z))
        })
        .collect();
    let circles = SPHERES
        .iter()
        .map(|&(_, x, z, radius)| Circle {
            center: place(x, z),
            radius,
            kind: StrokeKind::Wall,
        })
        .collect();
    RayDrawing {
        title: "The same rays from above".to_owned(),
        view: Bounds {
            min: [-4.5, -0.3],
            max: [4.5, 11.0],
        },
        strokes,
        circles,
        labels: SPHERES
            .map(|(name, x, z, _)| Label {
                at: place(x, z),
                text: name.to_owned(),
            })
            .to_vec(),
        ..RayDrawing::default()
    }
    .to_svg()
}

/// The rays whose weight can be seen; those below a faint one are as faint.
fn visible(record: &TreeRecord) -> impl Iterator<Item = &RecordedRay> {
    record.rays.iter().filter(|kept| kept.node.weight >= FAINT)
}
