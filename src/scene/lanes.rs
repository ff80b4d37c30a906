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
    light: Option<OnlyLight>,
    black_beyond: bool,
}

/// The only light of a scene, a quad of one colour.
#[derive(Clone, Copy, Debug)]
pub struct OnlyLight {
    /// The quad.
    pub quad: QuadInLanes,
    /// The number of its shape.
    pub shape: u32,
    /// Its index in [`Scene::lights`].
    pub index: u32,
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
    /// `None` where paths had better be traced one by one: where something moves or is an instance of a mesh, where
    /// nothing is diffuse and of one colour, and where nothing shines.
    pub fn new(scene: &'s Scene) -> Option<Self> {
        let transforms = scene
            .transformed
            .as_ref()
            .is_some_and(|shapes| !shapes.is_empty());
        let is_diffuse = |object: &Object| diffuse_albedo(object).is_some();
        let lit = !scene.is_dark() && scene.objects.iter().any(is_diffuse);
        (!transforms && lit).then_some(())?;
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

    /// Its only light, where that is a quad of one colour.
    pub fn light(&self) -> Option<&OnlyLight> {
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

    /// True where a shape may lie within rounding of others, one of which shines.
    pub fn has_contacts(&self) -> bool {
        self.scene.contacts.is_some()
    }

    /// What a ray meets where `hit` is what it seems to meet first: another shape within rounding may shine.
    pub fn met(&self, ray: &Ray, hit: PlainHit) -> PlainHit {
        let Some(contacts) = &self.scene.contacts else {
            return hit;
        };
        let met = contacts.met(ray, self.hit(&hit), &self.scene.objects);
        PlainHit {
            intersection: met.intersection,
            surface: met.surface,
            shape: met.shape,
        }
    }

    /// True where a shadow ray to a part of a light, which nothing clearly before it stops, also meets the light before
    /// all that is within rounding of it.
    pub fn light_is_met(&self, (light, part): (u32, u32), shadow_ray: &Ray) -> bool {
        self.scene.contacts.as_ref().is_none_or(|contacts| {
            contacts.is_met(light as usize, part, shadow_ray, &self.scene.objects)
        })
    }

    /// All that there is to know of a hit.
    pub fn interaction(&self, ray: &Ray, hit: &PlainHit) -> Interaction<'s> {
        Interaction::new(&self.scene.objects, ray, &self.hit(hit))
    }

    fn hit(&self, hit: &PlainHit) -> Hit {
        Hit {
            intersection: hit.intersection,
            surface: hit.surface,
            object: self.scene.object_of_shape[hit.shape as usize],
            shape: hit.shape,
        }
    }
}

fn only_quad(scene: &Scene) -> Option<OnlyLight> {
    let only = scene.light_choice.only()?;
    let Light::Quad(light) = scene.lights.get(only)? else {
        return None;
    };
    let index = u32::try_from(only).ok()?;
    let shines = |object: &u32| scene.objects[*object as usize].light == Some(index);
    let shape = scene.object_of_shape.iter().position(shines)?;
    scene.textured_lights.is_empty().then_some(OnlyLight {
        quad: QuadInLanes::new(light),
        shape: u32::try_from(shape).ok()?,
        index,
    })
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
