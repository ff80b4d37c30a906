//! A shape, a material and a light of your own, in a scene that is described in code.
//!
//! `cargo run --release --example your_own_parts` writes `out/your_own_parts.png`.

#![allow(clippy::print_stdout)]

use glam::{DVec3, Vec3};
use halfdisk::color::Rgb;
use halfdisk::geometry::{Aabb, InstancedShape, Intersection, Ray, Surface};
use halfdisk::integrators::Path;
use halfdisk::lights::{Arrival, CustomLight};
use halfdisk::materials::CustomBsdf;
use halfdisk::numeric;
use halfdisk::output::{self, Display, Provenance};
use halfdisk::render::{Options, render};
use halfdisk::sampling::frame::Frame;
use halfdisk::scene::build::build;
use halfdisk::scene::description::{Camera, Description, Film, Light, Material, Object, Shape};
use halfdisk::scene::value::{Albedo, Radiance, Triple};
use std::f32::consts::TAU;
use std::sync::Arc;

/// A disk of radius 1 around the origin; it faces along `+z`.
#[derive(Debug)]
struct Disk;

impl InstancedShape for Disk {
    fn bounds(&self) -> Aabb {
        Aabb::of([Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, 1.0, 0.0)])
    }

    fn intersect(&self, ray: &Ray) -> Option<Intersection> {
        let t = -ray.origin.z / ray.direction.z;
        let p = ray.at(t);
        let inside = p.x * p.x + p.y * p.y <= 1.0;
        // The texture runs once across the disk.
        let [u, v] = [p.x, p.y].map(|x| 0.5 + 0.5 * x);
        (inside && t > 0.0 && t <= ray.t_max).then(|| Intersection::new(t, u, v))
    }

    fn surface(&self, ray: &Ray, hit: Intersection) -> Surface {
        let p = ray.at(hit.t);
        Surface {
            // On the disk for sure: nothing is rounded across it.
            p: Vec3::new(p.x, p.y, 0.0),
            error: Vec3::ZERO,
            n: Vec3::Z,
            time: ray.time,
        }
    }
}

/// A lobe around the mirror direction: `f = reflectance (n + 2) / 2π cos^n`, with the angle to that
/// direction.
///
/// Source: Lafortune, Willems, Using the Modified Phong Reflectance Model for Physically Based Rendering
/// (Report CW 197, KU Leuven 1994).
#[derive(Debug)]
struct Phong {
    reflectance: Rgb,
    exponent: f32,
}

impl Phong {
    /// The cosine between `wi` and the mirror direction, if both directions are on one side.
    fn cos(wo: Vec3, wi: Vec3) -> Option<f32> {
        let mirrored = Vec3::new(-wo.x, -wo.y, wo.z);
        (wo.z * wi.z > 0.0).then(|| wi.dot(mirrored).max(0.0))
    }
}

impl CustomBsdf for Phong {
    fn f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        Phong::cos(wo, wi).map_or(Rgb::BLACK, |cos| {
            self.reflectance * ((self.exponent + 2.0) / TAU * libm::powf(cos, self.exponent))
        })
    }

    fn sample(&self, wo: Vec3, _: f32, [u, v]: [f32; 2]) -> Option<Vec3> {
        let cos = libm::powf(1.0 - u, 1.0 / (self.exponent + 1.0));
        let sin = (1.0 - cos * cos).max(0.0).sqrt();
        let (y, x) = numeric::sin_cos(TAU * v);
        let lobe = Frame::new(Vec3::new(-wo.x, -wo.y, wo.z));
        let wi = lobe.to_world(Vec3::new(sin * x, sin * y, cos)).normalize();
        (wi.z * wo.z > 0.0).then_some(wi)
    }

    fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        Phong::cos(wo, wi).map_or(0.0, |cos| {
            (self.exponent + 1.0) / TAU * libm::powf(cos, self.exponent)
        })
    }

    fn albedo(&self) -> Rgb {
        self.reflectance
    }
}

/// A spot light: a point that shines into a cone, and ever less towards its rim.
#[derive(Debug)]
struct Spot {
    place: DVec3,
    axis: DVec3,
    cos_rim: f64,
    /// In W/sr, along the axis.
    intensity: f64,
}

impl CustomLight for Spot {
    fn sample(&self, p: DVec3, _: [f32; 2]) -> Option<Arrival> {
        let way = self.place - p;
        let cos = -(way.normalize().dot(self.axis));
        let inside = ((cos - self.cos_rim) / (1.0 - self.cos_rim)).max(0.0);
        let irradiance = self.intensity * inside * inside / way.length_squared();
        (irradiance > 0.0).then(|| Arrival {
            wi: way.normalize().as_vec3(),
            distance: way.length() as f32,
            irradiance: Rgb::grey(irradiance as f32),
        })
    }

    fn fluence(&self) -> f64 {
        self.intensity
    }
}

