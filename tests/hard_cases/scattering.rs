//! Interfaces at every angle, glass in light from everywhere, shares that add up to anything.

use super::draw::Draw;
use super::{made, scene};
use glam::{DVec3, Vec3};
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Kajiya, LADDER, Whitted};
use halfdisk::lab::naive;
use halfdisk::materials::{Branch, Bsdf, Choice, Glass, Lambert, Mirror, Mixture, fresnel};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer};
use halfdisk::stats::Estimate;

/// Fresnel's share in the form with angles, which has no cosine to cancel.
fn by_angles(cos_i: f64, eta: f64) -> f64 {
    if eta == 1.0 {
        return 0.0;
    }
    let i = libm::acos(cos_i);
    let sin_t = libm::sin(i) / eta;
    if sin_t >= 1.0 {
        return 1.0;
    }
    let t = libm::asin(sin_t);
    if i < 1e-3 {
        return ((eta - 1.0) / (eta + 1.0)).powi(2);
    }
    let s = libm::sin(i - t) / libm::sin(i + t);
    let p = libm::tan(i - t) / libm::tan(i + t);
    0.5 * (s * s + p * p)
}

#[test]
fn a31_the_interface_at_every_angle() {
    let (mut worst, mut nan) = (0.0_f64, 0);
    for eta in [1.0, 1.33, 1.5, 2.4, 1.0 / 1.33, 1.0 / 1.5, 1.0 / 2.4] {
        for k in 0..=10_000 {
            let cos = f64::from(k) / 10_000.0;
            let ours = fresnel::dielectric(cos, eta);
            worst = worst.max((ours - by_angles(cos, eta)).abs());
            nan += usize::from(naive::fresnel(cos as f32, eta as f32).is_nan());
        }
    }
    for (eta, degrees, known) in [
        (1.5, 0.0, 0.04),
        (1.5, 45.0, 0.050_239_911),
        (1.5, 60.0, 0.089_186_713),
        (1.5, 90.0, 1.0),
        (1.0, 90.0, 0.0),
    ] {
        let cos = libm::cos(f64::to_radians(degrees)).max(0.0);
        let known = (fresnel::dielectric(cos, eta) - known).abs();
        assert!(known < 1e-5 || degrees == 90.0 && eta == 1.5 && known < 1e-3);
    }
    println!("70007 angles: ours off by {worst:.1e}, plainly {nan} NaN");
    assert!(worst < 1e-5 && nan > 10_000);
}

#[test]
fn a32_schlick_inside_glass_is_off_by_nearly_one() {
    let off = |eta: f64, cos: f64| {
        let exact = fresnel::dielectric(cos, eta);
        (f64::from(naive::schlick(cos as f32, eta as f32)) - exact).abs()
    };
    let worst = |eta: f64| {
        let each = (0..=10_000).map(|k| off(eta, f64::from(k) / 10_000.0));
        each.fold(0.0, f64::max)
    };
    let outside = [1.33, 1.5, 2.4].map(worst);
    let inside = worst(1.0 / 1.5);
    println!("Schlick's form off by {outside:.3?} from outside, {inside:.3} from inside");
    for (found, known) in outside.into_iter().zip([0.060, 0.036, 0.074]) {
        assert!((found - known).abs() < 1e-3, "{found}");
    }
    assert!((inside - 0.959).abs() < 2e-3);
    // Ours is exact, and 1 beyond the critical angle.
    let critical = (1.0_f64 - 1.0 / 2.25).sqrt();
    assert_eq!(fresnel::dielectric(critical - 1e-9, 1.0 / 1.5), 1.0);
    assert!(fresnel::dielectric(critical + 1e-4, 1.0 / 1.5) < 1.0);
}

fn along(scene: &Scene, integrator: &impl Integrator, ray: &Ray, n: u32) -> Estimate {
    let one = |i| {
        let mut tracer = Tracer::new(scene);
        f64::from(integrator.li(&mut tracer, ray, &Stream::new(33, 0, i)).g)
    };
    (0..n).map(one).collect()
}

/// A slab of glass between z = 4 and z = 5 before a sky of this radiance.
fn slab(ior: f32, sky: f32) -> Scene {
    scene(&format!(
        "background = {sky}\n[materials.glass]\nglass.ior = {ior}\n[[objects]]\n\
         material = 'glass'\nbox = {{ min = [-1e3, -1e3, 4], max = [1e3, 1e3, 5] }}\n"
    ))
}

