//! The path tracer for use paints what the plain ladder paints.

use crate::checks::{accept, alike, between, reject};
use crate::of_chapters::left_out::{LeftOut, Less, PathWithout};
use glam::{Vec2, Vec3};
use halfdisk::flatland::{self, exact};
use halfdisk::geometry::Ray;
use halfdisk::integrators::world::{FlatTracer, World};
use halfdisk::integrators::{AllLight, Combine, Integrator, Path};
use halfdisk::lab::mistakes::misled::{Misled, Slip};
use halfdisk::render::{Options, Picture, compare, render};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::scene::gallery::{self, GALLERY};
use halfdisk::scene::read::Source;
use halfdisk::scene::{CausticGuide, Scene, Tracer};
use halfdisk::space::{self, Flat};
use halfdisk::stats::Estimate;

fn picture(scene: &Scene, integrator: &impl Integrator, spp: u32, seed: u64) -> Picture {
    // Evenly, so that the edges of lamps that are seen make little noise.
    let options = Options {
        spp,
        seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &());
    assert_eq!(rendered.non_finite, 0, "{}", scene.name);
    rendered.film.picture()
}

fn small(name: &str) -> Scene {
    gallery::load(name).unwrap().sized([16; 2])
}

#[test]
fn on_every_scene_of_the_gallery() {
    let mut noticed = Vec::new();
    for (name, _) in GALLERY {
        let scene = small(name);
        let max_depth = scene.suggested.max_depth.min(12);
        let heuristic = Heuristic::Balance;
        let plain = Combine {
            max_depth,
            heuristic,
        };
        // Of points `combine` finds nothing that is focused.
        let path = match scene.inventory.point_lights {
            0 => Path::new(max_depth),
            _ => Path::from_eye(max_depth),
        };
        let path = Path {
            roulette_from: 3,
            ..path
        };
        let ours = picture(&scene, &path, 1024, 1);
        let theirs = picture(&scene, &plain, 1024, 2);
        let [ours, theirs] = [ours, theirs].map(|p| p.in_squares(4));
        let mean = |picture: &Picture| {
            let (mean, error) = picture.mean();
            (mean, error.unwrap())
        };
        if mean(&theirs) == (0.0, 0.0) {
            assert_eq!(mean(&ours), (0.0, 0.0), "{name}");
            continue;
        }
        alike(name, mean(&ours), mean(&theirs), 0.3);
        noticed.push(between(mean(&ours), mean(&theirs)).1);
        // 48 numbers and errors of their own: 6 leaves room for their tails.
        let z = compare::z_scores(&ours, &theirs).unwrap();
        assert!(z.largest < 6.0, "{name}: {}", z.largest);
    }
    // What is focused and only met by chance is known to less.
    noticed.sort_by(f64::total_cmp);
    let median = noticed[noticed.len() / 2];
    assert!(median < 0.02, "half of the scenes notice {median}");
}

/// The mean over pixels of the squared error, relative to the light of the pixel.
fn noise(picture: &Picture) -> f64 {
    let errors = picture.errors.as_ref().unwrap().iter().flatten();
    let values = picture.values.iter().flatten();
    let relative = errors.zip(values).map(|(e, x)| e * e / (x * x + 0.01));
    relative.collect::<Estimate>().mean()
}

#[test]
fn looking_towards_glass_changes_the_noise_and_not_the_mean() {
    // Errors over errors without, of eleven seeds: 0.70 ± 0.03 and 0.64 ± 0.06.
    for (name, most) in [("spheres", 0.8), ("caustic", 0.85)] {
        let scene = small(name);
        let path = Path::new(scene.suggested.max_depth);
        let looking = picture(&scene, &path, 4096, 1);
        let mut blind = scene.clone();
        blind.casters = CausticGuide::default();
        let not = picture(&blind, &path, 4096, 2);
        let error = |p: &Picture| p.mean().1.unwrap();
        let mean = |p: &Picture| (p.mean().0, error(p));
        alike(name, mean(&looking), mean(&not), 0.06);
        let z = compare::z_scores(&looking.in_squares(8), &not.in_squares(8)).unwrap();
        assert!(z.largest < 6.0, "{name}: {}", z.largest);
        let share = noise(&looking) / noise(&not);
        println!("{name}: {share:.2} of the noise");
        assert!(share < most, "{name}: {share}");
    }
}

