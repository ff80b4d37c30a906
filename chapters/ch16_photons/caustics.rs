//! Where light goes that mirrors and glass focus, in worlds so simple that geometry knows.

use super::landing::flat_world;
use glam::{DVec2, Vec2};
use halfdisk::color::Rgb;
use halfdisk::flatland::{FlatWorld, frame};
use halfdisk::integrators::Photons;
use halfdisk::integrators::world::{Emitted, FlatTracer};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Dot, HALF, Stroke, StrokeKind};
use halfdisk::lab::figures::flat;
use halfdisk::materials::fresnel;
use halfdisk::photons::Photon;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::space::{Flat, Ray};

const ELLIPSE: &str = "name = 'elliptic mirror'\nwindow = { min = [-2.15, -1.85], max = [2.15, 1.85] }\n\
    [[objects]]\nmirror = 1\nellipse = { center = [0, 0], axes = [2, 1.7320508] }\n\
    [[objects]]\nalbedo = 0\ncircle = { center = [1, 0], radius = 0.03 }\n\
    [[lamps]]\npoint = { position = [-1, 0], power = 1 }\n";

/// Eccentricity 1/n: half the height is the root of 1 - 1/n².
const LENS: &str = "name = 'glass ellipse'\nwindow = { min = [-1.9, -1.2], max = [1.35, 1.2] }\n\
    [[objects]]\nglass = 1.5\nellipse = { center = [0, 0], axes = [1, 0.745355992] }\n\
    [[objects]]\nalbedo = 0\nsegment = { from = [0.6666667, -0.002], to = [0.6666667, 0.002] }\n";

const ROUND: &str = "name = 'round mirror'\nwindow = { min = [-0.25, -1.08], max = [1.08, 1.08] }\n\
    [[objects]]\nmirror = 1\ncircle = { center = [0, 0], radius = 1 }\n";

/// The lamp is in the aplanatic point, 1/n from the middle of the ball.
const BALL: &str = "name = 'aplanatic point'\nwindow = { min = [-1.7, -1.9], max = [1.7, 1.75] }\n\
    [[objects]]\nglass = 1.5\ncircle = { center = [0, 0], radius = 1 }\n\
    [[objects]]\nalbedo = 0\nsegment = { from = [-9, -1.8], to = [9, -1.8] }\n\
    [[lamps]]\npoint = { position = [0, 0.6666667], power = 1 }\n";

const SLAB: &str = "name = 'slab'\n[[objects]]\nglass = 1.5\n\
    polyline = { points = [[0, 1], [0, 2], [9, 2], [9, 1]], closed = true }\n\
    [[objects]]\nalbedo = 0\nsegment = { from = [-1, 0], to = [10, 0] }\n";

/// The corners of a ray's way, along the branch of mirrors and glass that takes most light.
fn way(world: &FlatWorld, from: Vec2, direction: Vec2) -> Vec<DVec2> {
    let mut points = vec![from.as_dvec2()];
    let (mut from, mut direction) = (from, direction);
    for _ in 0..4 {
        let Some(hit) = world.first_hit(from, direction) else {
            points.push((from + direction * 9.0).as_dvec2());
            break;
        };
        points.push(hit.surface.p.as_dvec2());
        let Some(specular) = hit.specular else { break };
        let axes = frame(hit.front);
        let both = specular.specular(axes.transpose() * hit.wo);
        let weight = |branch: &halfdisk::materials::Branch| branch.weight.g;
        let most = match (both.reflected, both.transmitted) {
            (Some(back), Some(on)) if weight(&back) > weight(&on) => back,
            (_, Some(on)) => on,
            (Some(back), None) => back,
            (None, None) => break,
        };
        direction = (axes * Vec2::new(most.wi.x, most.wi.z)).normalize();
        from = hit.surface.leave(direction);
    }
    points
}

