//! Renders that go on, and what files say of how they were made.

use super::{SCENE, complaint, folder, halfdisk};
use std::fs;
use std::path::Path;

fn done(folder: &Path, arguments: &str) -> String {
    let words: Vec<&str> = arguments.split(' ').collect();
    let output = halfdisk(folder, &words);
    assert!(
        output.status.success(),
        "{arguments}: {}",
        complaint(&output)
    );
    String::from_utf8(output.stdout).unwrap()
}

fn refused(folder: &Path, arguments: &str) -> String {
    let words: Vec<&str> = arguments.split(' ').collect();
    let output = halfdisk(folder, &words);
    assert_eq!(output.status.code(), Some(2), "{arguments}");
    complaint(&output)
}

#[test]
fn a_render_in_three_steps_has_the_bytes_of_one() {
    let folder = folder();
    let folder = folder.path();
    for settings in [
        "cornell --seed 5",
        "caustic --max-depth 5",
        "caustic --integrator light-tracer",
        "spheres --integrator photons --photons 500",
        "mixture --paths L(D|S)+E --sampler independent",
    ] {
        done(
            folder,
            &format!("render {settings} --size 16x12 --spp 90 --out whole.exr -q"),
        );
        done(
            folder,
            &format!("render {settings} --size 16x12 --spp 10 --out steps.exr -q"),
        );
        done(folder, "render --resume steps.exr --spp 33 -q --threads 1");
        done(folder, "render --resume steps.exr --spp 90 -q --threads 3");
        let [whole, steps] = ["whole.exr", "steps.exr"].map(|f| fs::read(folder.join(f)).unwrap());
        assert!(whole == steps, "{settings}");
    }
}

#[test]
fn what_does_not_fit_is_refused_by_name() {
    let folder = folder();
    let folder = folder.path();
    fs::write(folder.join("mine.toml"), SCENE).unwrap();
    done(folder, "render mine.toml --spp 4 --out a.exr -q");
    done(folder, "render mine.toml --spp 4 --out a.png -q");
    for (arguments, said) in [
        ("--resume a.exr", "a.exr: has 4 samples per pixel already"),
        (
            "--resume a.exr --spp 4",
            "a.exr: has 4 samples per pixel already",
        ),
        (
            "--resume a.png --spp 8",
            "a.png: says no more than the picture",
        ),
        ("--resume mine.toml --spp 8", "mine.toml: pictures end in"),
        (
            "--resume a.exr --spp 8 --seed 1",
            "'--seed <SEED>' cannot be used",
        ),
        (
            "cornell --resume a.exr --spp 8",
            "a.exr: was made of another scene: cornell",
        ),
        ("--spp 8", "<SCENE>"),
    ] {
        let complaint = refused(folder, &format!("render {arguments} -q"));
        assert!(complaint.contains(said), "{arguments}: {complaint}");
    }
    // Comments and spaces are no other scene, numbers are.
    fs::write(folder.join("mine.toml"), format!("# Mine.\n\n{SCENE}")).unwrap();
    done(folder, "render --resume a.exr --spp 5 -q");
    fs::write(
        folder.join("mine.toml"),
        SCENE.replace("intensity = 9", "intensity = 9.5"),
    )
    .unwrap();
    let complaint = refused(folder, "render --resume a.exr --spp 6 -q");
    assert!(
        complaint.contains(
            "a.exr: was made of another scene: sample or a file that it names has changed"
        ),
        "{complaint}"
    );
}

#[test]
fn a_picture_says_how_it_is_made_again() {
    let folder = folder();
    let folder = folder.path();
    fs::write(folder.join("mine two.toml"), SCENE).unwrap();
    let made = "render 'mine two.toml' --target-error 40% --paths L(D|S)+E --seed 7 -q";
    let words = made.split(' ').map(|w| w.trim_matches('\''));
    let mut arguments: Vec<&str> = words.collect();
    arguments[1] = "mine two.toml";
    arguments.remove(2);
    for file in ["a.exr", "a.png"] {
        let output = halfdisk(folder, &[&arguments[..], &["--out", file]].concat());
        assert!(output.status.success(), "{}", complaint(&output));
        let said = done(folder, &format!("info {file}"));
        assert!(said.contains("sample by path"), "{said}");
        let command = said
            .lines()
            .find_map(|l| l.strip_prefix("made again by: halfdisk "))
            .unwrap();
        let mut again = shlex::split(command).unwrap();
        let other = format!("again-{file}");
        again.extend(["--out", &other, "-q"].map(str::to_owned));
        let again: Vec<&str> = again.iter().map(String::as_str).collect();
        assert!(halfdisk(folder, &again).status.success(), "{again:?}");
        let [first, second] = [file, &other].map(|f| fs::read(folder.join(f)).unwrap());
        assert!(first == second, "{command}");
    }
    fs::write(folder.join("b.png"), "no picture").unwrap();
    let output = halfdisk(folder, &["info", "b.png"]);
    assert!(complaint(&output).contains("b.png is no PNG picture that can be read"));
}
