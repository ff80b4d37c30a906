//! Random walks against closed forms, against each other, and against walks that are wrong.
//!
//! Where a number is compared with its truth, |z| ≤ 4.4 passes (one right estimate in 92 000 does
//! not), and the smallest bias that would have been noticed is printed.

mod survival;
mod weights;
mod which_ray;
mod wrong;

use crate::checks::{CRITICAL, accept, between, reject};
use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Kajiya, NextEvent, Whitted};
use halfdisk::render::{Film, Options, compare, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::gallery::{self, GALLERY};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, Tracer};
use halfdisk::stats::Estimate;
use std::f64::consts::PI;
use wrong::{Slip, Wrong};

fn scene(objects: &str) -> Scene {
    let head = "name = 'test'\ncamera = { from = [0, 0, 0], to = [0, 0, 1], fov = 40 }\n\
                materials.half.lambert.albedo = 0.5\nmaterials.most.lambert.albedo = 0.8\n";
    let text = head.to_owned() + objects;
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

/// Six quads that face inwards, each at distance 1 from the eye.
fn furnace() -> Scene {
    scene(&glowing_walls("half"))
}

fn glowing_walls(material: &str) -> String {
    let wall = |corner: [i8; 3], u: [i8; 3], v: [i8; 3]| {
        format!(
            "[[objects]]\nmaterial = '{material}'\nemits = 1\n\
             quad = {{ corner = {corner:?}, u = {u:?}, v = {v:?} }}\n"
        )
    };
    let (x, y, z) = ([2, 0, 0], [0, 2, 0], [0, 0, 2]);
    let walls = [
        wall([-1, -1, -1], x, y),
        wall([-1, -1, -1], y, z),
        wall([-1, -1, -1], z, x),
        wall([-1, -1, 1], y, x),
        wall([1, -1, -1], z, y),
        wall([-1, 1, -1], x, z),
    ];
    walls.concat()
}

/// The radiance along one ray, red channel, from so many walks.
fn radiance(integrator: &impl Integrator, scene: &Scene, ray: &Ray, walks: u32) -> Estimate {
    let mut tracer = Tracer::new(scene);
    let one = |i| f64::from(integrator.li(&mut tracer, ray, &Stream::new(1, i, 0)).r);
    (0..walks).map(one).collect()
}

#[test]
fn a_closed_furnace_cut_at_each_depth() {
    let scene = furnace();
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.3, 0.2, 1.0).normalize());
    for max_depth in [1, 2, 3, 4, 8] {
        let truth = 2.0 - 2.0 * f64::powi(0.5, max_depth as i32);
        let name = format!("furnace, {max_depth} segments");
        let walk = radiance(&Kajiya { max_depth }, &scene, &ray, 1000);
        accept(&format!("{name}, kajiya"), &walk, truth, 1e-3 * truth);
        // In solid angle no lamp is too near, not even where two of them meet in an edge.
        let asking = radiance(&NextEvent { max_depth }, &scene, &ray, 400_000);
        accept(&format!("{name}, next-event"), &asking, truth, 0.1 * truth);
        let twice = walk_wrongly(Slip::CountTwice, max_depth, &scene, &ray, 40_000);
        if max_depth > 1 {
            reject(&format!("{name}, counted twice"), &twice, truth);
        }
    }
}

