//! The gather against closed forms, in both worlds from the same lines: S1.02 to S1.21.

use crate::checks::{accept, reject};
use halfdisk::color::Rgb;
use halfdisk::integrators::world::{Diffuse, Step, World};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::furnace;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::worlds::{self, Counted, Furnace, Lit, Plates};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Tracer, gallery, read::Source};
use halfdisk::space::{Flat, Ray, Solid, Space};
use halfdisk::stats::Estimate;
use std::f64::consts::PI;

fn one_level(samples: u32, recipe: Recipe) -> Gather {
    Gather {
        samples,
        depth: 1,
        recipe,
    }
}

/// What a floor of albedo 0.8 reflects in a world.
fn reading<S: Space>(world: &mut impl World<S, Point = Lit<S>>, gather: Gather) -> Estimate {
    let floor = worlds::floor::<S>(0.8);
    (0..20_000)
        .map(|i| f64::from(gather.reflected(world, &floor, &Stream::new(2, i, 0)).r))
        .collect()
}

fn lamps<S: Space>() {
    for recipe in Recipe::ALL {
        let gather = one_level(64, recipe);
        let name = format!("{:?}, {recipe:?}", S::DIMENSION);
        let (low, high) = (-0.3_f32, 1.2_f32);
        let exact = 0.4 * (libm::sin(f64::from(high)) - libm::sin(f64::from(low)));
        let strip = reading::<S>(&mut worlds::strip::<S>(low, high), gather);
        accept(&format!("strip, {name}"), &strip, exact, exact);
        reject("with 1/π for 1/2", &strip, exact * 2.0 / PI);
        // Twice the lamp's radius: twice or four times the light.
        let exact = |sin: f64| 0.8 * sin.powi(S::FALL_OFF) * libm::cos(0.5);
        let ball = reading::<S>(&mut worlds::ball::<S>(0.7, 0.5), gather);
        accept(&format!("ball, {name}"), &ball, exact(0.7), exact(0.7));
        reject("with the other fall-off", &ball, exact(0.7) * 0.7);
    }
}

#[test]
fn s1_17_strips_and_balls_of_light() {
    lamps::<Flat>();
    lamps::<Solid>();
}

fn plates<S: Space>() {
    let mut plates = Plates {
        albedo: [0.8, 0.5],
        emission: [0.0, 1.0],
    };
    let floor = worlds::floor::<S>(0.8);
    for depth in [1, 2, 3, 12] {
        let gather = Gather {
            samples: if depth < 4 { 4 } else { 1 },
            depth,
            recipe: Recipe::Uniform,
        };
        let runs = [80_000, 60_000, 40_000, 600_000][(depth as usize - 1).min(3)];
        let reading: Estimate = (0..runs)
            .map(|i| {
                f64::from(
                    gather
                        .reflected::<S, _>(&mut plates, &floor, &Stream::new(4, i, 0))
                        .r,
                )
            })
            .collect();
        let [exact, _] = plates.radiance(depth);
        accept(
            &format!("{:?}, plates, depth {depth}", S::DIMENSION),
            &reading,
            exact,
            exact,
        );
        // Without the Lambert constant of this world: every bounce is off by the same factor.
        reject("the other world's constant", &reading, exact * PI / 2.0);
    }
    // All bounces: L = E + albedo L', solved by hand.
    let [all, _] = plates.radiance(100);
    assert!((all - 0.8 / (1.0 - 0.8 * 0.5)).abs() < 1e-7);
    let both = Plates {
        albedo: [0.5; 2],
        emission: [1.0, 0.0],
    }
    .radiance(60);
    assert!((both[0] - 4.0 / 3.0).abs() < 1e-12 && (both[1] - 2.0 / 3.0).abs() < 1e-12);
}

#[test]
fn s1_21_two_plates() {
    plates::<Flat>();
    plates::<Solid>();
}

fn bounces<S: Space>() {
    let albedo = 0.8_f32;
    let room = Furnace { albedo };
    // Cosine directions have no variance: each bounce adds albedo^k to the last digits.
    let at_depth = |depth| furnace::closed::<S>(Recipe::Cosine, albedo, depth, 100, 3).mean();
    for k in 1..=8 {
        let added = at_depth(k) - at_depth(k - 1);
        let exact = libm::pow(f64::from(albedo), f64::from(k));
        assert!((added - exact).abs() < 1e-5, "bounce {k}: {added}");
    }
    // Uniform ones have, and agree.
    let walks = furnace::closed::<S>(Recipe::Uniform, albedo, 5, 1_000_000, 3);
    let exact = room.radiance(5);
    accept(
        &format!("{:?}, furnace, depth 5", S::DIMENSION),
        &walks,
        exact,
        exact,
    );
    reject("all bounces", &walks, 1.0 / (1.0 - f64::from(albedo)));
    // A cut at depth 5 loses 26.2 % of the light.
    assert!((1.0 - exact * (1.0 - f64::from(albedo)) - 0.262).abs() < 1e-3);
}

#[test]
fn s1_07_a_closed_furnace_adds_a_power_of_its_albedo_with_each_bounce() {
    bounces::<Flat>();
    bounces::<Solid>();
}

#[test]
fn s1_20_the_open_furnace_reads_the_albedo_with_the_variance_it_should() {
    let check = |name: &str, reading: Estimate, sigma: f64| {
        accept(name, &reading, 0.6, 0.6);
        let measured = reading.variance().sqrt() / 0.6;
        println!("{name}: sigma {measured:.5}, exact {sigma:.5}");
        assert!((measured - sigma).abs() < 0.005);
    };
    let flat = |recipe| furnace::open::<Flat>(recipe, 0.6, 1, 400_000, 6);
    let solid = |recipe| furnace::open::<Solid>(recipe, 0.6, 1, 400_000, 6);
    check(
        "flat, uniform",
        flat(Recipe::Uniform),
        (PI * PI / 8.0 - 1.0).sqrt(),
    );
    check(
        "solid, uniform",
        solid(Recipe::Uniform),
        1.0 / 3.0_f64.sqrt(),
    );
    check("flat, cosine", flat(Recipe::Cosine), 0.0);
    check("solid, cosine", solid(Recipe::Cosine), 0.0);
}