fn strokes(points: &[DVec2], kind: StrokeKind) -> Vec<Stroke> {
    let pairs = points.windows(2);
    pairs
        .map(|w| Stroke::new(kind, w[0].to_array(), w[1].to_array()))
        .collect()
}

/// Photons of a beam between two points, all of power 1.
fn beam(
    world: &FlatWorld,
    [from, to]: [Vec2; 2],
    direction: Vec2,
    desk: &Desk,
) -> (Vec<Photon<Flat>>, u32) {
    let walks = desk.choose(80_000, 40_000);
    let by = Photons::in_space::<Flat>(64);
    let mut tracer = FlatTracer::new(world);
    let mut found = Vec::new();
    for walk in 0..walks {
        let stream = Stream::new(desk.options.seed, walk, 1);
        let u = stream.at(0, Purpose::Emission).one();
        let ray = Ray::new(from + (to - from) * u, direction);
        let start = Emitted {
            ray,
            power: Rgb::WHITE,
            is_delta: true,
        };
        by.follow(&mut tracer, start, &stream, &mut |p| found.push(p));
    }
    (found, walks)
}

/// A share of walks, with its error and what it should be.
fn share(desk: &mut Desk, name: &str, says: &str, count: usize, walks: u32, exact: f64) {
    let n = f64::from(walks);
    let number = Number {
        error: Some((exact * (1.0 - exact) / n).sqrt()),
        ..Number::new(says, count as f64 / n).exact(exact)
    };
    desk.number(name, number);
}

pub fn work(desk: &mut Desk) -> Result<(), DeskError> {
    desk.say("\nlight that is focused");
    ellipse(desk)?;
    lens(desk)?;
    round(desk)?;
    ball(desk)?;
    let slab = flat_world("slab.toml", SLAB)?;
    let ends = [4.0, 5.0].map(|x| Vec2::new(x, 3.0));
    let (found, walks) = beam(&slab, ends, Vec2::NEG_Y, desk);
    let r = fresnel::dielectric(1.0, 1.5);
    let says = "light through a slab of glass, (1 - R) / (1 + R)";
    share(
        desk,
        "slab",
        says,
        found.len(),
        walks,
        (1.0 - r) / (1.0 + r),
    );
    Ok(())
}

fn ellipse(desk: &mut Desk) -> Result<(), DeskError> {
    let world = flat_world("ellipse.toml", ELLIPSE)?;
    let mut drawing = flat::world(&world);
    drawing.bare = true;
    for k in 0..36 {
        let angle = (10.0 * f64::from(k) + 5.0).to_radians();
        let (sin, cos) = libm::sincos(angle);
        let points = way(
            &world,
            Vec2::new(-1.0, 0.0),
            Vec2::new(cos as f32, sin as f32),
        );
        drawing
            .strokes
            .extend(strokes(&points, StrokeKind::ToSurface));
    }
    let mut found = Vec::new();
    let walks = desk.choose(60_000, 20_000);
    let by = Photons::in_space::<Flat>(4);
    let mut tracer = FlatTracer::new(&world);
    for walk in 0..walks {
        let stream = Stream::new(desk.options.seed, walk, 2);
        by.trace(&mut tracer, 0.0, &stream, &mut |photon| found.push(photon));
    }
    let once = found.iter().filter(|photon| photon.segments <= 2).count();
    let says = "light of one focus of an elliptic mirror that comes to the other by one reflection";
    desk.known("ellipse", says, once as f64 / f64::from(walks), 1.0);
    let caption = "A lamp in one focus of an elliptic mirror. Every ray comes to the other focus, whatever its direction.";
    desk.figure("ellipse.svg", caption, drawing.to_svg_at(HALF)?)
}