#[test]
fn a_round_lamp_in_the_middle_of_a_round_room() {
    // Both of albedo 1/2 or 4/5, and only the lamp emits. Of the wall's light the share s = (r/R)²
    // meets the lamp, of the lamp's light all meets the wall: with one segment more,
    // wall = ρ (s lamp + (1 - s) wall), lamp = 1 + ρ wall.
    let scene = scene(
        "[[objects]]\nmaterial = 'most'\nsphere = { center = [-0.5, 0, 0], radius = 1 }\n\
         [[objects]]\nmaterial = 'half'\nemits = 1\nsphere = { center = [-0.5, 0, 0], radius = 0.3 }",
    );
    let s = 0.09;
    let (mut wall, mut lamp) = (0.0, 0.0);
    for max_depth in 1..=8 {
        (wall, lamp) = (0.8 * (s * lamp + (1.0 - s) * wall), 1.0 + 0.5 * wall);
        if max_depth == 1 {
            continue;
        }
        let (walk, asking) = (Kajiya { max_depth }, NextEvent { max_depth });
        for (name, toward, truth) in [
            ("wall", Vec3::new(0.6, 0.0, 0.8), wall),
            ("lamp", Vec3::NEG_X, lamp),
        ] {
            let ray = Ray::new(Vec3::ZERO, toward);
            let name = format!("round room, {max_depth} segments, {name}");
            let estimate = radiance(&walk, &scene, &ray, 50_000);
            accept(&format!("{name}, kajiya"), &estimate, truth, 15.0 * truth);
            let estimate = radiance(&asking, &scene, &ray, 50_000);
            accept(
                &format!("{name}, next-event"),
                &estimate,
                truth,
                2.0 * truth,
            );
        }
    }
}

#[test]
fn a_floor_under_a_square_lamp() {
    for h in [2.0_f64, 1.0, 0.5] {
        let scene = scene(&format!(
            "[[objects]]\nmaterial = 'half'\n\
             quad = {{ corner = [-9, -1, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n\
             [[objects]]\nmaterial = 'half'\nemits = 3\n\
             quad = {{ corner = [1.5, {}, -0.5], u = [1, 0, 0], v = [0, 0, 1] }}",
            h - 1.0
        ));
        assert_eq!(scene.lights.len(), 1);
        // The corner formula, four times around the middle.
        let x = 0.5 / h;
        let r = (1.0 + x * x).sqrt();
        let irradiance = 3.0 * 4.0 * x / r * libm::atan(x / r);
        let truth = 0.5 / PI * irradiance;
        // From the eye to the point below the middle of the lamp, past the lamp.
        let ray = Ray::new(
            Vec3::new(-2.0, -0.9, 0.0),
            Vec3::new(4.0, -0.1, 0.0).normalize(),
        );
        let name = format!("square lamp at {h}");
        let walk = radiance(&Kajiya { max_depth: 2 }, &scene, &ray, 400_000);
        accept(&format!("{name}, kajiya"), &walk, truth, 4.0 * truth);
        let asking = radiance(&NextEvent { max_depth: 2 }, &scene, &ray, 100_000);
        accept(&format!("{name}, next-event"), &asking, truth, truth);
        let twice = walk_wrongly(Slip::CountTwice, 2, &scene, &ray, 100_000);
        reject(&format!("{name}, counted twice"), &twice, truth);
        accept(
            "which is twice as much",
            &twice,
            2.0 * truth,
            5.0 * 2.0 * truth,
        );
    }
}

#[test]
fn a_slab_and_a_corridor_of_mirrors_by_single_paths() {
    let slab = gallery::load("slab").unwrap();
    let middle = slab.camera.ray(0.5, 0.5);
    let green = |li: Rgb| Rgb::grey(li.g);
    for (through, back) in [
        (
            radiance(&Kajiya { max_depth: 32 }, &slab, &middle, 400_000),
            radiance(
                &Map(Kajiya { max_depth: 32 }, green),
                &slab,
                &middle,
                400_000,
            ),
        ),
        (
            radiance(&NextEvent { max_depth: 32 }, &slab, &middle, 400_000),
            radiance(
                &Map(NextEvent { max_depth: 32 }, green),
                &slab,
                &middle,
                400_000,
            ),
        ),
    ] {
        accept("slab, through", &through, 12.0 / 13.0, 0.5 * 12.0 / 13.0);
        accept("slab, back", &back, 1.0 / 13.0, 5.0 * 1.0 / 13.0);
    }
    let forgotten = walk_wrongly(Slip::NoProbability, 32, &slab, &middle, 100_000);
    reject("slab, probability forgotten", &forgotten, 12.0 / 13.0);

    let tunnel = gallery::load("tunnel").unwrap();
    for n in 0..=6 {
        let ray = Ray::new(Vec3::ZERO, Vec3::new(6.0, n as f32, 0.0).normalize());
        let truth = f64::powi(0.9, n);
        let walk = radiance(&Kajiya { max_depth: 16 }, &tunnel, &ray, 100);
        accept(
            &format!("corridor, {n}, kajiya"),
            &walk,
            truth,
            1e-3 * truth,
        );
        let asking = radiance(&NextEvent { max_depth: 16 }, &tunnel, &ray, 100);
        accept(
            &format!("corridor, {n}, next-event"),
            &asking,
            truth,
            1e-3 * truth,
        );
    }
}

