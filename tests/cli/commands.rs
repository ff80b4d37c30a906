//! What the commands print, write and answer.

use super::{SCENE, complaint, folder, halfdisk, refused, shades};
use halfdisk::scene::gallery::GALLERY;
use serde_json::Value;

#[test]
fn bad_usage_ends_with_2() {
    let folder = folder();
    for arguments in [
        &[][..],
        &["paint"],
        &["render"],
        &["render", "cornell", "--nonsense"],
        &["render", "cornell", "--integrator", "magic"],
        &["render", "cornell", "--spp", "0"],
        &["render", "cornell", "--spp", "-1"],
        &["render", "cornell", "--max-depth", "0"],
        &["render", "cornell", "--seed", "-1"],
        &["render", "cornell", "--threads", "0"],
        &["render", "cornell", "--size", "640"],
        &["render", "cornell", "--size", "640x"],
        &["render", "cornell", "--size", "0x480"],
        &["render", "cornell", "--size", "-640x480"],
        &["render", "cornell", "--size", "70000x1"],
        &["render", "cornell", "--size", "65536x65536"],
        &["render", "cornell", "--size", "99999999999999999999x1"],
        &["scenes", "--show", "cornell", "--json"],
        &["completions", "cmd"],
        &["tour", "--only", "99"],
    ] {
        let output = halfdisk(folder.path(), arguments);
        let text = complaint(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(output.stdout.is_empty(), "{arguments:?}");
        assert!(!text.contains("panicked"), "{text}");
    }
    let output = halfdisk(folder.path(), &["render", "cornell", "--size", "9000x9000"]);
    let text = complaint(&output);
    assert!(
        text.contains("--size") && text.contains("at most 33554432 pixels"),
        "{text}"
    );
    assert!(folder.path().read_dir().unwrap().next().is_none());
}

#[test]
fn requests_that_cannot_be_met() {
    let folder = folder();
    let small = ["render", "lamp", "--spp", "1"];
    let ask = |more: &[&str], code| refused(folder.path(), &[&small, more].concat(), code);
    for name in ["p.jpg", "p", "p.toml", ".png"] {
        let sentence = ask(&["--out", name], 2);
        assert_eq!(
            sentence,
            format!("{name}: pictures end in .png, .exr or .hdr")
        );
    }
    let sentence = ask(&["--integrator", "whitted", "--max-depth", "64"], 2);
    assert!(
        sentence.starts_with("--max-depth 64: ") && sentence.contains("63"),
        "{sentence}"
    );
    assert!(folder.path().read_dir().unwrap().next().is_none());

    // A folder cannot be made inside a file, nor a picture in place of a folder.
    std::fs::write(folder.path().join("file"), "").unwrap();
    std::fs::create_dir(folder.path().join("taken.png")).unwrap();
    for name in ["file/p.png", "file/deep/p.exr", "taken.png"] {
        let sentence = ask(&["--out", name], 1);
        assert!(sentence.starts_with(&format!("{name}: ")), "{sentence}");
    }
}

#[test]
fn deep_trees_are_only_too_deep_for_whitted() {
    let folder = folder();
    let view = [
        "render",
        "lamp",
        "--spp",
        "1",
        "--integrator",
        "depth",
        "--max-depth",
        "64",
    ];
    assert!(halfdisk(folder.path(), &view).status.success());
}

#[test]
fn json_is_all_there_is_on_stdout() {
    let folder = folder();
    std::fs::write(folder.path().join("mine.toml"), SCENE).unwrap();
    let arguments = [
        "render",
        "mine.toml",
        "--seed",
        "7",
        "--out",
        "deep/p.exr",
        "--json",
    ];
    for more in [&[][..], &["--quiet"]] {
        let output = halfdisk(folder.path(), &[&arguments, more].concat());
        assert!(output.status.success(), "{}", complaint(&output));
        assert_eq!(output.stderr.is_empty(), more == ["--quiet"]);
        let object: Value = serde_json::from_slice(&output.stdout).expect("one JSON object");
        for key in [
            "facts",
            "size",
            "shapes",
            "degenerate_triangles",
            "build_seconds",
            "seconds",
            "rays",
            "rays_per_second",
            "lanes",
            "mean",
            "notes",
            "hidden_lamps",
            "coarse_shapes",
            "non_finite",
            "faults",
            "largest_sample",
            "too_bright_pixels",
            "clipped_pixels",
            "first_non_finite",
            "interrupted",
            "out",
        ] {
            assert!(object.get(key).is_some(), "no {key} in {object}");
        }
        let facts = &object["facts"];
        assert_eq!(
            facts["software"],
            format!("halfdisk {}", env!("CARGO_PKG_VERSION"))
        );
        assert_eq!(facts["scene"], "sample");
        assert_eq!(facts["integrator"], "path");
        assert_eq!(facts["sampler"], "sobol");
        assert_eq!((&facts["max_depth"], &facts["spp"]), (&4.into(), &1.into()));
        assert_eq!(facts["seed"], 7);
        assert_eq!(object["size"], serde_json::json!([12, 8]));
        assert_eq!(object["rays"]["camera"], 12 * 8);
        assert!(object["mean"]["value"].as_f64().unwrap() > 0.0);
        assert_eq!(object["non_finite"], 0);
        assert_eq!(object["interrupted"], false);
        assert_eq!(object["out"], "deep/p.exr");
        assert!(folder.path().join("deep/p.exr").exists());
    }
}

#[test]
fn quiet_is_silent() {
    let folder = folder();
    let output = halfdisk(folder.path(), &["render", "lamp", "--spp", "1", "--quiet"]);
    assert!(output.status.success());
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
    assert!(folder.path().join("out/lamp.png").exists());
}

#[test]
fn every_scene_is_listed_and_its_file_renders() {
    let folder = folder();
    let text = |arguments: &[&str]| {
        let output = halfdisk(folder.path(), arguments);
        assert!(output.status.success() && output.stderr.is_empty());
        String::from_utf8(output.stdout).unwrap()
    };
    let list = text(&["scenes"]);
    let names: Vec<&str> = list
        .lines()
        .filter_map(|l| l.split_whitespace().next())
        .collect();
    assert_eq!(
        names,
        GALLERY.iter().map(|(name, _)| *name).collect::<Vec<_>>()
    );
    let json: Value = serde_json::from_str(&text(&["scenes", "--json"])).unwrap();
    assert_eq!(json.as_array().unwrap().len(), GALLERY.len());

    for (name, file) in GALLERY {
        let shown = text(&["scenes", "--show", name]);
        assert_eq!(shown, *file);
        std::fs::write(folder.path().join("mine.toml"), shown).unwrap();
        let render = |scene: &str, out: &str| {
            let small = ["--size", "8x6", "--spp", "1", "--max-depth", "4"];
            let all = [&["render", scene, "--out", out][..], &small].concat();
            let output = halfdisk(folder.path(), &all);
            assert!(output.status.success(), "{}", complaint(&output));
            shades(&folder.path().join(out))
        };
        assert!(
            render("mine.toml", "a.png") == render(name, "b.png"),
            "{name}"
        );
    }
}

#[test]
fn help_version_and_completions() {
    let folder = folder();
    for arguments in [
        &["--help"][..],
        &["--version"],
        &["help", "render"],
        &["tour", "--help"],
        &["render", "--help"],
        &["scenes", "--help"],
        &["converge", "--help"],
        &["cost", "--help"],
        &["doctor", "--help"],
        &["completions", "--help"],
        &["completions", "bash"],
        &["completions", "zsh"],
        &["completions", "fish"],
    ] {
        let output = halfdisk(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(0), "{arguments:?}");
        assert!(output.stderr.is_empty());
        let text = String::from_utf8(output.stdout).unwrap();
        assert!(text.contains("halfdisk"), "{arguments:?}: {text}");
    }
}

#[cfg(unix)]
mod unix {
    use super::*;
    use std::io::Read;
    use std::process::{Child, Command, Stdio};

    fn start(folder: &std::path::Path, arguments: &[&str]) -> Child {
        Command::new(env!("CARGO_BIN_EXE_halfdisk"))
            .current_dir(folder)
            .args(arguments)
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    #[test]
    fn ctrl_c_keeps_the_picture() {
        let folder = folder();
        let long = [
            "render",
            "lamp",
            "--threads",
            "1",
            "--spp",
            "4000000",
            "--json",
        ];
        let output =
            crate::cli::interrupted(folder.path(), &[&long[..], &["--out", "p.exr"]].concat());
        let said = complaint(&output);
        assert_eq!(output.status.code(), Some(130), "{said}");
        let object: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(object["interrupted"], true);

        // "interrupted: the picture has LEAST to MOST samples per pixel", as the file says too.
        let line = said
            .lines()
            .find(|l| l.starts_with("interrupted:"))
            .expect("it says so");
        let counts: Vec<f32> = line.split(' ').filter_map(|w| w.parse().ok()).collect();
        let samples = crate::film::channel(&folder.path().join("p.exr"), "samples.Y");
        let least = samples.iter().copied().fold(f32::INFINITY, f32::min);
        let most = samples.iter().copied().fold(0.0, f32::max);
        assert_eq!(counts, [least, most], "{line}");
        assert!(least >= 1.0 && most < 4_000_000.0, "{line}");
    }

    #[test]
    fn a_reader_who_leaves_early_is_no_failure() {
        let folder = folder();
        for arguments in [
            &["scenes", "--show", "splitter"][..],
            &["completions", "zsh"],
        ] {
            let mut child = start(folder.path(), arguments);
            drop(child.stdout.take());
            let mut said = String::new();
            child
                .stderr
                .take()
                .unwrap()
                .read_to_string(&mut said)
                .unwrap();
            assert_eq!((child.wait().unwrap().code(), said.as_str()), (Some(0), ""));
        }
    }

    #[test]
    fn a_chapter_without_a_reader_draws_its_figures() {
        let folder = folder();
        let mut child = Command::new(env!("CARGO_BIN_EXE_ch01-from-the-eye"))
            .current_dir(folder.path())
            .args(["--quick", "--spp", "1"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        assert_eq!(child.wait().unwrap().code(), Some(0));
        assert!(folder.path().join("out/ch01/data.json").exists());
    }

    #[test]
    fn names_that_are_not_text() {
        use std::os::unix::ffi::OsStrExt;
        let folder = folder();
        let name = std::ffi::OsStr::from_bytes(b"caf\xe9.png");
        let output = Command::new(env!("CARGO_BIN_EXE_halfdisk"))
            .current_dir(folder.path())
            .args(["render", "lamp", "--spp", "1", "--quiet", "--json", "--out"])
            .arg(name)
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", complaint(&output));
        let object: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert!(object["out"].as_str().unwrap().starts_with("caf"));
        assert!(folder.path().join(name).exists());
    }
}

#[test]
fn what_is_too_small_or_hidden_is_said() {
    let folder = folder();
    let text = "name = 'far'\ncamera = { from = [0, 0, 0], to = [0, 0, 1], fov = 40 }\n\
                film.size = [4, 4]\nmaterials.half.lambert.albedo = 0.5\n\
                [[objects]]\nmaterial = 'half'\nsphere = { center = [1e6, 0, 9], radius = 0.1 }\n\
                [[objects]]\nemits = 1\nsphere = { center = [0, 0, 9], radius = 1 }\n\
                [[objects]]\nemits = 1\nsphere = { center = [0, 0, 9], radius = 1 }\n";
    std::fs::write(folder.path().join("far.toml"), text).unwrap();
    let said = |scene: &str| {
        let output = halfdisk(
            folder.path(),
            &["render", scene, "--spp", "1", "--size", "4x4"],
        );
        assert!(output.status.success());
        complaint(&output)
    };
    let far = said("far.toml");
    assert!(far.contains("warning: 1 shape is so small"), "{far}");
    assert!(far.contains("up to 0.0625 apart"), "{far}");
    assert!(far.contains("note: 1 lamp in the very place"), "{far}");
    let near = said("spheres");
    assert!(
        !near.contains("warning") && !near.contains("note: "),
        "{near}"
    );
}
