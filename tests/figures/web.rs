//! The same numbers in a page, bit for bit.

use halfdisk_figures::{darts, half_disk, inversion, lamp, path, roulette, window};
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A list of numbers that a page can ask for: its name, the range of its handle, and the function.
type List = (&'static str, [f64; 2], fn(f64, u32) -> Vec<f64>);

const LISTS: [List; 11] = [
    ("half_disk", half_disk::TILT, half_disk::run),
    ("inversion", inversion::U, |u, _| inversion::law(u)),
    ("path", path::SEGMENT, path::run),
    ("lamp_law", lamp::HALF_ANGLE, |a, _| lamp::law(a)),
    ("lamp", lamp::HALF_ANGLE, lamp::run),
    ("roulette_law", roulette::SURVIVAL, |q, _| roulette::law(q)),
    ("roulette", roulette::SURVIVAL, roulette::run),
    ("window_law", window::RADIUS, |r, _| window::law(r)),
    ("window", window::RADIUS, window::run),
    ("darts", darts::DARTS, darts::run),
    ("board", darts::DARTS, darts::board),
];
/// So many for each list: the larger part of what the comparison takes.
const INPUTS: u32 = 250;

/// What the book's tool asks cargo for.
const BUILD: &str = "--config book/figures/web.toml rustc --release --target wasm32-unknown-unknown \
                     --package halfdisk-figures --lib --crate-type cdylib --quiet \
                     --message-format=json-render-diagnostics";

/// Calls the lists that the second file names, and writes each as its length and its numbers to the third.
const NODE: &str = r#"
const fs = require("fs");
const [, program, inputs, answers] = process.argv;
const { exports: web } = new WebAssembly.Instance(new WebAssembly.Module(fs.readFileSync(program)));
const file = fs.openSync(answers, "w");
for (const line of fs.readFileSync(inputs, "utf8").trim().split("\n")) {
    const [name, handle, seed] = line.split(" ");
    const numbers = new Float64Array(1 + web[name](Number(handle), Number(seed)));
    numbers[0] = numbers.length - 1;
    for (let i = 1; i < numbers.length; i++) numbers[i] = web.number(i - 1);
    fs.writeSync(file, numbers);
}
if (!Number.isNaN(web.number(1e6))) throw "a number beyond the last";
"#;

/// The program as a page has it; `None` where it cannot be built or run.
fn program() -> Option<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let target = [
        "--print",
        "target-libdir",
        "--target",
        "wasm32-unknown-unknown",
    ];
    let library = Command::new("rustc")
        .args(target)
        .current_dir(root)
        .output();
    let library = String::from_utf8(library.ok()?.stdout).unwrap();
    if !Path::new(library.trim()).is_dir() {
        println!("not compared: the compiler has no standard library for the web");
        return None;
    }
    if Command::new("node").arg("--version").output().is_err() {
        println!("not compared: there is no node");
        return None;
    }
    let built = Command::new(env!("CARGO"))
        .args(BUILD.split_whitespace())
        .env("CARGO_INCREMENTAL", "0")
        .current_dir(root)
        .output()
        .unwrap();
    assert!(
        built.status.success(),
        "{}",
        String::from_utf8_lossy(&built.stderr)
    );
    let messages = String::from_utf8(built.stdout).unwrap();
    let mut words = messages.split('"');
    let found = words.find(|word| word.ends_with("halfdisk_figures.wasm"));
    Some(PathBuf::from(found.expect("a program among the messages")))
}

#[test]
fn a_page_has_the_same_numbers_bit_for_bit() {
    let Some(program) = program() else { return };
    let handle =
        |[low, high]: [f64; 2], i: u32| low + (high - low) * f64::from(i) / f64::from(INPUTS - 1);
    let mut inputs = String::new();
    for (name, range, _) in LISTS {
        for i in 0..INPUTS {
            inputs += &format!("{name} {:?} {i}\n", handle(range, i));
        }
    }
    let folder = tempfile::tempdir().unwrap();
    let [asked, answers] = ["asked", "answers"].map(|name| folder.path().join(name));
    fs::write(&asked, inputs).unwrap();
    let node = std::thread::spawn({
        let files = [program.clone(), asked, answers.clone()];
        move || Command::new("node").args(["-e", NODE]).args(files).output()
    });
    let native: Vec<Vec<f64>> = LISTS
        .into_par_iter()
        .flat_map(|(_, range, list)| {
            (0..INPUTS)
                .into_par_iter()
                .map(move |i| list(handle(range, i), i))
        })
        .collect();
    let output = node.join().unwrap().unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );

    let bytes = fs::read(answers).unwrap();
    let mut read = bytes
        .chunks_exact(8)
        .map(|b| f64::from_le_bytes(b.try_into().unwrap()));
    for (k, list) in native.iter().enumerate() {
        let (name, i) = (LISTS[k / INPUTS as usize].0, k % INPUTS as usize);
        assert_eq!(read.next(), Some(list.len() as f64), "{name}, input {i}");
        for (place, x) in list.iter().enumerate() {
            let y = read.next().unwrap();
            assert!(!x.is_nan(), "{name}, input {i}, number {place}");
            assert_eq!(
                x.to_bits(),
                y.to_bits(),
                "{name}, input {i}, number {place}: {x} and {y}"
            );
        }
    }
    assert_eq!(read.next(), None);
    println!(
        "{} bytes as WebAssembly",
        fs::metadata(program).unwrap().len()
    );
}
