//! What surfaces do with light: samples against densities, energy against quadrature, and materials
//! that are wrong.

mod furnace;
mod limits;
mod mixture;

use crate::pairs::{BothSides, fault};
use glam::{DVec3, Vec3};
use halfdisk::color::Rgb;
use halfdisk::materials::{Bsdf, Glossy, Lambert, Mixture, RoughGlass};
use halfdisk::sampling::stream::{Purpose, Stream};
use std::f64::consts::TAU;

/// The `index`-th direction with its uniforms.
fn numbers(index: u32) -> (f32, [f32; 2]) {
    let stream = Stream::new(5, index, 0);
    let choice = stream.at(0, Purpose::Branch).one();
    (choice, stream.at(0, Purpose::Direction).two())
}

/// A unit direction with this cosine, away from the axes.
fn direction(cos: f32) -> Vec3 {
    let sin = (1.0 - f64::from(cos).powi(2)).sqrt();
    DVec3::new(sin * 0.8, sin * 0.6, f64::from(cos)).as_vec3()
}

fn glossy(alpha: f32) -> Bsdf<'static> {
    let reflectance = Rgb::WHITE;
    Bsdf::Glossy(Glossy { reflectance, alpha })
}

fn rough_glass(ior: f32, alpha: f32) -> Bsdf<'static> {
    Bsdf::RoughGlass(RoughGlass { ior, alpha })
}

fn drawn(material: &Bsdf, wo: Vec3, index: u32) -> Option<Vec3> {
    let (choice, u) = numbers(index);
    let next = material.scatter(wo, choice, u)?;
    next.pdf.map(|_| next.wi)
}

#[test]
fn samples_follow_their_densities() {
    let check = |name: &str, material: Bsdf, cos: f32| {
        let wo = direction(cos);
        let pdf = |wi| f64::from(material.pdf(wo, wi));
        let fault = fault(&BothSides, |i| drawn(&material, wo, i), pdf);
        assert_eq!(fault, None, "{name}, cos {cos}");
    };
    for alpha in [0.1, 0.3, 1.0] {
        for cos in [1.0, 0.7, 0.2, -0.5] {
            check(&format!("glossy {alpha}"), glossy(alpha), cos);
        }
        for cos in [1.0, 0.7, 0.2, -1.0, -0.8, -0.3] {
            check(
                &format!("rough glass {alpha}"),
                rough_glass(1.5, alpha),
                cos,
            );
        }
    }
    for cos in [0.6, -0.6] {
        check("thin", rough_glass(0.6, 0.3), cos);
    }
    let albedo = Rgb::grey(0.5);
    check("lambert", Bsdf::Lambert(Lambert { albedo }), 0.4);
    for (kd, cos) in [(0.5, 0.4), (0.9, -0.4)] {
        let [kd, ks, kt] = [kd, 0.06, 0.02].map(Rgb::grey);
        let ior = 1.5;
        check("mixture", Bsdf::Mixture(Mixture { kd, ks, kt, ior }), cos);
    }
}

#[test]
fn wrong_densities_are_rejected() {
    let wo = direction(0.7);
    let half = |wi: Vec3| (wo + wi).normalize();
    for alpha in [0.1, 0.3, 1.0] {
        let material = glossy(alpha);
        let right = |wi| f64::from(material.pdf(wo, wi));
        let reject = |what: &str, pdf: &(dyn Fn(Vec3) -> f64 + Sync)| {
            let fault = fault(&BothSides, |i| drawn(&material, wo, i), pdf);
            println!("{what}, {alpha}: {fault:?}");
            assert!(fault.is_some(), "{what}, {alpha}");
        };
        reject("7 % too much", &|wi| 1.07 * right(wi));
        reject("7 % too little", &|wi| right(wi) / 1.07);
        reject("no Jacobian", &|wi| {
            right(wi) * 4.0 * f64::from(wo.dot(half(wi)))
        });
        reject("D without π", &|wi| right(wi) * TAU / 2.0);
        reject("all normals", &|wi| {
            // As if facets were drawn by D cos instead of the visible ones.
            let Bsdf::Glossy(g) = material else {
                return 0.0;
            };
            let ggx = halfdisk::materials::ggx::Ggx {
                alpha: f64::from(g.alpha),
            };
            let h = half(wi).as_dvec3();
            let above = f64::from(u8::from(wi.z > 0.0));
            above * ggx.d(h) * h.z / (4.0 * wo.as_dvec3().dot(h))
        });

        let glass = rough_glass(1.5, alpha);
        let below = |factor: f64| {
            fault(
                &BothSides,
                |i| drawn(&glass, wo, i),
                |wi| f64::from(glass.pdf(wo, wi)) * if wi.z < 0.0 { factor } else { 1.0 },
            )
        };
        assert!(below(1.0 / 2.25).is_some(), "η² forgotten");
        assert!(below(0.93).is_some(), "7 % below");
    }
}

#[test]
fn what_scatter_says_is_what_f_and_pdf_say() {
    let mut materials = vec![
        rough_glass(0.6, 0.2),
        Bsdf::Lambert(Lambert {
            albedo: Rgb::grey(0.7),
        }),
        Bsdf::Mixture(Mixture {
            kd: Rgb::new(0.5, 0.1, 0.0),
            ks: Rgb::grey(0.2),
            kt: Rgb::new(0.0, 0.3, 0.3),
            ior: 1.5,
        }),
    ];
    for alpha in [0.1, 0.3, 1.0] {
        materials.extend([glossy(alpha), rough_glass(1.5, alpha)]);
    }
    for material in materials {
        for cos in [1.0, 0.7, 0.1, -0.1, -0.9] {
            let wo = direction(cos);
            for index in 0..2000 {
                let (choice, u) = numbers(index);
                let Some(next) = material.scatter(wo, choice, u) else {
                    continue;
                };
                let Some(pdf) = next.pdf else { continue };
                let again = material.pdf(wo, next.wi);
                assert!((pdf - again).abs() <= 1e-4 * pdf, "{pdf} {again}");
                let spelt_out = material.f(wo, next.wi) * next.wi.z.abs() / pdf;
                let off = spelt_out - next.weight;
                let near = off.channels().iter().all(|x| x.abs() < 1e-4);
                assert!(near, "{material:?} {wo} {next:?}: {spelt_out:?}");
            }
        }
    }
}

#[test]
fn f_is_reciprocal() {
    for alpha in [0.1, 0.3, 1.0] {
        for (a, b) in (0..2000).map(|i| (numbers(i).1, numbers(i + 5000).1)) {
            let [a, b] = [a, b].map(halfdisk::sampling::warps::sample_sphere);
            let (there, back) = (glossy(alpha).f(a, b).r, glossy(alpha).f(b, a).r);
            assert!((there - back).abs() <= 1e-5 * there, "{there} {back}");
            let glass = rough_glass(1.5, alpha);
            let n2 = |w: Vec3| if w.z > 0.0 { 1.0 } else { 2.25 };
            let (there, back) = (glass.f(a, b).r / n2(b), glass.f(b, a).r / n2(a));
            assert!(
                (there - back).abs() <= 1e-3 * there + 1e-5,
                "{a} {b} {there} {back}"
            );
        }
    }
}
