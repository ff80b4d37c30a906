//! Light by its paths: classes, words, demands, and what is out of reach.

use super::{FLOOR, LAMP, POINT, path, scene, small, with};
use crate::cli::{complaint, folder, halfdisk};
use halfdisk::integrators::{FilteredPath, Path};
use halfdisk::lab::effects::by_class::by_class;
use halfdisk::lab::effects::language::{Class, Wanted, everything};
use halfdisk::lab::effects::measure::{Setup, difference};
use halfdisk::lab::effects::plan::{demand, plan};
use halfdisk::lab::effects::words::words;
use halfdisk::notation::Expression;
use halfdisk::render::{Options, render};
use halfdisk::sampling::stream::Sampler;
use std::fs;

#[test]
fn a_point_light_through_glass_reads_exactly_nothing_and_the_plan_says_so() {
    // All of the floor that is seen lies under a pane of glass as wide as the world.
    let pane = "[[objects]]\nmaterial = 'clear'\n\
                quad = { corner = [-400, 0.5, 400], u = [800, 0, 0], v = [0, 0, -800] }\n";
    let covered = |light: &str| scene("", &(FLOOR.to_owned() + pane + light));
    let by_a_point = covered(POINT);
    let seen = path(&by_a_point).film;
    let caustics = Class::Caustic.expression();
    let only = FilteredPath {
        path: Path::new(12),
        paths: caustics.eye_first(),
    };
    assert_eq!(with(&by_a_point, &only).film.max(), 0.0);
    assert_eq!(seen.max(), 0.0, "the pane covers the floor");
    let said = plan(&by_a_point).out_of_reach.unwrap();
    assert_eq!(said.paths, "LS+D(D|S)*SE");
    assert!(said.reason.contains("Only `photons`"), "{}", said.reason);
    // The same light with an extent arrives.
    let by_a_lamp = covered(&LAMP.replace("[0, 2, 1]", "[0, 3, 1]"));
    assert!(with(&by_a_lamp, &only).film.max() > 0.0);
    assert!(plan(&by_a_lamp).out_of_reach.is_none());

    let folder = folder();
    let text = format!(
        "name = 'pane'\nfilm.size = [8, 6]\nmaterials.half.lambert.albedo = 0.5\n\
         materials.clear.glass.ior = 1.5\n[camera]\nfrom = [0, 1, 5]\nto = [0, 0.5, 0]\nfov = 45\n\
         {FLOOR}{pane}{POINT}"
    );
    fs::write(folder.path().join("pane.toml"), text).unwrap();
    let output = halfdisk(folder.path(), &["render", "pane.toml", "--spp", "1"]);
    assert!(complaint(&output).contains("note: LS+D(D|S)*SE is out of reach"));
}

#[test]
fn classes_of_paths_add_up_to_the_picture() {
    for name in ["cornell", "caustic", "gloss", "mixture"] {
        let scene = small(name);
        let path = Path::new(scene.suggested.max_depth);
        let whole = with(&scene, &path).film.picture();
        let mut sums = vec![[0.0; 3]; whole.values.len()];
        for class in Class::ALL {
            let expression = class.expression();
            let paths = expression.eye_first();
            let part = with(&scene, &FilteredPath { path, paths }).film.picture();
            for (sum, part) in sums.iter_mut().zip(part.values) {
                (0..3).for_each(|c| sum[c] += part[c]);
            }
        }
        let total: f64 = whole.values.iter().flatten().sum();
        let sum: f64 = sums.iter().flatten().sum();
        assert!((sum / total - 1.0).abs() < 1e-6, "{name}: {sum} {total}");
        let brightest = whole
            .values
            .iter()
            .flatten()
            .fold(0.0, |a: f64, b| a.max(*b));
        for (sum, whole) in sums.iter().flatten().zip(whole.values.iter().flatten()) {
            assert!(
                (sum - whole).abs() <= 1e-6 * brightest,
                "{name}: {sum} {whole}"
            );
        }
        // A class that is left out is missed.
        let bleeding = Class::Bleeding.expression();
        let paths = bleeding.eye_first();
        let part = with(&scene, &FilteredPath { path, paths }).film.mean().0;
        assert!(part > 1e-3 * whole.mean().0, "{name}: {part}");
    }
}

