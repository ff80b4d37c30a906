//! Options: how numbers are written, and where help lists them.

use super::{complaint, folder, halfdisk};

#[test]
fn numbers_may_be_written_with_a_power_of_ten_and_what_is_refused_is_told_the_range() {
    let folder = folder();
    let output = halfdisk(
        folder.path(),
        &[
            "classify", "lamp", "--size", "4x4", "--spp", "1e1", "--seed", "1e9", "--json",
        ],
    );
    assert!(output.status.success(), "{}", complaint(&output));
    for (arguments, range) in [
        (&["render", "lamp", "--spp", "1e-3"][..], "from 1 to "),
        (&["render", "lamp", "--spp", "ten"], "from 1 to "),
        (
            &["render", "lamp", "--seed", "-1"],
            "from 0 to 18446744073709551615",
        ),
        (&["classify", "lamp", "--spp", "1e3.5"], "from 4 to 65536"),
        (&["classify", "lamp", "--seed", "-1"], "from 0 to "),
        (&["cost", "lamp", "--replicates", "-3"], "from 1 to 1000"),
        (&["converge", "darts", "--doublings", "25"], "from 1 to 24"),
        (
            &["effects", "lamp", "--measure", "--rounds", "2"],
            "from 3 to 1000",
        ),
    ] {
        let output = halfdisk(folder.path(), arguments);
        let text = complaint(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
        let words = format!("a whole number {range}");
        assert!(text.contains(&words), "{arguments:?}: {text}");
        assert!(!text.contains("tip:"), "{text}");
    }
}

#[test]
fn a_heading_in_the_help_names_its_own_options_and_no_others() {
    let folder = folder();
    for command in [
        "tour", "render", "scenes", "converge", "cost", "doctor", "effects", "classify",
    ] {
        let output = halfdisk(folder.path(), &[command, "--help"]);
        let text = String::from_utf8(output.stdout).unwrap();
        let mut heading = "";
        for line in text.lines() {
            if !line.starts_with(' ') && line.ends_with(':') {
                heading = line;
            }
            let option = line.trim_start().trim_start_matches("-q, ");
            let option = option.starts_with("--").then(|| {
                let name = |c: char| !(c.is_ascii_lowercase() || c == '-');
                option.split(name).next().unwrap()
            });
            if let Some(option) = option {
                let light = ["--paths", "--without"].contains(&option);
                assert_eq!(heading == "Which light:", light, "{command} {option}");
            }
        }
    }
}

#[test]
fn threads_are_as_many_as_asked_for_also_where_a_large_mesh_is_loaded() {
    let folder = folder();
    let pictures = ["1", "3"].map(|threads| {
        let name = format!("{threads}.exr");
        let few = ["render", "mesh", "--size", "4x4", "--spp", "1"];
        let rest = ["--threads", threads, "--out", &name];
        let output = halfdisk(folder.path(), &[&few[..], &rest].concat());
        assert!(output.status.success(), "{}", complaint(&output));
        std::fs::read(folder.path().join(name)).unwrap()
    });
    assert_eq!(pictures[0], pictures[1]);
}