fn lens(desk: &mut Desk) -> Result<(), DeskError> {
    let world = flat_world("lens.toml", LENS)?;
    let mut drawing = flat::world(&world);
    drawing.bare = true;
    for k in -9..=9 {
        let from = Vec2::new(-1.9, 0.075 * k as f32);
        drawing
            .strokes
            .extend(strokes(&way(&world, from, Vec2::X), StrokeKind::ToSurface));
    }
    let height = (1.0_f64 - 1.0 / 2.25).sqrt();
    let top = 0.9 * height;
    let ends = [-top, top].map(|y| Vec2::new(-1.9, y as f32));
    let (found, walks) = beam(&world, ends, Vec2::X, desk);
    let enters = |k: i32| {
        let y = top * f64::from(k) / 1000.0;
        let x = -(1.0 - (y / height).powi(2)).sqrt();
        let n = DVec2::new(x, y / (height * height)).normalize();
        1.0 - fresnel::dielectric(-n.x, 1.5)
    };
    let expected = (-1000..=1000).map(enters).sum::<f64>() / 2001.0;
    let says = "light of a beam that comes to the far focus of a glass ellipse: all that enters";
    share(desk, "lens", says, found.len(), walks, expected);
    let caption = "Parallel rays into glass of index n, whose front is an ellipse of eccentricity 1/n. They meet in its far \
                   focus exactly; a round front would not do that.";
    desk.figure("lens.svg", caption, drawing.to_svg_at(HALF)?)
}

fn round(desk: &mut Desk) -> Result<(), DeskError> {
    let world = flat_world("round.toml", ROUND)?;
    let mut drawing = flat::world(&world);
    drawing.bare = true;
    for k in -18..=18 {
        let y = 0.05 * f64::from(k);
        let points = way(&world, Vec2::new(-0.25, y as f32), Vec2::X);
        drawing.strokes.extend(strokes(
            &points[..3.min(points.len())],
            StrokeKind::ToSurface,
        ));
    }
    let nephroid = |k: i32| {
        let a = std::f64::consts::FRAC_PI_2 * f64::from(k) / 60.0;
        let x = (3.0 * libm::cos(a) - libm::cos(3.0 * a)) / 4.0;
        DVec2::new(x, libm::pow(libm::sin(a), 3.0))
    };
    let curve: Vec<DVec2> = (-60..=60).map(nephroid).collect();
    drawing.strokes.extend(strokes(&curve, StrokeKind::Lamp));
    let caption = "Parallel rays in a round mirror, as in a cup of coffee. They touch a nephroid, the thick line; its tip is \
                   halfway between the mirror and its middle.";
    desk.figure("nephroid.svg", caption, drawing.to_svg_at(HALF)?)
}

fn ball(desk: &mut Desk) -> Result<(), DeskError> {
    let world = flat_world("ball.toml", BALL)?;
    let mut drawing = flat::world(&world);
    drawing.bare = true;
    let lamp = Vec2::new(0.0, 2.0 / 3.0);
    let image = DVec2::new(0.0, 1.5);
    let mut worst = 0.0_f64;
    for k in -9..=9 {
        let angle = -90.0 + 3.5 * f64::from(k);
        let (sin, cos) = libm::sincos(angle.to_radians());
        let points = way(&world, lamp, Vec2::new(cos as f32, sin as f32));
        drawing
            .strokes
            .extend(strokes(&points, StrokeKind::ToSurface));
        if let [_, leaves, lands, ..] = points[..] {
            drawing.strokes.push(Stroke::new(
                StrokeKind::Axis,
                image.to_array(),
                leaves.to_array(),
            ));
            let along = (lands - leaves).normalize();
            worst = worst.max(along.perp_dot(image - leaves).abs());
        }
    }
    drawing.dots.push(Dot {
        at: image.to_array(),
    });
    // Below this is rounding.
    let says = "rays that leave the ball pass its image by less than 1e-5";
    desk.known("aplanatic", says, f64::from(u8::from(worst < 1e-5)), 1.0);
    let caption = "A lamp in a ball of glass of radius 1, 1/n from its middle. Outside, all its rays seem to come from \
                   the dot, n from the middle: the image has no error of shape, and microscopes are built on it.";
    desk.figure("aplanatic.svg", caption, drawing.to_svg_at(HALF)?)
}
