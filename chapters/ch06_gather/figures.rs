//! The figures of this chapter: a room bounce by bounce, its bleeding walls, and how trees grow.

use glam::Vec3;
use halfdisk::geometry::Ray;
use halfdisk::integrators::Integrator;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::worlds::{Counted, Furnace};
use halfdisk::render::{Film, Pixel, Rendered};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer};
use halfdisk::space::{self, Solid};
use halfdisk::stats::Estimate;
use rayon::prelude::*;

/// Direct light, what one and two bounces add, and all of it.
pub fn pictures(desk: &mut Desk, scene: &Scene, films: &[Rendered]) -> Result<(), DeskError> {
    let [direct, one, two, all] = films else {
        return Err(DeskError::Missing("four pictures".to_owned()));
    };
    desk.picture(
        "direct.png",
        "Direct light: the ceiling is black.",
        &direct.film,
        scene,
    )?;
    let added = difference(&one.film, &direct.film);
    desk.picture(
        "one.png",
        "One bounce between walls adds the ceiling, and colour beside the coloured walls.",
        &added,
        scene,
    )?;
    let added = difference(&two.film, &one.film);
    desk.picture(
        "two.png",
        "A second bounce adds about half as much, and is softer.",
        &added,
        scene,
    )?;
    desk.picture("all.png", "Up to three bounces together.", &all.film, scene)?;
    for (k, pair) in films.windows(2).enumerate() {
        let ((less, error), (more, error_more)) = (pair[0].film.mean(), pair[1].film.mean());
        let says = format!("mean of the picture: what bounce {} adds", k + 1);
        let number = Number::new(&says, more - less);
        // The two share their samples, so this overstates the error of their difference.
        let error = Some((error * error + error_more * error_more).sqrt());
        desk.number(&format!("adds_{}", k + 1), Number { error, ..number });
    }
    let (mean, error) = direct.film.mean();
    let number = Number::new("mean of the picture: direct light and lamp", mean);
    let error = Some(error);
    desk.number("adds_0", Number { error, ..number });
    Ok(())
}

/// What the second picture lacks. Both are of the same random numbers, so this is the light of
/// the further bounce alone.
fn difference(more: &Film, less: &Film) -> Film {
    let pixels = more.pixels().iter().zip(less.pixels()).map(|(a, b)| {
        let channel = |i: usize| -> Estimate {
            std::iter::once(a.channels[i].mean() - b.channels[i].mean()).collect()
        };
        Pixel {
            channels: [0, 1, 2].map(channel),
            ..Pixel::default()
        }
    });
    Film::new(more.width(), pixels.collect())
}

/// Red over green along the back wall, from the red wall to the green one; the rays it took.
pub fn bleeding(desk: &mut Desk, scene: &Scene, walks: u32) -> Result<u64, DeskError> {
    let mut curves = Vec::new();
    let mut rays = 0;
    for (depth, name) in [
        (0, "direct light only"),
        (1, "one bounce"),
        (4, "four bounces"),
    ] {
        let walk = Gather {
            samples: 1,
            depth,
            recipe: Recipe::Cosine,
        };
        let mut points = Vec::new();
        for step in 0..12 {
            // Above the blocks, 430 high; the camera is at (278, 278, -800).
            let x = 15.0 + 525.0 * step as f32 / 11.0;
            let towards = Ray::new(Vec3::new(x - 278.0, 430.0 - 278.0, 1300.0), Vec3::Z);
            let (ratio, error, traced) =
                red_over_green(scene, &walk, &towards, walks, desk.options.seed);
            points.push((f64::from(555.0 - x), ratio, error));
            rays += traced;
        }
        if let (Some(red), Some(green)) = (points.first(), points.last()) {
            for (wall, &(_, ratio, error)) in [("red", red), ("green", green)] {
                let says = format!("red over green on the back wall by the {wall} wall: {name}");
                let number = Number {
                    error: Some(error),
                    ..Number::new(&says, ratio)
                };
                desk.number(&format!("bleeding_{wall}_{depth}"), number);
            }
        }
        curves.push(Curve::measured(name, Style::MarksAndLine, points));
    }
    let chart = CurveChart {
        title: "Red over green on the white back wall".to_owned(),
        x_label: "distance from the green wall, left in the pictures; the red one is at 555"
            .to_owned(),
        y_label: "red over green (bars: one standard error)".to_owned(),
        curves,
        ..CurveChart::default()
    };
    let caption = "Along the white back wall, from the green wall to the red one, as in the pictures. Direct light has the \
                   same colour everywhere; each bounce tinges the wall beside its coloured neighbour.";
    desk.figure("bleeding.svg", caption, chart.to_svg()?)?;
    Ok(rays)
}

fn red_over_green(
    scene: &Scene,
    walk: &Gather,
    ray: &Ray,
    walks: u32,
    seed: u64,
) -> (f64, f64, u64) {
    let samples: Vec<([f64; 2], u64)> = (0..walks)
        .into_par_iter()
        .map(|i| {
            let mut tracer = Tracer::new(scene);
            let li = Integrator::li(walk, &mut tracer, ray, &Stream::new(seed, i, 0));
            ([f64::from(li.r), f64::from(li.g)], tracer.counts().total())
        })
        .collect();
    let green: Estimate = samples.iter().map(|([_, g], _)| *g).collect();
    let red: Estimate = samples.iter().map(|([r, _], _)| *r).collect();
    let ratio = red.mean() / green.mean();
    // To first order the ratio's error is that of the mean of r - ratio g, over g.
    let residual: Estimate = samples.iter().map(|([r, g], _)| r - ratio * g).collect();
    let rays = samples.iter().map(|(_, rays)| rays).sum();
    (ratio, residual.std_error() / green.mean(), rays)
}

/// Rays of a tree against its depth: counted for some, then by the formula.
pub fn growth(desk: &mut Desk, seed: u64) -> Result<(), DeskError> {
    for (samples, depth) in [(16, 2), (16, 4), (4, 4)] {
        let gather = Gather {
            samples,
            depth,
            recipe: Recipe::Cosine,
        };
        let mut room = Counted {
            world: Furnace { albedo: 0.5 },
            rays: 0,
        };
        let eye = space::Ray::<Solid>::new(Vec3::ZERO, Vec3::Y);
        gather.li(&mut room, &eye, &Stream::new(seed, 0, 0));
        let says = format!("rays of a tree: {samples} directions, depth {depth}");
        let name = format!("rays_{samples}_{depth}");
        desk.known(&name, &says, room.rays as f64, gather.rays() as f64);
    }
    let tree = |samples: u32| {
        let rays = move |depth: u32| {
            Gather {
                samples,
                depth,
                recipe: Recipe::Cosine,
            }
            .rays() as f64
        };
        let points = (0..=6).map(move |depth| (f64::from(depth), rays(depth)));
        let plural = if samples == 1 { "" } else { "s" };
        let name = format!("{samples} direction{plural}");
        Curve::new(name, Style::MarksAndLine, points)
    };
    let chart = CurveChart {
        title: "Rays for one look at one pixel".to_owned(),
        x_label: "depth".to_owned(),
        y_label: "rays".to_owned(),
        x_axis: Axis::Linear,
        y_axis: Axis::Log,
        curves: vec![tree(64), tree(16), tree(4), tree(1)],
    };
    let caption = "Rays of one tree. With N directions at each surface the line rises by the factor N for each further \
                   bounce; with one direction it is a path.";
    desk.figure("chart.svg", caption, chart.to_svg()?)
}