/// A picture of a gallery scene.
fn picture(name: &str, side: u32, integrator: &impl Integrator, spp: u32, seed: u64) -> Film {
    let small = gallery::load(name).unwrap().sized([side; 2]);
    let options = Options {
        spp,
        seed,
        ..Options::default()
    };
    let rendered = render(&small, integrator, &options, &());
    assert_eq!(rendered.non_finite, 0, "{name}");
    rendered.film
}

/// The distance of two pictures' means in standard errors.
fn apart(name: &str, a: &Film, b: &Film) -> f64 {
    let (z, notices) = between(a.mean(), b.mean());
    println!("{name}: z {z:+.2}, would notice {:.2} %", 100.0 * notices);
    z
}

/// The pixels of two pictures that show no lamp, neither straight nor by mirrors and glass, nor are
/// neighbours of one that does: at its edge few samples decide, and errors are far from normal.
/// Black pixels are left out, too.
fn without_lamps(name: &str, max_depth: u32, films: [&Film; 2]) -> [Film; 2] {
    let [width, height] = [films[0].width(), films[0].height()];
    let mut scene = gallery::load_with(name, |said| said.background = None).unwrap();
    scene.size = [width, height];
    scene.lights.clear();
    let options = Options::default();
    let lamps = render(&scene, &Whitted { max_depth }, &options, &()).film;
    let shows = |x: u32, y: u32| lamps.pixel(x, y).channels.iter().any(|c| c.mean() > 0.0);
    let near = |at: u32, end: u32| at.saturating_sub(1)..(at + 2).min(end);
    let keep = |&(x, y): &(u32, u32)| {
        let dim = near(y, height).all(|v| near(x, width).all(|u| !shows(u, v)));
        let varies = |f: &&Film| f.pixel(x, y).channels.iter().all(|c| c.variance() > 0.0);
        dim && films.iter().any(varies)
    };
    let all = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let kept: Vec<_> = all.filter(keep).collect();
    assert!(3 * kept.len() > lamps.pixels().len(), "{name}");
    films.map(|film| Film::new(1, kept.iter().map(|&(x, y)| *film.pixel(x, y)).collect()))
}

/// Two pictures agree in the mean, and pixel by pixel where no lamp is near.
#[track_caller]
fn agree(name: &str, max_depth: u32, a: &Film, b: &Film) {
    assert!(apart(name, a, b).abs() <= CRITICAL);
    let [a, b] = without_lamps(name, max_depth, [a, b]);
    assert!(apart(&format!("{name} but lamps"), &a, &b).abs() <= CRITICAL);
    let z = compare::z_scores(&a.picture(), &b.picture()).unwrap();
    let (squares, error) = (z.squares.mean(), z.squares.std_error());
    println!(
        "  z² {squares:.3} ± {error:.3}, largest |z| {:.2}",
        z.largest
    );
    assert!(z.squares.z(1.0).abs() <= CRITICAL, "{name}: {z:?}");
}