#[test]
fn a_restriction_to_everything_is_none_and_prunes_what_cannot_count() {
    let scene = small("mixture");
    let path = Path::new(scene.suggested.max_depth);
    let all = everything();
    let paths = all.eye_first();
    let restricted = with(&scene, &FilteredPath { path, paths });
    let free = with(&scene, &path);
    assert_eq!((restricted.film, restricted.rays), (free.film, free.rays));
    let direct = Class::Direct.expression();
    let paths = direct.eye_first();
    let pruned = with(&scene, &FilteredPath { path, paths });
    assert_eq!(pruned.rays.camera, free.rays.camera);
    // The ray that follows a diffuse surface may still meet a lamp; none goes on from there.
    assert!(pruned.rays.secondary <= pruned.rays.camera);
    assert!(pruned.rays.total() < free.rays.total());
}

#[test]
fn words_hold_all_light_of_the_picture_on_any_number_of_threads() {
    let scene = small("caustic");
    let path = Path::new(scene.suggested.max_depth);
    let options = Options {
        spp: 4,
        ..Options::default()
    };
    let count = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build()
            .unwrap()
            .install(|| words(&scene, &path, &options, 3))
    };
    let (one, three) = (count(1), count(3));
    let sum: f64 = one.shares.values().map(|s| s.light.mean()).sum();
    assert!((sum / one.total.mean() - 1.0).abs() < 1e-6);
    for ((word, a), (other, b)) in one.shares.iter().zip(&three.shares) {
        assert_eq!((word, a.light, a.paths), (other, b.light, b.paths));
        assert!(everything().light_first().accepts(&word.0), "{word}");
    }
    let rendered = render(&scene, &path, &options, &()).film.mean().0;
    let first = words(&scene, &path, &options, 1).total.mean();
    assert!((first / rendered - 1.0).abs() < 1e-6, "{first} {rendered}");
}

#[test]
fn a_demand_says_what_it_keeps() {
    let cornell = small("cornell");
    let direct = Class::Direct.expression();
    let left = demand(&cornell.inventory, direct.light_first()).unwrap();
    assert_eq!((left.all, left.kept), (false, vec!["LDE".to_owned()]));
    assert_eq!(left.left_out[..2], ["LE", "LDDE"]);
    assert!(
        demand(&cornell.inventory, everything().light_first())
            .unwrap()
            .all
    );
    let caustics = Class::Caustic.expression();
    assert!(demand(&cornell.inventory, caustics.light_first()).is_none());
}

#[test]
fn what_an_effect_changes_is_measured_without_the_noise() {
    let setup = |wanted: Option<&str>| Setup {
        scene: small("cornell"),
        wanted: wanted.map(|text| {
            let expression = Expression::parse(text).unwrap();
            Wanted::new(&expression)
        }),
    };
    let direct = difference(&setup(None), &setup(Some("LD?E")), 8, 12);
    // Bleeding is a fifth of all light of the box.
    assert!((direct.share.value - 0.21).abs() < 0.02, "{direct:?}");
    assert!(
        direct.rel_mse.value > 20.0 * direct.rel_mse.error,
        "{direct:?}"
    );
    assert!(direct.rays > 1.5, "{direct:?}");
    let nothing = difference(&setup(None), &setup(Some("LD*E")), 8, 4);
    assert_eq!(
        (nothing.share.value, nothing.rel_mse.value, nothing.rays),
        (0.0, 0.0, 1.0)
    );
}

#[test]
fn reasons_speak_of_aiming_only_where_something_can_aim() {
    let reason = |text: &str, line: usize| plan(&scene("", text)).lines[line].reason.clone();
    let mirror = FLOOR.replace("half", "silver");
    for (light, line) in [(POINT, 0), (LAMP, 1)] {
        let lit = reason(&(light.to_owned() + FLOOR), line);
        let mirrored = reason(&(light.to_owned() + &mirror), line);
        let says = |text: &str| text.contains("aimed at") || text.contains("shadow rays");
        assert!(says(&lit) && !says(&mirrored), "{lit} {mirrored}");
    }
}

#[test]
fn one_render_sorts_the_light_into_the_pictures_of_each_class_alone() {
    for (name, sampler) in [
        ("room", Sampler::Sobol),
        ("caustic", Sampler::Sobol),
        ("gloss", Sampler::Independent),
    ] {
        let scene = small(name);
        let path = Path::new(scene.suggested.max_depth);
        let options = Options {
            // More than a run of even samples: their errors are sorted, too.
            spp: 130,
            sampler,
            ..Options::default()
        };
        let recorded = by_class(&scene, path, &Class::ALL, &options, &());
        let whole = render(&scene, &path, &options, &()).film;
        assert_eq!(recorded.rendered.film, whole, "{name}");
        for (class, picture) in Class::ALL.into_iter().zip(&recorded.pictures) {
            let expression = class.expression();
            let paths = expression.eye_first();
            let alone = render(&scene, &FilteredPath { path, paths }, &options, &()).film;
            assert_eq!(picture, &alone, "{name}, {}", class.name());
        }
    }
}
