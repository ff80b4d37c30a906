//! The idea of this chapter on paper, and one scene by four walks.

use crate::SEGMENTS;
use glam::DVec2;
use halfdisk::integrators::{Combine, Entry, Kajiya, NextEvent, Path, Settings};
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::lab::drawing::StrokeKind;
use halfdisk::lab::figures::sketch::Sketch;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::scene::{Scene, gallery};

/// A path in a room: where it aims, what it meets by chance, and where it may end.
pub fn idea(desk: &mut Desk) -> Result<(), DeskError> {
    let mut sketch = Sketch::new(
        "One path, three ways to add light",
        [-1.5, -0.4],
        [4.6, 2.9],
    );
    let at = DVec2::new;
    for corners in [
        [at(0.0, 2.4), at(4.0, 2.4)],
        [at(4.0, 2.4), at(4.0, 0.0)],
        [at(4.0, 0.0), at(0.0, 0.0)],
    ] {
        sketch.line(StrokeKind::Wall, corners[0], corners[1]);
    }
    sketch.line(StrokeKind::Lamp, at(1.3, 2.37), at(2.1, 2.37));
    // A block, in whose shadow the last surface is.
    let block = [
        at(2.55, 1.15),
        at(3.05, 1.15),
        at(3.05, 1.4),
        at(2.55, 1.4),
        at(2.55, 1.15),
    ];
    sketch.curve(StrokeKind::Wall, block);
    let eye = at(-1.2, 1.3);
    let [x1, x2, x3] = [at(0.7, 0.0), at(4.0, 0.95), at(2.3, 0.0)];
    sketch.arrow(StrokeKind::Camera, eye, x1);
    sketch.arrow(StrokeKind::Reflected, x1, x2);
    sketch.arrow(StrokeKind::Reflected, x2, x3);
    sketch.arrow(StrokeKind::Reflected, x3, at(1.75, 2.37));
    sketch.line(StrokeKind::Shadow, x1, at(1.5, 2.37));
    sketch.line(StrokeKind::Lost, x2, at(2.55 + 0.5, 1.31));
    sketch.line(StrokeKind::Shadow, x3, at(1.4, 2.37));
    [eye, x1, x2, x3].into_iter().for_each(|p| sketch.dot(p));
    for (place, word) in [
        (eye + at(0.0, 0.16), "eye"),
        (x1 - at(0.0, 0.2), "x₁"),
        (x2 + at(0.25, 0.0), "x₂"),
        (x3 - at(0.0, 0.2), "x₃"),
        (at(1.7, 2.6), "lamp"),
        (at(0.85, 1.3), "aimed"),
        (at(1.45, 1.15), "aimed"),
        (at(2.45, 1.75), "met by chance"),
        (at(3.4, 1.6), "in shadow"),
        (at(3.35, 0.22), "survived?"),
    ] {
        sketch.word(place, word);
    }
    desk.figure(
        "idea.svg",
        "A path of four segments. Each surface sends a shadow ray to one lamp; that of x₂ is stopped by the block. The last \
         segment meets the lamp by chance. It counts with its weight, as the shadow ray of x₃ does, because \
         either could have found that light. After each surface, roulette may end the path.",
        sketch.to_svg()?,
    )
}

/// The box with a mirror and a glass ball by four walks that take about as many rays: all their rays.
pub fn pictures(desk: &mut Desk) -> Result<u64, DeskError> {
    let side = desk.choose(96, 32);
    let scene = gallery::load("spheres")?.sized([side; 2]);
    let spp = desk.spp(10, 8);
    let by_path = picture(desk, &scene, Path::ENTRY, spp)?;
    let mut rays = by_path.rays.total();
    for (name, entry) in [
        ("chance", Kajiya::ENTRY),
        ("aiming", NextEvent::ENTRY),
        ("combine", Combine::ENTRY),
    ] {
        let first = picture(desk, &scene, entry, 1)?;
        let as_many = by_path.rays.total() as f64 / first.rays.total() as f64;
        let found = picture(desk, &scene, entry, as_many.round().max(1.0) as u32)?;
        rays += first.rays.total() + found.rays.total();
        show(desk, name, entry, &found, &scene)?;
    }
    show(desk, "path", Path::ENTRY, &by_path, &scene)?;
    Ok(rays)
}

/// A scene with everything that the path tracer was built for; the rays it took.
pub fn finale(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "final.png",
        title: "A still life in the light of one window, by the path tracer. Look at the window in the chrome, and its blur \
                in the gold; at the bright spot that the ball of glass throws on the cloth; at the red that the wall lends \
                the gold; and at the cloth, upside down in the glass.",
        spp: 32,
        stops: 0.0,
    };
    let scene = gallery::load("final")?;
    let path = Path::new(scene.suggested.max_depth);
    Ok(desk.finale(&scene, &path, &finale)?.rays.total())
}

fn show(
    desk: &mut Desk,
    name: &str,
    entry: Entry,
    found: &Rendered,
    scene: &Scene,
) -> Result<(), DeskError> {
    let pixels = f64::from(scene.size[0] * scene.size[1]);
    let spp = found.rays.camera as f64 / pixels;
    let rays = found.rays.total() as f64 / pixels;
    let caption = format!("{}: {spp:.0} samples, {rays:.0} rays a pixel.", entry.name);
    desk.picture(&format!("{name}.png"), &caption, &found.film, scene)
}

fn picture(desk: &Desk, scene: &Scene, entry: Entry, spp: u32) -> Result<Rendered, DeskError> {
    let by = entry.prepare(scene, &Settings::new(SEGMENTS))?;
    let options = Options {
        spp,
        seed: desk.options.seed,
        ..Options::default()
    };
    let rendered = render(scene, &by, &options, &desk.bar(entry.name));
    match rendered.interrupted {
        true => Err(DeskError::Interrupted),
        false => Ok(rendered),
    }
}
