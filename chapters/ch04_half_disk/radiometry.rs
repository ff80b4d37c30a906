//! The drawings and numbers of the page "Light as a quantity", which stands before this chapter.

use glam::{DVec2, DVec3};
use halfdisk::integrators::Kajiya;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::StrokeKind;
use halfdisk::lab::estimators::furnace::irradiance;
use halfdisk::lab::estimators::worlds::{Furnace, ball, white};
use halfdisk::lab::figures::sketch::{Sketch, toward};
use halfdisk::sampling::stream::Stream;
use halfdisk::space::{Flat, Solid};
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::Largest;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// All four drawings.
pub fn drawings(desk: &mut Desk) -> Result<(), DeskError> {
    desk.figure(
        "cosine.svg",
        "Lambert's cosine law. The same seven rays meet a surface head-on, and one that is tilted by 50°. \
         There they cover 1.56 = 1/cos 50° times the length, so each piece receives less.",
        lambert().to_svg()?,
    )?;
    desk.figure(
        "angles.svg",
        "How much of the view something covers. Left: one radian is an arc of length 1 on the unit circle. \
         Right: one steradian is a patch of area 1 on the unit sphere, here a round one.",
        measures().to_svg()?,
    )?;
    desk.figure(
        "radiance.svg",
        "The same bulb from one metre and from two. From two it covers a quarter of the solid angle (half \
         the angle each way), but each ray that arrives carries what it carried before.",
        retreat().to_svg()?,
    )?;
    desk.figure(
        "brdf.svg",
        "A diffuse surface. Light arrives from a small cone around ωᵢ, at the angle θᵢ from the normal n; it \
         leaves with the same radiance in every direction ωₒ.",
        diffuse().to_svg()?,
    )
}

/// Rays head-on and at a slant.
fn lambert() -> Sketch {
    let mut drawing = Sketch::new("The same light on more surface", [-3.2, -1.35], [3.3, 2.1]);
    let tilt = 50_f64.to_radians();
    for (middle, tilt) in [(-1.7, 0.0), (1.5, tilt)] {
        let (middle, along) = (DVec2::new(middle, 0.0), toward(tilt));
        let rise = along.y / along.x;
        for i in -3..=3 {
            let x = 0.2 * f64::from(i);
            let foot = middle + DVec2::new(x, x * rise);
            let from = DVec2::new(foot.x, 2.0);
            drawing.arrow(StrokeKind::ToEmitter, from, foot);
        }
        let half = 0.6 / along.x;
        let (left, right) = (middle - along * half, middle + along * half);
        let wall = StrokeKind::Wall;
        drawing.line(wall, middle - along * 1.35, middle + along * 1.35);
        // How much of it is lit.
        let below = -along.perp() * 0.22;
        let tick = -along.perp() * 0.08;
        let blue = StrokeKind::Reflected;
        drawing.line(blue, left + below, right + below);
        for end in [left + below, right + below] {
            drawing.line(blue, end - tick, end + tick);
        }
        let name = if tilt == 0.0 { "A" } else { "A / cos θ" };
        let at = middle + below * if tilt == 0.0 { 2.2 } else { 3.4 };
        drawing.word(at, name);
        if tilt > 0.0 {
            let n = along.perp();
            drawing.arrow(StrokeKind::Normal, middle, middle + n * 1.2);
            let tip = middle + n * 1.35;
            drawing.word(tip, "n");
            drawing.arc(StrokeKind::Outline, middle, 0.75, FRAC_PI_2, tilt);
            let at = middle + toward(FRAC_PI_2 + 0.5 * tilt) * 0.92;
            drawing.word(at, "θ");
        }
    }
    drawing
}

/// One radian and one steradian.
fn measures() -> Sketch {
    let mut drawing = Sketch::new("A radian and a steradian", [-3.4, -1.5], [3.4, 1.25]);
    let (left, right) = (DVec2::new(-1.8, 0.0), DVec2::new(1.8, 0.0));
    for center in [left, right] {
        drawing.circle(StrokeKind::HalfDisk, center, 1.0);
        drawing.dot(center);
    }
    // The arc of one radian.
    let start = 0.35;
    drawing.arc(StrokeKind::Lamp, left, 1.0, start, 1.0);
    for angle in [start, start + 1.0] {
        drawing.line(StrokeKind::Axis, left, left + toward(angle));
    }
    let word = left + toward(start + 0.5) * 0.6;
    drawing.word(word, "1 rad");
    // The cap of one steradian: 2π (1 - cos θ) = 1. Seen from a little above.
    let cos = 1.0 - 1.0 / TAU;
    let sin = (1.0 - cos * cos).sqrt();
    let axis = DVec3::new(0.55, -0.6, 0.6).normalize();
    let across = axis.any_orthonormal_vector();
    let up = axis.cross(across);
    let seen = |p: DVec3| right + DVec2::new(p.x, 0.954 * p.z + 0.3 * p.y);
    let rim = |turn: f64| {
        let at = toward(turn);
        seen(axis * cos + (across * at.x + up * at.y) * sin)
    };
    let equator = |turn: f64| seen(toward(turn).extend(0.0));
    let turns = || (0..=72).map(|i| TAU * f64::from(i) / 72.0);
    drawing.curve(StrokeKind::HalfDisk, turns().map(equator));
    drawing.curve(StrokeKind::Lamp, turns().map(rim));
    for i in 0..4 {
        drawing.line(StrokeKind::Axis, right, rim(TAU * f64::from(i) / 4.0));
    }
    let word = seen(axis * 1.0);
    drawing.word(word, "1 sr");
    for (x, words) in [
        (left.x, "all around 2π rad, above a surface π"),
        (right.x, "all around 4π sr, above a surface 2π"),
    ] {
        drawing.word(DVec2::new(x, -1.3), words);
    }
    drawing
}

