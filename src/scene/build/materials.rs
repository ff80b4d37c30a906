//! Checks of materials.

use crate::color::Rgb;
use crate::materials::{Bsdf, Glass, Lambert, Material, Mirror, Mixture, Texture};
use crate::scene::description as said;
use crate::scene::field::{Checked, Within, check};
use crate::scene::parts::Parts;
use crate::scene::textures::Textured;
use crate::scene::value::Albedo;
use std::collections::BTreeMap;
use std::sync::Arc;

/// By how much shares that are meant to add up to 1 may miss it by rounding.
const ROUNDING: f64 = 1e-6;

impl Parts<'_> {
    /// Checks all materials of a file.
    pub(super) fn add_materials(&mut self, said: &BTreeMap<String, said::Material>) -> Checked<()> {
        for (name, said) in said {
            let material = self.material(said).within(&**name)?;
            self.materials.insert(name.clone(), material);
        }
        Ok(())
    }

    fn material(&mut self, said: &said::Material) -> Checked<Material> {
        use said::Material as Said;
        let mut textures = [None, None, None];
        let [first, second, third] = &mut textures;
        let bsdf = match said {
            Said::Custom(bsdf) => return Ok(Material::custom(Arc::clone(bsdf))),
            Said::Lambert { albedo } => Bsdf::Lambert(Lambert {
                albedo: self
                    .color(albedo, first)
                    .within("albedo")
                    .within("lambert")?,
            }),
            Said::Mirror { reflectance } => Bsdf::Mirror(Mirror {
                reflectance: self
                    .color(reflectance, first)
                    .within("reflectance")
                    .within("mirror")?,
            }),
            Said::Glass { ior } => Bsdf::Glass(Glass { ior: ior.get()? }),
            Said::Glossy {
                reflectance,
                roughness,
            } => {
                let reflectance = self
                    .color(reflectance, first)
                    .within("reflectance")
                    .within("glossy")?;
                Bsdf::glossy(reflectance, roughness.get()?)
            }
            Said::RoughGlass { ior, roughness } => Bsdf::rough_glass(ior.get()?, roughness.get()?),
            Said::Mixture { kd, ks, kt, ior } => {
                let mixture = Mixture {
                    kd: self.color(kd, first).within("kd").within("mixture")?,
                    ks: self.color(ks, second).within("ks").within("mixture")?,
                    kt: self.color(kt, third).within("kt").within("mixture")?,
                    ior: ior.get()?,
                };
                add_up([(kd, mixture.kd), (ks, mixture.ks), (kt, mixture.kt)]).within("mixture")?;
                Bsdf::Mixture(mixture)
            }
        };
        Ok(Material::textured(bsdf, textures))
    }

    /// The brightest value of a colour; its texture, if it is one, goes to `texture`.
    fn color(
        &mut self,
        said: &Textured<Albedo>,
        texture: &mut Option<Arc<dyn Texture>>,
    ) -> Checked<Rgb> {
        let color = said.build(self)?;
        *texture = color.texture().cloned();
        Ok(color.brightest())
    }
}

fn add_up(shares: [(&Textured<Albedo>, Rgb); 3]) -> Checked<()> {
    for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
        let most = |(said, brightest): &(&Textured<Albedo>, Rgb)| match said {
            Textured::Constant(albedo) => albedo.0[channel],
            _ => f64::from(brightest.channels()[channel]),
        };
        let total: f64 = shares.iter().map(most).sum();
        let what = format_args!(
            "must have kd + ks + kt at most 1 in each channel, or it would make light, but in {name} \
             they add up to {total}"
        );
        check(total <= 1.0 + ROUNDING, what)?;
    }
    Ok(())
}
