//! A smooth interface between air and a transparent medium.

use super::mirror::reflect;
use super::{Branch, Specular, fresnel};
use crate::color::Rgb;
use glam::Vec3;

/// A smooth dielectric: the medium lies behind the surface, index 1 in front of it.
///
/// Radiance is not scaled by the squared index on refraction: that factor cancels for a camera and
/// lights on the same side, and with it a picture taken inside glass would be in other units.
#[derive(Clone, Copy, Debug)]
pub struct Glass {
    /// Index of refraction of the medium behind the surface.
    pub ior: f32,
}

impl Glass {
    /// The mirrored and the refracted direction; their weights add up to exactly one.
    pub fn specular(&self, wo: Vec3) -> Specular {
        let cos_o = f64::from(wo.z.abs()).min(1.0);
        let reflectance = round_to_grid(fresnel::dielectric(cos_o, eta(wo, self.ior)));
        let reflected = Branch {
            wi: reflect(wo),
            weight: Rgb::grey(reflectance),
        };
        let transmitted = refract(wo, self.ior).map(|wi| Branch {
            wi,
            weight: Rgb::grey(1.0 - reflectance),
        });
        Specular {
            reflected: (reflectance > 0.0).then_some(reflected),
            transmitted,
        }
    }
}

/// The direction in which `wo` is refracted by the plane `z = 0` with a medium of index `ior` behind
/// it; `None` under total reflection.
pub(super) fn refract(wo: Vec3, ior: f32) -> Option<Vec3> {
    let eta = eta(wo, ior);
    let cos_o = f64::from(wo.z.abs()).min(1.0);
    fresnel::cos_refracted(cos_o, eta).map(|cos_t| {
        let z = if wo.z >= 0.0 { -cos_t } else { cos_t };
        let xy = -wo.truncate().as_dvec2() / eta;
        xy.extend(z).as_vec3()
    })
}

/// The index on the far side of the surface over that on the side of `wo`.
pub(super) fn eta(wo: Vec3, ior: f32) -> f64 {
    let ior = f64::from(ior);
    if wo.z >= 0.0 { ior } else { 1.0 / ior }
}

/// The nearest multiple of 2^-24. Both it and its complement to one are `f32` numbers, so a ray
/// that splits loses no energy to rounding, however often it splits.
fn round_to_grid(share: f64) -> f32 {
    const GRID: f64 = 16_777_216.0;
    ((share * GRID).round() / GRID) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shares_add_up_exactly_and_directions_stay_unit() {
        let glass = Glass { ior: 1.5 };
        for k in 0..=1000 {
            let cos = k as f32 / 1000.0;
            let sin = (1.0 - cos * cos).sqrt();
            for wo in [Vec3::new(sin, 0.0, cos), Vec3::new(0.0, -sin, -cos)] {
                let s = glass.specular(wo);
                let share = |b: Option<Branch>| b.map_or(0.0, |b| f64::from(b.weight.r));
                assert_eq!(share(s.reflected) + share(s.transmitted), 1.0, "{wo}");
                for b in [s.reflected, s.transmitted].into_iter().flatten() {
                    assert!((b.wi.length() - 1.0).abs() < 2e-7, "{wo} -> {}", b.wi);
                }
            }
        }
    }

    #[test]
    fn light_bends_towards_the_normal_on_its_way_in() {
        let wo = Vec3::new(0.6, 0.0, 0.8);
        let inside = Glass { ior: 1.5 }
            .specular(wo)
            .transmitted
            .expect("no total reflection from outside");
        assert!((inside.wi.x + 0.4).abs() < 1e-7, "sin 0.6 / 1.5");
        assert!(inside.wi.z < -0.8);
    }

    #[test]
    fn glass_of_index_one_is_not_there() {
        let wo = Vec3::new(0.6, 0.0, 0.8);
        let s = Glass { ior: 1.0 }.specular(wo);
        assert!(s.reflected.is_none());
        let through = s.transmitted.expect("everything goes through");
        assert_eq!(through.weight, Rgb::WHITE);
        assert!((through.wi + wo).length() < 1e-7);
    }
}
