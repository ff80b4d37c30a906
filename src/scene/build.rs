//! From a description to a scene: every value is checked here, and named where it is wrong.

mod materials;
mod meshes;
mod notes;

use super::description as said;
use super::field::{self, Checked, Field, exactly_one};
use super::lamps::Emission;
use super::made_from::MadeFrom;
use super::motion::{self, Shutter};
use super::parts::Parts;
use super::placement::Placement;
use super::spacing::Misplaced;
use super::{
    BuildReport, Casters, Contacts, Inventory, Object, Scene, Sky, Suggested, lamps, spacing,
};
use crate::camera::{Camera, Lens};
use crate::geometry::{Bvh, Quad, Shape, Sphere};
use crate::lights::{Light, LightChoice, SkyLight};
use crate::materials::Material;
use glam::{DVec3, Vec3};
use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Duration;

/// Pixels an image may have: its film takes 72 bytes each.
const MAX_PIXELS: u64 = 1 << 25;
/// Longest side of an image.
const MAX_SIDE: u32 = 65_536;

/// Checks a description and builds its scene.
pub(super) fn build(from: &Arc<MadeFrom>) -> Checked<Scene> {
    let (said, folder) = (&from.description, from.folder.as_deref());
    let top = Field::top();
    if said.name.trim().is_empty() {
        return Err(top.key("name").problem("must not be empty"));
    }
    let size = film_size(&top.key("film").key("size"), said.film.size)?;
    let (origin, camera) = camera(&top.key("camera"), &said.camera, size)?;
    let render = top.key("render");
    let suggested = Suggested {
        max_depth: field::whole(&render.key("max_depth"), said.render.max_depth, 1, 100_000)?,
        spp: field::whole(&render.key("spp"), said.render.spp, 1, 1 << 24)?,
    };
    let (background, environment) = lamps::environment(&top, said, folder)?;
    let shutter = Shutter::new(&top.key("camera").key("shutter"), said.camera.shutter)?;
    let mut parts = Parts {
        origin,
        folder,
        shutter,
        materials: materials::all(&top.key("materials"), &said.materials)?,
        all: Vec::new(),
        objects: Vec::new(),
        spans: Vec::new(),
        lights: Vec::new(),
        degenerate_triangles: 0,
        fields: Vec::new(),
        misplaced: Misplaced::default(),
        notes: Vec::new(),
        inventory: Inventory::default(),
        used: BTreeSet::new(),
        lamp_places: Default::default(),
        hidden_lamps: 0,
    };
    parts.note_black_sky(said, environment.is_some());
    for (i, light) in said.lights.iter().enumerate() {
        parts.add_light(&top.key("lights").item(i), light)?;
    }
    for (i, object) in said.objects.iter().enumerate() {
        parts.add_object(&top.key("objects").item(i), object)?;
    }
    parts.note_solids();
    let unused = parts
        .materials
        .keys()
        .filter(|name| !parts.used.contains(*name));
    let unused: Vec<String> = unused.cloned().collect();
    let lamps = parts.lights.len();
    let environment_light = environment.is_some().then_some(lamps);
    let sky_light = (environment.is_none() && !background.is_black()).then_some(lamps);
    parts.lights.extend(environment);
    parts.lights.extend(sky_light.map(|_| {
        Light::Sky(SkyLight {
            radiance: background,
        })
    }));
    let count = parts.all.len();
    let coarse = spacing::coarse(parts.all.iter().map(|(shape, _)| shape));
    let (shapes, object_of_shape, in_motion) =
        motion::part(parts.all, &parts.objects, &parts.spans, parts.lights.len());
    let placed = motion::placed(&shapes, &object_of_shape, in_motion.as_ref());
    let contacts = Contacts::new(&placed, &parts.objects, parts.lights.len());
    let span = |light: usize| {
        let moves = in_motion.as_ref();
        moves.map_or(Vec3::ZERO, |m| m.span_of_light[light])
    };
    let light_choice = LightChoice::new(&parts.lights, span);
    let casters = Casters::new(&parts.objects, &shapes, &object_of_shape);
    let inventory = Inventory {
        point_lights: parts.lights.iter().filter(|l| l.is_delta()).count(),
        area_lights: parts.objects.iter().filter(|o| o.light.is_some()).count(),
        sky: match environment_light {
            Some(_) => Sky::Image,
            None if !background.is_black() => Sky::Constant,
            None => Sky::Black,
        },
        casters: casters.len(),
        lens: camera.lens(),
        unused_materials: unused,
        ..parts.inventory
    };
    Ok(Scene {
        made_from: Arc::clone(from),
        name: said.name.clone(),
        about: said.about.clone(),
        camera,
        size,
        background,
        environment_light,
        sky_light,
        light_choice,
        lights: parts.lights,
        casters,
        suggested,
        report: BuildReport {
            shapes: count,
            degenerate_triangles: parts.degenerate_triangles,
            coarse,
            hidden_lamps: parts.hidden_lamps,
            files: from.files.clone(),
            notes: parts.notes,
            time: Duration::ZERO,
        },
        kinds: kinds(&parts.objects),
        dark: inventory.is_dark(),
        inventory,
        objects: parts.objects,
        object_of_shape,
        bvh: Bvh::new(&shapes),
        in_motion,
        contacts,
    })
}

