//! What surfaces are made of.

use super::{Bsdf, Texture};
use glam::Vec2;
use std::sync::Arc;

/// A BSDF whose colours may differ from point to point.
#[derive(Clone, Debug)]
pub struct Material {
    /// With the brightest value of each colour that a texture replaces.
    brightest: Bsdf,
    /// For each of its colours, in the order of [`Bsdf::colors_mut`], the texture that replaces it.
    textures: Option<Box<[Option<Arc<dyn Texture>>; 3]>>,
}

impl From<Bsdf> for Material {
    /// The same everywhere.
    fn from(bsdf: Bsdf) -> Self {
        Material {
            brightest: bsdf,
            textures: None,
        }
    }
}

impl Material {
    /// A BSDF, and for each of its colours the texture that replaces it, if there is one.
    ///
    /// Colours are numbered in the order of the fields: the albedo of `Lambert`, the reflectance of `Mirror`
    /// and `Glossy`, and `kd`, `ks`, `kt` of `Mixture`. Textures of other numbers are left out.
    pub fn textured(mut bsdf: Bsdf, textures: [Option<Arc<dyn Texture>>; 3]) -> Self {
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
            textures: Some(Box::new(textures)),
        }
    }

    /// The BSDF at the point with texture coordinates `uv`, which are asked for only by textures.
    #[inline]
    pub fn bsdf(&self, uv: impl FnOnce() -> Vec2) -> Bsdf {
        match &self.textures {
            None => self.brightest,
            Some(textures) => self.evaluated(textures, uv()),
        }
    }

    #[inline(never)]
    fn evaluated(&self, textures: &[Option<Arc<dyn Texture>>; 3], uv: Vec2) -> Bsdf {
        let mut bsdf = self.brightest;
        for (color, texture) in bsdf.colors_mut().into_iter().zip(textures) {
            if let (Some(color), Some(texture)) = (color, texture) {
                *color = texture.color(uv);
            }
        }
        bsdf
    }

    /// The BSDF with the brightest value of each colour: what it does anywhere, this does, too.
    pub fn brightest(&self) -> &Bsdf {
        &self.brightest
    }

    /// True where its BSDF differs from point to point.
    pub fn is_textured(&self) -> bool {
        self.textures.is_some()
    }
}
