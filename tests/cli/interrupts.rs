//! Ctrl-C and requests to terminate, in the middle of every kind of long work.
#![cfg(unix)]

use super::{complaint, folder};
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

const HALFDISK: &str = env!("CARGO_BIN_EXE_halfdisk");

/// A second, and what a busy machine needs to write the files.
const SOON: Duration = Duration::from_millis(2500);

fn start(folder: &Path, program: &str, arguments: &[&str]) -> Child {
    Command::new(program)
        .current_dir(folder)
        // The tour would build the chapters, which stand beside it.
        .env_remove("CARGO")
        .args(arguments)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn send(child: &Child, signal: &str) {
    let kill = Command::new("kill")
        .args([signal, &child.id().to_string()])
        .status();
    assert!(kill.unwrap().success());
}

/// Runs a program, asks it to stop once a file is there or after a while, and waits for its end.
fn stopped(folder: &Path, program: &str, arguments: &[&str], once: &str, signal: &str) -> Output {
    let child = start(folder, program, arguments);
    let begun = Instant::now();
    std::thread::sleep(Duration::from_millis(1200));
    while !once.is_empty() && !folder.join(once).exists() {
        assert!(begun.elapsed().as_secs() < 100, "no {once}");
        std::thread::sleep(Duration::from_millis(20));
    }
    let asked = Instant::now();
    send(&child, signal);
    let output = child.wait_with_output().unwrap();
    let took = asked.elapsed();
    let said = complaint(&output);
    assert!(took < SOON, "{arguments:?} took {took:?}: {said}");
    let code = if signal == "-TERM" { 143 } else { 130 };
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
    assert!(said.contains("interrupted"), "{arguments:?}: {said}");
    output
}

/// Work that takes far longer than anybody waits, and what is said when it is interrupted.
const LONG: &[(&[&str], &str)] = &[
    (
        &["render", "cornell", "--spp", "4000000"],
        "interrupted: the picture has ",
    ),
    (
        &["render", "cornell", "--time", "1h"],
        "interrupted: the picture has ",
    ),
    (
        &["classify", "cornell", "--spp", "65536", "--size", "64x64"],
        "interrupted: the classes have at least ",
    ),
    (
        &[
            "converge",
            "product-8",
            "--replicates",
            "4",
            "--doublings",
            "24",
        ],
        "interrupted: 0 of 1 estimators were finished",
    ),
    (
        &["converge", "half-disk", "--replicates", "1000000"],
        "runs of half-disk are kept",
    ),
    (
        &["effects", "spheres", "--measure", "--spp", "65536"],
        "interrupted: kept 0 of ",
    ),
    (
        &["cost", "cornell", "--budget", "100000"],
        "interrupted before the first replicate was finished",
    ),
];

#[test]
fn long_work_ends_at_once_and_says_what_is_kept() {
    for signal in ["-INT", "-TERM"] {
        for &(arguments, words) in LONG {
            let folder = folder();
            let output = stopped(folder.path(), HALFDISK, arguments, "", signal);
            let said = complaint(&output);
            assert!(said.contains(words), "{arguments:?}: {said}");
            if arguments[0] == "classify" {
                let strip = folder.path().join("out/classify/cornell/strip.png");
                assert!(image::open(strip).is_ok(), "{said}");
            }
        }
    }
}

#[test]
fn a_tour_keeps_the_chapters_that_are_done() {
    for signal in ["-INT", "-TERM"] {
        let folder = folder();
        // The signal is for the tour alone; the second chapter is told or ended by it.
        let arguments = ["tour", "--quick", "--only", "01,18"];
        let once = "out/ch01/output.txt";
        let output = stopped(folder.path(), HALFDISK, &arguments, once, signal);
        let said = complaint(&output);
        assert!(said.contains("interrupted: kept 1 of 2 chapters"), "{said}");
        let page = std::fs::read_to_string(folder.path().join("out/index.html")).unwrap();
        assert!(page.contains("ch01"));
    }
}

#[test]
fn a_chapter_ends_at_once_whatever_it_does() {
    for program in [
        env!("CARGO_BIN_EXE_ch18-cost"),
        env!("CARGO_BIN_EXE_ch03-hit-or-miss"),
    ] {
        for signal in ["-INT", "-TERM"] {
            let folder = folder();
            let child = start(folder.path(), program, &["--spp", "100000"]);
            std::thread::sleep(Duration::from_millis(300));
            let asked = Instant::now();
            send(&child, signal);
            let output = child.wait_with_output().unwrap();
            assert!(asked.elapsed() < SOON, "{program}");
            let code = if signal == "-TERM" { 143 } else { 130 };
            assert_eq!(output.status.code(), Some(code), "{program}");
            let said = complaint(&output);
            assert!(
                said.contains("the figures finished so far are kept"),
                "{said}"
            );
        }
    }
}

/// Panes of glass one behind the other, between which the tree of rays doubles at each of sixty surfaces:
/// a single sample of it never ends.
fn endless() -> String {
    let mut text = "name = 'endless'\ncamera = { from = [0, 0, 0], to = [0, 0, 1], fov = 1 }\n\
                    film.size = [1, 1]\nrender.max_depth = 63\nmaterials.glass.glass.ior = 1.5\n\
                    [[objects]]\nemits = 1\nsphere = { center = [0, 9, 9], radius = 1 }\n"
        .to_owned();
    for pane in 0..20 {
        let (front, back) = (2 * pane + 1, 2 * pane + 2);
        text += &format!(
            "[[objects]]\nmaterial = 'glass'\n\
             box = {{ min = [-9, -9, {front}], max = [9, 9, {back}] }}\n"
        );
    }
    text
}

#[test]
fn the_second_wish_ends_it_without_a_word() {
    let folder = folder();
    std::fs::write(folder.path().join("endless.toml"), endless()).unwrap();
    for (signal, code) in [("-INT", 130), ("-TERM", 143)] {
        let arguments = ["render", "endless.toml", "--integrator", "whitted"];
        let mut child = start(folder.path(), HALFDISK, &arguments);
        std::thread::sleep(Duration::from_millis(600));
        send(&child, signal);
        std::thread::sleep(Duration::from_millis(600));
        assert!(child.try_wait().unwrap().is_none(), "the sample has no end");
        let asked = Instant::now();
        send(&child, signal);
        assert_eq!(child.wait().unwrap().code(), Some(code));
        assert!(asked.elapsed() < SOON);
        // The only file is the scene.
        let files = walk(folder.path());
        assert_eq!(files, 1);
    }
}

fn walk(folder: &Path) -> usize {
    let entries = folder.read_dir().unwrap().map(|e| e.unwrap().path());
    entries
        .map(|path| if path.is_dir() { walk(&path) } else { 1 })
        .sum()
}

/// True where hangups are ignored already, by this process and all that it starts.
#[cfg(target_os = "linux")]
fn ignores_hangups() -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask & 1 == 1)
}

#[cfg(target_os = "linux")]
#[test]
fn a_render_that_ignores_hangups_goes_on_after_one() {
    let folder = folder();
    let script = "trap '' HUP; exec \"$0\" \"$@\"";
    let render = ["render", "cornell", "--spp", "4000000", "--out", "p.png"];
    let of_shell = [&["-c", script, HALFDISK], &render[..]].concat();
    for (program, arguments, ends) in [(HALFDISK, &render[..], true), ("sh", &of_shell[..], false)]
    {
        let mut child = start(folder.path(), program, arguments);
        std::thread::sleep(Duration::from_millis(1000));
        send(&child, "-HUP");
        std::thread::sleep(Duration::from_millis(1500));
        let ended = child.try_wait().unwrap().is_some();
        // Whatever is wrong, nothing goes on when the test is over.
        if !ended {
            send(&child, "-INT");
        }
        let code = child.wait().unwrap().code();
        // Under `nohup` all of this ignores hangups.
        let ends = ends && !ignores_hangups();
        assert_eq!((ended, code), (ends, Some(if ends { 129 } else { 130 })));
    }
}
