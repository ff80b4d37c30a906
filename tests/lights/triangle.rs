//! Triangles and meshes as lamps.

use super::{GROUND, irradiance, polygon, scene};
use crate::checks::{CRITICAL, alike, of as of_estimate};
use crate::pairs::{Weights, deviates, follows};
use glam::{DVec3, Vec3};
use halfdisk::color::Rgb;
use halfdisk::geometry::{Surface, Triangle};
use halfdisk::integrators::{Integrator, Kajiya, NextEvent};
use halfdisk::lights::{Light, MeshLight, TriangleLight};
use halfdisk::sampling::spherical_triangle::SphericalTriangle;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::sampling::warps;
use halfdisk::scene::Tracer;
use halfdisk::stats::Estimate;
use std::f64::consts::FRAC_PI_2;

const UP: Surface = Surface {
    n: Vec3::Z,
    ..GROUND
};

fn lamp(corners: [[f32; 3]; 3]) -> Light {
    let [a, b, c] = corners.map(Vec3::from);
    Light::Triangle(TriangleLight {
        triangle: Triangle { a, b, c },
        radiance: Rgb::WHITE,
        two_sided: false,
    })
}

#[test]
fn lamberts_formula() {
    let above = [[-0.5, -0.5, 1.0], [0.0, 0.5, 1.5], [0.5, -0.5, 1.0]];
    let intersection = [[1.0, -1.0, -0.5], [1.0, 0.0, 2.0], [1.0, 1.0, -0.5]];
    let far = above.map(|corner| corner.map(|x| 500.0 * x + 1e6));
    let corners = far.map(|c| DVec3::from(c.map(f64::from)));
    for (name, light, truth) in [
        ("above", lamp(above), 0.334_977_138),
        ("crossing the horizon", lamp(intersection), 0.312_777_308),
        ("far", lamp(far), polygon(&corners, DVec3::Z)),
    ] {
        let e = irradiance(&light, &UP, 400_000);
        println!("{name}: {} for {truth}, z {:+.2}", e.mean(), e.z(truth));
        let slack = CRITICAL * e.std_error() + 1e-5 * truth;
        assert!(
            (e.mean() - truth).abs() <= slack,
            "{name}: {e:?} for {truth}"
        );
        // As a mesh of one triangle, by area: the same light, with more noise.
        let Light::Triangle(one) = &light else {
            panic!()
        };
        let mesh = MeshLight::new(vec![one.triangle], Rgb::WHITE).unwrap();
        let by_area = irradiance(&Light::Mesh(mesh), &UP, 400_000);
        let slack = CRITICAL * by_area.std_error() + 1e-5 * truth;
        assert!(
            (by_area.mean() - truth).abs() <= slack,
            "{name}: {by_area:?}"
        );
        // Seen from its back it is dark.
        let back = TriangleLight {
            triangle: Triangle {
                b: one.triangle.c,
                c: one.triangle.b,
                ..one.triangle
            },
            ..*one
        };
        assert_eq!(irradiance(&Light::Triangle(back), &UP, 100).mean(), 0.0);
    }
}

#[test]
fn points_of_a_triangle_are_uniform_in_area() {
    let (area, pdf) = (0.25, warps::pdf_triangle(0.25));
    // The weights of two corners span twice the area of a triangle of them.
    let per_weights = |_| pdf * 2.0 * area;
    let sample = |u| warps::sample_triangle(u).map(f64::from);
    follows("points of a triangle", &Weights, sample, per_weights);
    let rootless = |[u, v]: [f32; 2]| [u * (1.0 - v), u * v].map(f64::from);
    deviates("without the root", "chi2", &Weights, rootless, per_weights);
}

#[test]
fn directions_of_a_triangle_are_uniform_in_solid_angle() {
    for (name, corners) in [
        ("an octant", [DVec3::X, DVec3::Y, DVec3::Z]),
        (
            "near",
            [[-0.3, -0.2, 0.2], [1.0, 0.0, 0.1], [0.0, 0.9, 0.3]].map(DVec3::from),
        ),
        (
            "thin",
            [[-3.0, 0.1, 1.0], [3.0, 0.1, 1.0], [0.0, 0.2, 1.0]].map(DVec3::from),
        ),
        (
            "small",
            [[70.0, 0.0, 100.0], [71.0, 0.0, 100.0], [70.0, 1.0, 101.0]].map(DVec3::from),
        ),
    ] {
        let seen = SphericalTriangle::new(corners).unwrap();
        let [a, b, c] = corners;
        let volume = a.dot(b.cross(c));
        // Solid angle per weights of the second and third corner.
        let density = |[u, v]: [f64; 2]| {
            let p = a + u * (b - a) + v * (c - a);
            seen.pdf() * volume.abs() / libm::pow(p.length_squared(), 1.5)
        };
        let sample = |u| {
            let w = seen.sample(u);
            let all = [w.dot(b.cross(c)), w.dot(c.cross(a)), w.dot(a.cross(b))].map(|x| x / volume);
            let sum: f64 = all.iter().sum();
            [all[1] / sum, all[2] / sum]
        };
        follows(name, &Weights, sample, density);
        // Of what is far away the density is nearly that of its points.
        if name != "small" {
            let by_area = |u| warps::sample_triangle(u).map(f64::from);
            deviates(name, "chi2", &Weights, by_area, density);
        }
    }
    // An octant is an eighth of the sphere, and in either order.
    let octant = SphericalTriangle::new([DVec3::X, DVec3::Z, DVec3::Y]).unwrap();
    assert!((octant.solid_angle() - FRAC_PI_2).abs() < 1e-15);
    assert!((octant.pdf() * octant.solid_angle() - 1.0).abs() < 1e-15);
    // Edge-on, and with the eye in a corner.
    assert!(SphericalTriangle::new([DVec3::X, DVec3::Y, -DVec3::X - DVec3::Y]).is_none());
    assert!(SphericalTriangle::new([DVec3::ZERO, DVec3::Y, DVec3::X]).is_none());
}