/// The light that a floor of albedo 0.5 under a ball of a lamp scatters to us, on two segments: the
/// lamp's own alone, `albedo L sin² θ cos γ`. Where the weights of its two ways add up to something
/// else than one, that is told.
fn a_lamp_over_a_floor(lamp: [f64; 3], radius: f64, material: &str, objects: &str) {
    let albedo = 0.5;
    let text = format!(
        "name = 'test'\ncamera = {{ from = [0, 2, 5], to = [0, 0, 0], fov = 40 }}\n\
         materials.half.lambert.albedo = {albedo}\n\
         materials.mirror.mirror.reflectance = 0.9\nmaterials.glass.glass.ior = 1.5\n\
         [[objects]]\nmaterial = 'half'\nquad = {{ corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n\
         [[objects]]\n{material}emits = 4\nsphere = {{ center = {lamp:?}, radius = {radius} }}\n{objects}"
    );
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    let scene = gallery::from_text(source, None, |_| {}).unwrap();
    // From the eye, which is the origin, to the floor below the origin of the file.
    let ray = Ray::new(Vec3::ZERO, Vec3::new(0.0, -2.0, -5.0).normalize());
    let mut tracer = Tracer::new(&scene);
    let path = Path::new(2);
    let estimate: Estimate = (0..400_000)
        .map(|i| f64::from(path.li(&mut tracer, &ray, &Stream::new(6, i, 0)).g))
        .collect();
    let distance2: f64 = lamp.iter().map(|x| x * x).sum();
    let truth = albedo * 4.0 * (radius * radius / distance2) * lamp[1] / distance2.sqrt();
    let name = format!("{lamp:?}, {radius}, {material}{objects}");
    accept(&name, &estimate, truth, truth);
}

#[test]
fn weights_of_aimed_and_met_light_add_up_to_one_before_mirrors_and_glass() {
    // Before, behind or beside the lamp stands what focuses light and is looked at.
    for (lamp, radius) in [([0.0, 1.0, 0.0], 0.5), ([1.0, 1.5, 0.5], 0.9)] {
        for caster in [
            "material = 'mirror'\nsphere = { center = [0, 4, 0], radius = 1.5 }\n",
            "material = 'mirror'\nsphere = { center = [2.5, 3, 1.2], radius = 1 }\n",
            "material = 'glass'\nsphere = { center = [1, 4, 0.5], radius = 1.5 }\n",
            "material = 'mirror'\nsphere = { center = [-1.5, 0.8, 0], radius = 0.7 }\n",
        ] {
            a_lamp_over_a_floor(lamp, radius, "", &format!("[[objects]]\n{caster}"));
        }
    }
}

#[test]
fn weights_of_aimed_and_met_light_add_up_to_one_where_the_lamp_is_of_glass_however_small() {
    for radius in [1e-6, 1e-4, 1e-3, 3e-3, 5e-3, 0.02, 0.3] {
        for material in ["material = 'glass'\n", "material = 'mirror'\n"] {
            a_lamp_over_a_floor([1.3, 3.7, -0.6], radius, material, "");
        }
    }
}

#[test]
fn with_any_ingredient_left_out_the_flat_room_reads_the_same_and_counted_twice_it_does_not() {
    let room = flatland::load("room").unwrap();
    let eye = space::Ray::<Flat>::new(Vec2::splat(0.5), Vec2::NEG_Y);
    let walk = |world: &mut dyn FnMut(&Stream) -> AllLight| -> Estimate {
        let one = |i| f64::from(world(&Stream::new(31, i, 0)).li.r);
        (0..200_000).map(one).collect()
    };
    fn follow(
        path: Path,
        world: &mut impl World<Flat>,
        eye: &space::Ray<Flat>,
        s: &Stream,
    ) -> AllLight {
        let mut all = AllLight::default();
        path.walk(world, eye, s, &mut all);
        all
    }
    let truth = exact::ROOM_FLOOR;
    for left_out in [
        LeftOut::Nothing,
        LeftOut::Aiming,
        LeftOut::Weights,
        LeftOut::Roulette,
    ] {
        let max_depth = 64;
        let path = PathWithout {
            max_depth,
            left_out,
        }
        .path();
        let mut world = Less {
            world: FlatTracer::new(&room),
            left_out,
        };
        let read = walk(&mut |s| follow(path, &mut world, &eye, s));
        accept(&format!("without {left_out:?}"), &read, truth, truth);
    }
    // Half of the work undone: shadow rays are sent, and what they find is met as well.
    let mut twice = Misled {
        world: FlatTracer::new(&room),
        slip: Slip::CountedTwice,
    };
    let read = walk(&mut |s| follow(Path::new(64), &mut twice, &eye, s));
    reject("counted twice", &read, truth);
}