#[test]
fn s0_04_a_tree_has_the_rays_it_should() {
    for (samples, depth, rays) in [(16, 2, 273), (16, 4, 69_905), (1, 7, 8), (4, 3, 85)] {
        let gather = Gather {
            samples,
            depth,
            recipe: Recipe::Uniform,
        };
        assert_eq!(gather.rays(), rays);
        let mut world = Counted::new(Furnace { albedo: 0.5 });
        let eye = Ray::<Flat>::new(glam::Vec2::ZERO, glam::Vec2::Y);
        gather.li(&mut world, &eye, &Stream::new(1, 0, 0));
        assert_eq!(world.rays, rays);
    }
    let gather = Gather {
        samples: 16,
        depth: 6,
        recipe: Recipe::Uniform,
    };
    assert_eq!(gather.rays(), 17_895_697);
}

/// A floor of albedo 0.5 under one lamp, in space.
fn lit_floor(lamp: &str) -> Estimate {
    let text = format!(
        "name = \"lit floor\"\n[camera]\nfrom = [0, 1, 0.5]\nto = [0, 0, 0]\nfov = 40\n\
         [film]\nsize = [4, 4]\n[materials.grey]\nlambert = {{ albedo = [0.5, 0.5, 0.5] }}\n\
         [[objects]]\nmaterial = \"grey\"\n\
         quad = {{ corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n\
         [[objects]]\nemits = 1\n{lamp}\n"
    );
    let source = Source {
        file: "lit floor",
        text: &text,
    };
    let scene = gallery::from_text(source, None, |_| {}).expect("a right scene");
    let mut tracer = Tracer::new(&scene);
    let camera = scene.camera.ray(0.5, 0.5);
    let eye = Ray::<Solid>::new(camera.origin, camera.direction);
    let gather = Gather {
        samples: 1,
        depth: 0,
        recipe: Recipe::Uniform,
    };
    (0..100_000)
        .map(|i| {
            let li: Rgb = gather.li(&mut tracer, &eye, &Stream::new(5, i, 0));
            f64::from(li.g)
        })
        .collect()
}

#[test]
fn s1_10_lamps_of_a_scene_by_shadow_rays() {
    // A sphere of radius 0.5, two units above: π (R/d)², times albedo over π.
    let sphere = lit_floor("sphere = { center = [0, 2, 0], radius = 0.5 }");
    accept("sphere", &sphere, 0.5 / 16.0, 0.5 / 16.0);
    reject("sphere as a disc", &sphere, 0.5 / 17.0);
    // A unit square centred one unit above.
    let square = lit_floor("quad = { corner = [-0.5, 1, -0.5], u = [1, 0, 0], v = [0, 0, 1] }");
    let exact = 0.5 * 0.752_274_688 / PI;
    accept("square", &square, exact, exact);
    reject("square as a point", &square, 0.5 / PI);
}

/// A unit square room whose ceiling shines; all walls reflect one half. Flat only.
struct Room;

impl World<Flat> for Room {
    type Point = Lit<Flat>;

    fn intersect(&mut self, ray: &Ray<Flat>, _: u32) -> Option<Lit<Flat>> {
        let (o, d) = (ray.origin, ray.direction);
        let to = |o: f32, d: f32| if d > 0.0 { (1.0 - o) / d } else { -o / d };
        let (tx, ty) = (to(o.x, d.x), to(o.y, d.y));
        let mut p = ray.at(tx.min(ty)).clamp(glam::Vec2::ZERO, glam::Vec2::ONE);
        let n = if tx < ty {
            p.x = f32::from(u8::from(d.x > 0.0));
            glam::Vec2::new(-d.x.signum(), 0.0)
        } else {
            p.y = f32::from(u8::from(d.y > 0.0));
            glam::Vec2::new(0.0, -d.y.signum())
        };
        let emission = Rgb::grey(f32::from(u8::from(n.y < 0.0)));
        let Lit { surface, .. } = worlds::floor(0.5);
        Some(Lit {
            surface: Diffuse { p, n, ..surface },
            emission,
        })
    }

    fn emitted(&self, _: &Ray<Flat>, hit: Option<&Lit<Flat>>) -> Rgb {
        hit.map_or(Rgb::BLACK, |hit| hit.emission)
    }

    fn diffuse(&self, at: &Lit<Flat>) -> Diffuse<Flat> {
        at.surface
    }

    fn sample_bsdf(&self, at: &Lit<Flat>, vertex: u64, stream: &Stream) -> Option<Step<Flat>> {
        Some(at.sample(vertex, stream))
    }
}

#[test]
fn s0_25_the_golden_room() {
    let mut middle = worlds::floor::<Flat>(0.5);
    middle.surface.p = glam::Vec2::new(0.5, 0.0);
    let walk = Gather {
        samples: 1,
        depth: 24,
        recipe: Recipe::Cosine,
    };
    let reading: Estimate = (0..400_000)
        .map(|i| f64::from(walk.reflected(&mut Room, &middle, &Stream::new(7, i, 0)).r))
        .collect();
    accept("floor midpoint", &reading, 0.330_679_4, 0.330_679_4);
    reject("without the second bounce", &reading, 0.223_606_8);
}