#[test]
fn a33_no_direction_beyond_the_critical_angle_and_no_light_lost_before() {
    let glass = |ior| Glass { ior };
    let (mut plain, mut ours, mut worst) = (0, 0, 0.0_f32);
    for k in 0..=10_000 {
        let cos = k as f32 / 10_000.0;
        let wo = Vec3::new((1.0 - cos * cos).sqrt(), 0.0, -cos);
        let through = glass(1.5).specular(wo).transmitted;
        let direction = naive::refract(wo, Vec3::NEG_Z, 1.0 / 1.5);
        plain += usize::from(direction.is_nan());
        if let Some(Branch { wi, .. }) = through {
            ours += 1;
            worst = worst.max((wi.length() - 1.0).abs());
        }
    }
    println!("inside glass {ours} of 10001 get out, unit to {worst:.1e}; plainly {plain} are NaN");
    assert!(worst < 1e-6 && plain > 7000 && ours + plain >= 10_000);

    // Light that is the same from everywhere is not changed by glass of any kind.
    let tree = Whitted {
        max_depth: Whitted::MAX_DEPTH,
    };
    for ior in [0.1, 0.5, 1.0, 1.33, 1.5, 2.4, 10.0] {
        let sky = slab(ior, 1.0);
        for x in [0.0, 0.3, 0.9, 3.0] {
            let ray = Ray::new(Vec3::ZERO, Vec3::new(x, 0.1, 1.0).normalize());
            let path = along(&sky, &Kajiya { max_depth: 10_000 }, &ray, 200);
            // A path within glass that reflects nearly all of its light may be long, and is not cut.
            assert_eq!((path.mean(), path.variance()), (1.0, 0.0), "{ior} {x}");
            let whole = along(&sky, &tree, &ray, 1).mean();
            assert!(whole <= 1.0 + 1e-6, "{ior} {x}: {whole}");
        }
    }
    // A lamp behind the slab: T = (1 - F) / (1 + F), at normal incidence 12/13.
    let behind = scene(
        "[materials.glass]\nglass.ior = 1.5\n[[objects]]\nmaterial = 'glass'\n\
         box = { min = [-9, -9, 4], max = [9, 9, 5] }\n[[objects]]\nemits = 1\n\
         quad = { corner = [-9, -9, 9], u = [0, 18, 0], v = [18, 0, 0] }\n",
    );
    let ray = Ray::new(Vec3::ZERO, Vec3::Z);
    let through = along(&behind, &tree, &ray, 1).mean();
    let closed = 12.0 / 13.0;
    println!("through a slab {through:.7}, exact {closed:.7}");
    assert!((through - closed).abs() < 1e-6);
}

/// What goes through interfaces at z = 2, 2 + gap and so on, straight on.
fn stack(iors: &[f64], gap: f64) -> f64 {
    let mut text = String::new();
    for (i, ior) in iors.iter().enumerate() {
        let z = 2.0 + gap * i as f64;
        // Facing the camera: the medium of this index, relative to the one before, is behind.
        text += &format!(
            "[materials.m{i}]\nglass.ior = {ior}\n[[objects]]\nmaterial = 'm{i}'\n\
             quad = {{ corner = [-9, -9, {z}], u = [0, 18, 0], v = [18, 0, 0] }}\n"
        );
    }
    text +=
        "[[objects]]\nemits = 1\nquad = { corner = [-9, -9, 9], u = [0, 18, 0], v = [18, 0, 0] }\n";
    let tree = Whitted {
        max_depth: Whitted::MAX_DEPTH,
    };
    let ray = Ray::new(Vec3::ZERO, Vec3::Z);
    along(&scene(&text), &tree, &ray, 1).mean()
}

#[test]
fn a34_water_in_a_glass_is_one_surface_and_not_two() {
    let share = |a: f64, b: f64| {
        let f = ((a - b) / (a + b)).powi(2);
        (1.0 - f, f)
    };
    // One interface from glass to water, of the quotient of their indices.
    let one = stack(&[1.33 / 1.5], 1.0);
    let exact = share(1.5, 1.33).0;
    // Two, with a sliver of air between: light goes to and fro in it.
    let two = stack(&[1.0 / 1.5, 1.33], 1e-4);
    let ([t1, f1], [t2, f2]) = {
        let (a, b) = (share(1.5, 1.0), share(1.0, 1.33));
        ([a.0, a.1], [b.0, b.1])
    };
    let with_air = t1 * t2 / (1.0 - f1 * f2);
    println!("glass to water {one:.5} ({exact:.5}), by way of air {two:.5} ({with_air:.5})");
    assert!((one - exact).abs() < 1e-5 && (two - with_air).abs() < 1e-4);
    assert!((exact - 0.996_39).abs() < 1e-5 && exact - with_air > 0.05);
}

