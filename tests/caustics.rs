//! Caustics traced from the lights are those that walks from the eye find, and points have some, too.

use crate::checks::{CRITICAL, alike, between, unlike};
use halfdisk::integrators::{FilteredPath, Integrator, LightTracer, Path};
use halfdisk::lab::effects::by_class::by_class;
use halfdisk::lab::effects::language::Class;
use halfdisk::lab::effects::words::words;
use halfdisk::notation::Expression;
use halfdisk::render::accuracy::{Accuracy, Measure};
use halfdisk::render::stopping::{Goal, predict, render_to};
use halfdisk::render::{Options, Rendered, compare, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::Scene;
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;

/// What is traced from lamps with extent.
const TRACED: &str = "LS(D|S|G)*DE";

/// A floor seen from above at an angle, and materials.
const FLOOR: &str = "name = 'test'\nfilm.size = [16, 16]\nrender.max_depth = 6\n\
    camera = { from = [0, 4, 6], to = [0, 0.5, 0], fov = 40, shutter = [0, 1] }\n\
    [materials]\nhalf.lambert.albedo = 0.5\nclear.glass.ior = 1.5\nmirror.mirror.reflectance = 0.9\n\
    coat.mixture = { kd = 0.3, ks = 0.6, kt = 0 }\nsilk.glossy = { reflectance = 0.8, roughness = 0.5 }\n\
    [[objects]]\nmaterial = 'half'\nquad = { corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }\n";
const LAMP: &str = "[[objects]]\nemits = 9\nsphere = { center = [1, 4, -1], radius = 0.8 }\n";
const BALL: &str =
    "[[objects]]\nmaterial = 'clear'\nsphere = { center = [0, 1, 0], radius = 0.8 }\n";

fn scene(parts: &[&str]) -> Scene {
    let text = FLOOR.to_owned() + &parts.concat();
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

fn rendered(scene: &Scene, integrator: &dyn Integrator, spp: u32, seed: u64) -> Rendered {
    let options = Options {
        spp,
        seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &());
    assert_eq!(rendered.faults, Default::default(), "{}", scene.name);
    rendered
}

/// The picture of some paths.
fn of(scene: &Scene, path: Path, paths: &str, spp: u32, seed: u64) -> Rendered {
    let paths: Expression = paths.parse().unwrap();
    let paths = paths.eye_first();
    rendered(scene, &FilteredPath { path, paths }, spp, seed)
}

/// Scenes with caustics of every kind of light and of what focuses it.
fn scenes() -> Vec<(&'static str, Scene)> {
    let many: String = (0..10)
        .map(|i| {
            let (x, z) = (0.8 * f64::from(i % 4) - 1.2, 0.9 * f64::from(i / 4) - 1.0);
            format!("[[objects]]\nmaterial = 'clear'\nsphere = {{ center = [{x}, 0.6, {z}], radius = 0.3 }}\n")
        })
        .collect();
    let mirror = "[[objects]]\nmaterial = 'mirror'\n\
        quad = { corner = [-2, 0, -2], u = [4, 0, 0], v = [0, 3, 0] }\n";
    vec![
        ("a ball of glass", scene(&[LAMP, BALL])),
        ("a flat mirror", scene(&[LAMP, mirror])),
        ("both, one before the other", scene(&[LAMP, BALL, mirror])),
        ("ten balls", scene(&[LAMP, &many])),
        (
            "bumpy glass",
            scene(&[
                LAMP,
                "[[objects]]\nmaterial = 'clear'\n\
                 bumpy_sphere = { center = [0, 1, 0], radius = 0.8, columns = 24, rows = 12 }\n",
            ]),
        ),
        (
            "a box of glass",
            scene(&[
                LAMP,
                "[[objects]]\nmaterial = 'clear'\nbox = { min = [-0.5, 0.2, -0.6], max = [0.5, 1, 0.6] }\n",
            ]),
        ),
        (
            "a lamp in a ball",
            scene(&[
                "[[objects]]\nemits = 9\nsphere = { center = [0.3, 1.5, 0], radius = 0.4 }\n",
                "[[objects]]\nmaterial = 'clear'\nsphere = { center = [0, 1.5, 0], radius = 1 }\n",
            ]),
        ),
        (
            "a lamp with two sides",
            scene(&[
                BALL,
                "[[objects]]\nemits = 9\ntwo_sided = true\n\
                 quad = { corner = [1, 1, -1], u = [0.2, 1.4, 0], v = [0, 0, 2] }\n",
            ]),
        ),
        (
            "paint under a coat",
            scene(&[
                // Large, for few walks from the eye find what a ball's side reflects.
                "[[objects]]\nemits = 9\nsphere = { center = [2, 5, -2], radius = 2.5 }\n",
                "[[objects]]\nmaterial = 'coat'\nsphere = { center = [0, 1, 0], radius = 0.8 }\n",
            ]),
        ),
        (
            "silk beside a mirror",
            scene(&[
                LAMP,
                mirror,
                "[[objects]]\nmaterial = 'silk'\nsphere = { center = [0, 1, 0], radius = 0.8 }\n",
            ]),
        ),
        (
            "a ball that moves",
            scene(&[
                LAMP,
                "[[objects]]\nmaterial = 'clear'\nmotion = [1, 0.4, 0]\n\
                 sphere = { center = [0, 1, 0], radius = 0.6 }\n",
            ]),
        ),
        (
            "a sky beside a lamp",
            scene(&["[environment]\nradiance = 1\n", LAMP, BALL]),
        ),
    ]
}

#[test]
fn walks_from_the_lights_bring_the_caustics_that_walks_from_the_eye_find() {
    let mut noticed = Vec::new();
    for (name, scene) in scenes() {
        let max_depth = scene.suggested.max_depth;
        let ours = of(&scene, Path::new(max_depth), TRACED, 1024, 1);
        let theirs = of(&scene, Path::from_eye(max_depth), TRACED, 2048, 2);
        assert!(!ours.is_black(), "{name}");
        alike(name, ours.mean(), theirs.mean(), 0.6);
        noticed.push(between(ours.mean(), theirs.mean()).1);
        let [a, b] = [&ours, &theirs].map(|r| r.film.picture().in_squares(4));
        let z = compare::z_scores(&a, &b).unwrap();
        assert!(z.largest < 6.0, "{name}: {}", z.largest);
        // Nothing is lost between the two and nothing counts twice.
        let whole = rendered(&scene, &Path::new(max_depth), 256, 3);
        let plain = rendered(&scene, &Path::from_eye(max_depth), 256, 4);
        alike(&format!("{name}, whole"), whole.mean(), plain.mean(), 0.2);
    }
    noticed.sort_by(f64::total_cmp);
    println!("noticed: {noticed:.4?}");
    let median = noticed[noticed.len() / 2];
    assert!(median < 0.2, "half of the scenes notice {median}");
}

/// A walk from the eye that forgets what is traced from the lights, or that finds it as well.
#[test]
fn light_that_nobody_or_everybody_traces_is_noticed() {
    let scene = scene(&[LAMP, BALL]);
    let right = rendered(&scene, &Path::from_eye(6), 256, 1).mean();
    let traced = of(&scene, Path::new(6), TRACED, 256, 2).mean();
    let sum = |factor: f64| (right.0 + factor * traced.0, right.1.hypot(traced.1));
    unlike("twice", sum(1.0), right);
    unlike("never", sum(-1.0), right);
    let path = rendered(&scene, &Path::new(6), 256, 3);
    alike("once", path.mean(), right, 0.05);
}

/// The number of paths from the lights changes the noise alone, down to one.
#[test]
fn any_number_of_light_paths_brings_the_same_light() {
    let scene = scene(&[LAMP, BALL]);
    let with = |light_paths, seed| {
        let path = Path {
            light_paths: Some(light_paths),
            ..Path::new(6)
        };
        of(&scene, path, TRACED, 512, seed).mean()
    };
    let many = with(1024, 1);
    for (few, share) in [(100, 0.05), (1, 0.6)] {
        alike(&few.to_string(), with(few, 2), many, share);
    }
}

/// A pilot splits the samples between the eye and the lights so that they need fewer rays, and the picture is that of a render with as many of both.
#[test]
fn a_pilot_splits_the_samples_between_the_eye_and_the_lights() {
    let flames = "[[lights]]\npoint = { position = [1, 4, -1], intensity = 20 }\n";
    let bumpy = "[[objects]]\nmaterial = 'clear'\n\
        bumpy_sphere = { center = [0, 1, 0], radius = 0.8, columns = 24, rows = 12 }\n";
    let scene = scene(&[flames, bumpy]);
    let goal = Goal {
        error: Some(0.03),
        ..Goal::default()
    };
    let options = Options {
        seed: 1,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let split = render_to(&scene, &Path::new(6), &options, &goal, &());
    let said = split.prediction.unwrap();
    let light_paths = said
        .light_paths
        .expect("all the noise is that of paths from the light");
    assert!(light_paths > Path::new(6).light_paths_of(&scene));
    let path = Path::new(6).with(light_paths);
    assert_eq!(
        rendered(&scene, &path, split.spp, 1).film,
        split.rendered.film
    );

    // Who asks for a number of them gets that.
    let usual = Path::new(6).with(Path::new(6).light_paths_of(&scene));
    let predict = |path: &dyn Integrator| predict(&scene, path, &options, &goal, &()).unwrap();
    assert_eq!(predict(&usual).light_paths, None);
    let price = |path: Path| {
        let long = rendered(&scene, &path, 2048, 2);
        let error = Accuracy::of(&long.film).error(Measure::RootMeanSquare);
        error * error * long.rays.total() as f64
    };
    let gain = price(usual) / price(path);
    assert!(gain > 1.05, "{gain}");

    // And so do the paths of a language alone.
    let paths: Expression = TRACED.replace("LS", "LS*").parse().unwrap();
    let filtered = FilteredPath {
        path: Path::new(6),
        paths: paths.eye_first(),
    };
    assert!(predict(&filtered).light_paths.is_some());
}

/// Points and directions: the light tracer finds the same, all of it but what is seen in glass.
#[test]
fn points_and_directions_have_caustics() {
    for (name, light) in [
        ("point", "point = { position = [1, 4, -1], intensity = 20 }"),
        (
            "direction",
            "directional = { direction = [-0.3, -1, 0.2], irradiance = 3 }",
        ),
    ] {
        let light = format!("[[lights]]\n{light}\n");
        let silk =
            "[[objects]]\nmaterial = 'silk'\nsphere = { center = [1.6, 0.5, 0.6], radius = 0.5 }\n";
        let scene = scene(&[&light, BALL, silk]);
        let focused = "LS(D|S|G)*(D|G)E";
        let ours = of(&scene, Path::new(6), focused, 256, 1);
        let none = of(&scene, Path::from_eye(6), focused, 256, 1);
        assert!(none.is_black() && !ours.is_black(), "{name}");
        let whole = of(&scene, Path::new(6), "L(D|S|G)*(D|G)E", 256, 1);
        let theirs = rendered(&scene, &LightTracer { max_depth: 6 }, 1024, 2);
        alike(name, whole.mean(), theirs.mean(), 0.1);
        let [a, b] = [&whole, &theirs].map(|r| r.film.picture().in_squares(4));
        let z = compare::z_scores(&a, &b).unwrap();
        assert!(z.largest < 6.0, "{name}: {}", z.largest);
        unlike(
            &format!("{name}, without"),
            of(&scene, Path::from_eye(6), "L(D|S|G)*(D|G)E", 256, 1).mean(),
            theirs.mean(),
        );
    }
}

/// Classes and words tell of what comes from the lights as of all else.
#[test]
fn classes_and_words_hold_what_is_traced_from_the_lights() {
    let scene = scene(&[LAMP, BALL]);
    let options = Options {
        spp: 512,
        seed: 5,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let path = Path::new(6);
    let sorted = by_class(&scene, path, &Class::ALL, &options, &());
    let sum: f64 = sorted.pictures.iter().map(|film| film.mean().0).sum();
    let whole = sorted.rendered.film.mean().0;
    assert!((sum / whole - 1.0).abs() < 1e-5, "{sum} {whole}");
    assert_eq!(
        sorted.rendered.film,
        render(&scene, &path, &options, &()).film,
        "sorting changes nothing"
    );
    let plain = by_class(&scene, Path::from_eye(6), &Class::ALL, &options, &());
    for (class, films) in Class::ALL
        .iter()
        .zip(sorted.pictures.iter().zip(&plain.pictures))
    {
        let [ours, theirs] = [films.0.mean(), films.1.mean()];
        match class {
            Class::Caustic => alike(class.name(), ours, theirs, 0.2),
            _ => assert!(
                ours == theirs || between(ours, theirs).0.abs() < CRITICAL,
                "{}: {ours:?} {theirs:?}",
                class.name()
            ),
        }
    }
    // Word by word against the picture of the word.
    let all = words(&scene, &path, &options, 4);
    for (word, share_noticed) in [("LSSDE", 0.1), ("LSDE", 0.8)] {
        let (_, share) = all
            .shares
            .iter()
            .find(|(other, _)| other.to_string() == word)
            .unwrap();
        let light = (share.light.mean(), share.light.std_error());
        let picture = of(&scene, path, word, 512, 9).mean();
        alike(word, light, picture, share_noticed);
    }
}

#[test]
fn nothing_is_traced_from_the_lights_where_there_are_no_caustics() {
    let room = gallery::load("cornell").unwrap();
    let sky = scene(&["[environment]\nradiance = 1\n", BALL]);
    let dark = scene(&[BALL]);
    for (name, scene) in [("cornell", &room), ("a sky", &sky), ("no light", &dark)] {
        assert!(!Path::new(6).traces_caustics(scene), "{name}");
        assert!(Path::new(6).passes(scene).is_none(), "{name}");
    }
    let lit = scene(&[LAMP, BALL]);
    assert!(Path::new(3).traces_caustics(&lit) && !Path::new(2).traces_caustics(&lit));
    assert!(!Path::from_eye(6).traces_caustics(&lit));
}
