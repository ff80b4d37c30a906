//! From a description to a scene: what is wrong is told with its place in the description.

mod materials;
mod meshes;
mod notes;

pub(super) use meshes::Repeated;

use super::description::{self as said, Description};
use super::field::{Checked, Problem, Within, check, named};
use super::made_from::MadeFrom;
use super::motion::{self, PlacedInstance, Way};
use super::parts::Parts;
use super::placement::Placement;
use super::value::{Positive, Whole};
use super::{
    BuildReport, CausticGuide, Contacts, Corners, Inventory, Mapping, Object, Scene, Sky,
    Suggested, focusing, lamps, procedural, spacing,
};
use crate::camera::{Camera, Lens};
use crate::geometry::{Aabb, Bvh, Quad, Shape, Sphere};
use crate::lights::{EmissionChoice, Light, LightChoice, SkyLight, Targets};
use glam::{DMat3, DVec3, Vec2, Vec3};
use std::path::Path;
use std::sync::Arc;
use std::time::Duration;

/// Pixels an image may have: its film takes 152 bytes each.
const MAX_PIXELS: u64 = 1 << 25;
/// A side of an image.
type Side = Whole<1, 65_536>;

/// Checks a description and builds its scene; meshes and images are looked for in `folder`.
pub fn build(said: Description, folder: Option<&Path>) -> Checked<Scene> {
    assemble(&Arc::new(MadeFrom::described(said, folder)))
}

/// The same of what was read from a file.
pub(super) fn assemble(from: &Arc<MadeFrom>) -> Checked<Scene> {
    let (said, folder) = (&from.description, from.folder.as_deref());
    check(!said.name.trim().is_empty(), "must not be empty").within("name")?;
    let size = film_size(said.film.size).within("size").within("film")?;
    let (origin, camera) = camera(&said.camera, size).within("camera")?;
    let suggested = Suggested {
        max_depth: said.render.max_depth.get().within("render")?,
        spp: said.render.spp.get().within("render")?,
    };
    let (background, environment) = lamps::environment(said, folder)?;
    let mut parts = Parts {
        origin,
        folder,
        shutter: said.camera.shutter.get().within("camera")?,
        said_often: meshes::said_often(said).into_iter().collect(),
        ..Parts::default()
    };
    parts.add_materials(&said.materials).within("materials")?;
    parts.note_black_sky(said, environment.is_some());
    for (i, light) in said.lights.iter().enumerate() {
        let light = parts.light(light).within(i).within("lights")?;
        parts.lights.push(light);
    }
    for (i, object) in said.objects.iter().enumerate() {
        parts.add_object(i, object).within(i).within("objects")?;
    }
    parts.note_solids();
    parts.part_from_lights();
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
    let instanced: usize = parts.instances.iter().map(PlacedInstance::shapes).sum();
    let count = parts.all.len() + instanced;
    let coarse = spacing::coarse(parts.all.iter().map(|(shape, _)| shape));
    let (shapes, object_of_shape, transformed) = motion::part(
        parts.all,
        &parts.objects,
        &parts.spans,
        parts.lights.len(),
        &parts.instances,
    );
    let placed = motion::placed(&shapes, &object_of_shape, transformed.as_ref());
    for (number, shape) in placed.iter().enumerate().rev() {
        parts.objects[shape.object as usize]
            .mapping
            .begin_at(number as u32);
    }
    for placed_once in &parts.instances {
        parts.objects[placed_once.object as usize]
            .mapping
            .begin_at(placed.len() as u32);
    }
    let contacts = Contacts::new(&placed, &parts.objects, parts.lights.len());
    let span = |light: usize| {
        let moves = transformed.as_ref();
        moves.map_or(Vec3::ZERO, |m| m.span_of_light[light])
    };
    let light_choice = LightChoice::new(&parts.lights, span);
    let casters = CausticGuide::new(&parts.objects, &shapes, &object_of_shape, &parts.instances);
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
    let shown = inventory.diffuse > 0 || inventory.glossy > 0 && inventory.point_lights > 0;
    let targets = match shown {
        true => focusing::targets(&parts.objects, &placed, &parts.instances),
        false => Targets::default(),
    };
    // A list of a million shapes makes room before their tree takes it.
    drop(placed);
    let bvh = Bvh::new(&shapes);
    let bounds = transformed.as_ref().map_or(Aabb::EMPTY, |t| t.bvh.bounds());
    let bounds = bvh.bounds().union(bounds);
    let emission_choice = EmissionChoice::new(&parts.lights, bounds);
    let caustic_choice = EmissionChoice::towards(&parts.lights, bounds, targets);
    Ok(Scene {
        made_from: Arc::clone(from),
        origin,
        name: said.name.clone(),
        about: said.about.clone(),
        camera,
        size,
        background,
        environment_light,
        sky_light,
        light_choice,
        emission_choice,
        caustic_choice,
        lights: parts.lights,
        casters,
        suggested,
        report: BuildReport {
            shapes: count,
            instances: parts.instances.len(),
            degenerate_triangles: parts.degenerate_triangles,
            coarse,
            hidden_lights: parts.hidden_lights,
            files: from.files.clone(),
            notes: parts.notes,
            time: Duration::ZERO,
        },
        kinds: kinds(&parts.objects),
        textured_lights: (0..)
            .zip(&parts.objects)
            .filter(|(_, object)| object.emission.texture().is_some())
            .filter_map(|(id, object)| Some((object.light?, id)))
            .collect(),
        dark: inventory.is_dark(),
        inventory,
        objects: parts.objects,
        object_of_shape,
        bvh,
        transformed,
        contacts,
    })
}