fn kinds(objects: &[Object]) -> u8 {
    let materials = objects.iter().filter_map(|object| object.material);
    materials.fold(0, |set, material| set | material.kind())
}

/// Checks the size of an image.
pub fn film_size(field: &Field, [width, height]: [i64; 2]) -> Checked<[u32; 2]> {
    let width = field::whole(&field.item(0), width, 1, MAX_SIDE)?;
    let height = field::whole(&field.item(1), height, 1, MAX_SIDE)?;
    if u64::from(width) * u64::from(height) > MAX_PIXELS {
        return Err(field.problem(format!(
            "must have at most {MAX_PIXELS} pixels in all, not {width} x {height}"
        )));
    }
    Ok([width, height])
}

/// The camera's place in the world, and the camera in coordinates relative to it.
fn camera(field: &Field, said: &said::Camera, [w, h]: [u32; 2]) -> Checked<(DVec3, Camera)> {
    let from = field::vector(&field.key("from"), said.from)?;
    let to = field::vector(&field.key("to"), said.to)?;
    let up = field::direction(&field.key("up"), said.up)?;
    let fov = field.key("fov");
    if !(said.fov > 0.0 && said.fov < 180.0) {
        return Err(fov.problem(format!(
            "must be an angle between 0 and 180 degrees, not {}",
            said.fov
        )));
    }
    if (to - from).try_normalize().is_none() {
        let what = "must be another point than `camera.from`: it gives the direction of view";
        return Err(field.key("to").problem(what));
    }
    let aspect = f64::from(w) / f64::from(h);
    let lens = lens(field, said, (to - from).length())?;
    Camera::new(Vec3::ZERO, to - from, up, said.fov.to_radians(), aspect)
        .map(|camera| (from, camera.with_lens(lens)))
        .ok_or_else(|| {
            field
                .key("up")
                .problem("must not be parallel to the direction of view")
        })
}

/// The lens, where there is one; `distance` is that of the point the camera looks at.
fn lens(field: &Field, said: &said::Camera, distance: f64) -> Checked<Option<Lens>> {
    let radius = field::not_negative(&field.key("lens_radius"), said.lens_radius)?;
    let focus = field::positive(&field.key("focus"), said.focus.unwrap_or(distance))?;
    Ok((radius > 0.0).then_some(Lens {
        radius: radius as f32,
        focus: focus as f32,
    }))
}

