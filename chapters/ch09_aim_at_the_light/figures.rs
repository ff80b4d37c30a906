//! The figures of this chapter: the sweep over lamps, a walk with its shadow rays, and boxes.

use crate::shrinking_lamp::{self, Technique};
use glam::Vec2;
use halfdisk::flatland;
use halfdisk::integrators::world::Lights;
use halfdisk::integrators::{Integrator, Kajiya, NextEvent};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::figures::walk::Watched;
use halfdisk::render::{Film, Options, Rendered, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::description::Shape;
use halfdisk::scene::value::{Emission, Triple};
use halfdisk::scene::{Scene, gallery};
use halfdisk::space::{Flat, Ray};
use halfdisk::stats::slope::Line;
use halfdisk::stats::z_test::{FOUR, Largest, z_test};

/// Half-angles of the lamp, in radians: the last three decide the slope.
const ANGLES: [f64; 7] = [1.4, 1.0, 0.3, 0.1, 0.03, 0.01, 0.003];

/// Techniques, and what they are called in numbers and in the chart.
const TECHNIQUES: [(Technique, &str, &str); 3] = [
    (Technique::Uniform, "uniform", "by chance, uniform"),
    (Technique::Cosine, "cosine", "by chance, cosine"),
    (Technique::Aim, "aim", "aimed at"),
];

/// The variance of each technique against the lamp, in both worlds: how far the means are from their
/// truths, and the rays.
pub fn sweep(desk: &mut Desk, finds: f64) -> Result<(Largest, u64), DeskError> {
    let (mut compared, mut rays) = (Largest::default(), 0);
    let mut curves = Vec::new();
    for (place, (technique, name, label)) in TECHNIQUES.into_iter().enumerate() {
        let mut points = Vec::new();
        for a in ANGLES {
            let (count, seed) = ((finds / technique.finds_flat(a)) as u32, desk.options.seed);
            let found = shrinking_lamp::flat(technique, a, count, seed)?;
            let truth = libm::sin(a);
            compared.add(z_test(&found.estimate, truth, FOUR).z);
            rays += found.rays;
            let (value, error) = found.relative_variance(truth);
            points.push((a, value, error));
            let says = format!("half-angle {a}, {label}: variance over mean²");
            let number = Number::new(&says, value).exact(technique.exact_flat(a));
            let error = Some(error);
            let key = format!("{name}_{}", digits(a));
            desk.number(&key, Number { error, ..number });
            if a == 0.1 {
                let key = format!("rays_{name}");
                desk.value(&key, "  rays of one walk", found.rays_each());
            }
        }
        if technique != Technique::Aim {
            slope(desk, technique, [name, label], &points[4..]);
        }
        curves.push(Curve::measured(label, Style::Marks, points).coloured(place));
        let law =
            (0..=80).map(|i| ANGLES[6] * libm::pow(ANGLES[0] / ANGLES[6], f64::from(i) / 80.0));
        let law = law.map(|a| (a, technique.exact_flat(a)));
        curves.push(Curve::new("", Style::Line, law).coloured(place));
    }
    let line = [0.003, 0.3].map(|a| (a, std::f64::consts::FRAC_PI_2 / a));
    curves.push(Curve::new("π / 2a", Style::Dashed, line).coloured(3));
    let chart = CurveChart {
        title: "What it takes to find a lamp".to_owned(),
        x_label: "half-angle a of the lamp, in radians".to_owned(),
        y_label: "variance of one walk over mean²".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves,
    };
    let caption = "Found by chance, a lamp costs the more the smaller it is; aimed at, the less. Marks are \
                   measured, lines are the closed forms.";
    desk.figure("chart.svg", caption, chart.to_svg()?)?;
    for a in [0.3, 0.1] {
        for (technique, name, label) in TECHNIQUES {
            let found = shrinking_lamp::solid(technique, a, finds as u32 * 4, desk.options.seed)?;
            let truth = libm::sin(a) * libm::sin(a);
            compared.add(z_test(&found.estimate, truth, FOUR).z);
            rays += found.rays;
            let (value, error) = found.relative_variance(truth);
            let says = format!("in space, half-angle {a}, {label}");
            let number = Number::new(&says, value).exact(technique.exact_solid(a));
            let error = Some(error);
            let key = format!("solid_{name}_{}", digits(a));
            desk.number(&key, Number { error, ..number });
        }
    }
    Ok((compared, rays))
}

/// The slope through the smallest lamps, beside that of the closed form through the same ones.
fn slope(
    desk: &mut Desk,
    technique: Technique,
    [name, label]: [&str; 2],
    points: &[(f64, f64, f64)],
) {
    let measured: Vec<(f64, f64)> = points.iter().map(|&(a, y, _)| (a, y)).collect();
    let law: Vec<(f64, f64)> = points
        .iter()
        .map(|&(a, ..)| (a, technique.exact_flat(a)))
        .collect();
    if let (Some(line), Some(law), [first, .., last]) =
        (Line::through(&measured), Line::through(&law), points)
    {
        // The outer points decide: the middle one lies, on these axes, in their middle.
        let error = (first.2 / first.1).hypot(last.2 / last.1) / libm::log(first.0 / last.0);
        let number = Number::new(&format!("slope, {label}"), line.slope).exact(law.slope);
        let error = Some(error);
        desk.number(&format!("slope_{name}"), Number { error, ..number });
    }
}

/// A name for an angle: its digits behind the point.
fn digits(a: f64) -> String {
    a.to_string().replace('.', "")
}

/// A walk of the yard with the lines it drew to lamps.
pub fn shadow_rays(desk: &mut Desk) -> Result<(), DeskError> {
    let yard = flatland::load("yard")?;
    let eye = Ray::<Flat>::new(Vec2::new(3.4, 2.6), Vec2::new(0.55, -0.84).normalize());
    let walk = NextEvent { max_depth: 4 };
    let walks = (0..1000).map(|i| {
        let mut watched = Watched::new(&yard, Lights::All);
        walk.walk(&mut watched, &eye, &Stream::new(desk.options.seed, i, 0));
        watched
    });
    // The first that stays in the yard and looks for a lamp in vain.
    let telling = |w: &Watched| w.rays.len() == 4 && w.lost() > 0;
    let watched = walks
        .into_iter()
        .find(telling)
        .ok_or_else(|| DeskError::Missing("a walk worth drawing".to_owned()))?;
    let mut drawing = watched.drawing();
    drawing.title = "A walk that asks every lamp on its way".to_owned();
    let caption = "Lines to the lamps leave each surface; grey ones find something in their way. \
                   The walk goes on whether or not they arrive.";
    desk.figure("shadow.svg", caption, drawing.to_svg()?)
}

/// The box with its lamp at three sizes and the same power, with and without aiming: the rays.
pub fn boxes(desk: &mut Desk) -> Result<u64, DeskError> {
    let mut rays = 0;
    for (size, scale) in [(1, 1.0), (2, 0.25), (3, 0.0625)] {
        let scene = gallery::load_with("cornell", |said| {
            said.film.size = [96; 2];
            for lamp in said.objects.iter_mut().filter(|o| o.emits.is_some()) {
                let (u, v) = (130.0 * scale, 105.0 * scale);
                lamp.shape = Shape::Quad {
                    corner: Triple([278.0 - 0.5 * u, 554.0, 279.5 - 0.5 * v]),
                    u: Triple([u, 0.0, 0.0]),
                    v: Triple([0.0, 0.0, v]),
                };
                lamp.emits = Some(Emission([15.0 / (scale * scale); 3]).into());
            }
        })?;
        let max_depth = 5;
        let chance = picture(desk, &scene, &Kajiya { max_depth }, 32, 4)?;
        let aimed = picture(desk, &scene, &NextEvent { max_depth }, 32, 4)?;
        let sides = format!("{} wide", 130.0 * scale);
        for (name, way, found) in [
            ("chance", "by chance", &chance),
            ("aim", "aimed at", &aimed),
        ] {
            let caption = format!("A lamp {sides}, {way}.");
            desk.picture(&format!("{name}_{size}.png"), &caption, &found.film, &scene)?;
            let says = format!("lamp {sides}, {way}: variance below the horizon");
            desk.value(
                &format!("box_{name}_{size}"),
                &says,
                three(lower(&found.film)),
            );
            rays += found.rays.total();
        }
        let each = |found: &Rendered| found.rays.total() as f64 / found.rays.camera.max(1) as f64;
        desk.value(
            &format!("box_rays_chance_{size}"),
            "  rays by chance",
            three(each(&chance)),
        );
        desk.value(
            &format!("box_rays_aim_{size}"),
            "  rays with aiming",
            three(each(&aimed)),
        );
    }
    Ok(rays)
}

/// The variance in the lower half of a picture, in which no lamp is to be seen.
fn lower(film: &Film) -> f64 {
    let height = film.height();
    film.rows(height / 2..height).sample_variance()
}

/// A picture by an integrator.
pub fn picture(
    desk: &Desk,
    scene: &Scene,
    integrator: &impl Integrator,
    full: u32,
    quick: u32,
) -> Result<Rendered, DeskError> {
    let options = Options {
        spp: desk.spp(full, quick),
        seed: desk.options.seed,
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &desk.bar("render"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}

/// Three digits: enough for a number that comes without an error.
pub fn three(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}
