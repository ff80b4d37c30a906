//! The figures of this chapter: a tree and its path, an edge, and a picture of forty paths.

use crate::compare::{three, without_lamp};
use crate::picture;
use glam::Vec2;
use halfdisk::flatland;
use halfdisk::integrators::world::Lights;
use halfdisk::integrators::{Kajiya, NextEvent};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Dot, HALF, HeatMap, RayDrawing, Stroke, StrokeKind};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::figures::{flat, walk::Watched};
use halfdisk::render::Pixel;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, gallery};
use halfdisk::space::{Flat, Ray};
use halfdisk::stats::Estimate;

/// Directions at each surface of the tree.
const BRANCHES: usize = 16;
/// A tree of rays in the flat room, and one path of it.
pub fn tree_and_path(desk: &mut Desk) -> Result<(), DeskError> {
    let room = flatland::load("room")?;
    let mut watched = Watched::new(&room, Lights::Points);
    let eye = Ray::<Flat>::new(Vec2::new(0.15, 0.75), Vec2::new(0.6, -0.8));
    let tree = Gather {
        samples: BRANCHES as u32,
        depth: 2,
        recipe: Recipe::Cosine,
    };
    tree.li(&mut watched, &eye, &Stream::new(desk.options.seed, 0, 0));
    // Each ray is followed by all that comes of it, before the next of its own level.
    let first = |i: usize| 1 + i * (1 + BRANCHES);
    let second = |i: usize, j: usize| first(i) + 1 + j;
    let stroke = |kind, number: usize| {
        let [from, to] = watched.rays.get(number)?.map(|p| p.as_dvec2().to_array());
        Some(Stroke::new(kind, from, to))
    };
    let mut drawing = flat::world(&room);
    drawing.strokes.extend(stroke(StrokeKind::Camera, 0));
    for i in 0..BRANCHES {
        drawing
            .strokes
            .extend(stroke(StrokeKind::Reflected, first(i)));
        let level = (0..BRANCHES).filter_map(|j| stroke(StrokeKind::ToSurface, second(i, j)));
        drawing.strokes.extend(level);
    }
    drawing.title = format!("The tree: {} rays", watched.rays.len());
    let caption = "Sixteen directions at the first surface, sixteen more wherever they lead.";
    desk.figure("tree.svg", caption, drawing.to_svg_at(HALF)?)?;

    // By way of a wall to the lamp, where there is such a branch.
    let ends_at = |number: usize| watched.rays.get(number).map_or(0.0, |[_, to]| to.y);
    let branches = (0..BRANCHES).flat_map(|i| (0..BRANCHES).map(move |j| (first(i), second(i, j))));
    let telling = |&(a, b): &(usize, usize)| (0.3..0.7).contains(&ends_at(a)) && ends_at(b) > 0.999;
    let (a, b) = branches
        .into_iter()
        .find(telling)
        .ok_or_else(|| DeskError::Missing("a path worth drawing".to_owned()))?;
    let path = [0, a, b];
    let strokes: Vec<Stroke> = path
        .iter()
        .zip([
            StrokeKind::Camera,
            StrokeKind::Reflected,
            StrokeKind::ToSurface,
        ])
        .filter_map(|(&number, kind)| stroke(kind, number))
        .map(|stroke| Stroke {
            arrow: true,
            ..stroke
        })
        .collect();
    let mut drawing = RayDrawing {
        dots: strokes.iter().map(|stroke| Dot { at: stroke.to }).collect(),
        ..flat::world(&room)
    };
    drawing.title = format!("The path: {} rays of it", strokes.len());
    drawing.strokes.extend(strokes);
    let caption = "One of the sixteen, one of its sixteen: what is left of the tree is a path.";
    desk.figure("path.svg", caption, drawing.to_svg_at(HALF)?)
}

/// The box by forty paths for each pixel, and the noise of one.
pub fn forty_paths(desk: &mut Desk, scene: &Scene) -> Result<u64, DeskError> {
    let max_depth = scene.suggested.max_depth;
    let found = picture(desk, scene, &NextEvent { max_depth }, desk.spp(40, 4), 0)?;
    let caption = "The box by forty paths for each pixel.";
    desk.picture("forty.png", caption, &found.film, scene)?;
    let deviation = |pixel: &Pixel| pixel.channels[1].variance().sqrt();
    let sigma = HeatMap {
        title: "Noise of one path".to_owned(),
        label: "standard deviation, W/(m² sr)".to_owned(),
        width: found.film.width(),
        values: found.film.pixels().iter().map(deviation).collect(),
        axis: Axis::Log,
    };
    let caption = "The standard deviation of one path, pixel by pixel, of the green channel: largest where \
                   the lamp is near, and where shadows are half.";
    desk.figure("sigma.svg", caption, sigma.to_svg_at(HALF)?)?;
    let each = found.rays.total() as f64 / found.rays.camera.max(1) as f64;
    desk.value(
        "forty_rays",
        "rays of one path in the box, lamp included",
        three(each),
    );
    Ok(found.rays.total())
}

