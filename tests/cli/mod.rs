//! The command as people meet it: the real program, run in folders of its own.

mod bad_meshes;
mod bad_scenes;
mod cluster;
mod commands;
mod converge;
mod cost;
mod doctor;
mod exercises;
mod interrupts;
mod json;
mod left_out;
pub mod meshes;
mod odd_scenes;
mod options;
mod resume;
mod shards;
mod target;
pub mod textured_meshes;
mod unheard;
mod views;
mod whole_files;

use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;

/// A scene with one of everything.
pub const SCENE: &str = r#"name = "sample"
about = "One of everything."
background = 0.5
[render]
max_depth = 4
spp = 1
[camera]
from = [0, 1, 6]
to = [0, 0.5, 0]
up = [0, 1, 0]
fov = 40
[film]
size = [12, 8]
[materials.dull]
lambert = { albedo = [0.5, 0.4, 0.3] }
[materials.shiny]
mirror = { reflectance = 0.9 }
[materials.clear]
glass = { ior = 1.5 }
[[lights]]
point = { position = [1, 4, 2], intensity = 9 }
[[lights]]
directional = { direction = [0, -1, -1], irradiance = [0.1, 0.2, 0.3] }
[[objects]]
material = "dull"
quad = { corner = [-3, 0, 3], u = [6, 0, 0], v = [0, 0, -6] }
[[objects]]
material = "shiny"
sphere = { center = [1, 0.5, 0], radius = 0.5 }
transform = { scale = 1.5, rotate = { axis = [0, 1, 0], degrees = 30 }, translate = [0, 0.1, 0] }
[[objects]]
material = "clear"
triangle = { a = [-1, 0, 0], b = [0, 0, 0], c = [0, 1, 0] }
[[objects]]
material = "dull"
box = { min = [-2, 0, -1], max = [-1, 1, 0] }
[[objects]]
material = "dull"
bumpy_sphere = { center = [0, 2, 0], radius = 0.3, columns = 8, rows = 6 }
[[objects]]
emits = [2, 2, 2]
quad = { corner = [-1, 3, -1], u = [2, 0, 0], v = [0, 0, 2] }
"#;

/// The program in `folder`.
pub fn program(folder: &Path) -> Command {
    let mut program = Command::new(env!("CARGO_BIN_EXE_halfdisk"));
    program.current_dir(folder);
    program
}

/// Runs `halfdisk` in `folder`.
pub fn halfdisk(folder: &Path, arguments: &[&str]) -> Output {
    program(folder)
        .args(arguments)
        .output()
        .expect("the program starts")
}

/// Runs `halfdisk` in `folder` and interrupts it, as Ctrl-C does, once it is well under way.
#[cfg(unix)]
pub fn interrupted(folder: &Path, arguments: &[&str]) -> Output {
    let child = program(folder)
        .args(arguments)
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .expect("the program starts");
    std::thread::sleep(std::time::Duration::from_millis(1200));
    let kill = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(kill.expect("kill starts").success());
    child.wait_with_output().expect("the program ends")
}

/// The shades of a picture, without what the file says of how it was made.
pub fn shades(file: &Path) -> Vec<u8> {
    image::open(file).expect("a picture").into_bytes()
}

/// A folder of its own for a test.
pub fn folder() -> TempDir {
    tempfile::tempdir().expect("a temporary folder")
}

/// What was written to stderr.
pub fn complaint(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).expect("stderr is text")
}

/// Runs the program and checks that it stops with `code` and exactly one sentence, which is
/// returned without its `error: `, and prints no result.
pub fn refused(folder: &Path, arguments: &[&str], code: i32) -> String {
    let output = halfdisk(folder, arguments);
    let text = complaint(&output);
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {text}");
    assert!(output.stdout.is_empty(), "{arguments:?} prints a result");
    assert_eq!(text.lines().count(), 1, "{arguments:?}: {text}");
    let sentence = text.trim_end().strip_prefix("error: ");
    sentence.expect("it says that it is an error").to_owned()
}

/// Checks that a scene file is refused for what stands on `line` (counted from 1) under `field`
/// (empty for the whole file), in a sentence with `words`; returns the sentence.
pub fn scene_refused(
    folder: &Path,
    text: &[u8],
    line: usize,
    field: &str,
    words: &[&str],
) -> String {
    std::fs::write(folder.join("bad.toml"), text).unwrap();
    let sentence = refused(folder, &["render", "bad.toml", "--out", "picture.png"], 2);
    let place = match field {
        "" => format!("bad.toml:{line}: "),
        _ => format!("bad.toml:{line}: `{field}` "),
    };
    assert!(
        sentence.starts_with(&place),
        "not at {place:?}\n  {sentence}"
    );
    for word in words {
        assert!(sentence.contains(word), "no {word:?} in\n  {sentence}");
    }
    assert!(!folder.join("picture.png").exists(), "{sentence}");
    sentence
}
