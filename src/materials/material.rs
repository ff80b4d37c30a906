//! What surfaces are made of.

use super::{Bsdf, CustomBsdf, Texture};
use glam::Vec2;
use std::sync::Arc;

/// A BSDF whose colours may differ from point to point, or one's own.
#[derive(Clone, Debug)]
pub struct Material {
    /// With the brightest value of each colour that a texture replaces.
    brightest: Bsdf<'static>,
    /// What is not the same everywhere; `None` for most.
    special: Option<Box<Special>>,
}

/// What makes a material more than a BSDF of constant colours.
#[derive(Clone, Debug)]
enum Special {
    /// For each colour, in the order of [`Bsdf::colors_mut`], the texture that replaces it.
    Textures([Option<Arc<dyn Texture>>; 3]),
    /// A BSDF of one's own, in place of the other.
    Custom(Arc<dyn CustomBsdf>),
}

impl From<Bsdf<'static>> for Material {
    /// The same everywhere.
    fn from(bsdf: Bsdf<'static>) -> Self {
        Material {
            brightest: bsdf,
            special: None,
        }
    }
}

impl Material {
    /// A BSDF, and for each of its colours the texture that replaces it, if there is one.
    ///
    /// Colours are numbered in the order of the fields: the albedo of `Lambert`, the reflectance of `Mirror`
    /// and `Glossy`, and `kd`, `ks`, `kt` of `Mixture`. Textures of other numbers are left out.
    pub fn textured(mut bsdf: Bsdf<'static>, textures: [Option<Arc<dyn Texture>>; 3]) -> Self {
        if textures.iter().all(Option::is_none) {
            return bsdf.into();
        }
        for (color, texture) in bsdf.colors_mut().into_iter().zip(&textures) {
            if let (Some(color), Some(texture)) = (color, texture) {
                *color = texture.brightest();
            }
        }
        Material {
            brightest: bsdf,
            special: Some(Box::new(Special::Textures(textures))),
        }
    }

    /// A BSDF of one's own.
    pub fn custom(bsdf: Arc<dyn CustomBsdf>) -> Self {
        Material {
            brightest: Bsdf::Lambert(super::Lambert {
                albedo: bsdf.albedo(),
            }),
            special: Some(Box::new(Special::Custom(bsdf))),
        }
    }

    /// The BSDF at the point with texture coordinates `uv`, which are asked for only by textures.
    #[inline]
    pub fn bsdf(&self, uv: impl FnOnce() -> Vec2) -> Bsdf<'_> {
        match &self.special {
            None => self.brightest,
            Some(special) => self.evaluated(special, uv()),
        }
    }

    #[inline(never)]
    fn evaluated<'a>(&self, special: &'a Special, uv: Vec2) -> Bsdf<'a> {
        let textures = match special {
            Special::Custom(bsdf) => return Bsdf::Custom(&**bsdf),
            Special::Textures(textures) => textures,
        };
        let mut bsdf = self.brightest;
        for (color, texture) in bsdf.colors_mut().into_iter().zip(textures) {
            if let (Some(color), Some(texture)) = (color, texture) {
                *color = texture.color(uv);
            }
        }
        bsdf
    }

    /// The BSDF with the brightest value of each colour: what it does anywhere, this does, too.
    pub fn brightest(&self) -> Bsdf<'_> {
        match self.special.as_deref() {
            Some(Special::Custom(bsdf)) => Bsdf::Custom(&**bsdf),
            _ => self.brightest,
        }
    }

    /// True where its BSDF differs from point to point.
    pub fn is_textured(&self) -> bool {
        matches!(self.special.as_deref(), Some(Special::Textures(_)))
    }
}
