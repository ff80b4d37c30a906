//! The flat world on paper: its walls and lamps, and the half disk over a point with its rays.
//!
//! Directions are parameters: whoever samples them also has them drawn.

use crate::flatland::{Ellipse, FlatSurface, FlatWorld, Shape};
use crate::lab::drawing::{Arc, Bounds, Circle, Dot, Label, RayDrawing, Stroke, StrokeKind};
use crate::numeric::sin_cos;
use glam::{DVec2, Mat2, Vec2};
use std::f64::consts::{FRAC_PI_2, PI};

/// Walls, lamps and circles of a world.
pub fn world(world: &FlatWorld) -> RayDrawing {
    let mut drawing = RayDrawing {
        title: world.name.clone(),
        view: Bounds {
            min: wide(world.window.min),
            max: wide(world.window.max),
        },
        ..RayDrawing::default()
    };
    for part in world.parts() {
        let shines = !world.objects()[part.object].emission.is_black();
        let kind = if shines {
            StrokeKind::Lamp
        } else {
            StrokeKind::Wall
        };
        match part.shape {
            Shape::Segment(segment) => {
                let [from, to] = segment.ends().map(wide);
                drawing.strokes.push(Stroke::new(kind, from, to));
            }
            Shape::Circle(circle) => drawing.circles.push(Circle {
                center: wide(circle.center),
                radius: f64::from(circle.radius),
                kind,
            }),
            Shape::Ellipse(ellipse) => drawing.strokes.extend(outline(&ellipse, kind)),
        }
    }
    let lamp = |at| Dot { at: wide(at) };
    drawing.lamps = world
        .point_lights
        .iter()
        .map(|l| lamp(l.position))
        .collect();
    drawing
}

/// An ellipse as a polygon, fine enough to look round.
fn outline(ellipse: &Ellipse, kind: StrokeKind) -> Vec<Stroke> {
    const SIDES: u32 = 96;
    let corner = |k: u32| {
        let surface = ellipse.surface_at(2.0 * PI * f64::from(k) / f64::from(SIDES));
        wide(surface.p)
    };
    let side = |k| Stroke::new(kind, corner(k), corner(k + 1));
    (0..SIDES).map(side).collect()
}

/// A world with the half disk over P, and the rays that leave P in the given directions of the
/// world, coloured by what they meet.
///
/// Rays below the surface are drawn as long as the half disk is wide: they ought not to be.
pub fn half_disk(flat: &FlatWorld, p: &FlatSurface, directions: &[Vec2]) -> RayDrawing {
    let radius = 0.16 * flat.window.size().min_element();
    let mut drawing = world(flat);
    for &direction in directions {
        drawing.strokes.push(ray(flat, p, direction, radius));
    }
    let (at, n) = (p.p.as_dvec2(), p.n.as_dvec2());
    add_half_disk(&mut drawing, at, n, radius);
    drawing.dots.push(Dot { at: at.to_array() });
    drawing.labels.push(Label {
        at: at.to_array(),
        text: "P".into(),
    });
    drawing
}

fn ray(flat: &FlatWorld, p: &FlatSurface, direction: Vec2, radius: f64) -> Stroke {
    let at = |length: f64| (p.p.as_dvec2() + direction.as_dvec2() * length).to_array();
    if direction.dot(p.n) < 0.0 {
        return Stroke::new(StrokeKind::Below, wide(p.p), at(radius));
    }
    let (kind, end) = match flat.first_hit(p.leave(direction), direction) {
        Some(hit) if !hit.emitted(-direction).is_black() => {
            (StrokeKind::ToEmitter, wide(hit.surface.p))
        }
        Some(hit) => (StrokeKind::ToSurface, wide(hit.surface.p)),
        // Twice as far as the view is wide and high is out of it from anywhere within.
        None => (
            StrokeKind::ToSky,
            at(2.0 * flat.window.size().element_sum()),
        ),
    };
    Stroke::new(kind, wide(p.p), end)
}

/// A way to turn the half disk to a normal, and its name on the drawing.
#[derive(Clone, Copy, Debug)]
pub struct Turn {
    /// Its name.
    pub name: &'static str,
    /// The matrix for a unit normal.
    pub matrix: fn(Vec2) -> Mat2,
}

/// Half disks over twelve normals, 30° apart and clockwise from upright, for each of some ways to
/// turn them; each with the share of its rays that goes below the surface.
///
/// * `local` are directions in local coordinates, where `y` is the normal.
pub fn tilted(title: &str, turns: &[Turn], local: &[Vec2]) -> RayDrawing {
    const COLUMNS: usize = 6;
    /// Between the centres of unit half disks, and room for a headline.
    const CELL: DVec2 = DVec2::new(2.9, 3.1);
    const HEADLINE: f64 = 0.7;
    let mut drawing = RayDrawing {
        title: title.to_owned(),
        ..RayDrawing::default()
    };
    let mut top = 0.0;
    for turn in turns {
        top -= HEADLINE;
        drawing.captions.push(Label {
            at: [0.5 * CELL.x * COLUMNS as f64, top + 0.5 * HEADLINE],
            text: format!("{}: share of rays below the surface", turn.name),
        });
        for i in 0..12 {
            let (column, row) = (i % COLUMNS, i / COLUMNS);
            // A little above the middle of its cell: below it stands its share.
            let cell = DVec2::new(column as f64 + 0.5, -(row as f64) - 0.44);
            add_tilted(&mut drawing, DVec2::Y * top + cell * CELL, i, turn, local);
        }
        top -= 12_usize.div_ceil(COLUMNS) as f64 * CELL.y;
    }
    drawing.view = Bounds {
        min: [0.0, top],
        max: [CELL.x * COLUMNS as f64, 0.0],
    };
    drawing
}

