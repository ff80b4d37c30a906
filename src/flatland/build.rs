//! From a description to a flat world: what is wrong is told with its place in the description.

use super::description::{self as said, Description};
use super::{
    AreaLight, Circle, Ellipse, FlatHit, FlatSpecular, FlatWorld, Object, Part, PointLight,
    Segment, Shape, Window,
};
use crate::color::Rgb;
use crate::scene::field::{Checked, Problem, Within, check, named};
use crate::scene::value::{Emission, Pair, Radiance};
use glam::{DVec2, Vec2};

/// Checks a description and builds its world.
pub fn build(said: &Description) -> Checked<FlatWorld> {
    let background = said.background.map_or(Ok(Rgb::BLACK), Radiance::get)?;
    let mut world = FlatWorld {
        name: said.name.clone(),
        about: said.about.clone(),
        background,
        point_lights: Vec::new(),
        probe: None,
        window: Window::around([]),
        objects: Vec::new(),
        parts: Vec::new(),
        glowing: Vec::new(),
    };
    for material in said.materials.values() {
        // Also the ones that nobody uses.
        material.albedo.get().within("materials")?;
    }
    for (i, &said::Lamp::Point { position, power }) in said.lamps.iter().enumerate() {
        let lamp = point(position, power).within(i).within("lamps")?;
        world.point_lights.push(lamp);
    }
    for (i, said_object) in said.objects.iter().enumerate() {
        let (object, shapes) = object(said, said_object).within(i).within("objects")?;
        let part = |shape| Part { shape, object: i };
        world.objects.push(object);
        world.parts.extend(shapes.into_iter().map(part));
    }
    world.glowing = glowing(&world);
    if let Some(said) = &said.probe {
        world.probe = Some(probe(said, &world).within("probe")?);
    }
    world.window = match &said.window {
        Some(said) => window(said).within("window")?,
        None => everything(&world),
    };
    Ok(world)
}

fn glowing(world: &FlatWorld) -> Vec<AreaLight> {
    let glow = |(number, part): (usize, &Part)| {
        let radiance = world.objects[part.object].emission;
        (!radiance.is_black()).then_some(AreaLight {
            shape: part.shape,
            radiance,
            part: number,
        })
    };
    world.parts.iter().enumerate().filter_map(glow).collect()
}

fn point(position: Pair, power: Emission) -> Checked<PointLight> {
    Ok(PointLight {
        position: position.get()?.as_vec2(),
        power: power.get()?,
    })
}

fn object(all: &Description, said: &said::Object) -> Checked<(Object, Vec<Shape>)> {
    let albedo = match (&said.material, said.albedo) {
        (Some(_), Some(_)) => {
            return Problem::of("has both `material` and `albedo`, but takes only one of them");
        }
        (Some(name), None) => Some(named(&all.materials, name).within("material")?.albedo),
        (None, albedo) => albedo,
    };
    let specular = match (said.mirror, said.glass) {
        (None, None) => None,
        (Some(reflectance), None) => Some(FlatSpecular::Mirror {
            reflectance: reflectance.get().within("mirror")?,
        }),
        (None, Some(ior)) => Some(FlatSpecular::Glass {
            ior: ior.get().within("glass")?,
        }),
        (Some(_), Some(_)) => {
            return Problem::of("has both `mirror` and `glass`, but takes only one of them");
        }
    };
    let two = specular.is_some() && albedo.is_some();
    check(!two, "is a `mirror` or `glass`, and has no albedo besides")?;
    let seen = albedo.is_some() || specular.is_some() || said.emits.is_some();
    let what = "needs an `albedo`, a `material`, a `mirror`, `glass`, or `emits`";
    check(seen, what)?;
    let ellipse = matches!(said.shape, said::Shape::Ellipse { .. });
    let what = "is an ellipse, and `emits`: of round shapes only a `circle` shines";
    check(!(ellipse && said.emits.is_some()), what)?;
    let object = Object {
        specular,
        albedo: albedo.map_or(Ok(Rgb::BLACK), |albedo| albedo.get())?,
        emission: said.emits.map_or(Ok(Rgb::BLACK), Emission::get)?,
    };
    Ok((object, shapes(&said.shape)?))
}

