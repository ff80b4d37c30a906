//! The figures of this chapter: profiles against closed forms, the rays of a first hit, and the sky
//! alone.

use crate::profiles::{Profile, Reading};
use halfdisk::integrators::{Distributed, Integral};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Curve, CurveChart, HALF, Style};
use halfdisk::render::{Options, render};
use halfdisk::scene::description::{Material, Sky};
use halfdisk::scene::gallery;
use halfdisk::scene::value::{Albedo, Radiance};

/// What an integral is called in numbers and files.
pub fn name(integral: Integral) -> &'static str {
    match integral {
        Integral::Pixel => "pixel",
        Integral::Light => "light",
        Integral::Lens => "lens",
        Integral::Time => "time",
        Integral::Gloss => "gloss",
        Integral::Hemisphere => "hemisphere",
    }
}

/// What an integral changes in the picture, and where to look.
pub fn look(integral: Integral) -> &'static str {
    match integral {
        Integral::Pixel => "Pixel only: the jagged edges become smooth.",
        Integral::Light => "Light only: shadows get soft rims, wider the farther they fall.",
        Integral::Lens => "Lens only: things before and behind the focus blur.",
        Integral::Time => "Time only: what moves leaves a trail.",
        Integral::Gloss => "Gloss only: the rough mirror shows blurred images.",
        Integral::Hemisphere => "Hemisphere only: light from all around fills the shadows.",
    }
}

/// Four edges side by side, each in widths of its blur; then the sky by a wall and the lobes.
pub fn profiles(desk: &mut Desk, rows: &[(Profile, Vec<Reading>)]) -> Result<(), DeskError> {
    let (mut edges, mut others) = (Vec::new(), Vec::new());
    for (profile, row) in rows {
        let side_by_side = match profile.integral {
            Integral::Pixel => Some((0.0, 8.0)),
            Integral::Light => Some((2.6, 0.2)),
            Integral::Lens => Some((4.8, 1.5)),
            Integral::Time => Some((7.0, 1.5)),
            Integral::Gloss | Integral::Hemisphere => None,
        };
        let (shift, width) = side_by_side.unwrap_or((0.0, 1.0));
        let place = |r: &Reading| shift + r.x / width;
        let points = row.iter().map(|r| (place(r), r.read.mean(), r.error));
        let law = row.iter().map(|r| (place(r), r.exact));
        let label = match profile.integral {
            Integral::Gloss => "measured",
            Integral::Hemisphere => "measured",
            other => name(other),
        };
        let curves = if side_by_side.is_some() {
            &mut edges
        } else {
            &mut others
        };
        let colour = if side_by_side.is_some() {
            curves.len() / 2
        } else {
            0
        };
        curves.push(Curve::measured(label, Style::Marks, points).coloured(colour));
        let law_name = if side_by_side.is_some() {
            ""
        } else {
            "closed form"
        };
        curves.push(Curve::new(law_name, Style::Dashed, law).coloured(colour));
    }
    let chart = |title: &str, x_label: &str, y_label: &str, curves| CurveChart {
        title: title.to_owned(),
        x_label: x_label.to_owned(),
        y_label: y_label.to_owned(),
        curves,
        ..CurveChart::default()
    };
    let edges = chart(
        "Four edges, each blurred by one integral",
        "place in widths of the blur, side by side",
        "radiance",
        edges,
    );
    let caption = "Four rows of pixels across an edge: slanted, in penumbra, out of focus, in motion. Dots are measured; \
                   dashed, the closed forms they must follow.";
    desk.figure("edges.svg", caption, edges.to_svg()?)?;
    for (file, title, x_label, place, caption) in [
        (
            "lobe.svg",
            "What a rough mirror sends back",
            "roughness α",
            0,
            "Energy of the GGX lobe under a white sky: at α = 1 the share 1 - ln 2 is left, because facets \
             shadow each other.",
        ),
        (
            "wall.svg",
            "The sky beside a wall",
            "distance from the wall, in its heights",
            2,
            "At the foot of a wall without end half of the sky is left.",
        ),
    ] {
        let both = others.iter().skip(place).take(2).cloned().collect();
        let chart = chart(title, x_label, "share of a white sky", both);
        desk.figure(file, caption, chart.to_svg_at(HALF)?)?;
    }
    Ok(())
}

/// Rays of a sample up to the first surface, counted: a camera ray, a shadow ray, one ray more.
pub fn first_hits(desk: &mut Desk) -> Result<u64, DeskError> {
    let scene = gallery::load("six")?.sized([80, 60]);
    let sets = Integral::ALL.map(|i| (name(i), i.others()));
    let mut drawn = 0;
    for (name, fixed) in [("none", Integral::NONE)]
        .into_iter()
        .chain(sets)
        .chain([("all", &[][..])])
    {
        let options = Options {
            spp: 4,
            seed: desk.options.seed,
            fixed,
            ..Options::default()
        };
        let rays = render(&scene, &Distributed { max_depth: 2 }, &options, &()).rays;
        let says = format!("{name}: rays of a sample up to the first surface");
        let camera = rays.camera as f64;
        desk.value(
            &format!("first_{name}"),
            &says,
            rays.total() as f64 / camera,
        );
        let says = format!("{name}: camera and shadow rays of a sample up to the first surface");
        let asked = (rays.camera + rays.shadow) as f64 / camera;
        desk.value(&format!("asked_{name}"), &says, asked);
        drawn += rays.total();
    }
    Ok(drawn)
}

/// The scene in chalk under a white sky: what is dark is hidden from it.
pub fn occlusion(desk: &mut Desk) -> Result<u64, DeskError> {
    let scene = gallery::load_with("six", |said| {
        said.film.size = [160, 120];
        for material in said.materials.values_mut() {
            *material = Material::Lambert {
                albedo: Albedo([1.0; 3]).into(),
            };
        }
        said.objects.retain(|o| o.emits.is_none());
        if let Some(sky) = &mut said.environment {
            sky.light = Sky::Radiance(Radiance([1.0; 3]));
        }
    })?;
    let options = Options {
        spp: desk.spp(16, 2),
        seed: desk.options.seed,
        fixed: Integral::Hemisphere.others(),
        ..Options::default()
    };
    let rendered = render(
        &scene,
        &Distributed { max_depth: 2 },
        &options,
        &desk.bar("sky"),
    );
    let caption = "Ambient occlusion: the same scene in chalk under a white sky. Corners and the ground beside things are dark, \
                   because less of the sky is seen from there.";
    desk.picture("occlusion.png", caption, &rendered.film, &scene)?;
    Ok(rendered.rays.total())
}
