//! A scene as sixteen paths at once look at it.

use super::interaction::{Hit, Interaction};
use super::{Object, Scene};
use crate::geometry::lanes::{FewShapes, Note};
use crate::geometry::{ClosestHit, Intersection, Ray, Surface};
use crate::lights::Light;
use crate::lights::lanes::QuadInLanes;
use crate::materials::Bsdf;

/// What of a scene is looked at in lanes: its quads and spheres, where they are few, and its light, where that is one
/// quad.
///
/// All else goes lane by lane through the same code as a single path.
#[derive(Clone, Debug)]
pub struct SceneInLanes<'s> {
    scene: &'s Scene,
    shapes: Option<FewShapes>,
    light: Option<(QuadInLanes, u32)>,
    black_beyond: bool,
}

/// What a single ray hits.
#[derive(Clone, Copy, Debug)]
pub struct PlainHit {
    /// Where on the ray and on the shape.
    pub intersection: Intersection,
    /// The point.
    pub surface: Surface,
    /// The number of the shape.
    pub shape: u32,
}

impl PlainHit {
    fn new(ray: &Ray, found: &ClosestHit) -> Self {
        PlainHit {
            intersection: found.intersection,
            surface: found.surface(ray),
            shape: found.id,
        }
    }
}

impl<'s> SceneInLanes<'s> {
    /// `None` where paths had better be traced one by one: where something moves, is an instance of a mesh or lies
    /// within rounding of a light, where nothing is diffuse and of one colour, and where nothing shines.
    pub fn new(scene: &'s Scene) -> Option<Self> {
        let transforms = scene
            .transformed
            .as_ref()
            .is_some_and(|shapes| !shapes.is_empty());
        let still = !transforms && scene.contacts.is_none();
        let is_diffuse = |object: &Object| diffuse_albedo(object).is_some();
        let lit = !scene.is_dark() && scene.objects.iter().any(is_diffuse);
        (still && lit).then_some(())?;
        let note =
            |shape: u32| note(&scene.objects[scene.object_of_shape[shape as usize] as usize]);
        Some(SceneInLanes {
            scene,
            shapes: FewShapes::new(scene.bvh.shapes(), note),
            light: only_quad(scene),
            black_beyond: scene.environment_light.is_none() && scene.background.is_black(),
        })
    }

    /// The scene.
    pub fn scene(&self) -> &'s Scene {
        self.scene
    }

    /// Its quads and spheres, where they are few.
    pub fn shapes(&self) -> Option<&FewShapes> {
        self.shapes.as_ref()
    }

    /// Its only light, where that is a quad of one colour, and the number of the quad.
    pub fn light(&self) -> Option<&(QuadInLanes, u32)> {
        self.light.as_ref()
    }

    /// True where rays that leave the scene bring no light.
    pub fn is_black_beyond(&self) -> bool {
        self.black_beyond
    }

    /// What lanes know of the object that a shape belongs to.
    pub fn note(&self, shape: u32) -> Note {
        note(&self.scene.objects[self.scene.object_of_shape[shape as usize] as usize])
    }

    /// What a single ray hits first.
    pub fn first_hit(&self, ray: &Ray) -> Option<PlainHit> {
        let found = self.scene.bvh.first_hit(ray)?;
        Some(PlainHit::new(ray, &found))
    }

    /// The triangle that a single ray hits first.
    pub fn first_triangle(&self, ray: &Ray) -> Option<PlainHit> {
        let found = self.scene.bvh.first_triangle(ray)?;
        Some(PlainHit::new(ray, &found))
    }

    /// True where something stands in the way of a single ray.
    pub fn occluded(&self, ray: &Ray) -> bool {
        self.scene.bvh.occluded(ray)
    }

    /// True where a triangle does.
    pub fn occluded_by_triangles(&self, ray: &Ray) -> bool {
        self.scene.bvh.occluded_by_triangles(ray)
    }

    /// All that there is to know of a hit.
    pub fn interaction(&self, ray: &Ray, hit: &PlainHit) -> Interaction<'s> {
        let hit = Hit {
            intersection: hit.intersection,
            surface: hit.surface,
            object: self.scene.object_of_shape[hit.shape as usize],
            shape: hit.shape,
        };
        Interaction::new(&self.scene.objects, ray, &hit)
    }
}

fn only_quad(scene: &Scene) -> Option<(QuadInLanes, u32)> {
    let only = scene.light_choice.only()?;
    let Light::Quad(light) = scene.lights.get(only)? else {
        return None;
    };
    let shines = |object: &u32| scene.objects[*object as usize].light == Some(only as u32);
    let shape = scene.object_of_shape.iter().position(shines)?;
    let quad = (QuadInLanes::new(light), u32::try_from(shape).ok()?);
    scene.textured_lights.is_empty().then_some(quad)
}

fn note(object: &Object) -> Note {
    Note {
        albedo: diffuse_albedo(object).unwrap_or_default(),
        shines: object.light.is_some(),
    }
}

/// The albedo of what is diffuse and of one colour, and not black.
fn diffuse_albedo(object: &Object) -> Option<[f32; 3]> {
    let material = object
        .material
        .as_ref()
        .filter(|material| !material.is_textured())?;
    match material.brightest() {
        Bsdf::Lambert(lambert) if !lambert.albedo.is_black() => Some(lambert.albedo.channels()),
        _ => None,
    }
}
