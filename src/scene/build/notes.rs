//! What is odd about a scene, though it can be rendered.

use crate::geometry::Shape;
use crate::materials::Material;
use crate::scene::Mapping;
use crate::scene::description::{self as said, Description};
use crate::scene::parts::Parts;
use crate::scene::solids;
use crate::scene::spacing::Misplaced;
use crate::scene::textures::Textured;

impl Parts<'_> {
    /// An image around the scene that is all black is none.
    pub(super) fn note_black_sky(&mut self, said: &Description, shines: bool) {
        if let (Some(image), false) = (said.image(), shines) {
            self.note(format!(
                "{}: every pixel is black, so it gives no light",
                image.display()
            ));
        }
    }

    /// A texture on a mesh that does not say where on it.
    pub(super) fn note_without_coordinates(
        &mut self,
        number: usize,
        said: &said::Object,
        mapping: &Mapping,
    ) {
        let material = said
            .material
            .as_ref()
            .and_then(|name| self.materials.get(name));
        let emits = said.emits.as_ref();
        let textured = material.is_some_and(Material::is_textured)
            || emits.is_some_and(|color| !matches!(color, Textured::Constant(_)));
        if let (said::Shape::Mesh { file }, true, false) = (&said.shape, textured, mapping.is_own())
        {
            self.note(format!(
                "objects[{number}] has a texture, but {} has no texture coordinates: each of its \
                 triangles gets (0, 0), (1, 0) and (1, 1)",
                file.display()
            ));
        }
    }

    /// Of a closed surface the front is outside, if anything is in it or it shines.
    pub(super) fn note_inside_out(
        &mut self,
        number: usize,
        material: Option<&Material>,
        shines: bool,
        shapes: &[Shape],
    ) {
        let has_inside = material.is_some_and(|m| m.brightest().refracts());
        if (has_inside || shines) && solids::inside_out(shapes) {
            let what = if has_inside {
                "what it is made of lies outside"
            } else {
                "it shines inwards"
            };
            self.note(format!(
                "objects[{number}] is closed and its front faces inwards, so that {what}: turn its faces round"
            ));
        }
    }

    /// Says what is odd about all objects together.
    pub(super) fn note_solids(&mut self) {
        let Misplaced { shapes, by } = self.misplaced;
        if shapes > 0 {
            self.note(format!(
                "{shapes} shapes are so large for their distance from the camera that rounding \
                 moves them by up to {by:.2e}"
            ));
        }
        let pairs = solids::touching(&self.all, &self.objects, &self.spans);
        if let Some(&[a, b]) = pairs.first() {
            let [a, b] = [a, b].map(|i| self.numbers[i as usize]);
            let who = if a == b {
                format!("objects[{a}] has two faces")
            } else {
                format!("objects[{a}] and objects[{b}] have faces")
            };
            let more = match pairs.len() - 1 {
                0 => String::new(),
                n => format!(" (and {n} more pairs)"),
            };
            self.note(format!(
                "{who} in one place, and refract{more}: rays meet one of them only; leave one out and \
                 give the other the ratio of both indices, or leave a gap"
            ));
        }
    }
}
