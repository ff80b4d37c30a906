//! `halfdisk effects`, `halfdisk classify`, and demands on `halfdisk render`.

use crate::cli::{complaint, folder, halfdisk};
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