/// A plate of one's own on a floor, under a spot.
fn description() -> Description {
    let floor = Shape::Quad {
        corner: Triple([-6.0, 0.0, 6.0]),
        u: Triple([12.0, 0.0, 0.0]),
        v: Triple([0.0, 0.0, -12.0]),
    };
    let grey = Material::Lambert {
        albedo: Albedo([0.5, 0.48, 0.45]).into(),
    };
    let phong = Phong {
        reflectance: Rgb::new(0.9, 0.6, 0.3),
        exponent: 60.0,
    };
    let mut plate = Object {
        material: Some("phong".to_owned()),
        ..Shape::Custom(Arc::new(Disk)).into()
    };
    plate.transform.translate = Triple([0.0, 1.2, 0.0]);
    let spot = Spot {
        place: DVec3::new(1.5, 3.5, 3.0),
        axis: DVec3::new(-1.0, -2.0, -2.2).normalize(),
        cos_rim: 0.9,
        intensity: 60.0,
    };
    Description {
        name: "your own".to_owned(),
        background: Some(Radiance([0.02, 0.03, 0.05])),
        camera: Camera {
            from: Triple([0.0, 1.5, 6.0]),
            to: Triple([0.0, 0.9, 0.0]),
            ..Camera::default()
        },
        film: Film { size: [320, 240] },
        materials: [
            ("grey".to_owned(), grey),
            ("phong".to_owned(), Material::Custom(Arc::new(phong))),
        ]
        .into(),
        objects: vec![
            Object {
                material: Some("grey".to_owned()),
                ..floor.into()
            },
            plate,
        ],
        lights: vec![Light::Custom(Arc::new(spot))],
        ..Description::default()
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let scene = build(description(), None)?;
    let options = Options {
        spp: 64,
        ..Options::default()
    };
    let rendered = render(&scene, &Path::new(6), &options, &());
    let facts = Provenance::new(&scene, "path", 6, options.spp.into(), options.seed);
    let path = std::path::Path::new("out/your_own_parts.png");
    output::write(path, &rendered.film, Display::Radiance, &facts)?;
    println!("{}", path.display());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use halfdisk::integrators::{Combine, Integrator, NextEvent, Whitted};
    use halfdisk::sampling::mis::Heuristic;
    use halfdisk::sampling::stream::{Purpose, Stream};
    use halfdisk::scene::Tracer;
    use halfdisk::stats::Estimate;

    fn read(integrator: &impl Integrator, s: f32, t: f32, samples: u32) -> Estimate {
        let scene = build(description(), None).unwrap();
        let ray = scene.camera.ray(s, t);
        let mut tracer = Tracer::new(&scene);
        let one = |i| f64::from(integrator.li(&mut tracer, &ray, &Stream::new(1, i, 0)).g);
        (0..samples).map(one).collect()
    }

    #[test]
    fn the_floor_under_the_spot_is_as_bright_as_the_formula_says() {
        // Where the ray meets the floor, and what the spot gives there.
        let scene = build(description(), None).unwrap();
        let ray = scene.camera.ray(0.5, 0.75);
        let eye = DVec3::new(0.0, 1.5, 6.0);
        let d = ray.direction.as_dvec3();
        let p = eye - d * (eye.y / d.y);
        let to_light = DVec3::new(1.5, 3.5, 3.0) - p;
        let axis = DVec3::new(-1.0, -2.0, -2.2).normalize();
        let inside = ((-to_light.normalize().dot(axis) - 0.9) / 0.1).max(0.0);
        let irradiance = 60.0 * inside * inside / to_light.length_squared();
        let exact = 0.48 / std::f64::consts::PI * irradiance * to_light.normalize().y;
        let seen = read(&Whitted { max_depth: 2 }, 0.5, 0.75, 1).mean();
        assert!(
            exact > 0.01 && (seen / exact - 1.0).abs() < 1e-4,
            "{seen} {exact}"
        );
    }

    #[test]
    fn all_integrators_agree_on_the_plate() {
        let max_depth = 4;
        let heuristic = Heuristic::Power;
        let combine = Combine {
            max_depth,
            heuristic,
        };
        let truth = read(&NextEvent { max_depth }, 0.5, 0.45, 60_000);
        assert!(truth.mean() > 0.01, "{}", truth.mean());
        for other in [
            read(&combine, 0.5, 0.45, 60_000),
            read(&Path::new(max_depth), 0.5, 0.45, 60_000),
        ] {
            let error = truth.std_error().hypot(other.std_error());
            let off = (other.mean() - truth.mean()).abs();
            assert!(
                off < 4.0 * error && error < 0.01 * truth.mean(),
                "{off} {error}"
            );
        }
    }

    #[test]
    fn the_lobe_is_sampled_as_its_density_says_and_makes_no_light() {
        let phong = Phong {
            reflectance: Rgb::WHITE,
            exponent: 20.0,
        };
        for wo in [
            Vec3::Z,
            Vec3::new(0.6, 0.0, 0.8),
            Vec3::new(0.0, 0.96, -0.28),
        ] {
            let (mut reciprocal, mut albedo) = (Estimate::new(), Estimate::new());
            for i in 0..200_000 {
                let mut numbers = Stream::new(2, i, 0).at(0, Purpose::Direction);
                let wi = phong.sample(wo, 0.5, numbers.two());
                let near = |wi: &Vec3| Phong::cos(wo, *wi).is_some_and(|cos| cos > 0.9);
                let density = |wi: Vec3| 1.0 / f64::from(phong.pdf(wo, wi));
                reciprocal.add(wi.filter(near).map_or(0.0, density));
                let weight = |wi: Vec3| phong.f(wo, wi).g * wi.z.abs() / phong.pdf(wo, wi);
                albedo.add(f64::from(wi.map_or(0.0, weight)));
            }
            // The mean of 1 / pdf is the solid angle of the directions that count: a cap, if all of it is
            // above the surface.
            let cap = f64::from(TAU) * 0.1;
            let (mean, error) = (reciprocal.mean(), reciprocal.std_error());
            if wo.z.abs() > 0.5 {
                assert!((mean - cap).abs() < 4.4 * error, "{wo}: {mean} {cap}");
            }
            assert!(albedo.mean() <= 1.0 + 4.0 * albedo.std_error(), "{wo}");
        }
    }
}
