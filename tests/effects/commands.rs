//! `halfdisk effects`, `halfdisk classify`, and demands on `halfdisk render`.

use crate::cli::{complaint, folder, halfdisk, refused};
use halfdisk::scene::Effect;

#[test]
fn the_commands_answer_and_refuse() {
    let folder = folder();
    let output = halfdisk(folder.path(), &["effects", "lens"]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("the lens has a radius of 0.15"), "{text}");
    assert!(text.contains("light paths: L(D|G)*E"), "{text}");
    let output = halfdisk(
        folder.path(),
        &["effects", "gloss", "--json", "--without", "gloss"],
    );
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(
        answer["plan"]["lines"].as_array().unwrap().len(),
        Effect::ALL.len()
    );
    assert!(answer["demand"]["left_out"].to_string().contains("LGE"));
    let small = ["--size", "16x12", "--spp", "4"];
    let classify = [&["classify", "caustic", "--json"][..], &small].concat();
    let output = halfdisk(folder.path(), &classify);
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!(answer["sum_is_off_by"].as_f64().unwrap() < 1e-5);
    assert!(
        folder
            .path()
            .join("out/classify/caustic/strip.png")
            .exists()
    );
    let biased = [
        "render",
        "gloss",
        "--without",
        "gloss",
        "--size",
        "16x12",
        "--spp",
        "4",
    ];
    let output = halfdisk(folder.path(), &biased);
    assert!(
        complaint(&output).contains("the picture is biased"),
        "{}",
        complaint(&output)
    );
    for (arguments, what) in [
        (
            &["render", "cornell", "--paths", "LS+DE"][..],
            "the paths of cornell are LD*E",
        ),
        (
            &["render", "cornell", "--paths", "DE"],
            "matches no light path",
        ),
        (&["render", "cornell", "--paths", "L(DE"], "character 2"),
        (
            &["render", "cornell", "--without", "music"],
            "the effects are point-lights",
        ),
        (
            &[
                "render",
                "cornell",
                "--without",
                "diffuse,area-lights",
                "--integrator",
                "kajiya",
            ],
            "only `path`",
        ),
    ] {
        let output = halfdisk(folder.path(), arguments);
        let text = complaint(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        assert!(text.contains(what), "{arguments:?}: {text}");
    }
}

#[test]
fn what_asks_for_a_measurement_is_refused_without_one() {
    let folder = folder();
    for alone in [&["--spp", "4"][..], &["--rounds", "3"], &["--out", "x"]] {
        let output = halfdisk(folder.path(), &[&["effects", "lens"], alone].concat());
        let text = complaint(&output);
        assert_eq!(output.status.code(), Some(2), "{text}");
        assert!(
            text.contains("--measure") && output.stdout.is_empty(),
            "{text}"
        );
    }
}

#[test]
fn what_was_measured_is_drawn_as_svg_and_as_png() {
    let folder = folder();
    let mut arguments = "effects cornell --measure --spp 1 --rounds 3 --out charts --json"
        .split(' ')
        .collect::<Vec<_>>();
    let output = halfdisk(folder.path(), &arguments);
    assert!(output.status.success(), "{}", complaint(&output));
    let measured: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let effects = measured["measured"]["effects"].as_array().unwrap();
    let svg = std::fs::read_to_string(folder.path().join("charts/effects.svg")).unwrap();
    assert!(svg.contains("What each effect brings: cornell"), "{svg}");
    for effect in effects {
        let name = effect["effect"].as_str().unwrap();
        assert!(svg.contains(name), "{name} is not drawn");
    }
    assert!(!svg.contains("motion"), "an effect that was not measured");
    let png = image::open(folder.path().join("charts/effects.png")).unwrap();
    assert!(png.width() > 1000, "large enough for a lecture");
    // Without a folder nothing is written.
    arguments.drain(7..9);
    let empty = self::folder();
    assert!(halfdisk(empty.path(), &arguments).status.success());
    assert!(empty.path().read_dir().unwrap().next().is_none());
}

#[test]
fn what_is_not_there_cannot_be_left_out() {
    let folder = folder();
    for (scene, effect, why) in [
        ("cornell", "caustics", "nothing is a mirror or glass"),
        ("cornell", "lens", "the camera is a pinhole"),
        (
            "caustic",
            "bleeding,sky",
            "no light comes from beyond the scene",
        ),
    ] {
        for command in ["render", "effects"] {
            let sentence = refused(folder.path(), &[command, scene, "--without", effect], 2);
            let what = format!("{scene} has no such effect to leave out: {why}");
            assert!(sentence.contains(&what), "{sentence}");
        }
    }
    assert!(folder.path().read_dir().unwrap().next().is_none());
}

/// What `effects --measure` says that a picture lacks without an effect is the share of the class of
/// paths that `classify` says the effect brings: the same set of words, measured twice. It sees a
/// difference of half the share at the least.
#[test]
fn effects_and_classify_measure_the_same_caustics_and_the_same_bleeding() {
    let folder = folder();
    let json = |arguments: &[&str]| -> serde_json::Value {
        let output = halfdisk(folder.path(), arguments);
        assert!(output.status.success(), "{}", complaint(&output));
        serde_json::from_slice(&output.stdout).unwrap()
    };
    let number =
        |value: &serde_json::Value| ["value", "error"].map(|part| value[part].as_f64().unwrap());
    for scene in ["room", "spheres"] {
        let classified = json(&[
            "classify", scene, "--json", "--size", "40x40", "--spp", "64", "--seed", "77",
        ]);
        let measured = json(&[
            "effects",
            scene,
            "--json",
            "--measure",
            "--spp",
            "4",
            "--rounds",
            "6",
        ]);
        for (effect, class) in [("bleeding", "bleeding"), ("caustics", "caustic")] {
            let find = |list: &serde_json::Value, key: &str, name: &str| {
                let list = list.as_array().unwrap().clone();
                list.into_iter().find(|entry| entry[key] == name).unwrap()
            };
            let share = number(&find(&classified["classes"], "class", class)["share"]);
            let found = find(&measured["measured"]["effects"], "effect", effect);
            let missing = number(&found["difference"]["share"]);
            let error = share[1].hypot(missing[1]);
            let apart = (share[0] - missing[0]).abs();
            assert!(
                apart <= 4.0 * error,
                "{scene} {effect}: {share:?} {missing:?}"
            );
            assert!(
                error < 0.1 * share[0].max(0.02),
                "{scene} {effect}: {share:?} {missing:?}"
            );
        }
    }
}
