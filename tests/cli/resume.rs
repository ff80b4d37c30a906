//! Renders that go on, and what files say of how they were made.

use super::{SCENE, complaint, folder, halfdisk, program};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;
use std::fs;
use std::path::Path;
use std::time::Duration;

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

/// Kills renders at random moments, twenty times in all: what was written last goes on to the bytes of one that was
/// left alone.
#[test]
fn killed_renders_lose_no_more_than_the_time_since_they_were_kept() {
    let folder = folder();
    let folder = folder.path();
    let mut random = Pcg32::seed_from_u64(1);
    let (mut kills, mut kept) = (0, 0);
    for (settings, spp) in [
        ("cornell --size 32x24", 4000),
        ("caustic --size 24x18", 2000),
        (
            "spheres --size 24x18 --integrator photons --photons 300",
            600,
        ),
        ("caustic --size 24x18 --integrator light-tracer", 2000),
    ] {
        done(
            folder,
            &format!("render {settings} --spp {spp} --out whole.exr -q"),
        );
        let begin = format!("render {settings} --spp {spp} --out a.exr -q --checkpoint 20ms");
        for _ in 0..5 {
            let there = folder.join("a.exr").exists();
            let goes_on = format!("render --resume a.exr --spp {spp} -q --checkpoint 20ms");
            let arguments = if there { &goes_on } else { &begin };
            let mut child = program(folder).args(arguments.split(' ')).spawn().unwrap();
            std::thread::sleep(Duration::from_millis(random.random_range(30..250)));
            child.kill().unwrap();
            child.wait().unwrap();
            kills += 1;
            if folder.join("a.exr").exists() {
                kept += 1;
                done(folder, "info a.exr");
            }
        }
        let output = match folder.join("a.exr").exists() {
            true => halfdisk(
                folder,
                &[
                    "render",
                    "--resume",
                    "a.exr",
                    "--spp",
                    &spp.to_string(),
                    "-q",
                ],
            ),
            false => halfdisk(folder, &begin.split(' ').collect::<Vec<_>>()),
        };
        // It may have ended before it was killed.
        let ended = complaint(&output).contains("samples per pixel already");
        assert!(
            output.status.success() || ended,
            "{settings}: {}",
            complaint(&output)
        );
        let [whole, killed] = ["whole.exr", "a.exr"].map(|f| fs::read(folder.join(f)).unwrap());
        assert!(whole == killed, "{settings}");
        fs::remove_file(folder.join("a.exr")).unwrap();
    }
    assert_eq!(kills, 20);
    assert!(kept >= 8, "{kept}");
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
            "cannot be used with '--seed <SEED>'",
        ),
        (
            "cornell --resume a.exr --spp 8",
            "a.exr: was made of another scene: cornell",
        ),
        (
            "mine.toml --spp 8 --checkpoint 1s --out b.png",
            "--checkpoint: only .exr files can be gone on with, not b.png",
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

#[test]
fn what_a_killed_render_left_is_swept_away_by_the_next() {
    let folder = folder();
    let folder = folder.path();
    let begin = "render spheres --size 8x6 --spp 2 --out a.exr -q";
    done(folder, begin);
    // That of this file, that of another one, and what nobody wrote aside.
    let (own, others) = (
        ".halfdisk-a.exr-aB3xY9.part",
        [
            ".halfdisk-a.exr-b.exr-aB3xY9.part",
            ".halfdisk-a.exr-note.part.txt",
        ],
    );
    for arguments in [
        "render --resume a.exr --spp 4 -q",
        "render spheres --size 8x6 --spp 2 --out a.exr -q --checkpoint 1h",
    ] {
        for name in [&[own][..], &others].concat() {
            fs::write(folder.join(name), "half a pict").unwrap();
        }
        done(folder, begin);
        assert!(
            folder.join(own).exists(),
            "another process may be writing it"
        );
        done(folder, arguments);
        assert!(!folder.join(own).exists(), "{arguments}");
        assert!(
            others.iter().all(|name| folder.join(name).exists()),
            "{arguments}"
        );
    }
}
