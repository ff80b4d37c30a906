//! Further views of one scene: `--camera`.

use super::{complaint, folder, halfdisk, refused};
use std::path::Path;

/// A lit corner, from some place.
fn scene(from: &str) -> String {
    format!(
        "name = 'corner'\ncamera = {{ from = {from}, to = [0, 0.5, 0], fov = 60 }}\nfilm.size = [24, 16]\n\
         materials.grey.lambert.albedo = 0.5\n\
         [[objects]]\nmaterial = 'grey'\nquad = {{ corner = [-1, 0, 1], u = [2, 0, 0], v = [0, 0, -2] }}\n\
         [[objects]]\nmaterial = 'grey'\nquad = {{ corner = [-1, 0, -1], u = [2, 0, 0], v = [0, 2, 0] }}\n\
         [[objects]]\nemits = 5\nquad = {{ corner = [-0.3, 1.9, -0.3], u = [0.6, 0, 0], v = [0, 0, 0.6] }}\n"
    )
}

fn pixels(path: &Path) -> Vec<u8> {
    image::open(path).unwrap().to_rgb8().into_raw()
}

/// The largest difference of two pictures, of 255.
fn apart(a: &[u8], b: &[u8]) -> u8 {
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().zip(b);
    pairs.map(|(a, b)| a.abs_diff(*b)).max().unwrap()
}

#[test]
fn another_view_is_the_picture_from_there() {
    let folder = folder();
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("here.toml"), scene("[0, 1, 4]")).unwrap();
    std::fs::write(at("there.toml"), scene("[2, 1.5, 3]")).unwrap();
    for integrator in ["path", "radiosity"] {
        let run = |scene: &str, more: &[&str]| {
            let usual = [
                "render",
                scene,
                "--spp",
                "64",
                "--quiet",
                "--integrator",
                integrator,
            ];
            let output = halfdisk(folder.path(), &[&usual[..], more].concat());
            assert!(output.status.success(), "{}", complaint(&output));
        };
        run(
            "here.toml",
            &["--out", "both.png", "--camera", "there.toml"],
        );
        run("here.toml", &["--out", "first.png"]);
        run("there.toml", &["--out", "second.png"]);
        let [first, second] = ["first.png", "second.png"].map(|name| pixels(&at(name)));
        assert_eq!(pixels(&at("both.png")), first, "{integrator}");
        // The same light to rounding; the first view is another picture.
        let there = pixels(&at("both-there.png"));
        assert!(
            apart(&there, &second) <= 2,
            "{integrator}: {}",
            apart(&there, &second)
        );
        assert!(apart(&there, &first) > 50, "{integrator}");
    }
}

#[test]
fn views_that_cannot_be_are_refused() {
    let folder = folder();
    std::fs::write(folder.path().join("here.toml"), scene("[0, 1, 4]")).unwrap();
    let twice = [
        "render",
        "here.toml",
        "--camera",
        "cornell",
        "--camera",
        "cornell",
    ];
    let sentence = refused(folder.path(), &twice, 2);
    assert!(sentence.contains("another view goes to"), "{sentence}");
    let with =
        |file: &str| ["render", "here.toml", "--spp", "1", "--camera", file].map(str::to_owned);
    let said = |file: &str| {
        let arguments = with(file);
        refused(folder.path(), &arguments.each_ref().map(String::as_str), 2)
    };
    assert!(said("nowhere.toml").starts_with("nowhere.toml: "));
    let wide = scene("[0, 1, 4]").replace("fov = 60", "fov = 400");
    std::fs::write(folder.path().join("wide.toml"), wide).unwrap();
    let sentence = said("wide.toml");
    assert!(
        sentence.starts_with("wide.toml:2: `camera.fov` "),
        "{sentence}"
    );
}

