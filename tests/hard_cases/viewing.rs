//! Cameras that look along their own `up`, lenses without width, worlds far away and shapes squeezed.

use super::draw::Draw;
use super::{room_with, scene};
use glam::{DVec3, Mat3, Vec3};
use halfdisk::camera::Camera;
use halfdisk::geometry::{PreparedRay, Primitive, Ray, Sphere};
use halfdisk::integrators::{Integrator, Normals, Path, Whitted};
use halfdisk::lab::naive;
use halfdisk::render::{Film, Options, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::description::Shape;
use halfdisk::scene::value::{NotNegative, Positive, Triple};
use halfdisk::scene::{Scene, Tracer};
use halfdisk::stats::Estimate;

const OPTIONS: Options = Options {
    spp: 16,
    seed: 13,
    sampler: halfdisk::sampling::stream::Sampler::Independent,
    fixed: &[],
    tile: 16,
    shard: None,
};

fn picture(scene: &Scene, seed: u64) -> Film {
    let options = Options { seed, ..OPTIONS };
    let rendered = render(scene, &Path::new(6), &options, &());
    assert_eq!(rendered.faults, Default::default());
    rendered.film
}

/// The mean of squared differences over squared values.
fn relative_mse(a: &Film, b: &Film) -> f64 {
    let values = |film: &Film| -> Vec<f64> {
        let means = film.pixels().iter().map(|p| p.mean().expect("samples"));
        means.flatten().collect()
    };
    let pairs = values(a).into_iter().zip(values(b));
    let each: Estimate = pairs
        .map(|(a, b)| (a - b).powi(2) / (b * b + 1e-2))
        .collect();
    each.mean()
}

#[test]
fn a11_poles_and_cameras_without_an_upright() {
    let mut draw = Draw::new(11, 0);
    let mut nan = 0;
    for _ in 0..1_000_000 {
        let n = draw.cube(1.0).normalize();
        nan += usize::from(naive::angle(n, n).is_nan());
    }
    println!("seed 11: the arc cosine of n · n is NaN for {nan} of 10^6 unit vectors");
    assert!(nan > 10_000);
    let plain = Vec3::Y.cross(Vec3::Y).normalize();
    assert!(plain.is_nan(), "the plain right of a camera that looks up");
    for (forward, up) in [
        (DVec3::Y, DVec3::Y),
        (DVec3::Y, -DVec3::Y),
        (DVec3::ZERO, DVec3::Y),
        (DVec3::Z, DVec3::ZERO),
        (DVec3::Y, DVec3::new(1e-12, 1.0, 0.0)),
        (DVec3::Y * 1e-200, DVec3::Z),
    ] {
        assert!(Camera::new(Vec3::ZERO, forward, up, 1.0, 1.0).is_none());
    }
    // Almost upright is upright.
    let steep = Camera::new(Vec3::ZERO, DVec3::new(1e-6, 1.0, 0.0), DVec3::Y, 1.0, 1.0);
    assert!(steep.is_some_and(|c| c.ray(0.3, 0.8).is_valid()));
    // A sphere has no coordinates that end at its poles.
    let ball = Sphere::new(Vec3::new(3.0, -2.0, 1.0), 0.7);
    for pole in [DVec3::X, DVec3::Y, DVec3::Z] {
        for pole in [pole, -pole] {
            let at = ball.surface_towards(pole);
            assert!(at.p.is_finite() && at.n.as_dvec3() == pole);
        }
    }
}

#[test]
fn a13_a_scene_far_from_the_origin_is_the_same_picture() {
    let far = DVec3::new(1e6, -7e5, 4e5);
    let shift = |p: &mut Triple| p.0 = (DVec3::from(p.0) + far).to_array();
    let here = room_with([48, 36], |_| {});
    let there = room_with([48, 36], |said| {
        shift(&mut said.camera.from);
        shift(&mut said.camera.to);
        for object in &mut said.objects {
            match &mut object.shape {
                Shape::Quad { corner, .. } => shift(corner),
                Shape::Sphere { center, .. } => shift(center),
                _ => {}
            }
        }
    });
    let moved = relative_mse(&picture(&there, 1), &picture(&here, 1));
    let seeds = relative_mse(&picture(&here, 2), &picture(&here, 1));
    println!("moved by (1e6, -7e5, 4e5): relMSE {moved:.2e}; two seeds {seeds:.2e}");
    assert!(moved <= 2.0 * seeds);
    assert!(
        moved < 0.1 * seeds,
        "the same numbers, and nearly the same places"
    );
    assert_eq!(there.report.coarse, None);
    // The plain twin: coordinates as they stand in the file. A unit sphere has few places then.
    let places: std::collections::BTreeSet<u32> = (0..=1000)
        .map(|k| (1e6_f32 + (k as f32 / 500.0 - 1.0)).to_bits())
        .collect();
    println!(
        "a unit sphere at 1e6 has {} different x in f32",
        places.len()
    );
    assert!(places.len() < 40);
}

#[test]
fn a13_what_is_too_small_for_its_place_is_reported() {
    let ball = |x: f64, radius: f64| {
        scene(&format!(
            "[[objects]]\nmaterial = 'half'\nsphere = {{ center = [{x}, 0, 9], radius = {radius} }}\n"
        ))
    };
    assert_eq!(ball(1e6, 1.0).report.coarse, None);
    assert_eq!(ball(0.0, 1e-4).report.coarse, None);
    let coarse = ball(1e6, 0.1)
        .report
        .coarse
        .expect("16 steps of it are one unit");
    assert_eq!((coarse.shapes, coarse.step), (1, 0.0625));
    // A mesh of a kilometre, with details of a tenth of a millimetre.
    let tiny = scene(
        "[[objects]]\nmaterial = 'half'\n\
         triangle = { a = [1e3, 0, 0], b = [1000.0002, 0, 0], c = [1e3, 0.01, 1] }\n",
    );
    assert_eq!(tiny.report.coarse.map(|c| c.shapes), Some(1));
}

#[test]
fn a13_a_wall_of_sixteen_steps_casts_its_whole_shadow() {
    for place in [1.0, 1e3, 1e5_f64] {
        let step = f64::from((place as f32).next_up() - place as f32);
        let (low, high) = (place, place + 16.0 * step);
        let wide = 2.0 * place;
        let dark = scene(&format!(
            "[[objects]]\nmaterial = 'half'\nquad = {{ corner = [-{wide}, -{wide}, {}], \
             u = [0, {w}, 0], v = [{w}, 0, 0] }}\n[[objects]]\nmaterial = 'half'\n\
             box = {{ min = [-{wide}, -{wide}, {low}], max = [{wide}, {wide}, {high}] }}\n\
             [[lights]]\npoint = {{ position = [0, 0, 0], intensity = {} }}\n",
            3.0 * place,
            place * place,
            w = 2.0 * wide,
        ));
        let behind = Vec3::Z * (2.0 * place) as f32;
        let mut draw = Draw::new(13, place as u32);
        for _ in 0..10_000 {
            let aim = Vec3::new(draw.between(-0.3, 0.3), draw.between(-0.3, 0.3), 1.0);
            let ray = Ray::new(behind, aim.normalize());
            let li =
                Whitted { max_depth: 2 }.li(&mut Tracer::new(&dark), &ray, &Stream::new(13, 0, 0));
            assert!(li.is_black(), "{place}");
        }
    }
    println!("seed 13: 3 x 10^4 points behind a wall of 16 steps: all dark");
}

#[test]
fn a15_normals_of_squeezed_shapes_and_mirrored_furnaces() {
    let mut worst = 0.0_f64;
    for scale in [[1.0, 10.0, 1.0], [1.0, 1e-3, 1e3], [-2.0, 5.0, 1.0]] {
        for k in 0..100 {
            let mut draw = Draw::new(15, k);
            let [a, b, c] = std::array::from_fn(|_| draw.cube(1.0).as_dvec3());
            let text = |v: DVec3| format!("{:?}", v.to_array());
            let squeezed = scene(&format!(
                "[[objects]]\nmaterial = 'half'\ntriangle = {{ a = {}, b = {}, c = {} }}\n\
                 transform = {{ scale = {scale:?}, translate = [0, 0, 3] }}\n",
                text(a),
                text(b),
                text(c)
            ));
            let middle = (a + b + c) / 3.0 * DVec3::from(scale) + DVec3::Z * 3.0;
            let ray = Ray::new(Vec3::ZERO, middle.normalize().as_vec3());
            let mut tracer = Tracer::new(&squeezed);
            let Some(hit) = tracer.camera_ray(&ray) else {
                continue;
            };
            // The inverse transpose, in f64; a reflection turns the order of the corners.
            let n = (b - a).cross(c - a) / DVec3::from(scale);
            let n = n.normalize();
            worst = worst.max((hit.surface.n.as_dvec3() - n).length());
        }
    }
    println!("seed 15: normals off by {worst:.1e}");
    assert!(worst < 1e-6);
    // Normals taken along, as points are.
    let plain = Vec3::new(1.0, 1.0, 0.0).normalize() * Vec3::new(1.0, 10.0, 1.0);
    let right = Vec3::new(1.0, 0.1, 0.0).normalize();
    assert!(plain.normalize().distance(right) > 0.5, "the plain twin");

    let box_of = |scale: &str| {
        scene(&format!(
            "[[objects]]\nmaterial = 'half'\nemits = 1\n\
             sphere = {{ center = [0, 0, 0], radius = 5, inward = true }}\n\
             transform = {{ scale = {scale} }}\n"
        ))
    };
    for scale in ["1", "[-1, 1, 1]", "[-2, -2, -2]"] {
        let furnace = box_of(scale);
        let read: Estimate = (0..20_000)
            .map(|i| {
                let stream = Stream::new(15, 0, i);
                let ray = Ray::new(Vec3::ZERO, Vec3::Z);
                let li = Path::new(60).li(&mut Tracer::new(&furnace), &ray, &stream);
                f64::from(li.g)
            })
            .collect();
        assert!(read.z(2.0).abs() <= 4.4, "{scale}: {read:?}");
    }
}

#[test]
fn a17_no_matrix_is_mixed_with_another() {
    // What moves here moves along a line; turned by mixing matrices it would shrink.
    let turned = |degrees: f32| {
        let (sin, cos) = libm::sincosf(degrees.to_radians());
        Mat3::from_cols(Vec3::new(cos, sin, 0.0), Vec3::new(-sin, cos, 0.0), Vec3::Z)
    };
    let shrunk = [90.0, 170.0, 180.0].map(|degrees| {
        let half = naive::matrix_between(Mat3::IDENTITY, turned(degrees), 0.5);
        (half * Vec3::X).length()
    });
    println!("half-way a mixed turn by 90, 170, 180 degrees leaves {shrunk:.3?} of each length");
    assert!((shrunk[0] - 0.707).abs() < 1e-3 && shrunk[2] < 1e-6);
    // A ball that moves on, at any time.
    let moving = halfdisk::geometry::Moving::new(
        halfdisk::geometry::Shape::Sphere(Sphere::new(Vec3::ZERO, 1.0)),
        Vec3::new(3.0, -2.0, 5.0),
    );
    let moving = moving.expect("finite");
    let mut draw = Draw::new(17, 0);
    for _ in 0..100_000 {
        let time = draw.one();
        let at = Vec3::new(3.0, -2.0, 5.0) * time;
        let ray = Draw::towards(at + draw.direction() * 9.0, at);
        let x = moving.intersect(&PreparedRay::from(&ray.at_time(time)), f32::MAX);
        assert!(x.is_some_and(|x| (x.t - 8.0).abs() < 1e-4));
    }
}

#[test]
fn a18_a_lens_without_width_is_a_pinhole() {
    let lens = |radius: f64, focus: Option<f64>| {
        let scene = room_with([24, 18], |said| {
            said.camera.lens_radius = NotNegative(radius);
            said.camera.focus = focus.map(Positive);
        });
        picture(&scene, 18)
    };
    let pinhole = lens(0.0, None);
    for focus in [1e-6, 1.0, 1e30] {
        assert_eq!(
            pinhole,
            lens(0.0, Some(focus)),
            "no number drawn, no bit changed"
        );
        // A radius that `f32` cannot tell from zero against the numbers of the scene.
        let tiny = lens(1e-30, Some(focus));
        let all = tiny.pixels().iter().all(|p| p.count() == 16);
        assert!(all && tiny.max().is_finite());
    }
    assert_ne!(pinhole, lens(0.05, Some(2.0)));
    let plain = Vec3::splat(1e30).normalize();
    println!("a ray to a focus at 1e30, normalised plainly: {plain}");
    assert_eq!(plain, Vec3::ZERO, "the plain twin");
}

#[test]
fn a19_from_inside_lamps_and_glass() {
    let inside = |text: &str, depth: u32| -> Estimate {
        let scene = scene(text);
        (0..20_000)
            .map(|i| {
                let ray = Ray::new(Vec3::new(0.1, 0.2, -0.3), Vec3::new(0.6, 0.0, 0.8));
                let stream = Stream::new(19, 0, i);
                let li = Path::new(depth).li(&mut Tracer::new(&scene), &ray, &stream);
                f64::from(li.g)
            })
            .collect()
    };
    let room = "[[objects]]\nmaterial = 'half'\nemits = 1\n\
                sphere = { center = [0, 0, 0], radius = 1, inward = true }\n";
    let lamp = inside(room, 100);
    let glass = "background = 1\n[materials.glass]\nglass.ior = 1.5\n[[objects]]\n\
                 material = 'glass'\nsphere = { center = [0, 0, 0], radius = 1 }\n";
    let ball = inside(glass, 1000);
    println!("seed 19: in a glowing sphere {lamp:?}, exact 2; in glass {ball:?}, exact 1");
    assert!(lamp.z(2.0).abs() <= 4.4);
    assert!(ball.z(1.0).abs() <= 4.4 || (ball.mean() - 1.0).abs() < 1e-6);
    // A lamp that shines outwards is dark within: what one sees there is its back.
    let back = "[[objects]]\nemits = 1\nsphere = { center = [0, 0, 0], radius = 1 }\n";
    assert_eq!(inside(back, 10).mean(), 0.0);
    // Seen from inside, a room's normals point inwards, and those of a ball outwards: away from the
    // eye in its middle.
    let normals = |text: &str| {
        let film = render(&scene(text), &Normals, &OPTIONS, &()).film;
        let colours = film.pixels().iter().map(|p| p.mean().unwrap());
        let outwards = |[r, g, b]: [f64; 3]| DVec3::new(r, g, b) * 2.0 - 1.0;
        colours.map(outwards).collect::<Vec<_>>()
    };
    for (inside, outside) in normals(room).into_iter().zip(normals(back)) {
        assert!((inside + outside).length() < 1e-5, "{inside} {outside}");
        assert!(outside.z > 0.5, "the eye looks along z: {outside}");
    }
}
