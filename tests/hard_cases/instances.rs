//! Meshes in many places, stored once: rays meet them where they meet copies, and leave them for good.

use super::draw::Draw;
use glam::{DMat3, DQuat, DVec3, Vec3};
use halfdisk::geometry::{
    Bvh, Instance, PreparedRay, Primitive, Ray, Shape, SharedMesh, Surface, Transformed, Triangle,
};
use halfdisk::scene::{Scene, Tracer, gallery, read::Source};
use std::sync::Arc;

/// Some triangles of different sizes around the origin.
fn mesh(draw: &mut Draw) -> Arc<SharedMesh> {
    let triangle = |_| {
        let size = draw.power(-2.0, 0.0);
        let center = draw.cube(1.0);
        let [a, b, c] = [(); 3].map(|()| center + draw.cube(size));
        Triangle { a, b, c }
    };
    let all = (0..40).map(triangle).filter(Triangle::is_proper);
    Arc::new(SharedMesh::new(all.collect()))
}

/// A rotation with stretches, mirrored now and then, and a place up to `far` away.
fn place(draw: &mut Draw, far: f32) -> (DMat3, DVec3) {
    let turn = DQuat::from_axis_angle(draw.direction().as_dvec3(), f64::from(draw.one()) * 6.0);
    let stretch = [(); 3].map(|()| f64::from(draw.signed_power(-1.0, 1.0)));
    let shift = draw.direction().as_dvec3() * f64::from(draw.power(-2.0, 1.0) * far);
    (
        DMat3::from_quat(turn) * DMat3::from_diagonal(stretch.into()),
        shift,
    )
}

#[test]
fn an_instance_is_met_where_copies_of_its_triangles_are() {
    let (mut hits, mut other, mut turned) = (0, 0, 0);
    for i in 0..60 {
        let mut draw = Draw::new(201, i);
        let mesh = mesh(&mut draw);
        let (linear, shift) = place(&mut draw, 10.0);
        let instance = Instance::new(mesh.clone(), linear, shift).expect("well-conditioned");
        let copies = mesh
            .triangles()
            .iter()
            .map(|t| Shape::Triangle(instance.placed(t)));
        let copies: Vec<Shape> = copies.collect();
        let copies = Bvh::new(&copies);
        let instances = Bvh::new(&[Transformed::Instance(instance.clone())]);
        let middle = instance.bounds().center();
        let size = (instance.bounds().max - middle).length();
        for _ in 0..500 {
            let from = middle + draw.direction() * size * 2.0;
            let ray = Draw::towards(from, middle + draw.cube(size * 0.5));
            let (a, b) = (instances.first_hit(&ray), copies.first_hit(&ray));
            assert_eq!(instances.occluded(&ray), a.is_some());
            match (a, b) {
                (Some(a), Some(b)) if a.intersection.part == b.id => {
                    hits += 1;
                    let [p, q] = [a.surface(&ray), b.surface(&ray)];
                    let off = (p.p - q.p).abs();
                    assert!(off.cmple(Vec3::splat(size * 1e-4)).all(), "{off} of {size}");
                    turned += usize::from(p.n.dot(q.n) < 0.999);
                }
                (None, None) => {}
                _ => other += 1,
            }
        }
    }
    println!("{hits} hits alike, {other} others, {turned} normals");
    assert!(hits > 2000 && other <= hits / 1000 && turned <= hits / 200);
}

/// A surface that claims to be exact.
fn exact(surface: &Surface) -> Surface {
    Surface {
        error: Vec3::ZERO,
        ..*surface
    }
}

#[test]
fn rays_that_leave_an_instance_do_not_meet_the_same_triangle_again() {
    let (mut ours, mut plain, mut rays) = (0, 0, 0);
    for i in 0..800 {
        let mut draw = Draw::new(202, i);
        let mesh = mesh(&mut draw);
        // Close to the eye, and as far as a thousand sizes away.
        let far = [1.0, 1000.0][i as usize % 2];
        let (linear, shift) = place(&mut draw, far);
        let Some(instance) = Instance::new(mesh, linear, shift) else {
            continue;
        };
        let middle = instance.bounds().center();
        let size = (instance.bounds().max - middle).length();
        for _ in 0..40 {
            let from = middle + draw.direction() * size * 2.0;
            let ray = Draw::towards(from, middle + draw.cube(size * 0.4));
            let Some(x) = instance.intersect(&PreparedRay::from(&ray), f32::MAX) else {
                continue;
            };
            let surface = instance.surface(&ray, x);
            for k in 0..20 {
                let side = if k % 2 == 0 { surface.n } else { -surface.n };
                let out = draw.leaving(side);
                let again = |s: &Surface| {
                    let ray: Ray = s.spawn(out);
                    let met = instance.intersect(&PreparedRay::from(&ray), f32::MAX);
                    met.is_some_and(|met| met.part == x.part)
                };
                rays += 1;
                ours += usize::from(again(&surface));
                plain += usize::from(again(&exact(&surface)));
            }
        }
    }
    println!("{rays} rays: {ours} come back, {plain} of points that claim to be exact");
    assert!(rays > 50_000 && plain > rays / 20, "{plain}");
    assert_eq!(ours, 0);
}