#[test]
fn a38_shares_that_add_up_to_nothing_or_to_one() {
    let [black, absorbed] = naive::absorption(0.0, 0.0);
    let too_much = naive::absorption(0.7, 0.7)[1];
    assert!(black.is_nan() && absorbed == 1.0 && too_much < 0.0);

    let mut draw = Draw::new(38, 0);
    let mut most = 0.0_f64;
    for shares in [
        [0.0, 0.0, 0.0],
        [1e-30, 0.0, 0.0],
        [0.0, 1e-38, 1e-30],
        [0.3, 0.7, 0.0],
        [0.0, 0.0, 1.0],
        [0.2, 0.3, 0.5],
    ] {
        let [kd, ks, kt] = shares.map(Rgb::grey);
        let m = Mixture {
            kd,
            ks,
            kt,
            ior: 1.5,
        };
        let total: f32 = shares.iter().sum();
        for rule in [Choice::Equal, Choice::ByMean, Choice::ByLuminance] {
            let sum: f64 = m.probabilities(rule).iter().sum();
            assert!((sum - 1.0).abs() < 1e-12 || total == 0.0, "{shares:?}");
        }
        let weights: Estimate = (0..20_000)
            .map(|_| {
                let next = m.scatter(
                    Vec3::new(0.6, 0.0, 0.8),
                    draw.one(),
                    [draw.one(), draw.one()],
                );
                assert!(total > 0.0 || next.is_none());
                next.map_or(0.0, |s| f64::from(s.weight.g))
            })
            .collect();
        let over = weights.mean() - f64::from(total);
        assert!(over.abs() <= 4.4 * weights.std_error() + 1e-6 * f64::from(total));
        most = most.max(over);
    }
    println!("seed 38: weights exceed what is not absorbed by at most {most:.1e}");
}

#[test]
fn a36_no_material_gives_back_more_than_it_gets() {
    let white = Rgb::WHITE;
    let mixture = Mixture {
        kd: Rgb::grey(0.3),
        ks: Rgb::grey(0.3),
        kt: Rgb::grey(0.4),
        ior: 1.5,
    };
    let all = [
        (Bsdf::Lambert(Lambert { albedo: white }), true),
        (Bsdf::Mirror(Mirror { reflectance: white }), true),
        (Bsdf::Glass(Glass { ior: 1.5 }), true),
        (Bsdf::Mixture(mixture), true),
        (Bsdf::glossy(white, 0.3), false),
        (Bsdf::rough_glass(1.5, 0.3), false),
    ];
    let mut draw = Draw::new(36, 0);
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    for (material, keeps_all) in all {
        for k in 1..=10 {
            let cos = k as f32 / 10.0;
            let sin = (1.0 - cos * cos).sqrt();
            let wo = Vec3::new(sin, 0.0, if k % 2 == 0 { cos } else { -cos });
            let read: Estimate = (0..20_000)
                .map(|_| {
                    let next = material.scatter(wo, draw.one(), [draw.one(), draw.one()]);
                    next.map_or(0.0, |s| f64::from(s.weight.g))
                })
                .collect();
            let slack = 4.4 * read.std_error() + 1e-6;
            most = most.max(read.mean());
            assert!(read.mean() <= 1.0 + slack, "{material:?} {cos}: {read:?}");
            if keeps_all {
                worst = worst.max((read.mean() - 1.0).abs());
                assert!(
                    (read.mean() - 1.0).abs() <= slack,
                    "{material:?} {cos}: {read:?}"
                );
            }
        }
    }
    println!("seed 36: furnaces off one by {worst:.1e}, at most {most:.6}");
}

#[test]
fn a37_no_light_comes_through_a_closed_surface() {
    // Normals are those of the geometry; there are no others to disagree with them.
    let corners = [DVec3::new(1., 1., 1.), DVec3::new(-1., -1., 1.)];
    let [a, b] = corners.map(|c| c * 2.0);
    let [c, d] = [DVec3::new(-1., 1., -1.), DVec3::new(1., -1., -1.)].map(|c| c * 2.0);
    let mut text = "background = 1\n".to_owned();
    for [a, b, c] in [[a, b, c], [a, d, b], [a, c, d], [b, d, c]] {
        let [a, b, c] = [a, b, c].map(|v| v.to_array());
        text += &format!(
            "[[objects]]\nmaterial = 'half'\ntriangle = {{ a = {a:?}, b = {b:?}, c = {c:?} }}\n"
        );
    }
    let dark = scene(&text);
    let mut draw = Draw::new(37, 0);
    for integrator in LADDER.map(|integrator| made(&integrator, &dark, 20)) {
        for i in 0..2000 {
            let ray = Ray::new(draw.cube(0.1), draw.direction());
            let li = integrator.li(&mut Tracer::new(&dark), &ray, &Stream::new(37, 0, i));
            assert!(li.is_black(), "{li:?}");
        }
    }
    println!("seed 37: 16 000 paths of eight kinds inside a tetrahedron: all black");
}
