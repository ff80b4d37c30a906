//! One ray of three kinds: closed forms of mixtures, and the light of the other walks.

use super::wrong::{Slip, Wrong};
use super::*;
use halfdisk::integrators::{Combine, WhichRay};
use halfdisk::materials::Choice;
use halfdisk::sampling::mis::Heuristic;

const CHOICES: [Choice; 4] = [
    Choice::Equal,
    Choice::ByMean,
    Choice::ByLuminance,
    Choice::Analog,
];

fn mixed([kd, ks, kt]: [f32; 3]) -> String {
    format!(
        "background = [1, 1, 1]\n\
         materials.mixed.mixture = {{ kd = {kd}, ks = {ks}, kt = {kt}, ior = 1.5 }}\n"
    )
}

fn towards() -> Ray {
    Ray::new(Vec3::ZERO, Vec3::new(0.3, 0.2, 1.0).normalize())
}

#[test]
fn s0_20_a_sheet_under_a_white_sky_reads_what_it_does_not_absorb() {
    for k in [[0.5, 0.3, 0.1], [0.2, 0.2, 0.2], [0.0, 0.4, 0.3]] {
        let truth: f64 = k.iter().copied().map(f64::from).sum();
        let sheet = "[[objects]]\nmaterial = 'mixed'\n\
                     quad = { corner = [9, -9, 2], u = [-18, 0, 0], v = [0, 18, 0] }";
        let scene = scene(&(mixed(k) + sheet));
        let max_depth = 2;
        for choice in CHOICES {
            let which = WhichRay { max_depth, choice };
            let read = radiance(&which, &scene, &towards(), 100_000);
            accept(&format!("{k:?} {choice:?}"), &read, truth, 3.0 * truth);
            let weights_alike = choice == Choice::ByMean || choice == Choice::ByLuminance;
            assert!(!weights_alike || read.variance() < 1e-10, "{choice:?}");
        }
        let forgotten = walk_wrongly(Slip::NoWeight, 2, &scene, &towards(), 1000);
        assert_eq!(forgotten.mean(), 1.0);
        reject("weight forgotten", &forgotten, truth);
    }
}

#[test]
fn a_closed_furnace_of_a_mixture_adds_a_power_of_its_shares_with_each_bounce() {
    // All walls glow with one, and what leaves through them meets a sky of one and never returns.
    for k in [[0.5, 0.3, 0.0], [0.3, 0.3, 0.3]] {
        let scene = scene(&(mixed(k) + &glowing_walls("mixed")));
        let [kd, ks, kt] = k.map(f64::from);
        for max_depth in [2, 3, 5] {
            let bounces = max_depth as i32 - 1;
            let stays = kd + ks;
            // Bounce j adds stays^(j - 1) (stays + kt): a power of k_tot where nothing is let through.
            let powers: f64 = (0..bounces).map(|j| stays.powi(j)).sum();
            let truth = 1.0 + powers * (stays + kt);
            for choice in CHOICES {
                let name = format!("{k:?}, {bounces} bounces, {choice:?}");
                let which = WhichRay { max_depth, choice };
                let read = radiance(&which, &scene, &towards(), 30_000);
                accept(&name, &read, truth, 3.0 * truth);
            }
            for slip in [Slip::NoWeight, Slip::CountTwice] {
                let read = walk_wrongly(slip, max_depth, &scene, &towards(), 5_000);
                reject("walked wrongly", &read, truth);
            }
        }
    }
}

