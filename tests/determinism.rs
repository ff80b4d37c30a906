//! The same picture, byte for byte, whoever computes it and however the scene is put.

use crate::cli::{complaint, folder, halfdisk};
use halfdisk::integrators::{Normals, Whitted};
use halfdisk::render::{Film, Options, Progress, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::Scene;
use halfdisk::scene::description::{Description, Light, Shape, Transform};
use halfdisk::scene::gallery::{self, load_with};
use halfdisk::scene::read::Source;
use halfdisk::scene::value::{Positive, Scale, Triple, Whole};
use std::sync::atomic::{AtomicU64, Ordering};

const OPTIONS: Options = Options {
    spp: 3,
    seed: 5,
    sampler: Sampler::Independent,
    fixed: &[],
    tile: 16,
    shard: None,
};

fn small(name: &str, change: impl FnOnce(&mut Description)) -> Scene {
    let scene = load_with(name, change).expect("a scene of the gallery");
    scene.sized([30, 22])
}

fn film(scene: &Scene, options: &Options) -> Film {
    let rendered = render(scene, &Whitted { max_depth: 6 }, options, &());
    assert_eq!(rendered.non_finite, 0);
    rendered.film
}

#[test]
fn threads_and_repetition_change_no_byte() {
    let folder = folder();
    for name in ["spheres", "whitted", "lamp"] {
        for ending in ["png", "exr", "hdr"] {
            let render = |threads: &str| {
                let out = format!("p.{ending}");
                let small = ["--size", "30x22", "--spp", "3", "--max-depth", "6"];
                let all = [
                    &["render", name, "--threads", threads, "--out", &out][..],
                    &small,
                ];
                let output = halfdisk(folder.path(), &all.concat());
                assert!(output.status.success(), "{}", complaint(&output));
                std::fs::read(folder.path().join(out)).unwrap()
            };
            let first = render("1");
            for threads in ["1", "2", "3", "7"] {
                assert!(
                    first == render(threads),
                    "{name}.{ending} on {threads} threads"
                );
            }
        }
    }
}

#[test]
fn tiles_change_no_bit() {
    for name in ["cornell", "caustic", "tunnel"] {
        let scene = small(name, |_| {});
        let first = film(&scene, &OPTIONS);
        for tile in [0, 1, 7, 8, 1000, u32::MAX] {
            assert_eq!(
                first,
                film(&scene, &Options { tile, ..OPTIONS }),
                "{name}, {tile}"
            );
        }
        assert_ne!(
            first,
            film(&scene, &Options { seed: 6, ..OPTIONS }),
            "{name}"
        );
    }
}

/// Stops once so many samples are done.
struct After(u64, AtomicU64);

impl Progress for After {
    fn tell(&self, done: u64, _: u64) {
        self.1.fetch_max(done, Ordering::Relaxed);
    }
    fn stop(&self) -> bool {
        self.1.load(Ordering::Relaxed) >= self.0
    }
}

#[test]
fn a_render_that_is_stopped_is_one_of_fewer_samples() {
    let scene = small("spheres", |_| {});
    let pixels = u64::from(scene.size[0]) * u64::from(scene.size[1]);
    let whitted = Whitted { max_depth: 6 };
    // One tile, so that passes of 1, 1, 2, 4 samples are all there is to stop between.
    let options = |spp| Options {
        spp,
        tile: 1000,
        ..OPTIONS
    };
    for spp in [1, 2, 4, 8] {
        let after = After(pixels * u64::from(spp), AtomicU64::new(0));
        let stopped = render(&scene, &whitted, &options(16), &after);
        let whole = render(&scene, &whitted, &options(spp), &());
        assert!(stopped.interrupted && !whole.interrupted);
        assert_eq!(stopped.film, whole.film);
        assert_eq!(stopped.rays, whole.rays);
        assert!(
            whole
                .film
                .pixels()
                .iter()
                .all(|p| p.count() == u64::from(spp))
        );
    }
}

#[test]
fn the_order_of_objects_changes_no_bit() {
    for name in ["caustic", "lamp", "spheres", "cornell", "whitted", "slab"] {
        let first = film(&small(name, |_| {}), &OPTIONS);
        let turned = |turn: usize| {
            small(name, |said| {
                // Lights keep their order: each draws random numbers of its own.
                let (lamps, mut dark): (Vec<_>, Vec<_>) =
                    said.objects.drain(..).partition(|o| o.emits.is_some());
                let turn = turn % dark.len();
                dark.rotate_left(turn);
                dark.reverse();
                said.objects = dark.into_iter().chain(lamps).collect();
            })
        };
        for turn in 0..3 {
            assert_eq!(first, film(&turned(turn), &OPTIONS), "{name}, {turn}");
        }
    }
}

/// The description with every length multiplied by `s`, seen from as far away.
fn scale(said: &mut Description, s: f64) {
    let point = |p: &mut Triple| p.0 = p.0.map(|x| x * s);
    point(&mut said.camera.from);
    point(&mut said.camera.to);
    said.camera.lens_radius.0 *= s;
    said.camera.focus = said.camera.focus.map(|f| Positive(f.0 * s));
    for light in &mut said.lights {
        if let Light::Point {
            position,
            intensity,
        } = light
        {
            point(position);
            // Irradiance falls with the square of the distance.
            intensity.0 = intensity.0.map(|x| x * s * s);
        }
    }
    for object in &mut said.objects {
        match &mut object.shape {
            Shape::Sphere { center, radius, .. } | Shape::BumpySphere { center, radius, .. } => {
                point(center);
                radius.0 *= s;
            }
            Shape::Quad {
                corner: a,
                u: b,
                v: c,
            }
            | Shape::Triangle { a, b, c } => [a, b, c].into_iter().for_each(point),
            Shape::Box { min, max } => [min, max].into_iter().for_each(point),
            Shape::Mesh { .. } | Shape::Custom(_) => {}
        }
        point(&mut object.motion);
        point(&mut object.transform.translate);
    }
}

#[test]
fn scaled_by_powers_of_two_nothing_changes() {
    for (name, _) in gallery::GALLERY {
        let first = film(&small(name, |_| {}), &OPTIONS);
        for k in [-20, -10, 10, 20] {
            let scaled = small(name, |said| scale(said, 2_f64.powi(k)));
            assert_eq!(first, film(&scaled, &OPTIONS), "{name} times 2^{k}");
        }
    }
}

/// A lamp in each of six directions, all facing a camera in their middle, or turned away.
fn lamps(shape: &str, signs: [f64; 3]) -> Scene {
    let text = format!(
        r#"name = "lamps"
[camera]
from = [0, 0, 0]
to = [1, 2, 3]
fov = 150
[film]
size = [24, 24]
[[objects]]
emits = [1, 2, 3]
{shape}
"#
    );
    let source = Source {
        file: "lamps",
        text: &text,
    };
    gallery::from_text(source, None, |said| {
        said.camera.to.0 = [0, 1, 2].map(|i| said.camera.to.0[i] * signs[i]);
        said.objects[0].transform = Transform {
            scale: Scale(signs),
            ..Transform::default()
        };
    })
    .expect("a proper scene")
}

#[test]
fn mirrored_shapes_keep_their_front() {
    let facing = "quad = { corner = [-2, -2, 3], u = [0, 4, 0], v = [4, 0, 0] }";
    let away = "quad = { corner = [-2, -2, 3], u = [4, 0, 0], v = [0, 4, 0] }";
    let box_before = "box = { min = [0.5, 1, 1.5], max = [1, 2.5, 3] }";
    let around = "box = { min = [-4, -4, -4], max = [4, 4, 4] }";
    let sphere = "sphere = { center = [1, 2, 3], radius = 1 }";
    for x in [1.0, -1.0] {
        for y in [1.0, -1.0] {
            for z in [1.0, -1.0] {
                let seen = |shape| {
                    let rendered = render(
                        &lamps(shape, [x, y, z]),
                        &Whitted { max_depth: 1 },
                        &Options { spp: 1, ..OPTIONS },
                        &(),
                    );
                    rendered.film.max()
                };
                assert_eq!(seen(facing), 3.0, "{x} {y} {z}");
                assert_eq!(seen(away), 0.0, "{x} {y} {z}");
                assert_eq!(seen(box_before), 3.0, "{x} {y} {z}");
                assert_eq!(seen(around), 0.0, "a box shines outwards: {x} {y} {z}");
                assert_eq!(seen(sphere), 3.0, "{x} {y} {z}");
            }
        }
    }
}

#[test]
fn mirrored_meshes_keep_their_front() {
    let normals = |signs: [f64; 3]| {
        let scene = small("mesh", |said| {
            said.objects
                .retain(|o| matches!(o.shape, Shape::BumpySphere { .. }));
            let Shape::BumpySphere {
                center,
                columns,
                rows,
                ..
            } = &mut said.objects[0].shape
            else {
                panic!("a bumpy sphere");
            };
            center.0 = [0.0; 3];
            (*columns, *rows) = (Whole(32), Whole(16));
            said.camera.from.0 = [0.0, 0.0, -400.0];
            said.camera.to.0 = [0.0; 3];
            said.objects[0].transform = Transform {
                scale: Scale(signs),
                ..Transform::default()
            };
        });
        let film = render(&scene, &Normals, &Options { spp: 1, ..OPTIONS }, &()).film;
        // 0.5 + 0.5 n: what faces the camera has a normal towards -z.
        let middle = film.pixel(15, 11).mean().unwrap()[2];
        assert!(middle < 0.5, "{signs:?}: the front faces the eye, {middle}");
    };
    for signs in [
        [1.0, 1.0, 1.0],
        [-1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, -1.0, -1.0],
    ] {
        normals(signs);
    }
}

#[test]
fn another_size_is_that_of_a_file_that_says_so() {
    for (name, _) in gallery::GALLERY {
        for size in [[7, 5], [3, 11]] {
            let said = load_with(name, |said| said.film.size = size.map(i64::from)).unwrap();
            let sized = gallery::load(name).unwrap().sized(size);
            // What is made from a sized scene keeps its size.
            let changed = sized.changed(|_| {}).unwrap();
            assert_eq!(film(&said, &OPTIONS), film(&sized, &OPTIONS), "{name}");
            assert_eq!(film(&said, &OPTIONS), film(&changed, &OPTIONS), "{name}");
        }
    }
}
