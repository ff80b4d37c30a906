//! Trees, paths and what lies between, at what they cost.

use crate::picture;
use crate::split::Split;
use halfdisk::integrators::NextEvent;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::walks;
use halfdisk::render::{Film, Rendered};
use halfdisk::scene::{Scene, gallery};

/// The lower half of the box: the lamp is not in it, whose few bright pixels would decide all.
pub fn without_lamp(found: &Rendered) -> Film {
    let height = found.film.height();
    found.film.rows(height / 2..height)
}

/// Variance of one sample times its rays: what certainty costs.
fn price(found: &Rendered) -> f64 {
    without_lamp(found).sample_variance() * each(found)
}

/// Rays of one sample.
fn each(found: &Rendered) -> f64 {
    found.rays.total() as f64 / found.rays.camera.max(1) as f64
}

fn small() -> Result<Scene, DeskError> {
    Ok(gallery::load("cornell")?.sized([32; 2]))
}

/// The tree of the gather and single paths, in the same room, for as many rays: how far they are
/// apart in standard errors, and the rays.
pub fn tree_and_paths(desk: &mut Desk) -> Result<(f64, u64), DeskError> {
    let scene = small()?;
    let tree = Gather {
        samples: 16,
        depth: 2,
        recipe: Recipe::Cosine,
    };
    let paths = NextEvent { max_depth: 4 };
    let spp = desk.choose(3, 2);
    let tree = picture(desk, &scene, &tree, spp, 0)?;
    // As many paths as the same rays buy; a few tell how many rays a path has.
    let few = picture(desk, &scene, &paths, 4, 1)?;
    let many = (f64::from(spp) * each(&tree) / each(&few)) as u32;
    let paths = picture(desk, &scene, &paths, many, 1)?;
    let (a, b) = (without_lamp(&tree), without_lamp(&paths));
    for (name, says, found, half) in [
        ("tree", "lower half of the box, by trees", &tree, &a),
        ("paths", "lower half of the box, by paths", &paths, &b),
    ] {
        let (mean, error) = half.mean();
        let number = Number::new(says, mean);
        let error = Some(error);
        desk.number(name, Number { error, ..number });
        desk.value(&format!("{name}_rays"), "  rays of one", three(each(found)));
        desk.value(
            &format!("{name}_all"),
            "  rays in all",
            found.rays.total() as f64,
        );
        let samples = half.pixels().first().map_or(1, |p| p.count());
        let noise = (half.sample_variance() / samples as f64).sqrt();
        desk.value(&format!("{name}_noise"), "  noise of a pixel", three(noise));
    }
    let ((a, a_error), (b, b_error)) = (a.mean(), b.mean());
    desk.value(
        "price_ratio",
        "rays of trees for one of paths",
        three(price(&tree) / price(&paths)),
    );
    let z = (a - b) / a_error.hypot(b_error);
    desk.value("apart", "their distance in standard errors", three(z.abs()));
    Ok((z, tree.rays.total() + paths.rays.total()))
}

/// One, two, four or sixteen paths for each ray from the eye, sixty-four in all: the rays.
pub fn splitting(desk: &mut Desk) -> Result<u64, DeskError> {
    let (scene, max_depth, seed) = (small()?, 5, desk.options.seed);
    // Where every ray from the eye meets the same surface, and across an edge of the short block.
    let inside = scene.camera.ray(0.35, 0.93);
    let all = desk.choose(64, 32);
    let (mut rays, mut best) = (0, (f64::INFINITY, 0));
    let (mut picture_wide, mut one_point) = (Vec::new(), Vec::new());
    for paths in [1, 2, 4, 16] {
        let split = Split { paths, max_depth };
        let found = picture(desk, &scene, &split, all / paths, 0)?;
        let whole = price(&found);
        let count = desk.choose(48_000, 16_000) / paths;
        let walks = walks::solid(&scene, &inside, &split, 0.0, count, seed);
        let point = walks.estimate.variance() * walks.rays_each();
        desk.value(
            &format!("split_rays_{paths}"),
            &format!("{paths} paths for each ray from the eye: rays"),
            three(each(&found)),
        );
        desk.value(
            &format!("split_{paths}"),
            "  variance times rays, picture",
            three(whole),
        );
        desk.value(
            &format!("split_point_{paths}"),
            "  variance times rays, one point",
            three(point),
        );
        best = if whole < best.0 { (whole, paths) } else { best };
        picture_wide.push((f64::from(paths), whole));
        one_point.push((f64::from(paths), point));
        rays += found.rays.total() + walks.rays;
    }
    desk.value(
        "best_split",
        "the best of these for the picture",
        f64::from(best.1),
    );
    let relative = |points: Vec<(f64, f64)>| {
        let first = points.first().map_or(1.0, |p| p.1);
        points.into_iter().map(move |(x, y)| (x, y / first))
    };
    let chart = CurveChart {
        title: "What certainty costs, with several paths for each ray from the eye".to_owned(),
        x_label: "paths for each ray from the eye".to_owned(),
        y_label: "variance × rays, for one path: 1".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Linear,
        curves: vec![
            Curve::new(
                "picture, lower half",
                Style::MarksAndLine,
                relative(picture_wide),
            ),
            Curve::new(
                "one point of the floor",
                Style::MarksAndLine,
                relative(one_point),
            ),
        ],
    };
    let caption = "Sharing the ray from the eye saves a ray and takes away chances: at a point it pays a \
                   little, over pixels with edges in them it does not.";
    desk.figure("chart.svg", caption, chart.to_svg()?)?;
    Ok(rays)
}

/// Three digits: enough for a number that comes without an error.
pub fn three(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}