fn kinds(objects: &[Object]) -> u8 {
    let materials = objects.iter().filter_map(|object| object.material.as_ref());
    materials.fold(0, |set, material| set | material.brightest().kind())
}

/// Checks the size of an image.
pub fn film_size([width, height]: [i64; 2]) -> Checked<[u32; 2]> {
    let [w, h]: [Side; 2] = [Whole(width), Whole(height)];
    let size = [w.get().within(0)?, h.get().within(1)?];
    let what = format_args!("must have at most {MAX_PIXELS} pixels in all, not {width} x {height}");
    let pixels: u64 = size.map(u64::from).iter().product();
    check(pixels <= MAX_PIXELS, what).map(|()| size)
}

/// The camera's place in the world, and the camera in coordinates relative to it.
fn camera(said: &said::Camera, [w, h]: [u32; 2]) -> Checked<(DVec3, Camera)> {
    let (from, up, fov) = (said.from.get()?, said.up.get()?, said.fov.get()?);
    let view = said.to.get()? - from;
    let what = "must be another point than `camera.from`: it gives the direction of view";
    check(view.try_normalize().is_some(), what).within("to")?;
    let radius = said.lens_radius.get()?;
    let focus = said.focus.unwrap_or(Positive(view.length()));
    let focus = focus.get().within("focus")? as f32;
    let lens = (radius > 0.0).then_some(Lens {
        radius: radius as f32,
        focus,
    });
    let camera = Camera::new(Vec3::ZERO, view, up, fov, f64::from(w) / f64::from(h));
    let what = "must not be parallel to the direction of view";
    let camera = camera.ok_or(Problem::new(what).within("up"))?;
    Ok((from, camera.with_lens(lens)))
}

