//! The files that learners get: they compile, and ask for what is not there. The compiler is asked without cargo.

use crate::cli::{complaint, folder, halfdisk};
use halfdisk::lab::exercises::*;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The library that this test was built with: the newest beside it.
fn library() -> (PathBuf, PathBuf) {
    let program = std::env::current_exe().unwrap();
    let folder = program.ancestors().nth(2).unwrap().join("deps");
    let built = |path: &Path| fs::metadata(path).unwrap().modified().unwrap();
    let files = fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let is_library = |path: &PathBuf| {
        let name = path.file_name().unwrap().to_string_lossy();
        name.starts_with("libhalfdisk-") && name.ends_with(".rlib")
    };
    let newest = files.filter(is_library).max_by_key(|path| built(path));
    (
        newest.expect("the library is built before its tests"),
        folder,
    )
}

/// Compiles a file with the library; the program is beside the file.
fn compile(file: &Path, more: &[&str]) -> Output {
    let (library, folder) = library();
    let mut path = library.into_os_string();
    path = [std::ffi::OsStr::new("halfdisk="), &path].concat_os();
    Command::new("rustc")
        .args(["--edition", "2024", "-A", "unused", "-D", "warnings"])
        .args(more)
        .arg("-L")
        .arg([std::ffi::OsStr::new("dependency="), folder.as_os_str()].concat_os())
        .arg("--extern")
        .arg(path)
        .arg(file)
        .current_dir(file.parent().unwrap())
        .output()
        .expect("rustc starts")
}

trait ConcatOs {
    fn concat_os(self) -> std::ffi::OsString;
}

impl ConcatOs for [&std::ffi::OsStr; 2] {
    fn concat_os(self) -> std::ffi::OsString {
        let mut all = self[0].to_owned();
        all.push(self[1]);
        all
    }
}

#[test]
fn every_unfilled_file_compiles_and_the_program_asks_for_its_task() {
    let folder = folder();
    let mut all = String::from("#![allow(dead_code)]\n");
    for entry in LADDER {
        let file = format!("{}.rs", entry.program());
        all += &format!("#[path = \"{file}\"] mod {};\n", entry.program());
        fs::write(folder.path().join(file), entry.unfilled()).unwrap();
    }
    let cases = LADDER.map(|entry| format!("{} => {}::main(),\n", entry.number, entry.program()));
    // One program for all of them: it is linked once.
    all += &format!(
        "fn main() -> std::process::ExitCode {{
            let number = std::env::var(\"NUMBER\").unwrap();
            match number.parse::<u32>().unwrap() {{ {} _ => unreachable!() }}
        }}",
        cases.concat()
    );
    for entry in LADDER {
        let file = folder.path().join(format!("{}.rs", entry.program()));
        let text = fs::read_to_string(&file).unwrap();
        fs::write(file, text.replace("\nfn main()", "\npub fn main()")).unwrap();
    }
    let main = folder.path().join("all.rs");
    fs::write(&main, all).unwrap();
    let compiled = compile(&main, &["-o", "all"]);
    assert!(compiled.status.success(), "{}", complaint(&compiled));
    for entry in LADDER {
        let run = Command::new(folder.path().join("all"))
            .env("NUMBER", entry.number.to_string())
            .output()
            .unwrap();
        let said = String::from_utf8(run.stdout).unwrap();
        assert_eq!(run.status.code(), Some(1), "{said}");
        let start = format!("{:02} {}: not written yet.\n\n", entry.number, entry.name);
        assert!(said.starts_with(&(start + &entry.task())), "{said}");
    }
}

/// The whole way by cargo, in an empty folder and without network.
#[test]
#[ignore = "builds the library once more"]
fn long_start_and_check_by_cargo() {
    let folder = folder();
    let run = |arguments: &[&str]| halfdisk(folder.path(), &[&["exercises"], arguments].concat());
    let started = run(&["start", "4"]);
    assert!(started.status.success(), "{}", complaint(&started));
    let check = || {
        let output = run(&["check", "4", "--json"]);
        let json: serde_json::Value = serde_json::from_slice(&output.stdout).expect("JSON");
        (output.status.code(), json)
    };
    let (code, json) = check();
    assert_eq!(
        (code, &json["status"]),
        (Some(1), &"error".into()),
        "{json}"
    );
    assert_eq!(json["halfdisk"]["verdict"], "unwritten");
    let file = folder.path().join("exercises/src/bin/ex04_cosine.rs");
    let solution = of_number(4).unwrap().solved();
    let write = |text: &str| fs::write(&file, text).unwrap();
    write(&solution.replace("0.5 * w.y", "w.y"));
    let (code, json) = check();
    assert_eq!((code, &json["status"]), (Some(1), &"fail".into()), "{json}");
    assert_eq!(json["halfdisk"]["mistakes"][0], "density not normalised");
    write(&solution.replace(
        "let x =",
        "println!(\"here\"); loop {} #[allow(unreachable_code)] let x =",
    ));
    let output = run(&["check", "4", "--time-limit", "1s"]);
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("no answer after 1 s"), "{said}");
    write("fn main() { no }");
    let (code, json) = check();
    assert_eq!(
        (code, &json["halfdisk"]["verdict"]),
        (Some(1), &"not-built".into())
    );
    assert!(
        json["message"]
            .as_str()
            .unwrap()
            .contains("cannot find value `no`"),
        "{json}"
    );
    write(&solution);
    let (code, json) = check();
    assert_eq!((code, &json["status"]), (Some(0), &"pass".into()), "{json}");
    assert!(run(&["solution", "4"]).status.success());
    let list = run(&["list", "--json"]);
    let list: serde_json::Value = serde_json::from_slice(&list.stdout).unwrap();
    assert_eq!(list[3]["state"], "right");
}