/// The half disk number `i` of twelve.
fn add_tilted(drawing: &mut RayDrawing, at: DVec2, i: usize, turn: &Turn, local: &[Vec2]) {
    let (sin, cos) = sin_cos(std::f32::consts::PI * i as f32 / 6.0);
    let n = Vec2::new(sin, cos);
    let matrix = (turn.matrix)(n);
    let mut below = 0;
    for &w in local {
        let w = matrix * w;
        let kind = if w.dot(n) < 0.0 {
            below += 1;
            StrokeKind::Below
        } else {
            StrokeKind::Above
        };
        let end = (at + w.as_dvec2()).to_array();
        drawing.strokes.push(Stroke::new(kind, at.to_array(), end));
    }
    add_half_disk(drawing, at, n.as_dvec2(), 1.0);
    let percent = 100.0 * below as f64 / local.len().max(1) as f64;
    drawing.captions.push(Label {
        at: (at - DVec2::Y * 1.45).to_array(),
        text: format!("{}°: {percent:.0} %", 30 * i),
    });
}

/// The rim, the diameter and the normal of the half disk over a point.
fn add_half_disk(drawing: &mut RayDrawing, at: DVec2, n: DVec2, radius: f64) {
    let tangent = n.perp() * radius;
    let ends = [at - tangent, at + tangent].map(|end| end.to_array());
    let diameter = Stroke::new(StrokeKind::HalfDisk, ends[0], ends[1]);
    let tip = (at + n * (1.25 * radius)).to_array();
    let normal = Stroke::arrow(StrokeKind::Normal, at.to_array(), tip);
    drawing.strokes.extend([diameter, normal]);
    drawing.arcs.push(Arc {
        center: at.to_array(),
        radius,
        start: libm::atan2(n.y, n.x) - FRAC_PI_2,
        turn: PI,
        kind: StrokeKind::HalfDisk,
    });
}

fn wide(v: Vec2) -> [f64; 2] {
    v.as_dvec2().to_array()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flatland::{self, frame};

    /// Evenly spread over the half circle.
    fn local(rays: usize) -> Vec<Vec2> {
        let angle = |i: usize| std::f32::consts::PI * (i as f32 + 0.5) / rays as f32;
        let direction = |i| {
            let (sin, cos) = sin_cos(angle(i));
            Vec2::new(cos, sin)
        };
        (0..rays).map(direction).collect()
    }

    fn count(drawing: &RayDrawing, kind: StrokeKind) -> usize {
        drawing.strokes.iter().filter(|s| s.kind == kind).count()
    }

    #[test]
    fn rays_are_coloured_by_what_they_meet() {
        let lamp = flatland::load("lamp").unwrap();
        let p = lamp.probe.unwrap().surface;
        let drawing = half_disk(&lamp, &p, &local(180));
        // The lamp spans 2 atan(1/2) = 53.13°, the rest is sky.
        assert_eq!(count(&drawing, StrokeKind::ToEmitter), 54);
        assert_eq!(count(&drawing, StrokeKind::ToSky), 126);
        let room = flatland::load("room").unwrap();
        let p = room.probe.unwrap().surface;
        let drawing = half_disk(&room, &p, &local(180));
        assert_eq!(count(&drawing, StrokeKind::ToSky), 0);
        assert_eq!(count(&drawing, StrokeKind::ToSurface), 126);
        assert_eq!((drawing.arcs.len(), drawing.dots.len()), (1, 1));
    }

    #[test]
    fn the_transpose_sends_rays_below() {
        let turns = [
            Turn {
                name: "right",
                matrix: frame,
            },
            Turn {
                name: "transposed",
                matrix: |n| frame(n).transpose(),
            },
        ];
        let one = |turn| tilted("", &[turn], &local(24));
        assert_eq!(count(&one(turns[0]), StrokeKind::Below), 0);
        // Shares of 24 rays: 0, 1/3, 2/3, 1, 2/3, 1/3, and once more.
        assert_eq!(count(&one(turns[1]), StrokeKind::Below), 2 * 24 * 3);
        let both = tilted("both", &turns, &local(24));
        assert_eq!(both.arcs.len(), 24);
        assert!(both.captions.iter().any(|l| l.text == "30°: 33 %"));
    }
}