impl Parts<'_> {
    fn add_object(&mut self, number: usize, said: &said::Object) -> Checked<()> {
        let material = match &said.material {
            Some(name) => {
                self.used.insert(name.clone());
                Some(named(&self.materials, name).within("material")?.clone())
            }
            None => None,
        };
        let emits = said.emits.as_ref().map(|said| said.build(self));
        let radiance = emits.transpose().within("emits")?;
        if said.two_sided.is_some() {
            check_two_sided(said).within("two_sided")?;
        }
        let seen = material.is_some() || radiance.is_some();
        check(seen, "needs a `material`, or `emits`, or both")?;
        let way = Way::new(self.shutter, said.motion).within("motion")?;
        let place = Placement::new(&said.transform).within("transform")?;
        let place = place.shifted(way.start);
        let (shapes, mapping) = self.shapes(&said.shape, &place)?;
        way.check(&shapes).within("motion")?;
        if let Some(material) = &material {
            self.inventory.count(&material.brightest(), &shapes);
        }
        self.note_inside_out(number, material.as_ref(), radiance.is_some(), &shapes);
        let two_sided = said.two_sided.unwrap_or(false);
        let emission = radiance.map(|radiance| lamps::Emission {
            radiance,
            two_sided,
        });
        self.note_without_coordinates(number, said, &mapping);
        let alone = emission.is_some() || way.span != Vec3::ZERO;
        if let said::Shape::Custom(shape) = &said.shape {
            let what = "may neither shine nor move: it is an object of one's own";
            check(!alone, what)?;
            let instance = self.custom(shape, &place)?;
            self.push_instance((instance, None), material, mapping);
        } else if !alone && let Some((instance, mesh, mapping)) = self.instance(&said.shape, &place)
        {
            self.push_instance((instance, Some(mesh)), material, mapping);
        } else {
            self.push(shapes, material, emission, way.span, &mapping);
        }
        self.spans.resize(self.objects.len(), way.span);
        self.numbers.resize(self.objects.len(), number);
        if said.motion.0 != [0.0; 3] {
            let moves = way.span != Vec3::ZERO;
            self.inventory.moving += usize::from(moves);
            self.inventory.frozen += usize::from(!moves);
        }
        Ok(())
    }

    fn shapes(&mut self, said: &said::Shape, place: &Placement) -> Checked<(Vec<Shape>, Mapping)> {
        use said::Shape as Said;
        let mirrored = |mapping: Mapping| match place.mirrors() {
            true => mapping.mirrored(),
            false => mapping,
        };
        Ok(match said {
            Said::Sphere {
                center,
                radius,
                inward,
            } => {
                let sphere = self.sphere(center.get()?, radius.get()?, *inward, place);
                (vec![sphere.within("sphere")?], place.of_sphere(*inward))
            }
            Said::Quad { corner, u, v } => {
                let quad = self.quad(corner.get()?, u.get()?, v.get()?, place);
                (vec![quad.within("quad")?], mirrored(Mapping::default()))
            }
            Said::Triangle { a, b, c } => self.triangle([*a, *b, *c], place).within("triangle")?,
            Said::Box { min, max } => {
                let sides = self.cuboid(min.get()?, max.get()?, place).within("box")?;
                (sides, mirrored(Mapping::of(Corners::Each(BOX.into()))))
            }
            Said::Custom(_) => (Vec::new(), Mapping::default()),
            Said::Mesh { file } => self.mesh_file(file, place).within("file").within("mesh")?,
            Said::BumpySphere {
                center,
                radius,
                columns,
                rows,
            } => {
                let (columns, rows) = (columns.get()?, rows.get()?);
                let mesh = procedural::bumpy_sphere(center.get()?, radius.get()?, columns, rows);
                self.mesh(&mesh, place)
            }
        })
    }

    fn sphere(
        &mut self,
        center: DVec3,
        radius: f64,
        inward: bool,
        place: &Placement,
    ) -> Checked<Shape> {
        let what = "cannot be scaled differently along different axes; use a mesh";
        let scale = place.uniform_scale().ok_or(Problem::new(what))?;
        let radius = Positive(radius * scale).get().within("radius")?;
        let center = place.point(center);
        let sphere = Sphere {
            center: self.relative(center).within("center")?,
            radius: radius as f32,
            inward,
        };
        let what = "must end at most 3.4e38 away from the camera";
        check(sphere.bounds().is_finite(), what).within("radius")?;
        self.misplaced.sphere(center - self.origin, radius, &sphere);
        Ok(Shape::Sphere(sphere))
    }

    fn quad(&mut self, corner: DVec3, u: DVec3, v: DVec3, place: &Placement) -> Checked<Shape> {
        let (u, v) = (place.vector(u), place.vector(v));
        let (u, v) = if place.mirrors() { (v, u) } else { (u, v) };
        let corner = place.point(corner) - self.origin;
        let what = "has no area: its edges are parallel, zero or too large";
        let quad = Quad::new(corner, u, v).ok_or(Problem::new(what))?;
        self.misplaced.quad([corner, u, v], &quad);
        Ok(Shape::Quad(quad))
    }

    fn cuboid(&mut self, min: DVec3, max: DVec3, place: &Placement) -> Checked<Vec<Shape>> {
        let what = "must have each coordinate of `min` below that of `max`";
        check(min.cmplt(max).all(), what)?;
        let [x, y, z] = DMat3::from_diagonal(max - min)
            .to_cols_array_2d()
            .map(DVec3::from);
        let sides = [
            (min, z, y),
            (min, x, z),
            (min, y, x),
            (max, -y, -z),
            (max, -z, -x),
            (max, -x, -y),
        ];
        let quad = |(corner, u, v)| self.quad(corner, u, v, place);
        sides.into_iter().map(quad).collect()
    }
}

/// Texture coordinates of a quad whose edges are `u` and `v`.
const UPRIGHT: [Vec2; 3] = [Vec2::ZERO, Vec2::X, Vec2::Y];

/// Texture coordinates of the sides of a box in the order of `Parts::cuboid`: seen from outside each is
/// upright, with `v` along `+y`, and along `-z` on top and `+z` below.
const BOX: [[Vec2; 3]; 6] = [
    UPRIGHT,
    UPRIGHT,
    [Vec2::X, Vec2::ONE, Vec2::ZERO],
    [Vec2::Y, Vec2::ZERO, Vec2::ONE],
    [Vec2::X, Vec2::ONE, Vec2::ZERO],
    [Vec2::ONE, Vec2::Y, Vec2::X],
];

/// A complaint where light on both sides has no meaning.
fn check_two_sided(said: &said::Object) -> Checked<()> {
    let what = "is only possible with `emits`: it says which sides shine";
    check(said.emits.is_some(), what)?;
    let has_sides = !matches!(
        said.shape,
        said::Shape::Sphere { .. } | said::Shape::Box { .. }
    );
    check(
        has_sides,
        "is only possible for a quad, a triangle or a mesh",
    )
}
