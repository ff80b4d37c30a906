//! How long rays take: each shape, the tree against the plain loop, a mesh from near and far.
#![allow(missing_docs, clippy::expect_used)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec3, Vec3};
use halfdisk::geometry::{
    Bvh, Moving, PreparedRay, Quad, Ray, Shape, Sphere, Triangle, brute_force,
};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::sampling::warps;
use halfdisk::scene::{Tracer, gallery};
use std::hint::black_box;

const RAYS: u32 = 4096;

/// Rays from a sphere around `center` to points of a ball in its middle.
fn inwards(center: Vec3, from: f32, to: f32) -> Vec<Ray> {
    let ray = |i| {
        let mut numbers = Stream::new(1, i, 0).at(0, Purpose::Direction);
        let origin = center + warps::sample_sphere(numbers.two()) * from;
        let radius = to * libm::cbrtf(numbers.one());
        let target = center + warps::sample_sphere(numbers.two()) * radius;
        Ray::new(origin, (target - origin).normalize())
    };
    (0..RAYS).map(ray).collect()
}

/// A sphere, a quad and a triangle, each about one unit wide.
fn kinds(center: Vec3) -> [(&'static str, Shape); 3] {
    let c = center.as_dvec3();
    let quad = Quad::new(
        c - 0.5,
        DVec3::new(1.0, 0.2, 0.0),
        DVec3::new(0.1, 1.0, 0.3),
    );
    let [a, b] = [Vec3::new(1.0, 0.2, 0.0), Vec3::new(0.1, 1.0, 0.3)];
    let triangle = Triangle {
        a: center - (a + b) / 3.0,
        b: center + a,
        c: center + b,
    };
    let sphere = Sphere::new(center, 0.5);
    [
        ("sphere", Shape::Sphere(sphere)),
        ("quad", quad.map(Shape::Quad).expect("it has an area")),
        ("triangle", Shape::Triangle(triangle)),
    ]
}

fn shapes(c: &mut Criterion) {
    let mut group = c.benchmark_group("shape");
    group.throughput(Throughput::Elements(RAYS.into()));
    let rays: Vec<PreparedRay> = inwards(Vec3::ZERO, 5.0, 0.7)
        .iter()
        .map(PreparedRay::from)
        .collect();
    for (name, shape) in kinds(Vec3::ZERO) {
        let cross = |ray| shape.intersect(ray, f32::MAX).is_some();
        group.bench_function(name, |b| {
            b.iter(|| rays.iter().filter(|r| cross(r)).count())
        });
    }
    group.finish();
}

fn trees(c: &mut Criterion) {
    let mut group = c.benchmark_group("tree");
    group.throughput(Throughput::Elements(RAYS.into()));
    let rays = inwards(Vec3::ZERO, 10.0, 4.0);
    for count in [16, 256] {
        let place = |i| {
            let mut numbers = Stream::new(2, i, 0).at(0, Purpose::Direction);
            warps::sample_sphere(numbers.two()) * (4.0 * numbers.one())
        };
        let shapes: Vec<Shape> = (0..count)
            .map(|i| kinds(place(i))[i as usize % 3].1)
            .collect();
        let tree = Bvh::new(&shapes);
        group.bench_function(format!("{count} shapes, plain loop"), |b| {
            b.iter(|| {
                rays.iter()
                    .filter(|r| brute_force(&shapes, r).is_some())
                    .count()
            });
        });
        group.bench_function(format!("{count} shapes, first"), |b| {
            b.iter(|| rays.iter().filter(|r| tree.first_hit(r).is_some()).count());
        });
        group.bench_function(format!("{count} shapes, any"), |b| {
            b.iter(|| rays.iter().filter(|r| tree.occluded(r)).count());
        });
        let moving: Vec<Moving> = shapes
            .iter()
            .filter_map(|s| Moving::new(*s, Vec3::X))
            .collect();
        let tree = Bvh::new(&moving);
        group.bench_function(format!("{count} moving shapes, first"), |b| {
            b.iter(|| {
                rays.iter()
                    .filter(|r| tree.first_hit(&r.at_time(0.5)).is_some())
                    .count()
            });
        });
    }
    group.finish();
}

fn meshes(c: &mut Criterion) {
    let scene = gallery::load("mesh").expect("a scene of the gallery");
    let mut tracer = Tracer::new(&scene);
    let mut group = c.benchmark_group("mesh");
    group.throughput(Throughput::Elements(RAYS.into()));
    let side = 64;
    let at = |i: u32| (i as f32 + 0.5) / side as f32;
    let camera: Vec<Ray> = (0..RAYS)
        .map(|i| scene.camera.ray(at(i % side), at(i / side)))
        .collect();
    // Around the bumpy sphere, in coordinates relative to the camera.
    let incoherent = inwards(Vec3::new(0.0, -78.0, 1080.0), 200.0, 130.0);
    let runs = [("camera rays", camera), ("incoherent rays", incoherent)];
    for (name, rays) in &runs {
        group.bench_function(*name, |b| {
            b.iter(|| {
                for ray in rays {
                    black_box(tracer.secondary_ray(ray));
                }
            });
        });
        group.bench_function(format!("{name}, occlusion"), |b| {
            b.iter(|| rays.iter().filter(|ray| tracer.unoccluded(ray)).count());
        });
    }
    group.finish();
}

criterion_group!(all, shapes, trees, meshes);
criterion_main!(all);