impl Parts<'_> {
    fn add_object(&mut self, field: &Field, said: &said::Object) -> Checked<()> {
        let material = match &said.material {
            Some(name) => Some(self.material_named(&field.key("material"), name)?),
            None => None,
        };
        let emission = match said.emits {
            Some(color) => Some(Emission {
                radiance: field::light(&field.key("emits"), color)?,
                two_sided: said.two_sided.unwrap_or(false),
            }),
            None => None,
        };
        if said.two_sided.is_some() {
            self.check_two_sided(&field.key("two_sided"), said)?;
        }
        if material.is_none() && emission.is_none() {
            return Err(field.problem("needs a `material`, or `emits`, or both"));
        }
        let way = self.shutter.way(&field.key("motion"), said.motion)?;
        let place = Placement::new(&field.key("transform"), said.transform.as_ref())?;
        let shapes = self.shapes(field, said, &place.shifted(way.start))?;
        way.check(&field.key("motion"), &shapes)?;
        if let Some(material) = &material {
            self.inventory.count(material, &shapes);
        }
        self.note_inside_out(field, material.as_ref(), emission.is_some(), &shapes);
        match emission {
            Some(emission) => self.push_lamp(shapes, material, emission, way.span),
            None => self.push(shapes, material, None),
        }
        self.spans.resize(self.objects.len(), way.span);
        self.fields.resize(self.objects.len(), field.clone());
        if said.motion.is_some_and(|motion| motion.0 != [0.0; 3]) {
            let moves = way.span != Vec3::ZERO;
            self.inventory.moving += usize::from(moves);
            self.inventory.frozen += usize::from(!moves);
        }
        Ok(())
    }

    /// A complaint where light on both sides has no meaning.
    fn check_two_sided(&self, field: &Field, said: &said::Object) -> Checked<()> {
        if said.emits.is_none() {
            return Err(field.problem("is only possible with `emits`: it says which sides shine"));
        }
        if said.sphere.is_some() || said.cuboid.is_some() {
            return Err(field.problem("is only possible for a quad, a triangle or a mesh"));
        }
        Ok(())
    }

    fn material_named(&mut self, field: &Field, name: &str) -> Checked<Material> {
        self.used.insert(name.to_owned());
        self.materials.get(name).copied().ok_or_else(|| {
            let defined: Vec<&str> = self.materials.keys().map(String::as_str).collect();
            field.problem(if defined.is_empty() {
                format!("names {name:?}, but the file defines no materials")
            } else {
                format!("names {name:?}; defined are {}", defined.join(", "))
            })
        })
    }

    fn shapes(
        &mut self,
        field: &Field,
        said: &said::Object,
        place: &Placement,
    ) -> Checked<Vec<Shape>> {
        let at = |name: &str| field.key(name);
        let sphere = said.sphere.as_ref();
        let quad = said.quad.as_ref();
        let triangle = said.triangle.as_ref();
        let cuboid = said.cuboid.as_ref();
        let mesh = said.mesh.as_ref();
        let bumpy = said.bumpy_sphere.as_ref();
        let kinds = vec![
            (
                "sphere",
                sphere.map(|s| self.sphere(&at("sphere"), s, place)),
            ),
            ("quad", quad.map(|q| self.quad(&at("quad"), q, place))),
            (
                "triangle",
                triangle.map(|t| self.triangle(&at("triangle"), t, place)),
            ),
            ("box", cuboid.map(|c| self.cuboid(&at("box"), c, place))),
            ("mesh", mesh.map(|m| self.mesh_file(&at("mesh"), m, place))),
            (
                "bumpy_sphere",
                bumpy.map(|b| self.bumpy_sphere(&at("bumpy_sphere"), b, place)),
            ),
        ];
        exactly_one(field, "shape", kinds)?
    }

    fn sphere(
        &mut self,
        field: &Field,
        said: &said::Sphere,
        place: &Placement,
    ) -> Checked<Vec<Shape>> {
        let center = field::vector(&field.key("center"), said.center)?;
        let radius_field = field.key("radius");
        let radius = field::positive(&radius_field, said.radius)?;
        let scale = place.uniform_scale().ok_or_else(|| {
            field.problem("cannot be scaled differently along different axes; use a mesh")
        })?;
        let radius = field::positive(&radius_field, radius * scale)?;
        let center = place.point(center);
        let sphere = Sphere {
            center: self.within_reach(&field.key("center"), center)?,
            radius: radius as f32,
            inward: said.inward,
        };
        if !sphere.bounds().is_finite() {
            return Err(radius_field.problem("must end at most 3.4e38 away from the camera"));
        }
        self.misplaced.sphere(center - self.origin, radius, &sphere);
        Ok(vec![Shape::Sphere(sphere)])
    }

    fn quad(&mut self, field: &Field, said: &said::Quad, place: &Placement) -> Checked<Vec<Shape>> {
        let corner = field::vector(&field.key("corner"), said.corner)?;
        let u = field::vector(&field.key("u"), said.u)?;
        let v = field::vector(&field.key("v"), said.v)?;
        self.parallelogram(field, corner, u, v, place)
            .map(|quad| vec![quad])
    }

    fn parallelogram(
        &mut self,
        field: &Field,
        corner: DVec3,
        u: DVec3,
        v: DVec3,
        place: &Placement,
    ) -> Checked<Shape> {
        let (u, v) = (place.vector(u), place.vector(v));
        let (u, v) = if place.mirrors() { (v, u) } else { (u, v) };
        let corner = place.point(corner) - self.origin;
        let what = "has no area: its edges are parallel, zero or too large";
        let quad = Quad::new(corner, u, v).ok_or_else(|| field.problem(what))?;
        self.misplaced.quad([corner, u, v], &quad);
        Ok(Shape::Quad(quad))
    }

    fn cuboid(
        &mut self,
        field: &Field,
        said: &said::Cuboid,
        place: &Placement,
    ) -> Checked<Vec<Shape>> {
        let min = field::vector(&field.key("min"), said.min)?;
        let max = field::vector(&field.key("max"), said.max)?;
        if !min.cmplt(max).all() {
            return Err(field.problem("must have each coordinate of `min` below that of `max`"));
        }
        let d = max - min;
        let (x, y, z) = (DVec3::X * d.x, DVec3::Y * d.y, DVec3::Z * d.z);
        [
            (min, z, y),
            (min, x, z),
            (min, y, x),
            (max, -y, -z),
            (max, -z, -x),
            (max, -x, -y),
        ]
        .into_iter()
        .map(|(corner, u, v)| self.parallelogram(field, corner, u, v, place))
        .collect()
    }
}