#[test]
fn a_place_whose_roundings_would_be_too_large_is_none() {
    let mut draw = Draw::new(203, 0);
    let mesh = mesh(&mut draw);
    let place = |scale: [f64; 3], shift: f64| {
        let linear = DMat3::from_diagonal(scale.into());
        Instance::new(mesh.clone(), linear, DVec3::splat(shift)).is_some()
    };
    assert!(place([1.0, 1.0, 1.0], 0.0) && place([100.0, 1.0, -1.0], 1e6));
    assert!(
        place([1e-20; 3], 0.0) && place([1e20; 3], 0.0),
        "small and large, but alike"
    );
    assert!(!place([1e6, 1.0, 1.0], 0.0) && !place([0.0, 1.0, 1.0], 0.0));
    assert!(!place([1.0; 3], 1e39) && !place([f64::NAN, 1.0, 1.0], 0.0));
}

/// A pyramid with texture coordinates, three of them over a floor and one beside a lamp: from one file, or
/// each from a file of its own.
fn yard(folder: &std::path::Path, shared: bool) -> Scene {
    let obj = "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1.5 0\nvt 0 0\nvt 1 0\nvt 0.5 1\n\
               f 1/1 5/3 2/2\nf 2/1 5/3 3/2\nf 3/1 5/3 4/2\nf 4/1 5/3 1/2\n";
    let mut text = "name = 'yard'\nbackground = 0.3\n[camera]\nfrom = [1, 3, 9]\nto = [0, 0.5, 0]\nfov = 45\n\
        [film]\nsize = [64, 48]\n[materials.floor]\nlambert = { albedo = 0.5 }\n\
        [materials.roof]\nlambert = { albedo = { checker = { even = 0.8, odd = [0.1, 0.2, 0.3], fields = [4, 6] } } }\n\
        [[objects]]\nmaterial = 'floor'\nquad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n\
        [[objects]]\nemits = 6\nquad = { corner = [-1, 5, -1], u = [2, 0, 0], v = [0, 0, 2] }\n"
        .to_owned();
    let places = [
        "{ translate = [-3, 0.1, 0] }",
        "{ scale = [-1, 1.5, 1], translate = [0, 0.1, 0] }",
        "{ rotate = { axis = [0, 1, 0], degrees = 30 }, translate = [3, 0.1, 0] }",
        "{ scale = 0.5, translate = [0, 4.25, 0] }",
    ];
    for (i, place) in places.iter().enumerate() {
        let file = if shared {
            "roof.obj".to_owned()
        } else {
            format!("roof{i}.obj")
        };
        std::fs::write(folder.join(&file), obj).unwrap();
        text += &format!(
            "[[objects]]\nmaterial = 'roof'\ntransform = {place}\nmesh = {{ file = '{file}' }}\n"
        );
    }
    let source = Source {
        file: "yard.toml",
        text: &text,
    };
    gallery::from_text(source, Some(folder), |_| {}).expect("a right scene")
}

#[test]
fn a_scene_with_instances_looks_as_one_with_copies() {
    let folder = tempfile::tempdir().unwrap();
    let [once, copies] = [true, false].map(|shared| yard(folder.path(), shared));
    assert_eq!(once.report.shapes, copies.report.shapes);
    let instances = [&once, &copies].map(|scene| scene.report.instances);
    assert_eq!(instances, [3, 0], "one touches the lamp");
    let (mut seen, mut other) = (0, 0);
    for i in 0..20_000 {
        let mut draw = Draw::new(204, i);
        let ray = once.camera.ray(draw.one(), draw.one());
        let [a, b] = [&once, &copies].map(|scene| Tracer::new(scene).camera_ray(&ray));
        let look = |hit: Option<halfdisk::scene::Interaction>| {
            hit.map(|hit| (hit.bsdf.map(|b| b.albedo()), hit.emission, hit.wo.z > 0.0))
        };
        seen += usize::from(b.is_some_and(|hit| hit.bsdf.is_some_and(|b| b.albedo().g != 0.5)));
        other += usize::from(look(a) != look(b));
    }
    println!("{seen} of 20 000 rays meet a roof, {other} see something else");
    assert!(seen > 1500 && other < 10, "{seen} {other}");
}

#[test]
fn an_instance_that_touches_a_lamp_is_told_from_it_as_a_copy_is() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("plate.obj"),
        "v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 1 2 3 4\n",
    )
    .unwrap();
    let text = "name = 'ceiling'\n[camera]\nfrom = [0, -3, 0.5]\nto = [0, 0, 0]\nfov = 30\n\
        [film]\nsize = [16, 16]\n[materials.m]\nlambert = { albedo = 0.5 }\n\
        [[objects]]\nmaterial = 'm'\nmesh = { file = 'plate.obj' }\n\
        [[objects]]\nmaterial = 'm'\ntransform = { translate = [5, 5, 5] }\nmesh = { file = 'plate.obj' }\n\
        [[objects]]\nemits = 2\nquad = { corner = [-0.5, 0, -0.5], u = [1, 0, 0], v = [0, 0, 1] }\n";
    let source = Source {
        file: "ceiling.toml",
        text,
    };
    let scene = gallery::from_text(source, Some(folder.path()), |_| {}).expect("a right scene");
    assert_eq!(scene.report.instances, 1, "the one far from the lamp");
    let mut lit = 0;
    for i in 0..800 {
        let mut draw = Draw::new(205, i);
        let ray = scene
            .camera
            .ray(draw.between(0.4, 0.6), draw.between(0.4, 0.6));
        let hit = Tracer::new(&scene).camera_ray(&ray).expect("a ceiling");
        lit += usize::from(!hit.emission.is_black());
    }
    assert_eq!(lit, 800);
}