/// The noise of many paths over the noise of one, from pictures that differ by chance alone; the
/// rays.
pub fn noise(desk: &mut Desk, pictures: u64) -> Result<u64, DeskError> {
    let side = desk.choose(40, 24);
    let scene = gallery::load("cornell")?.sized([side; 2]);
    let mut means = vec![Estimate::new(); (side * side / 2) as usize];
    let mut singles = vec![Estimate::new(); means.len()];
    let mut rays = 0;
    for number in 0..pictures {
        let found = picture(desk, &scene, &NextEvent { max_depth: 5 }, 40, 1 + number)?;
        for ((mean, single), pixel) in means
            .iter_mut()
            .zip(&mut singles)
            .zip(without_lamp(&found).pixels())
        {
            mean.add(pixel.channels[1].mean());
            single.add(pixel.channels[1].variance());
        }
        rays += found.rays.total();
    }
    let of =
        |list: &[Estimate], f: fn(&Estimate) -> f64| -> Estimate { list.iter().map(f).collect() };
    let (forty, one) = (of(&means, Estimate::variance), of(&singles, Estimate::mean));
    let square = forty.mean() / one.mean();
    // To first order the error of a ratio is that of the mean of what it leaves over.
    let rest: Estimate = means
        .iter()
        .zip(&singles)
        .map(|(m, s)| m.variance() - square * s.mean())
        .collect();
    let ratio = square.sqrt();
    let error = Some(0.5 * ratio * rest.std_error() / (square * one.mean()));
    let number = Number::new("noise of forty paths over noise of one", ratio);
    let exact = Some(1.0 / libm::sqrt(40.0));
    desk.number(
        "noise",
        Number {
            error,
            exact,
            ..number
        },
    );
    Ok(rays)
}

/// An edge through pixels, against the share of each that it covers; the rays.
pub fn edge(desk: &mut Desk) -> Result<u64, DeskError> {
    let source = Source {
        file: "edge.toml",
        text: include_str!("edge.toml"),
    };
    let scene = gallery::from_text(source, None, |_| {})?;
    let spp = 4096;
    let found = picture(desk, &scene, &Kajiya { max_depth: 1 }, spp, 0)?;
    let [width, height] = scene.size;
    let (mut worst, mut edges) = (0.0_f64, 0);
    for y in 0..height {
        for x in 0..width {
            let (read, exact) = (&found.film.pixel(x, y).channels[0], covered(x, y, width));
            if exact == 0.0 || exact == 1.0 {
                // All of it or nothing, without any noise.
                let far = (read.mean() - exact).abs() > 0.0;
                worst = if far { f64::INFINITY } else { worst };
                continue;
            }
            edges += 1;
            worst = worst.max(read.z(exact).abs());
            if (x, y) == (9, 2) {
                desk.estimate("edge_pixel", "a pixel on the edge", read, Some(exact));
            }
        }
    }
    desk.value("edge_pixels", "pixels on the edge", f64::from(edges));
    desk.value(
        "edge_worst",
        "the farthest of them, in standard errors",
        three(worst),
    );
    let caption =
        "An edge through pixels of 1/16 of the picture. A pixel is as bright as it is covered.";
    desk.picture("edge.png", caption, &found.film, &scene)?;
    Ok(found.rays.total())
}

/// The share of a pixel to the left of the edge `X = Y / 3`, where the picture spans -1 to 1.
fn covered(x: u32, y: u32, size: u32) -> f64 {
    let side = 2.0 / f64::from(size);
    let left = -1.0 + side * f64::from(x);
    // Where the edge crosses the pixel's row, in widths of the pixel: at its bottom and its top.
    let [bottom, top] = [y + 1, y].map(|row| ((1.0 - side * f64::from(row)) / 3.0 - left) / side);
    let integral = |t: f64| match t {
        t if t <= 0.0 => 0.0,
        t if t < 1.0 => 0.5 * t * t,
        t => t - 0.5,
    };
    (integral(top) - integral(bottom)) / (top - bottom)
}