#[test]
fn an_empty_view_says_why() {
    let folder = folder();
    let write = |name: &str, text: String| std::fs::write(folder.path().join(name), text).unwrap();
    let block =
        "[[objects]]\nmaterial = 'grey'\nbox = { min = [-0.5, 0, -0.5], max = [0.5, 1, 0.5] }\n";
    let at = |from: &str| scene(from) + block;
    write("here.toml", at("[0, 1, 4]"));
    write("inside.toml", at("[0.1, 0.4, 0.2]"));
    write(
        "away.toml",
        at("[0, 1, 4]").replace("to = [0, 0.5, 0]", "to = [0, 1, 40]"),
    );
    for integrator in ["path", "radiosity"] {
        let usual = [
            "render",
            "here.toml",
            "--spp",
            "4",
            "--integrator",
            integrator,
        ];
        let views = [
            "--camera",
            "inside.toml",
            "--camera",
            "away.toml",
            "--camera",
            "here.toml",
        ];
        let out = ["--out", "a.png"];
        let output = halfdisk(folder.path(), &[&usual[..], &views, &out].concat());
        let said = complaint(&output);
        assert_eq!(output.status.code(), Some(0), "{said}");
        let inside = "note: a-inside.png is black: the camera is inside an object";
        assert!(said.contains(inside), "{said}");
        assert!(
            said.contains("note: a-away.png is black: the camera sees nothing"),
            "{said}"
        );
        assert_eq!(said.matches("is black").count(), 2, "{said}");
    }
    // The first view is as bad as any other.
    let inside = [
        "render",
        "inside.toml",
        "--spp",
        "4",
        "--integrator",
        "radiosity",
    ];
    let said = complaint(&halfdisk(folder.path(), &inside));
    assert!(
        said.contains("the picture is black: the camera is inside an object"),
        "{said}"
    );
}

#[test]
fn a_scene_without_patches_is_refused_in_one_sentence() {
    let folder = folder();
    // Radiosity also leaves out light of these scenes, which is of no interest then.
    for (scene, why) in [
        ("motion", "something moves"),
        ("room", "is a sphere"),
        ("mesh", "form factors"),
    ] {
        let sentence = refused(
            folder.path(),
            &["render", scene, "--integrator", "radiosity"],
            2,
        );
        assert!(
            sentence.starts_with("--integrator radiosity: "),
            "{sentence}"
        );
        assert!(sentence.contains(why), "{sentence}");
    }
}

#[test]
fn photons_are_asked_for_where_there_are_some_and_said_with_their_blur() {
    let folder = folder();
    let render = |more: &[&str]| {
        let start = ["render", "caustic", "--size", "16x12"];
        halfdisk(folder.path(), &[&start, more].concat())
    };
    let by = ["--integrator", "photons"];
    for (more, what) in [
        (&["--photons", "100"][..], "only `--integrator photons` has"),
        (&["--radius", "1"], "`path` has no photon map"),
        (&["--photons", "0", by[0], by[1]], "from 1 to"),
        (&["--radius", "0", by[0], by[1]], "above 0"),
        (&["--radius", "nan", by[0], by[1]], "above 0"),
        (
            &["--target-error", "2%", by[0], by[1]],
            "says how much that is",
        ),
    ] {
        let said = complaint(&render(more));
        assert!(said.contains(what), "{said}");
    }
    let output = render(&[
        "--spp",
        "4",
        "--photons",
        "2000",
        "--radius",
        "0.3",
        by[0],
        by[1],
    ]);
    let said = complaint(&output);
    assert!(output.status.success(), "{said}");
    for what in [
        "photons: 2000 walks from the lights in each pass; discs of radius 3.000e-1 in the first",
        "blur: ",
        "that error is noise alone",
    ] {
        assert!(said.contains(what), "{said}");
    }
    let bytes = std::fs::read(folder.path().join("out/caustic-photons.png")).unwrap();
    let facts = r#""photons":{"walks":2000,"first_radius":0.3}"#.as_bytes();
    let holds = bytes.windows(facts.len()).any(|part| part == facts);
    assert!(holds, "the file says what it is made with");
}

#[test]
fn patches_are_asked_for_where_there_are_some() {
    let folder = folder();
    for (arguments, what) in [
        (
            &["render", "cornell", "--patches", "100"][..],
            "`path` has no patches",
        ),
        (
            &[
                "render",
                "cornell",
                "--integrator",
                "radiosity",
                "--patches",
                "3",
            ],
            "too few",
        ),
        (
            &[
                "render",
                "cornell",
                "--integrator",
                "radiosity",
                "--patches",
                "0",
            ],
            "--patches",
        ),
        (
            &[
                "render",
                "cornell",
                "--integrator",
                "radiosity",
                "--patch-size",
                "-1",
            ],
            "a length",
        ),
        (
            &[
                "render",
                "cornell",
                "--integrator",
                "radiosity",
                "--patches",
                "100000",
            ],
            "40 GB",
        ),
        (
            &[
                "render",
                "cornell",
                "--integrator",
                "radiosity",
                "--target-error",
                "2%",
            ],
            "--target-error",
        ),
    ] {
        let output = halfdisk(folder.path(), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let sentence = complaint(&output);
        assert!(
            sentence.starts_with("error: "),
            "{arguments:?}: {sentence:?}"
        );
        assert!(sentence.contains(what), "{arguments:?}: {sentence}");
    }
}