fn shapes(said: &said::Shape) -> Checked<Vec<Shape>> {
    match said {
        said::Shape::Segment { from, to } => {
            let wall = segment("`from`", from.get()?, to.get()?);
            Ok(vec![wall.within("to").within("segment")?])
        }
        said::Shape::Circle { center, radius } => Ok(vec![Shape::Circle(Circle {
            center: center.get()?.as_vec2(),
            radius: radius.get()? as f32,
        })]),
        said::Shape::Ellipse { center, axes } => {
            let half = axes.get()?.as_vec2();
            let what = "must be two numbers above 0";
            check(half.cmpgt(Vec2::ZERO).all(), what).within("axes")?;
            Ok(vec![Shape::Ellipse(Ellipse {
                center: center.get()?.as_vec2(),
                axes: half,
            })])
        }
        said::Shape::Polyline { points, closed } => polyline(points, *closed)
            .within("points")
            .within("polyline"),
    }
}

fn polyline(points: &[Pair], closed: bool) -> Checked<Vec<Shape>> {
    let least = if closed { 3 } else { 2 };
    let given = points.len();
    let what = format_args!("must be {least} points or more, not {given}");
    check(given >= least, what)?;
    let points: Vec<DVec2> = points.iter().map(|p| p.get()).collect::<Checked<_>>()?;
    let mut shapes = Vec::with_capacity(points.len());
    for (i, ends) in points.windows(2).enumerate() {
        shapes.push(segment("the one before", ends[0], ends[1]).within(i + 1)?);
    }
    if let (true, [first, .., last]) = (closed, points.as_slice()) {
        let other = "the first: `closed` leads back there";
        shapes.push(segment(other, *last, *first).within(points.len() - 1)?);
    }
    Ok(shapes)
}

fn segment(other: &str, from: DVec2, to: DVec2) -> Checked<Shape> {
    let what = format!("must be another point than {other}");
    let segment = Segment::new(from, to).ok_or(Problem::new(what))?;
    Ok(Shape::Segment(segment))
}

/// The point P, on the surface that passes `probe.at` up to its decimals.
fn probe(said: &said::Probe, world: &FlatWorld) -> Checked<FlatHit> {
    /// Decimals are trusted to this share of the largest coordinate.
    const NEAR: f64 = 1e-5;
    let p = said.at.get()?;
    let n = said.normal.get()?.try_normalize();
    let what = "must not be [0, 0]: it is a direction";
    let n = n.ok_or(Problem::new(what).within("normal"))?;
    // From just above the point down to just below it.
    let near = NEAR * f64::from(world.reach()).max(p.abs().max_element());
    let hit = world
        .first_hit((p + n * near).as_vec2(), -n.as_vec2())
        .filter(|hit| f64::from(hit.t) <= 2.0 * near);
    let what = "must lie on the surface of an object";
    let hit = hit.ok_or(Problem::new(what).within("at"))?;
    let upright = n.perp_dot(hit.surface.n.as_dvec2()).abs() <= 1e-3;
    let what = "must be at right angles to the surface at `probe.at`";
    check(upright, what).within("normal")?;
    Ok(hit.seen_from(n.as_vec2()))
}

fn window(said: &said::Window) -> Checked<Window> {
    let (min, max) = (said.min.get()?.as_vec2(), said.max.get()?.as_vec2());
    let what = "must be above and to the right of `window.min`";
    check(min.cmplt(max).all(), what).within("max")?;
    Ok(Window { min, max })
}

fn everything(world: &FlatWorld) -> Window {
    let shapes = world.parts.iter().flat_map(|part| part.shape.bounds());
    let lamps = world.point_lights.iter().map(|lamp| lamp.position);
    let probe = world.probe.iter().map(|probe| probe.surface.p);
    Window::around(shapes.chain(lamps).chain(probe))
}
