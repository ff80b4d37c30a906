//! From a description to a flat world: every value is checked here, and named where it is wrong.

use super::description::{self as said, Description, Pair};
use super::{Circle, FlatHit, FlatWorld, Glowing, Lamp, Object, Part, Segment, Shape, Window};
use crate::color::Rgb;
use crate::scene::description::Exactly;
use crate::scene::field::{self, Checked, Field, exactly_one};
use glam::DVec2;

/// Checks a description and builds its world.
pub fn build(said: &Description) -> Checked<FlatWorld> {
    let top = Field::top();
    let background = match said.background {
        Some(color) => field::light_or_none(&top.key("background"), color)?,
        None => Rgb::BLACK,
    };
    let mut world = FlatWorld {
        name: said.name.clone(),
        about: said.about.clone(),
        background,
        lamps: Vec::new(),
        probe: None,
        window: Window::around([]),
        objects: Vec::new(),
        parts: Vec::new(),
        glowing: Vec::new(),
    };
    for (name, material) in &said.materials {
        // Also the ones that nobody uses.
        albedo(&top.key("materials").key(name), material)?;
    }
    for (i, said_lamp) in said.lamps.iter().enumerate() {
        world
            .lamps
            .push(lamp(&top.key("lamps").item(i), said_lamp)?);
    }
    for (i, said_object) in said.objects.iter().enumerate() {
        let field = top.key("objects").item(i);
        world.objects.push(object(&field, said, said_object)?);
        let part = |shape| Part { shape, object: i };
        let shapes = shapes(&field, said_object)?;
        world.parts.extend(shapes.into_iter().map(part));
    }
    world.glowing = glowing(&world);
    if let Some(said_probe) = &said.probe {
        world.probe = Some(probe(&top.key("probe"), said_probe, &world)?);
    }
    world.window = match &said.window {
        Some(said_window) => window(&top.key("window"), said_window)?,
        None => everything(&world),
    };
    Ok(world)
}

fn glowing(world: &FlatWorld) -> Vec<Glowing> {
    let glow = |(number, part): (usize, &Part)| {
        let radiance = world.objects[part.object].emission;
        (!radiance.is_black()).then_some(Glowing {
            shape: part.shape,
            radiance,
            part: number,
        })
    };
    world.parts.iter().enumerate().filter_map(glow).collect()
}

fn albedo(field: &Field, said: &said::Material) -> Checked<Rgb> {
    field::reflectance(&field.key("albedo"), said.albedo)
}

fn lamp(field: &Field, said: &said::Lamp) -> Checked<Lamp> {
    let point = said.point.as_ref().map(|l| {
        let field = field.key("point");
        Ok(Lamp {
            position: pair(&field.key("position"), l.position)?.as_vec2(),
            power: field::light(&field.key("power"), l.power)?,
        })
    });
    exactly_one(field, "kind of lamp", vec![("point", point)])?
}

fn object(field: &Field, all: &Description, said: &said::Object) -> Checked<Object> {
    let albedo = match (&said.material, said.albedo) {
        (Some(_), Some(_)) => {
            return Err(
                field.problem("has both `material` and `albedo`, but takes only one of them")
            );
        }
        (Some(name), None) => Some(named_albedo(&field.key("material"), all, name)?),
        (None, Some(color)) => Some(field::reflectance(&field.key("albedo"), color)?),
        (None, None) => None,
    };
    let emission = match said.emits {
        Some(color) => Some(field::light(&field.key("emits"), color)?),
        None => None,
    };
    if albedo.is_none() && emission.is_none() {
        return Err(field.problem("needs an `albedo`, a `material`, or `emits`"));
    }
    Ok(Object {
        albedo: albedo.unwrap_or_default(),
        emission: emission.unwrap_or_default(),
    })
}

fn named_albedo(field: &Field, all: &Description, name: &str) -> Checked<Rgb> {
    match all.materials.get(name) {
        Some(material) => albedo(&Field::top().key("materials").key(name), material),
        None if all.materials.is_empty() => Err(field.problem(format!(
            "names \"{name}\", but the file defines no materials"
        ))),
        None => {
            let defined: Vec<&str> = all.materials.keys().map(String::as_str).collect();
            let defined = defined.join(", ");
            Err(field.problem(format!("names \"{name}\"; defined are {defined}")))
        }
    }
}