#[test]
fn both_walks_paint_the_same_pictures() {
    for (name, max_depth) in [("cornell", 8), ("spheres", 12)] {
        // Few and large pixels: a walk finds the lamp rarely, and the mean of a few finds is far
        // from normal.
        let asking = picture(name, 12, &NextEvent { max_depth }, 2048, 1);
        let walk = picture(name, 12, &Kajiya { max_depth }, 16_384, 2);
        agree(name, max_depth, &asking, &walk);

        let wrong = |slip| picture(name, 12, &Wrong { slip, max_depth }, 512, 1);
        let z = |what: &str, slip| {
            let [wrong, right] = without_lamps(name, max_depth, [&wrong(slip), &walk]);
            apart(what, &wrong, &right)
        };
        assert!(z("counted twice", Slip::CountTwice) > CRITICAL);
        if name == "spheres" {
            // Without lamps behind glass there is no caustic.
            assert!(z("blind after glass", Slip::NeverAfterSpecular) < -CRITICAL);
        }
    }
}

#[test]
fn direct_light_is_whitteds() {
    let asking = picture("cornell", 32, &NextEvent { max_depth: 2 }, 512, 1);
    let tree = picture("cornell", 32, &Whitted { max_depth: 2 }, 512, 2);
    agree("cornell", 2, &asking, &tree);
    // From the same seed the shadow rays aim at the same points.
    let same = picture("cornell", 32, &Whitted { max_depth: 2 }, 512, 1);
    assert_eq!(asking, same);
}

#[test]
fn the_ends_of_the_ladder_see_what_they_say() {
    // No walk meets a point or a direction; shadow rays find them at diffuse surfaces.
    let dark = |integrator: &dyn Fn(&Scene, &Ray) -> Rgb| {
        let scene = gallery::load_with("whitted", |said| said.background = None).unwrap();
        let ray = scene.camera.ray(0.5, 0.95);
        integrator(&scene, &ray)
    };
    let stream = Stream::new(0, 0, 0);
    let walk =
        dark(&|scene, ray| Kajiya { max_depth: 9 }.li(&mut Tracer::new(scene), ray, &stream));
    let asking =
        dark(&|scene, ray| NextEvent { max_depth: 9 }.li(&mut Tracer::new(scene), ray, &stream));
    assert!(walk.is_black() && !asking.is_black(), "{walk:?} {asking:?}");

    // A path costs as many rays as it has segments, and one for each lamp at each surface.
    let room = furnace();
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.3, 0.2, 1.0).normalize());
    let mut tracer = Tracer::new(&room);
    Kajiya { max_depth: 8 }.li(&mut tracer, &ray, &stream);
    let count = tracer.counts();
    assert_eq!((count.camera, count.secondary, count.shadow), (1, 7, 0));
    let mut tracer = Tracer::new(&room);
    NextEvent { max_depth: 8 }.li(&mut tracer, &ray, &stream);
    let count = tracer.counts();
    // Nothing can come from the lamp one stands on.
    assert_eq!((count.camera, count.secondary, count.shadow), (1, 7, 7 * 5));
}

#[test]
fn walks_are_the_same_on_any_threads_and_finite_everywhere() {
    let on = |threads: usize, paint: &(dyn Fn() -> Film + Sync)| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(paint)
    };
    for (name, _) in GALLERY {
        let walk = || picture(name, 16, &Kajiya { max_depth: 12 }, 8, 3);
        let asking = || picture(name, 16, &NextEvent { max_depth: 12 }, 8, 3);
        assert_eq!(on(1, &walk), on(2, &walk), "{name}");
        assert_eq!(on(1, &asking), on(2, &asking), "{name}");
    }
}

/// An integrator seen through a change of colours.
struct Map<I>(I, fn(Rgb) -> Rgb);

impl<I: Integrator> Integrator for Map<I> {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        (self.1)(self.0.li(tracer, ray, stream))
    }
}

fn walk_wrongly(slip: Slip, max_depth: u32, scene: &Scene, ray: &Ray, walks: u32) -> Estimate {
    radiance(&Wrong { slip, max_depth }, scene, ray, walks)
}
