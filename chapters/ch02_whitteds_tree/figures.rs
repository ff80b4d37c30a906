//! The figures of this chapter: one pixel's tree, and how trees grow.

use halfdisk::integrators::{Met, RayKind, RecordedRay, TreeCount, TreeRecord};
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::lab::drawing::{
    Axis, Bounds, ChartError, Circle, Curve, CurveChart, EdgeKind, Label, RayDrawing, Stroke,
    StrokeKind, Style, TreeDrawing, TreeNode,
};

/// The picture of the chapter.
pub const FINALE: Finale = Finale {
    file: "image.png",
    title: "A glass, a mirror and a diffuse sphere, by shadow, mirror and glass rays alone. Look into the \
            shadows: they are black.",
    spp: 6,
    stops: 0.0,
};

/// The pixel, as a film position: at the edge of the glass sphere, where some light comes by way of the mirror.
pub const PIXEL: [f32; 2] = [0.25, 0.64];

/// The scene's spheres: name, x and z of the centre relative to the camera, radius.
const SPHERES: [(&str, f32, f32, f64); 3] = [
    ("glass", -0.75, -6.0, 0.9),
    ("mirror", 1.5, -8.2, 1.1),
    ("diffuse", -2.4, -9.0, 0.7),
];

/// Weights below this share are left out of the drawings.
const FAINT: f64 = 0.002;

/// One pixel's tree: as a tree, and as rays seen from above.
pub fn one_tree(desk: &mut Desk, record: &TreeRecord) -> Result<(), DeskError> {
    let deepest = record.rays.iter().map(|ray| ray.node.depth).max();
    let last = record
        .rays
        .iter()
        .filter(|ray| Some(ray.node.depth) == deepest);
    let most = last.map(|ray| ray.node.weight).fold(0.0, f64::max);
    let caption = format!(
        "The ray tree of one pixel at the rim of the glass sphere. Each split shares the light between \
         reflection (blue) and refraction (orange). After {} levels no branch carries more than {:.1} % of it.",
        deepest.unwrap_or(0),
        100.0 * most
    );
    desk.figure("tree.svg", &caption, tree(record)?)?;
    let caption = "The same rays from above: the one from the eye enters at the bottom, the circles \
                   are the three spheres.";
    desk.figure("plan.svg", caption, plan(record)?)
}

/// Rays and weights at each depth, as numbers and as a chart; the number of rays in all.
pub fn growth(desk: &mut Desk, count: &TreeCount) -> Result<u64, DeskError> {
    let mut total = 0;
    for (depth, (rays, weight)) in (1..).zip(&count.levels) {
        total += rays;
        let full = ((1_u64 << depth) - 1) as f64;
        let says = format!("rays up to depth {depth}");
        desk.known(&format!("rays_{depth}"), &says, total as f64, full);
        let says = "  weight of those at this depth";
        desk.known(&format!("weight_{depth}"), says, *weight, 1.0);
    }
    let deepest = count.levels.len() as i32;
    let measured = |value: fn(&(u64, f64)) -> f64| {
        let levels = count.levels.iter().enumerate();
        levels.map(move |(i, level)| ((i + 1) as f64, value(level)))
    };
    let powers = |sign: i32| (1..=deepest).map(move |d| (f64::from(d), 2_f64.powi(sign * (d - 1))));
    let path = (1..=deepest).map(|d| (f64::from(d), 1.0));
    let chart = CurveChart {
        title: "Twice the rays, half the weight".to_owned(),
        x_label: "depth".to_owned(),
        y_label: "rays at this depth; mean weight of one".to_owned(),
        x_axis: Axis::Linear,
        y_axis: Axis::Log,
        curves: vec![
            Curve::new("rays", Style::Marks, measured(|(rays, _)| *rays as f64)),
            Curve::new("doubling: slope ln 2", Style::Dashed, powers(1)),
            Curve::new(
                "mean weight",
                Style::Marks,
                measured(|(rays, weight)| weight / *rays as f64),
            ),
            Curve::new("halving: slope -ln 2", Style::Dashed, powers(-1)),
            Curve::new("a path: one ray at each depth", Style::Line, path),
        ],
    };
    let caption = "Rays grow exponentially with depth, and what each is worth shrinks as fast.";
    desk.figure("chart.svg", caption, chart.to_svg()?)?;
    Ok(total)
}

/// What each depth changes in the picture and costs: (depth, change, rays added per sample).
pub fn gain(desk: &mut Desk, gains: &[(f64, f64, f64)]) -> Result<(), DeskError> {
    for (depth, change, rays) in gains {
        let says = format!("root mean square change of the picture by depth {depth}");
        desk.value(&format!("gain_{depth}"), &says, *change);
        desk.value(&format!("cost_{depth}"), "  rays added per sample", *rays);
    }
    let changes = gains.iter().map(|(depth, change, _)| (*depth, *change));
    let costs = gains.iter().map(|(depth, _, rays)| (*depth, *rays));
    let chart = CurveChart {
        title: "What a further depth adds, and costs".to_owned(),
        x_label: "depth".to_owned(),
        y_label: "change of the picture, W/(m² sr); rays".to_owned(),
        y_axis: Axis::Log,
        curves: vec![
            Curve::new("change of the picture (RMS)", Style::MarksAndLine, changes),
            Curve::new("rays added per sample", Style::MarksAndLine, costs),
        ],
        ..CurveChart::default()
    };
    let caption = "In this scene most rays soon leave, so the cost stays level; what a depth adds \
                   goes on shrinking.";
    desk.figure("gain.svg", caption, chart.to_svg()?)
}

/// The tree with its weights.
fn tree(record: &TreeRecord) -> Result<String, ChartError> {
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
            format!("{:.3}", kept.node.weight),
        )
    });
    TreeDrawing {
        title: "One pixel's tree".to_owned(),
        nodes: nodes.collect(),
    }
    .to_svg()
}

/// The rays in plan view, camera at the origin.
fn plan(record: &TreeRecord) -> Result<String, ChartError> {
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
            min: [-3.6, 4.2],
            max: [3.2, 10.2],
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