#[test]
fn a_mesh_is_the_sum_of_its_triangles() {
    // A tent of four triangles of different size, open below, and one without area that is never
    // chosen.
    let top = [0.1, 1.0, 0.2];
    let rim = [
        [-1.0, 0.8, -0.5],
        [0.7, 0.6, -0.9],
        [1.0, 0.9, 0.8],
        [-0.6, 0.7, 1.2],
    ];
    let mut sides: Vec<Triangle> = (0..4)
        .map(|i| [top, rim[(i + 1) % 4], rim[i]].map(Vec3::from))
        .map(|[a, b, c]| Triangle { a, b, c })
        .map(|t| match (t.b - t.a).cross(t.c - t.a).y > 0.0 {
            true => Triangle {
                b: t.c,
                c: t.b,
                ..t
            },
            false => t,
        })
        .collect();
    let truth: f64 = sides
        .iter()
        .map(|t| polygon(&[t.a, t.b, t.c].map(|v| v.as_dvec3()), DVec3::Y))
        .sum();
    sides.insert(
        2,
        Triangle {
            a: Vec3::Y,
            b: Vec3::Y,
            c: Vec3::X,
        },
    );
    let mesh = Light::Mesh(MeshLight::new(sides.clone(), Rgb::WHITE).unwrap());
    let e = irradiance(&mesh, &GROUND, 400_000);
    println!("tent: {} for {truth}, z {:+.2}", e.mean(), e.z(truth));
    assert!(e.z(truth).abs() <= CRITICAL, "{e:?} for {truth}");
    // The mistake of a triangle chosen without regard to its area.
    let proper: Vec<&Triangle> = sides.iter().filter(|t| t.is_proper()).collect();
    let total: f64 = proper.iter().map(|t| t.area()).sum();
    let wrong: Estimate = (0..400_000)
        .map(|i| {
            let mut u = Stream::new(9, i, 0).at(0, Purpose::LightPoint);
            let t = proper[(u.one() * 4.0) as usize];
            let [b, c] = warps::sample_triangle(u.two());
            let p = (t.a * (1.0 - b - c) + t.b * b + t.c * c).as_dvec3();
            let n = (t.b - t.a).cross(t.c - t.a).normalize().as_dvec3();
            total * p.y * -n.dot(p) / p.length_squared().powi(2)
        })
        .collect();
    assert!(wrong.z(truth).abs() > CRITICAL, "{wrong:?}");
    assert!(MeshLight::new(Vec::new(), Rgb::WHITE).is_none());
    assert!(MeshLight::new(vec![sides[2]], Rgb::WHITE).is_none());
}

#[test]
fn triangles_and_meshes_shine_in_scenes() {
    let room = scene(
        "[[objects]]\nmaterial = 'half'\nquad = { corner = [-4, -1, 4], u = [8, 0, 0], v = [0, 0, -8] }\n\
         [[objects]]\nemits = 4\ntriangle = { a = [1, 0, 1], b = [1, 0.2, -1], c = [3, 0.5, 1] }\n\
         [[objects]]\nemits = 2\nbumpy_sphere = { center = [-2, 0, 1], radius = 0.5, columns = 16, rows = 12 }",
    );
    assert_eq!(room.lights.len(), 2, "a mesh is one light");
    assert!(
        matches!(room.lights[0], Light::Triangle(_)) && matches!(room.lights[1], Light::Mesh(_))
    );
    let max_depth = 3;
    for toward in [Vec3::new(0.1, -1.0, 0.1), Vec3::new(-1.0, -1.0, 0.5)] {
        let ray = halfdisk::geometry::Ray::new(Vec3::ZERO, toward.normalize());
        let of = |integrator: &dyn Integrator, seed| -> Estimate {
            let mut tracer = Tracer::new(&room);
            (0..200_000)
                .map(|i| f64::from(integrator.li(&mut tracer, &ray, &Stream::new(seed, i, 0)).g))
                .collect()
        };
        let walk = of(&Kajiya { max_depth }, 1);
        let asking = of(&NextEvent { max_depth }, 2);
        alike(
            "a walk and asking",
            of_estimate(&walk),
            of_estimate(&asking),
            0.05,
        );
    }
}