/// A bulb from one metre and from two.
fn retreat() -> Sketch {
    let mut drawing = Sketch::new("Step back from the bulb", [-0.8, -1.15], [5.5, 1.15]);
    for (y, distance, words) in [
        (0.6, 2.0, "one metre: solid angle Ω"),
        (-0.6, 4.0, "two metres: Ω/4"),
    ] {
        let (bulb, eye) = (DVec2::new(0.0, y), DVec2::new(distance, y));
        let radius = 0.4;
        drawing.circle(StrokeKind::Lamp, bulb, radius);
        let half = libm::asin(radius / distance);
        for sign in [-1.0, 1.0] {
            let far = eye + toward(PI + sign * half) * distance * libm::cos(half);
            drawing.line(StrokeKind::Camera, eye, far);
        }
        let edge = bulb + DVec2::new(radius, 0.0);
        drawing.arrow(StrokeKind::ToEmitter, edge, eye);
        drawing.arc(StrokeKind::Outline, eye, 0.8, PI - half, 2.0 * half);
        drawing.dot(eye);
        drawing.label(eye + DVec2::new(0.02, -0.1), words);
        drawing.word(DVec2::new(0.5 * distance + 0.2, y + 0.33), "L");
    }
    drawing
}

/// What a diffuse surface does with light from one direction.
fn diffuse() -> Sketch {
    let mut drawing = Sketch::new("What a BRDF says", [-2.6, -0.45], [2.6, 1.75]);
    let x = DVec2::ZERO;
    let wall = StrokeKind::Wall;
    drawing.line(wall, DVec2::new(-2.2, 0.0), DVec2::new(2.2, 0.0));
    let incoming = FRAC_PI_2 + 0.85;
    for off in [-0.07, 0.0, 0.07] {
        let from = toward(incoming + off) * 1.9;
        drawing.arrow(StrokeKind::ToEmitter, from, x);
    }
    for i in 1..=11 {
        let to = toward(PI * f64::from(i) / 12.0) * 0.72;
        drawing.line(StrokeKind::ToSurface, x, to);
    }
    drawing.arc(StrokeKind::ToSurface, x, 0.72, 0.0, PI);
    let out = FRAC_PI_2 - 0.65;
    drawing.arrow(StrokeKind::Reflected, x, toward(out) * 1.5);
    drawing.arrow(StrokeKind::Normal, x, DVec2::new(0.0, 1.4));
    drawing.arc(StrokeKind::Outline, x, 1.05, FRAC_PI_2, 0.85);
    for (at, word) in [
        (toward(incoming) * 2.05 + DVec2::new(-0.1, 0.0), "ωᵢ"),
        (toward(out) * 1.62, "ωₒ"),
        (DVec2::new(0.0, 1.55), "n"),
        (toward(FRAC_PI_2 + 0.42) * 1.2, "θᵢ"),
        (DVec2::new(0.0, -0.2), "x"),
    ] {
        drawing.word(at, word);
    }
    drawing
}

/// Irradiances under a white sky and under a bulb, and the radiance of a furnace; how far they are from
/// what they should be.
pub fn numbers(desk: &mut Desk) -> Largest {
    let (samples, seed) = (desk.choose(300_000, 100_000), desk.options.seed);
    let mut compared = Largest::default();
    let mut record = |name: &str, says: &str, read: &Estimate, exact: f64| {
        desk.estimate(name, says, read, Some(exact));
        compared.add(read.z(exact));
    };
    let flat = irradiance::<Flat, _>(white::<Flat>(), samples, seed);
    record(
        "sky_flat",
        "irradiance under a white sky, flat world",
        &flat,
        2.0,
    );
    let solid = irradiance::<Solid, _>(white::<Solid>(), samples, seed);
    record(
        "sky_solid",
        "irradiance under a white sky, space",
        &solid,
        PI,
    );
    for (name, sine) in [("one", 0.2_f32), ("two", 0.1)] {
        let read = irradiance::<Solid, _>(ball::<Solid>(sine, 0.0), 4 * samples, seed);
        let says =
            format!("irradiance from a bulb of radius 0.2 and radiance 1, {name} metre(s) away");
        let exact = PI * f64::from(sine) * f64::from(sine);
        record(&format!("bulb_{name}"), &says, &read, exact);
    }
    // A room that glows has no integral to get wrong: 1 + 1/2 + 1/4 + ...
    let (max_depth, eye) = (24, Furnace::eye::<Solid>());
    let li =
        Kajiya { max_depth }.walk(&mut Furnace { albedo: 0.5 }, &eye, &Stream::new(seed, 0, 0));
    desk.known(
        "furnace",
        "radiance in a furnace of albedo 1/2",
        li.r.into(),
        2.0,
    );
    compared
}
