//! Chapter 2: Whitted's tree.
//!
//! Question: what does a tree of mirror, glass and shadow rays see, and what does it cost?
//! New here: `integrators::Whitted`. Simulates `LD?S*E`. Builds on: chapter 1 (rays from the eye).

mod drawing;

use halfdisk::chart::{Axis, Curve, CurveChart, Style};
use halfdisk::desk::{Chapter, Desk, DeskError, Number};
use halfdisk::geometry::Ray;
use halfdisk::integrators::{TreeCount, TreeRecord, Whitted};
use halfdisk::ledger::Ledger;
use halfdisk::output::{Display, Provenance, png_bytes};
use halfdisk::render::{Options, Rendered, compare, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer, gallery};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch02",
    title: "Whitted's tree",
    question: "What does a tree of mirror, glass and shadow rays see, and what does it cost?",
};

fn main() -> ExitCode {
    Desk::run(CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // The picture, and the tree of one of its pixels.
    let scene = gallery::load("whitted")?;
    let spp = desk.spp(16, 4);
    let picture = picture(desk, &scene, scene.suggested.max_depth, spp)?;
    let facts = Provenance::new(
        &scene,
        "whitted",
        scene.suggested.max_depth,
        spp.into(),
        desk.options.seed,
    );
    let caption = "A glass, a mirror and a dull sphere, by shadow, mirror and glass rays alone.";
    desk.figure(
        "image.png",
        caption,
        png_bytes(&picture.film, Display::Radiance, &facts)?,
    )?;
    let mut record = TreeRecord::default();
    let pixel = scene.camera.ray(drawing::PIXEL[0], drawing::PIXEL[1]);
    tree(&scene, &pixel, 7, &mut record);
    desk.number(
        "tree_rays",
        Number::new(
            "rays in the tree of one pixel, seven segments deep",
            record.rays.len() as f64,
        ),
    );
    desk.figure("tree.svg", drawing::TREE, drawing::tree(&record)?)?;
    desk.figure("plan.svg", drawing::PLAN, drawing::plan(&record)?)?;

    // ANCHOR: splitter
    // Sheets of glass in which every ray splits: 1, 2, 4, 8 … rays, of the same weight in all.
    let splitter = gallery::load("splitter")?;
    let mut count = TreeCount::default();
    tree(&splitter, &straight(&splitter), 14, &mut count);
    let mut total = 0;
    for (level, (rays, weight)) in count.levels.iter().enumerate() {
        total += rays;
        let depth = level + 1;
        let full = ((1_u64 << depth) - 1) as f64;
        desk.number(
            &format!("rays_{depth}"),
            Number::new(&format!("rays up to depth {depth}"), total as f64).exact(full),
        );
        desk.number(
            &format!("weight_{depth}"),
            Number::new("  their weights at this depth add up to", *weight).exact(1.0),
        );
    }
    // ANCHOR_END: splitter
    let levels = |f: fn(&(u64, f64)) -> f64| {
        let points = count.levels.iter().enumerate();
        points
            .map(|(i, level)| ((i + 1) as f64, f(level)))
            .collect::<Vec<_>>()
    };
    let doubling = |sign: i32| {
        (1..=14)
            .map(|d| (f64::from(d), 2_f64.powi(sign * (d - 1))))
            .collect::<Vec<_>>()
    };
    let chart = CurveChart {
        title: "Twice the rays, half the weight".to_owned(),
        x_label: "depth".to_owned(),
        y_label: "rays; mean weight of a ray".to_owned(),
        x_axis: Axis::Linear,
        y_axis: Axis::Log,
        curves: vec![
            Curve::new("rays", Style::Marks, levels(|(rays, _)| *rays as f64)),
            Curve::new("doubling", Style::Dashed, doubling(1)),
            Curve::new(
                "mean weight",
                Style::Marks,
                levels(|(rays, weight)| weight / *rays as f64),
            ),
            Curve::new("halving", Style::Dashed, doubling(-1)),
            Curve::new(
                "a path: one ray at each depth",
                Style::Line,
                (1..=14).map(|d| (f64::from(d), 1.0)),
            ),
        ],
    };
    let caption = "Rays grow exponentially with depth, and what each is worth shrinks as fast.";
    desk.figure("chart.svg", caption, chart.to_svg()?)?;

    // ANCHOR: slab
    // What a slab lets through and reflects, when its rays have bounced inside thirty times.
    let slab = gallery::load("slab")?;
    let li = tree(&slab, &straight(&slab), 32, &mut ());
    let f = 0.04;
    let through = Number::new("glass slab: share of light let through", li.r.into());
    desk.number("slab_through", through.exact((1.0 - f) / (1.0 + f)));
    let back = Number::new("glass slab: share of light reflected", li.g.into());
    desk.number("slab_back", back.exact(2.0 * f / (1.0 + f)));
    // ANCHOR_END: slab
    let left = f64::from(f as f32).powi(30) * (1.0 - f);
    desk.number(
        "slab_left",
        Number::new("weight of the ray that was not followed further", left),
    );

    // A mirror corridor: the lamp after n bounces, mirrored n times by 0.9.
    let tunnel = gallery::load("tunnel")?;
    let mut worst = 0.0_f64;
    for n in 0..=6_i32 {
        let toward = glam::Vec3::new(6.0, n as f32, 0.0).normalize();
        let li = tree(&tunnel, &Ray::new(glam::Vec3::ZERO, toward), 16, &mut ());
        worst = worst.max((f64::from(li.r) - 0.9_f64.powi(n)).abs());
    }
    desk.number(
        "tunnel_error",
        Number::new(
            "mirror corridor: largest distance from 0.9^n, n = 0 … 6",
            worst,
        )
        .exact(0.0),
    );

    // What each further depth adds to the picture, and costs.
    let deep = desk.choose(10, 6);
    let mut gains = Vec::new();
    let mut costs = Vec::new();
    let mut before: Option<Rendered> = None;
    let mut spent = picture.rays.total();
    for depth in 2..=deep {
        let now = self::picture(desk, &scene, depth, spp)?;
        spent += now.rays.total();
        if let Some(before) = before {
            let rms = compare::mse(&now.film, &before.film).sqrt();
            let added = (now.rays.total() - before.rays.total()) as f64;
            desk.number(
                &format!("gain_{depth}"),
                Number::new(
                    &format!("root mean square change of the picture by depth {depth}"),
                    rms,
                ),
            );
            gains.push((f64::from(depth), rms));
            costs.push((f64::from(depth), added / (320.0 * 200.0 * f64::from(spp))));
        }
        before = Some(now);
    }
    let chart = CurveChart {
        title: "What a further depth adds, and costs".to_owned(),
        x_label: "depth".to_owned(),
        y_label: "change of the picture; rays added per sample".to_owned(),
        y_axis: Axis::Log,
        curves: vec![
            Curve::new("change of the picture (RMS)", Style::MarksAndLine, gains),
            Curve::new("rays added per sample", Style::MarksAndLine, costs),
        ],
        ..CurveChart::default()
    };
    let caption = "In a real scene rays soon leave, so the cost stops growing; what they add goes on shrinking.";
    desk.figure("gain.svg", caption, chart.to_svg()?)?;

    let samples = 320.0 * 200.0 * f64::from(spp);
    let variance = picture.film.sample_variance();
    Ok(Ledger {
        rays: spent + total,
        seconds: 0.0,
        variance: Some(variance),
        bias_in_errors: None,
        efficiency: Some(samples / (variance * picture.rays.total() as f64)),
        gain: "Mirrors and glass, sharp and exact; each further depth may double the rays and adds less to the picture.".to_owned(),
    })
}

/// The tree of one ray, with someone looking on.
fn tree(
    scene: &Scene,
    ray: &Ray,
    max_depth: u32,
    watcher: &mut impl halfdisk::integrators::Watch,
) -> halfdisk::color::Rgb {
    Whitted { max_depth }.watch(&mut Tracer::new(scene), ray, &Stream::new(0, 0, 0), watcher)
}

/// The ray through the middle of the picture.
fn straight(scene: &Scene) -> Ray {
    scene.camera.ray(0.5, 0.5)
}

fn picture(desk: &Desk, scene: &Scene, max_depth: u32, spp: u32) -> Result<Rendered, DeskError> {
    let options = Options {
        spp,
        seed: desk.options.seed,
        ..Options::default()
    };
    let rendered = render(
        scene,
        &Whitted { max_depth },
        &options,
        &desk.bar("whitted"),
    );
    if rendered.interrupted {
        Err(DeskError::Interrupted)
    } else {
        Ok(rendered)
    }
}
