//! `{{#live name chapter/file}}`: a figure that computes in the page.
//!
//! It is the picture of the last run, which a script replaces where scripts run. That script is one file for all pages:
//! the program of `book/figures` in base64, what draws figures, and the figures. mdBook copies it, because it lies among
//! the sources. Where the program cannot be built, pictures stay pictures.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use base64::prelude::{BASE64_STANDARD, Engine as _};
use serde::Deserialize;

use crate::data::Run;
use crate::figures;

/// The file of the script among the sources.
const SCRIPT: &str = "figures.js";
/// What cargo is asked for: the numbers of the figures as a program for the web, and where it is.
const BUILD: &str = "--config book/figures/web.toml rustc --release --target wasm32-unknown-unknown \
                     --package halfdisk-figures --lib --crate-type cdylib --quiet \
                     --message-format=json-render-diagnostics";
/// What all figures share, in the folder of their scripts.
const KIT: &str = "kit";

/// The live figures of a book.
pub struct Live {
    /// The folder with a script for each figure.
    pub scripts: PathBuf,
    /// Whether they compute in this book.
    pub computes: bool,
}

impl Live {
    /// Builds the program and writes the script; where the target is missing, says so and leaves no script.
    pub fn build(book: &Path, sources: &Path) -> Result<Self, String> {
        let scripts = book.join("figures/web");
        let program = program(book)?;
        let file = sources.join(SCRIPT);
        match &program {
            Some(program) => replace(&file, &script(&scripts, program)?)?,
            None => {
                eprintln!("live figures stay still: rustup target add wasm32-unknown-unknown");
                if file.exists() {
                    fs::remove_file(&file)
                        .map_err(|error| format!("cannot remove {}: {error}", file.display()))?;
                }
            }
        }
        Ok(Live {
            scripts,
            computes: program.is_some(),
        })
    }

    /// The figure, marked as the place of a live one.
    pub fn expand(&self, arguments: &[&str], run: &Run) -> Result<String, String> {
        let [name, picture] = arguments else {
            return Err("write the figure's name and `chapter/file`".to_string());
        };
        let known = names(&self.scripts)?;
        if !known.iter().any(|figure| figure == name) {
            let known = known.join(", ");
            return Err(format!("unknown live figure `{name}` (known: {known})"));
        }
        let html = figures::expand(&[picture], run)?;
        Ok(match self.computes {
            true => html.replacen("<figure>", &format!("<figure data-live=\"{name}\">"), 1),
            false => html,
        })
    }

    /// What ends a page: a call of the script, if it has live figures.
    pub fn call(&self, file: &Path, page: &str) -> String {
        if !self.computes || !page.contains("<figure data-live=") {
            return String::new();
        }
        let up = "../".repeat(file.components().count().saturating_sub(1));
        format!("\n\n<script defer src=\"{up}{SCRIPT}\"></script>\n")
    }
}

/// The names of all figures, in order.
fn names(scripts: &Path) -> Result<Vec<String>, String> {
    let entries = fs::read_dir(scripts)
        .map_err(|error| format!("cannot read {}: {error}", scripts.display()))?;
    let files = entries.flatten().map(|entry| entry.path());
    let mut names: Vec<String> = files
        .filter(|path| path.extension().is_some_and(|ending| ending == "js"))
        .filter_map(|path| Some(path.file_stem()?.to_str()?.to_string()))
        .filter(|name| name != KIT)
        .collect();
    names.sort();
    Ok(names)
}

/// One script for all pages, which runs once on each: the page with all chapters calls it many times.
fn script(scripts: &Path, program: &[u8]) -> Result<String, String> {
    let read = |name: &str| {
        let path = scripts.join(name).with_extension("js");
        fs::read_to_string(&path)
            .map_err(|error| format!("cannot read {}: {error}", path.display()))
    };
    let mut script = "(() => {\n\"use strict\";\nif (globalThis.hasLiveFigures) return;\n\
                      globalThis.hasLiveFigures = true;\n"
        .to_string();
    script += &format!("const WASM = \"{}\";\n", BASE64_STANDARD.encode(program));
    script += &read(KIT)?;
    for name in names(scripts)? {
        script += &read(&name)?;
    }
    Ok(script + "start();\n})();\n")
}

/// Writes a file if that changes it: a book that is watched is built again whenever one of its sources changes.
fn replace(file: &Path, text: &str) -> Result<(), String> {
    if fs::read_to_string(file).is_ok_and(|old| old == text) {
        return Ok(());
    }
    fs::write(file, text).map_err(|error| format!("cannot write {}: {error}", file.display()))
}

