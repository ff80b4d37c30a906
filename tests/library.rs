//! What other packages rely on: errors that are errors, descriptions with defaults, and no platform that
//! is asked for what it may not have.

use halfdisk::flatland::{build as flat_build, description as flat};
use halfdisk::integrators::Refused;
use halfdisk::lab::chapter::DeskError;
use halfdisk::lab::drawing::ChartError;
use halfdisk::lab::experiment::cost::Nothing;
use halfdisk::notation::ExpressionError;
use halfdisk::output::OutputError;
use halfdisk::radiosity::RadiosityError;
use halfdisk::render::stopping::Unfinished;
use halfdisk::scene::build::build;
use halfdisk::scene::description::{Description, Environment, Light, Material, Object, Rotation};
use halfdisk::scene::field::Problem;
use halfdisk::scene::read::SceneError;
use halfdisk::stats::slope::Insufficient;
use std::error::Error;
use std::fs;
use std::path::Path;

/// Names the types that are errors which threads may pass on, and that fit into a `Box<dyn Error>`.
macro_rules! errors {
    ($($name:ident)*) => {{
        fn is_error<E: Error + Send + Sync + 'static>() {}
        $(is_error::<$name>();)*
        vec![$(stringify!($name)),*]
    }};
}

/// Calls a function with each source file of the library, by its path in `src` and its text.
fn each_source(folder: &Path, see: &mut impl FnMut(&str, &str)) {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for entry in fs::read_dir(src.join(folder)).unwrap() {
        let path = entry.unwrap().path();
        let name = path.strip_prefix(&src).unwrap();
        if path.is_dir() {
            each_source(name, see);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = fs::read_to_string(&path).unwrap();
            see(&name.to_string_lossy().replace('\\', "/"), &text);
        }
    }
}

#[test]
fn each_public_error_is_an_error_that_threads_may_pass_on() {
    let named = errors![
        ChartError DeskError ExpressionError Insufficient Nothing OutputError Problem RadiosityError Refused SceneError
        Unfinished
    ];
    let mut found = Vec::new();
    each_source(Path::new(""), &mut |file, text| {
        for rest in text.split("thiserror::Error").skip(1) {
            let kinds = ["pub enum ", "pub struct "].iter();
            let name = kinds.filter_map(|kind| rest.split_once(kind)).next();
            let name = name.and_then(|(_, rest)| rest.split([' ', '(', '<']).next());
            let name = name.unwrap_or_else(|| panic!("{file}: an error without a name"));
            assert!(named.contains(&name), "{file}: {name} is not in the list");
            found.push(name.to_owned());
        }
        // An error that is none would have to be written by hand.
        assert!(!text.contains("impl std::error::Error"), "{file}");
    });
    assert_eq!(found.len(), named.len(), "{found:?}");
}

/// The source without its tests.
fn shipped(text: &str) -> &str {
    text.split("#[cfg(test)]").next().unwrap_or("")
}

#[test]
fn only_one_file_of_what_runs_on_the_web_asks_for_the_time() {
    // These belong to the feature `programs`, and to the programs of learners, which return an exit code.
    let programs = ["main.rs", "cli/", "lab/chapter/", "lab/exercises/run.rs"];
    let mut asked = Vec::new();
    each_source(Path::new(""), &mut |file, text| {
        // On the web these panic, though they compile.
        let panic = ["Instant", "SystemTime", "std::thread", "std::process"];
        let asks = panic.iter().any(|what| shipped(text).contains(what));
        if asks && !programs.iter().any(|program| file.starts_with(program)) {
            asked.push(file.to_owned());
        }
    });
    assert_eq!(asked, ["time.rs"]);
}

#[test]
fn what_a_description_leaves_out_is_a_scene_all_the_same() {
    let grey = ("grey".to_owned(), Material::default());
    let mut object = Object {
        material: Some(grey.0.clone()),
        ..Object::default()
    };
    object.transform.rotate = Some(Rotation::default());
    let scene = build(
        Description {
            name: "defaults".to_owned(),
            environment: Some(Environment::default()),
            materials: [grey].into(),
            objects: vec![object],
            lights: vec![Light::default()],
            ..Description::default()
        },
        None,
    );
    let scene = scene.unwrap_or_else(|problem| panic!("{}: {problem}", problem.field));
    // A black sky is no light.
    assert_eq!(scene.lights.len(), 1);

    let world = flat_build::build(&flat::Description {
        name: "defaults".to_owned(),
        probe: Some(flat::Probe::default()),
        window: Some(flat::Window::default()),
        materials: [("grey".to_owned(), flat::Material::default())].into(),
        objects: vec![flat::Object {
            material: Some("grey".to_owned()),
            ..flat::Object::default()
        }],
        lamps: vec![flat::Lamp::default()],
        ..flat::Description::default()
    });
    let world = world.unwrap_or_else(|problem| panic!("{}: {problem}", problem.field));
    assert!(world.probe.is_some());
}