fn shapes(field: &Field, said: &said::Object) -> Checked<Vec<Shape>> {
    let straight = said.segment.as_ref().map(|s| {
        let field = field.key("segment");
        let from = pair(&field.key("from"), s.from)?;
        let to = pair(&field.key("to"), s.to)?;
        Ok(vec![segment(&field.key("to"), "`from`", from, to)?])
    });
    let circle = said.circle.as_ref().map(|c| {
        let field = field.key("circle");
        Ok(vec![Shape::Circle(Circle {
            center: pair(&field.key("center"), c.center)?.as_vec2(),
            radius: field::positive(&field.key("radius"), c.radius)? as f32,
        })])
    });
    let polyline = said
        .polyline
        .as_ref()
        .map(|p| polyline(&field.key("polyline"), p));
    let kinds = vec![
        ("segment", straight),
        ("circle", circle),
        ("polyline", polyline),
    ];
    exactly_one(field, "shape", kinds)?
}

fn polyline(field: &Field, said: &said::Polyline) -> Checked<Vec<Shape>> {
    let field = field.key("points");
    let least = if said.closed { 3 } else { 2 };
    if said.points.len() < least {
        let given = said.points.len();
        return Err(field.problem(format!("must be {least} points or more, not {given}")));
    }
    let points: Vec<DVec2> = said
        .points
        .iter()
        .enumerate()
        .map(|(i, &point)| pair(&field.item(i), point))
        .collect::<Checked<_>>()?;
    let mut shapes = Vec::with_capacity(points.len());
    for (i, ends) in points.windows(2).enumerate() {
        let end = field.item(i + 1);
        shapes.push(segment(&end, "the one before", ends[0], ends[1])?);
    }
    if let (true, [first, .., last]) = (said.closed, points.as_slice()) {
        let end = field.item(points.len() - 1);
        let other = "the first: `closed` leads back there";
        shapes.push(segment(&end, other, *last, *first)?);
    }
    Ok(shapes)
}

fn segment(end: &Field, other: &str, from: DVec2, to: DVec2) -> Checked<Shape> {
    Segment::new(from, to)
        .map(Shape::Segment)
        .ok_or_else(|| end.problem(format!("must be another point than {other}")))
}

/// The point P, on the surface that passes `probe.at` up to its decimals.
fn probe(field: &Field, said: &said::Probe, world: &FlatWorld) -> Checked<FlatHit> {
    /// Decimals are trusted to this share of the largest coordinate.
    const NEAR: f64 = 1e-5;
    let (at, normal) = (field.key("at"), field.key("normal"));
    let p = pair(&at, said.at)?;
    let n = pair(&normal, said.normal)?
        .try_normalize()
        .ok_or_else(|| normal.problem("must not be [0, 0]: it is a direction"))?;
    // From just above the point down to just below it.
    let near = NEAR * f64::from(world.reach()).max(p.abs().max_element());
    let hit = world
        .first_hit((p + n * near).as_vec2(), -n.as_vec2())
        .filter(|hit| f64::from(hit.t) <= 2.0 * near)
        .ok_or_else(|| at.problem("must lie on the surface of an object"))?;
    if n.perp_dot(hit.surface.n.as_dvec2()).abs() > 1e-3 {
        return Err(normal.problem("must be at right angles to the surface at `probe.at`"));
    }
    Ok(hit.seen_from(n.as_vec2()))
}

fn window(field: &Field, said: &said::Window) -> Checked<Window> {
    let min = pair(&field.key("min"), said.min)?.as_vec2();
    let max = pair(&field.key("max"), said.max)?.as_vec2();
    if !min.cmplt(max).all() {
        let what = "must be above and to the right of `window.min`";
        return Err(field.key("max").problem(what));
    }
    Ok(Window { min, max })
}

fn everything(world: &FlatWorld) -> Window {
    let shapes = world.parts.iter().flat_map(|part| part.shape.bounds());
    let lamps = world.lamps.iter().map(|lamp| lamp.position);
    let probe = world.probe.iter().map(|probe| probe.surface.p);
    Window::around(shapes.chain(lamps).chain(probe))
}

/// A point or direction whose coordinates `f32` can hold.
fn pair(field: &Field, Exactly(xy): Pair) -> Checked<DVec2> {
    for x in xy {
        field::finite(field, x)?;
    }
    Ok(DVec2::from(xy))
}
