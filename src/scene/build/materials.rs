//! Checks of materials.

use crate::materials::{Glass, Lambert, Material, Mirror, Mixture};
use crate::scene::description as said;
use crate::scene::field::{Checked, Within, check};
use crate::scene::value::Albedo;
use std::collections::BTreeMap;

/// By how much shares that are meant to add up to 1 may miss it by rounding.
const ROUNDING: f64 = 1e-6;

/// Checks all materials of a file.
pub fn all(said: &BTreeMap<String, said::Material>) -> Checked<BTreeMap<String, Material>> {
    let checked = |(name, said): (&String, _)| Ok((name.clone(), one(said).within(&**name)?));
    said.iter().map(checked).collect()
}

fn one(said: &said::Material) -> Checked<Material> {
    use said::Material as Said;
    Ok(match *said {
        Said::Lambert { albedo } => Material::Lambert(Lambert {
            albedo: albedo.get()?,
        }),
        Said::Mirror { reflectance } => Material::Mirror(Mirror {
            reflectance: reflectance.get()?,
        }),
        Said::Glass { ior } => Material::Glass(Glass { ior: ior.get()? }),
        Said::Glossy {
            reflectance,
            roughness,
        } => Material::glossy(reflectance.get()?, roughness.get()?),
        Said::RoughGlass { ior, roughness } => Material::rough_glass(ior.get()?, roughness.get()?),
        Said::Mixture { kd, ks, kt, ior } => {
            add_up([kd, ks, kt]).within("mixture")?;
            Material::Mixture(Mixture {
                kd: kd.get()?,
                ks: ks.get()?,
                kt: kt.get()?,
                ior: ior.get()?,
            })
        }
    })
}

fn add_up(shares: [Albedo; 3]) -> Checked<()> {
    for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
        let total: f64 = shares.iter().map(|share| share.0[channel]).sum();
        let what = format_args!(
            "must have kd + ks + kt at most 1 in each channel, or it would make light, but in {name} \
             they add up to {total}"
        );
        check(total <= 1.0 + ROUNDING, what)?;
    }
    Ok(())
}
