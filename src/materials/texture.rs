//! Colours that differ from point to point.

use crate::color::Rgb;
use glam::Vec2;
use std::fmt::Debug;
use std::sync::Arc;

/// A colour as a function of the texture coordinates of a point.
pub trait Texture: Debug + Send + Sync {
    /// The colour at `uv`: `u` to the right and `v` upwards, both of any size.
    fn color(&self, uv: Vec2) -> Rgb;

    /// The largest value of each channel anywhere.
    fn brightest(&self) -> Rgb;
}

/// A colour of a surface: the same everywhere, or a texture.
#[derive(Clone, Debug)]
pub enum Color {
    /// The same everywhere.
    Constant(Rgb),
    /// It differs from point to point.
    Textured(Arc<dyn Texture>),
}

impl Default for Color {
    fn default() -> Self {
        Color::Constant(Rgb::BLACK)
    }
}

impl Color {
    /// The colour at the point with texture coordinates `uv`, which are asked for only by textures.
    #[inline]
    pub fn at(&self, uv: impl FnOnce() -> Vec2) -> Rgb {
        match self {
            Color::Constant(color) => *color,
            Color::Textured(texture) => texture.color(uv()),
        }
    }

    /// The largest value of each channel anywhere.
    pub fn brightest(&self) -> Rgb {
        match self {
            Color::Constant(color) => *color,
            Color::Textured(texture) => texture.brightest(),
        }
    }

    /// The texture, if it is one.
    pub fn texture(&self) -> Option<&Arc<dyn Texture>> {
        match self {
            Color::Constant(_) => None,
            Color::Textured(texture) => Some(texture),
        }
    }
}
