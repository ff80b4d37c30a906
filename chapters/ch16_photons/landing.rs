//! Where photons land: on a line, where they can be counted by hand, and on the floor under a ball of glass.

use super::scene;
use super::window::{LAMP, first_photons};
use halfdisk::flatland::{FlatWorld, gallery};
use halfdisk::integrators::Photons;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Bounds, Circle, Dot, HALF, Label, RayDrawing, Stroke, StrokeKind};
use halfdisk::lab::figures::flat;
use halfdisk::photons::Photon;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::Tracer;
use halfdisk::scene::read::Source;
use halfdisk::space::Flat;

/// A flat world of this chapter.
pub fn flat_world(file: &'static str, text: &str) -> Result<FlatWorld, DeskError> {
    Ok(gallery::from_text(Source { file, text })?)
}

pub fn work(desk: &mut Desk) -> Result<(), DeskError> {
    window(desk)?;
    ball(desk)
}

/// The flat lamp, some of its photons, and a window around P.
fn window(desk: &mut Desk) -> Result<(), DeskError> {
    let world = flat_world("lamp.toml", LAMP)?;
    let mut drawing = flat::world(&world);
    drawing.title = "Photons on a line".to_owned();
    drawing.bare = true;
    let (at, radius) = (0.35, 0.25);
    let photons = first_photons(&world, 120, desk.options.seed, 0);
    let shown = |photon: &&Photon<Flat>| photon.p.x.abs() < 1.6;
    let mut counted = 0;
    for photon in photons.iter().filter(shown) {
        let p = photon.p.as_dvec2();
        let inside = (p.x - at).abs() < radius;
        counted += u32::from(inside);
        let kind = match inside {
            true => StrokeKind::ToEmitter,
            false => StrokeKind::Axis,
        };
        drawing
            .strokes
            .push(Stroke::new(kind, [0.0, 1.0], p.to_array()));
        drawing.dots.push(Dot { at: p.to_array() });
    }
    for end in [at - radius, at + radius] {
        drawing
            .strokes
            .push(Stroke::new(StrokeKind::Normal, [end, -0.08], [end, 0.08]));
    }
    drawing.labels.push(Label {
        at: [at, -0.16],
        text: "P".to_owned(),
    });
    desk.value(
        "window_photons",
        "photons in the window of the drawing, of 120",
        f64::from(counted),
    );
    let caption = format!(
        "120 walks from a lamp over a floor, and a dot for each photon. Count those in the window around P, which is {} m \
         wide: {counted}. So about {counted}/120 of the lamp's power falls on {} m of floor around P.",
        2.0 * radius,
        2.0 * radius
    );
    desk.figure("window.svg", &caption, drawing.to_svg()?)
}

/// The floor under a ball of glass, from above: each dot is a photon.
fn ball(desk: &mut Desk) -> Result<(), DeskError> {
    let scene = scene("ball.toml", include_str!("ball.toml"))?;
    let by = Photons::new(6);
    let mut tracer = Tracer::new(&scene);
    let eye = scene.origin();
    let view = Bounds {
        min: [-1.9, -1.9],
        max: [1.9, 1.9],
    };
    for (file, caustic, caption) in [
        (
            "landed_direct.svg",
            false,
            "Photons straight from the lamp, on the floor under a ball of glass, seen from above. The circle is the ball. \
             Look for its shadow: it is empty.",
        ),
        (
            "landed_caustic.svg",
            true,
            "Photons of as many walks that came through the glass. Nearly all of them lie in one spot inside the shadow: there \
             the light is dense, so the photons are, too.",
        ),
    ] {
        let mut drawing = RayDrawing {
            title: if caustic { "LS+D" } else { "LD" }.to_owned(),
            view,
            ..RayDrawing::default()
        };
        drawing.circles.push(Circle {
            center: [0.0, 0.0],
            radius: 1.0,
            kind: StrokeKind::Wall,
        });
        for walk in 0..30_000_u32 {
            let stream = Stream::new(desk.options.seed, walk, 0);
            by.trace(&mut tracer, 0.0, &stream, &mut |photon| {
                let p = photon.p.as_dvec3() + eye;
                let first = (photon.segments > 1) == caustic;
                let seen = p.x.abs() < 1.9 && p.z.abs() < 1.9;
                // Those that have met the floor before are another word.
                if first && seen && photon.power.g > 0.0 && p.y.abs() < 1e-3 {
                    drawing.dots.push(Dot { at: [p.x, -p.z] });
                }
            });
        }
        let name = if caustic {
            "photons_caustic"
        } else {
            "photons_direct"
        };
        let says = format!("photons in the drawing of {}", drawing.title);
        desk.value(name, &says, drawing.dots.len() as f64);
        desk.figure(file, caption, drawing.to_svg_at(HALF)?)?;
    }
    Ok(())
}
