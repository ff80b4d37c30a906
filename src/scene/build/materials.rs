//! Checks of materials.

use super::super::description as said;
use super::super::field::{self, Checked, Field, exactly_one};
use crate::materials::{Glass, Lambert, Material, Mirror, Mixture};
use std::collections::BTreeMap;

/// By how much shares that are meant to add up to 1 may miss it by rounding.
const ROUNDING: f64 = 1e-6;

/// Checks all materials of a file.
pub fn all(
    field: &Field,
    said: &BTreeMap<String, said::Material>,
) -> Checked<BTreeMap<String, Material>> {
    said.iter()
        .map(|(name, m)| Ok((name.clone(), one(&field.key(name), m)?)))
        .collect()
}

fn one(field: &Field, said: &said::Material) -> Checked<Material> {
    let at = |kind: &str| field.key(kind);
    let lambert = said.lambert.as_ref().map(|l| {
        let albedo = field::reflectance(&at("lambert").key("albedo"), l.albedo)?;
        Ok(Material::Lambert(Lambert { albedo }))
    });
    let mirror = said.mirror.as_ref().map(|m| {
        let field = at("mirror").key("reflectance");
        let reflectance = field::reflectance(&field, m.reflectance)?;
        Ok(Material::Mirror(Mirror { reflectance }))
    });
    let glass = said.glass.as_ref().map(|g| {
        let ior = index(&at("glass").key("ior"), g.ior)?;
        Ok(Material::Glass(Glass { ior }))
    });
    let glossy = said.glossy.as_ref().map(|g| {
        let field = at("glossy");
        let reflectance = field::reflectance(&field.key("reflectance"), g.reflectance)?;
        let alpha = roughness(&field.key("roughness"), g.roughness)?;
        Ok(Material::glossy(reflectance, alpha))
    });
    let rough_glass = said.rough_glass.as_ref().map(|g| {
        let field = at("rough_glass");
        let ior = index(&field.key("ior"), g.ior)?;
        let alpha = roughness(&field.key("roughness"), g.roughness)?;
        Ok(Material::rough_glass(ior, alpha))
    });
    let mixture = said.mixture.as_ref().map(|m| mixture(&at("mixture"), m));
    let kinds = vec![
        ("lambert", lambert),
        ("mirror", mirror),
        ("glass", glass),
        ("glossy", glossy),
        ("rough_glass", rough_glass),
        ("mixture", mixture),
    ];
    exactly_one(field, "kind of material", kinds)?
}

fn mixture(field: &Field, said: &said::Mixture) -> Checked<Material> {
    let kd = field::reflectance(&field.key("kd"), said.kd)?;
    let ks = field::reflectance(&field.key("ks"), said.ks)?;
    let kt = field::reflectance(&field.key("kt"), said.kt)?;
    for (channel, name) in ["red", "green", "blue"].into_iter().enumerate() {
        let total = said.kd.0[channel] + said.ks.0[channel] + said.kt.0[channel];
        if total > 1.0 + ROUNDING {
            return Err(field.problem(format!(
                "must have kd + ks + kt at most 1 in each channel, or it would make light, \
                 but in {name} they add up to {total}"
            )));
        }
    }
    let ior = index(&field.key("ior"), said.ior)?;
    Ok(Material::Mixture(Mixture { kd, ks, kt, ior }))
}

fn index(field: &Field, ior: f64) -> Checked<f32> {
    if (0.1..=10.0).contains(&ior) {
        Ok(ior as f32)
    } else {
        Err(field.problem(format!("must be between 0.1 and 10, not {ior}")))
    }
}

fn roughness(field: &Field, alpha: f64) -> Checked<f32> {
    if alpha > 0.0 && alpha <= 1.0 {
        Ok(alpha as f32)
    } else {
        Err(field.problem(format!(
            "must be greater than 0 and at most 1, not {alpha}; \
             perfectly smooth surfaces are `mirror` and `glass`"
        )))
    }
}