/// The program of the figures; `None` where the compiler has no standard library for the web.
fn program(book: &Path) -> Result<Option<Vec<u8>>, String> {
    let root = book.join("..");
    let mut asked = Command::new("rustc");
    asked.args([
        "--print",
        "target-libdir",
        "--target",
        "wasm32-unknown-unknown",
    ]);
    let library = answer(asked.current_dir(&root))?;
    if !Path::new(library.trim()).is_dir() {
        return Ok(None);
    }
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    // What is optimised as a whole is not compiled piece by piece.
    cargo
        .args(BUILD.split_whitespace())
        .env("CARGO_INCREMENTAL", "0");
    let messages = answer(cargo.current_dir(&root))?;
    let file = artifact(&messages).ok_or("cargo names no program of the live figures")?;
    let program = fs::read(&file).map_err(|error| format!("cannot read {file}: {error}"))?;
    Ok(Some(program))
}

/// What a command prints; its complaints go where this program's go.
fn answer(command: &mut Command) -> Result<String, String> {
    let words = format!("{command:?}");
    let output = command
        .stderr(std::process::Stdio::inherit())
        .output()
        .map_err(|error| format!("cannot run {words}: {error}"))?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
        false => Err(format!("{words} failed")),
    }
}

/// A message of cargo: only the files it names are read.
#[derive(Deserialize)]
struct Message {
    #[serde(default)]
    filenames: Vec<String>,
}

/// The file of the program, from what cargo says while it builds.
fn artifact(messages: &str) -> Option<String> {
    messages
        .lines()
        .filter_map(|line| serde_json::from_str::<Message>(line).ok())
        .flat_map(|message| message.filenames)
        .find(|name| name.ends_with(".wasm"))
}

#[cfg(test)]
pub mod tests {
    use super::*;
    use crate::data::tests::fixtures;

    /// The figures of this book, live or not.
    pub fn live(computes: bool) -> Live {
        Live {
            scripts: Path::new(env!("CARGO_MANIFEST_DIR")).join("../figures/web"),
            computes,
        }
    }

    #[test]
    fn a_live_figure_is_the_picture_with_a_mark_or_the_picture_alone() {
        let run = fixtures();
        let arguments = ["half-disk", "ch01/plot.svg"];
        let still = live(false).expand(&arguments, &run).unwrap();
        assert_eq!(Ok(&still), figures::expand(&arguments[1..], &run).as_ref());
        let computes = live(true).expand(&arguments, &run).unwrap();
        let marked = computes.strip_prefix("<figure data-live=\"half-disk\">");
        assert_eq!(marked, still.strip_prefix("<figure>"));
    }

    #[test]
    fn only_pages_with_live_figures_call_the_script() {
        let page = "<figure data-live=\"path\"></figure>";
        let call = "\n\n<script defer src=\"figures.js\"></script>\n";
        assert_eq!(live(true).call(Path::new("a.md"), page), call);
        assert!(
            live(true)
                .call(Path::new("b/a.md"), page)
                .contains("\"../figures.js\"")
        );
        assert_eq!(live(true).call(Path::new("a.md"), "<figure></figure>"), "");
        assert_eq!(live(false).call(Path::new("a.md"), page), "");
    }

    #[test]
    fn the_script_holds_the_program_and_every_figure() {
        let scripts = live(true).scripts;
        let script = script(&scripts, b"\0asm").unwrap();
        assert!(script.contains("const WASM = \"AGFzbQ==\";\n"));
        let names = names(&scripts).unwrap();
        assert_eq!(names.len(), 7);
        for name in names {
            assert_eq!(script.matches(&format!("figure(\"{name}\", {{")).count(), 1);
        }
        assert!(script.ends_with("});\nstart();\n})();\n"));
    }

    #[test]
    fn mistakes_are_refused() {
        let run = fixtures();
        let one = |arguments: &[&str]| live(true).expand(arguments, &run).unwrap_err();
        assert!(one(&["half-disc", "ch01/plot.svg"]).contains("(known: darts, half-disk, "));
        assert!(one(&["kit", "ch01/plot.svg"]).starts_with("unknown live figure"));
        assert!(one(&["half-disk", "ch01/nothing.png"]).starts_with("unknown figure"));
        assert!(one(&["half-disk"]).starts_with("write the figure's name"));
        assert!(names(Path::new("nowhere")).is_err());
    }

    #[test]
    fn the_program_is_found_among_the_messages() {
        let messages = "{\"reason\":\"compiler-artifact\",\"filenames\":[\"/t/libglam.rlib\"]}\n\
                        {\"reason\":\"compiler-artifact\",\"filenames\":[\"/t/halfdisk_figures.wasm\"]}\n\
                        {\"reason\":\"build-finished\",\"success\":true}\n";
        assert_eq!(
            artifact(messages).as_deref(),
            Some("/t/halfdisk_figures.wasm")
        );
        assert_eq!(artifact("no message"), None);
    }
}