#[test]
fn a_slab_is_that_of_the_tree_and_a_mixture_can_be_glass() {
    let which = WhichRay {
        max_depth: 32,
        choice: Choice::ByMean,
    };
    let glass = gallery::load("slab").unwrap();
    let shares = scene(
        "materials.pane.mixture = { kd = 0, ks = 0.04, kt = 0.96, ior = 1.5 }\n\
         [[objects]]\nmaterial = 'pane'\nbox = { min = [-99, -99, 4], max = [99, 99, 5] }\n\
         [[objects]]\nemits = [1, 0, 0]\n\
         quad = { corner = [-99, -99, 7], u = [0, 198, 0], v = [198, 0, 0] }\n\
         [[objects]]\nemits = [0, 1, 0]\n\
         quad = { corner = [-99, -99, -1], u = [198, 0, 0], v = [0, 198, 0] }",
    );
    for (name, slab) in [("glass", &glass), ("mixture", &shares)] {
        let middle = slab.camera.ray(0.5, 0.5);
        let tree = Whitted { max_depth: 32 };
        let tree = tree.li(&mut Tracer::new(slab), &middle, &Stream::new(0, 0, 0));
        let green = Map(which, |li| Rgb::grey(li.g));
        for (side, li, tree, truth, percent) in [
            (
                "through",
                radiance(&which, slab, &middle, 400_000),
                tree.r,
                12.0 / 13.0,
                0.5,
            ),
            (
                "back",
                radiance(&green, slab, &middle, 400_000),
                tree.g,
                1.0 / 13.0,
                5.0,
            ),
        ] {
            accept(
                &format!("slab of {name}, {side}"),
                &li,
                truth,
                percent * truth,
            );
            assert!(
                (f64::from(tree) - truth).abs() < 1e-6,
                "{name}, {side}: {tree}"
            );
        }
        let forgotten = walk_wrongly(Slip::NoProbability, 32, slab, &middle, 100_000);
        reject(name, &forgotten, 12.0 / 13.0);
    }
}

#[test]
fn it_paints_the_pictures_of_combine_and_path() {
    let max_depth = 12;
    let heuristic = Heuristic::Power;
    let combine = Combine {
        max_depth,
        heuristic,
    };
    let combine = picture("mixture", 12, &combine, 2048, 2);
    let whole = halfdisk::integrators::Path::new(max_depth);
    let path = picture("mixture", 12, &whole, 2048, 3);
    for choice in CHOICES {
        let which = picture("mixture", 12, &WhichRay { max_depth, choice }, 2048, 1);
        agree("mixture", max_depth, &which, &combine);
        agree("mixture", max_depth, &which, &path);
    }
    for slip in [Slip::NoWeight, Slip::CountTwice] {
        let wrong = picture("mixture", 12, &Wrong { slip, max_depth }, 512, 1);
        let z = apart("walked wrongly", &wrong, &combine);
        assert!(z > CRITICAL, "{z}");
    }
}

#[test]
fn a_path_costs_one_ray_and_one_for_each_lamp_at_each_surface() {
    let lamps = "[[objects]]\nemits = 1\nsphere = { center = [0, 3, 0], radius = 0.5 }\n\
                 [[objects]]\nemits = 1\nsphere = { center = [2, 3, 0], radius = 0.5 }\n\
                 [[objects]]\nemits = 1\nsphere = { center = [-2, 3, 0], radius = 0.5 }\n";
    let walls = glowing_walls("mixed").replace("emits = 1\n", "");
    let far = "quad = { corner = [-90, -1, 90], u = [180, 0, 0], v = [0, 0, -180] }";
    let floor = format!("[[objects]]\nmaterial = 'half'\n{far}\n");
    let count = |text: &str, max_depth| {
        let scene = scene(text);
        let which = WhichRay {
            max_depth,
            choice: Choice::ByMean,
        };
        let mut tracer = Tracer::new(&scene);
        let down = Ray::new(Vec3::ZERO, Vec3::new(0.1, -1.0, 0.1).normalize());
        which.li(&mut tracer, &down, &Stream::new(1, 0, 0));
        let count = tracer.counts();
        (count.camera, count.secondary, count.shadow)
    };
    // Three lamps above a floor; no lamp in a room of no transmission.
    assert_eq!(count(&(floor + lamps), 2), (1, 1, 3));
    assert_eq!(count(&(mixed([0.5, 0.5, 0.0]) + &walls), 9), (1, 8, 0));
    // What leaves by a mirror or goes through asks no lamp: none of them shines by way of it.
    let mirror = mixed([0.0, 1.0, 0.0]) + "[[objects]]\nmaterial = 'mixed'\n" + far + "\n" + lamps;
    assert_eq!(count(&mirror, 2), (1, 1, 0));
}
