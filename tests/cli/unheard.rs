//! Nobody reads what is said, or the disk is full: no work ends by that, and no file is lost.
#![cfg(target_os = "linux")]

use super::{complaint, folder};
use std::collections::BTreeSet;
use std::path::Path;
use std::process::{Command, Output, Stdio};

const HALFDISK: &str = env!("CARGO_BIN_EXE_halfdisk");
const CHAPTER: &str = env!("CARGO_BIN_EXE_ch01-from-the-eye");

/// Every kind of work, as short as can be.
const WORK: &[(&str, &[&str])] = &[
    (
        HALFDISK,
        &["render", "lamp", "--size", "8x8", "--spp", "4", "--maps"],
    ),
    (
        HALFDISK,
        &["render", "lamp", "--size", "8x8", "--target-error", "50%"],
    ),
    (
        HALFDISK,
        &[
            "render",
            "whitted",
            "--size",
            "8x8",
            "--integrator",
            "kajiya",
        ],
    ),
    (
        HALFDISK,
        &[
            "render",
            "gloss",
            "--size",
            "8x8",
            "--spp",
            "4",
            "--without",
            "gloss",
            "--out",
            "p.exr",
        ],
    ),
    (
        HALFDISK,
        &["classify", "caustic", "--size", "8x8", "--spp", "4"],
    ),
    (
        HALFDISK,
        &["converge", "darts", "--replicates", "2", "--doublings", "2"],
    ),
    (
        HALFDISK,
        &[
            "cost",
            "lamp",
            "--size",
            "4x4",
            "--budget",
            "1",
            "--replicates",
            "2",
            "--methods",
            "path",
        ],
    ),
    (HALFDISK, &["effects", "lens"]),
    (HALFDISK, &["doctor"]),
    (HALFDISK, &["tour", "--quick", "--only", "01"]),
    (CHAPTER, &["--quick", "--spp", "1"]),
];

fn run(folder: &Path, (program, arguments): (&str, &[&str]), said: Stdio, read: Stdio) -> Output {
    Command::new(program)
        .current_dir(folder)
        // The tour would build the chapters, which stand beside it.
        .env_remove("CARGO")
        .args(arguments)
        .stderr(said)
        .stdout(read)
        .output()
        .expect("the program starts")
}

/// The names of all files below a folder.
fn files(folder: &Path) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    for entry in folder.read_dir().unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() {
            found.extend(files(&path).into_iter().map(|f| format!("{name}/{f}")));
        } else {
            found.insert(name);
        }
    }
    found
}

/// The writing end of a pipe that nobody reads.
fn closed_pipe() -> Stdio {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    writer.into()
}

fn full_disk() -> Stdio {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
    full.unwrap().into()
}

#[test]
fn reports_that_nobody_can_read_end_no_work() {
    for &work in WORK {
        let heard = folder();
        let output = run(heard.path(), work, Stdio::piped(), Stdio::piped());
        let said = complaint(&output);
        assert_eq!(output.status.code(), Some(0), "{work:?}: {said}");
        for unheard in [full_disk, closed_pipe] {
            let folder = folder();
            let output = run(folder.path(), work, unheard(), Stdio::piped());
            assert_eq!(output.status.code(), Some(0), "{work:?}");
            assert_eq!(files(folder.path()), files(heard.path()), "{work:?}");
        }
    }
}

#[test]
fn results_that_cannot_be_printed_lose_no_file() {
    for &(program, arguments) in WORK {
        for json in [false, true] {
            let mut arguments = arguments.to_vec();
            if json {
                if arguments[0] == "tour" {
                    continue;
                }
                arguments.push("--json");
            }
            let work = (program, arguments.as_slice());
            let heard = folder();
            let output = run(heard.path(), work, Stdio::piped(), Stdio::piped());
            assert_eq!(output.status.code(), Some(0), "{}", complaint(&output));
            let prints = !output.stdout.is_empty();

            let full = folder();
            let output = run(full.path(), work, Stdio::piped(), full_disk());
            let said = complaint(&output);
            assert_eq!(
                output.status.code(),
                Some(i32::from(prints)),
                "{work:?}: {said}"
            );
            assert_eq!(
                said.contains("error: stdout: No space left"),
                prints,
                "{said}"
            );
            assert_eq!(files(full.path()), files(heard.path()), "{work:?}");

            // Somebody who has seen enough is no failure.
            let closed = folder();
            let output = run(closed.path(), work, Stdio::piped(), closed_pipe());
            let said = complaint(&output);
            assert_eq!(output.status.code(), Some(0), "{work:?}: {said}");
            assert_eq!(files(closed.path()), files(heard.path()), "{work:?}");
        }
    }
}

#[test]
fn errors_that_nobody_can_read_keep_their_exit_codes() {
    let folder = folder();
    for (arguments, code) in [
        (&["render", "nowhere"][..], 2),
        (&["render", "--nonsense"], 2),
        (&["render", "lamp", "--out", "/proc/no/p.png"], 1),
        (&["converge", "nothing"], 2),
        (&["scenes", "--show", "nothing"], 2),
    ] {
        for unheard in [full_disk, closed_pipe] {
            let output = run(
                folder.path(),
                (HALFDISK, arguments),
                unheard(),
                Stdio::piped(),
            );
            assert_eq!(output.status.code(), Some(code), "{arguments:?}");
        }
    }
    for arguments in [&["--help"][..], &["render", "--help"], &["--version"]] {
        let output = run(
            folder.path(),
            (HALFDISK, arguments),
            Stdio::piped(),
            full_disk(),
        );
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(complaint(&output).starts_with("error: stdout: "));
    }
}
