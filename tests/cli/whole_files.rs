//! A file is the old one or the new one, never a part; and no scene loses its own.

use super::{SCENE, complaint, folder, halfdisk, refused};
use std::fs;
use std::path::Path;

/// The names in a folder.
fn names(folder: &Path) -> Vec<String> {
    let entries = folder.read_dir().unwrap();
    let name = |e: std::io::Result<fs::DirEntry>| e.unwrap().file_name().into_string().unwrap();
    let mut names: Vec<String> = entries.map(name).collect();
    names.sort();
    names
}

const SMALL: &[&str] = &["render", "lamp", "--size", "20x20", "--spp", "4"];

#[cfg(unix)]
mod unix {
    use super::*;
    use std::io::Read;
    use std::os::unix::fs::{MetadataExt, symlink};
    use std::process::{Command, Output};

    /// Runs the program with files of at most `blocks` of half a kilobyte, or of one.
    fn limited(folder: &Path, blocks: u32, temporary: &Path, arguments: &[&str]) -> Output {
        let script = format!("ulimit -f {blocks}; exec \"$0\" \"$@\"");
        Command::new("sh")
            .args(["-c", &script, env!("CARGO_BIN_EXE_halfdisk")])
            .args(arguments)
            .env("TMPDIR", temporary)
            .current_dir(folder)
            .output()
            .unwrap()
    }

    #[test]
    fn where_there_is_no_room_the_old_file_stays_and_the_picture_is_kept_elsewhere() {
        let (folder, temporary) = (folder(), crate::cli::folder());
        let big = folder.path().join("big.exr");
        fs::write(&big, "an old picture").unwrap();
        let to_big = [SMALL, &["--out", "big.exr", "--json"]].concat();
        // Enough for a PNG of 400 pixels, not for their EXR.
        let output = limited(folder.path(), 4, temporary.path(), &to_big);
        let said = complaint(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert_eq!(fs::read(&big).unwrap(), b"an old picture");
        assert_eq!(names(folder.path()), ["big.exr"]);
        let kept = names(temporary.path());
        assert!(
            kept.len() == 1 && kept[0].starts_with("big-") && kept[0].ends_with(".png"),
            "{kept:?}"
        );
        let kept = temporary.path().join(&kept[0]);
        assert!(
            said.contains("error: big.exr: File too large")
                && said.ends_with(&format!("; the picture is in {}\n", kept.display())),
            "{said}"
        );
        assert_eq!(image::open(&kept).unwrap().width(), 20);
        // The report and the facts are there all the same.
        let facts: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(facts["out"], kept.display().to_string());
        assert!(said.contains("mean of the picture"), "{said}");
    }

    #[test]
    fn where_there_is_no_room_at_all_it_says_so() {
        let folder = folder();
        fs::write(folder.path().join("p.png"), "an old picture").unwrap();
        let nowhere = folder.path().join("nowhere");
        let output = limited(
            folder.path(),
            0,
            &nowhere,
            &[SMALL, &["--out", "p.png"]].concat(),
        );
        let said = complaint(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains("error: p.png: "), "{said}");
        assert!(
            said.contains("nor could the picture be kept elsewhere"),
            "{said}"
        );
        assert_eq!(names(folder.path()), ["p.png"]);
        assert_eq!(
            fs::read(folder.path().join("p.png")).unwrap(),
            b"an old picture"
        );
    }

    #[test]
    fn results_of_other_commands_are_printed_where_there_is_no_room_for_their_files() {
        for (arguments, words) in [
            (
                &["converge", "darts", "--replicates", "4", "--doublings", "2"][..],
                "darts, exact",
            ),
            (
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
                "path",
            ),
        ] {
            let folder = folder();
            let output = limited(folder.path(), 0, folder.path(), arguments);
            let said = complaint(&output);
            assert_eq!(output.status.code(), Some(1), "{said}");
            assert!(said.contains("File too large"), "{said}");
            let printed = String::from_utf8(output.stdout).unwrap();
            assert!(printed.contains(words), "{printed}");
        }
    }

    #[test]
    fn links_stay_and_what_they_name_is_replaced() {
        let folder = folder();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("deep")).unwrap();
        fs::write(at("deep/real.png"), "an old picture").unwrap();
        symlink("deep/real.png", at("link.png")).unwrap();
        symlink("link.png", at("second.png")).unwrap();
        symlink("deep/new.png", at("dangling.png")).unwrap();
        for (name, real) in [
            ("second.png", "deep/real.png"),
            ("dangling.png", "deep/new.png"),
        ] {
            let output = halfdisk(folder.path(), &[SMALL, &["--out", name]].concat());
            assert!(output.status.success(), "{}", complaint(&output));
            assert!(at(name).is_symlink() && !at(real).is_symlink());
            assert_eq!(image::open(at(real)).unwrap().width(), 20);
        }
        assert_eq!(names(&at("deep")), ["new.png", "real.png"]);
        symlink("round.png", at("round.png")).unwrap();
        let round = [SMALL, &["--out", "round.png"]].concat();
        assert!(refused(folder.path(), &round, 1).contains("too many links"));
    }

    #[test]
    fn what_is_no_file_is_written_to_as_it_is() {
        let folder = folder();
        let at = |name: &str| folder.path().join(name);
        symlink("/dev/null", at("null.png")).unwrap();
        let output = halfdisk(folder.path(), &[SMALL, &["--out", "null.png"]].concat());
        assert!(output.status.success(), "{}", complaint(&output));
        assert!(at("null.png").is_symlink());

        let pipe = Command::new("mkfifo").arg(at("pipe.png")).status();
        assert!(pipe.unwrap().success());
        let name = at("pipe.png");
        let reader = std::thread::spawn(move || fs::read(name).unwrap());
        let output = halfdisk(folder.path(), &[SMALL, &["--out", "pipe.png"]].concat());
        assert!(output.status.success(), "{}", complaint(&output));
        let image = image::load_from_memory(&reader.join().unwrap()).unwrap();
        assert_eq!(image.width(), 20);

        // The shell's file is open already: replaced, it would get nothing.
        symlink("/dev/stdout", at("out.png")).unwrap();
        let script = "\"$0\" \"$@\" > shown.png";
        let shell = Command::new("sh")
            .args(["-c", script, env!("CARGO_BIN_EXE_halfdisk")])
            .args([SMALL, &["--out", "out.png"]].concat())
            .current_dir(folder.path())
            .status();
        assert!(shell.unwrap().success());
        assert_eq!(image::open(at("shown.png")).unwrap().width(), 20);
        let mut through = Command::new(env!("CARGO_BIN_EXE_halfdisk"))
            .args([SMALL, &["--out", "out.png"]].concat())
            .current_dir(folder.path())
            .stdout(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        let mut bytes = Vec::new();
        let mut stdout = through.stdout.take().unwrap();
        stdout.read_to_end(&mut bytes).unwrap();
        assert!(through.wait().unwrap().success());
        assert_eq!(image::load_from_memory(&bytes).unwrap().width(), 20);
    }

    #[test]
    fn permissions_are_those_of_any_new_file_or_of_the_old_one() {
        let folder = folder();
        let mode = |name: &str| fs::metadata(folder.path().join(name)).unwrap().mode() & 0o777;
        fs::write(folder.path().join("plain"), "").unwrap();
        let own = folder.path().join("own.exr");
        fs::write(&own, "").unwrap();
        fs::set_permissions(&own, std::os::unix::fs::PermissionsExt::from_mode(0o640)).unwrap();
        for name in ["new.png", "own.exr", "new.hdr"] {
            let output = halfdisk(folder.path(), &[SMALL, &["--maps", "--out", name]].concat());
            assert!(output.status.success(), "{}", complaint(&output));
        }
        assert_eq!(mode("own.exr"), 0o640);
        for name in ["new.png", "new.hdr", "new.variance.svg"] {
            assert_eq!(mode(name), mode("plain"), "{name}");
        }
    }

    #[test]
    fn a_scene_keeps_its_files_by_whatever_way_they_are_named() {
        let folder = folder();
        let at = |name: &str| folder.path().join(name);
        for name in ["images", "out/cost/sky", "strips"] {
            fs::create_dir_all(at(name)).unwrap();
        }
        let sky = |image: &str| {
            let environment = format!("environment = {{ image = \"{image}\" }}\n[render]");
            let text = SCENE.replace("background = 0.5\n", "");
            fs::write(at("sky.toml"), text.replacen("[render]", &environment, 1)).unwrap();
            let white = image::RgbImage::from_pixel(8, 4, image::Rgb([255; 3]));
            white.save(at(image)).unwrap();
            fs::read(at(image)).unwrap()
        };
        symlink("images", at("way")).unwrap();
        let absolute = at("images/sky.png");
        let absolute = absolute.to_str().unwrap();
        for (image, arguments) in [
            (
                "images/sky.png",
                &["render", "sky.toml", "--out", "images/sky.png"][..],
            ),
            (
                "images/sky.png",
                &["render", "sky.toml", "--out", "./way/../images/sky.png"],
            ),
            (
                "images/sky.png",
                &["render", "sky.toml", "--out", "way/sky.png"],
            ),
            ("images/sky.png", &["render", "sky.toml", "--out", absolute]),
            // Also where this render has no use for the file.
            (
                "images/sky.png",
                &[
                    "render",
                    "sky.toml",
                    "--out",
                    "way/sky.png",
                    "--without",
                    "sky",
                ],
            ),
            ("out/sky.png", &["render", "sky.toml"]),
            (
                "out/sky-albedo.png",
                &["render", "sky.toml", "--integrator", "albedo"],
            ),
            (
                "strips/strip.png",
                &["classify", "sky.toml", "--out", "strips"],
            ),
            (
                "strips/classes.png",
                &["classify", "sky.toml", "--out", "strips"],
            ),
            ("out/sky.variance.png", &["render", "sky.toml", "--maps"]),
            (
                "out/cost/sky/rays.png",
                &["cost", "sky.toml", "--methods", "path"],
            ),
            (
                "out/cost/sky/error_path.png",
                &["cost", "sky.toml", "--methods", "path"],
            ),
        ] {
            let before = sky(image);
            let sentence = refused(folder.path(), arguments, 2);
            assert!(
                sentence.ends_with(
                    ": the scene needs this file, so it cannot be replaced: choose another name"
                ),
                "{arguments:?}: {sentence}"
            );
            assert_eq!(fs::read(at(image)).unwrap(), before);
        }
        // A copy is no file of the scene.
        sky("images/sky.png");
        fs::copy(at("images/sky.png"), at("copy.png")).unwrap();
        let copy = ["render", "sky.toml", "--spp", "1", "--out", "copy.png"];
        assert!(halfdisk(folder.path(), &copy).status.success());
    }
}

#[test]
fn pictures_that_are_replaced_leave_nothing_beside() {
    let folder = folder();
    for _ in 0..2 {
        let output = halfdisk(folder.path(), &[SMALL, &["--out", "p.exr"]].concat());
        assert!(output.status.success(), "{}", complaint(&output));
        assert_eq!(names(folder.path()), ["p.exr"]);
    }
}

#[test]
fn results_are_called_after_the_scenes_file_and_what_is_not_usual() {
    let folder = folder();
    let file = SCENE.replace("sample", "another name");
    fs::create_dir(folder.path().join("scenes")).unwrap();
    fs::write(folder.path().join("scenes/mine.toml"), file).unwrap();
    let mine = "scenes/mine.toml";
    let mut written = Vec::new();
    for (arguments, name) in [
        (&["render", mine][..], "mine.png"),
        (
            &["render", mine, "--integrator", "path", "--maps"],
            "mine.png",
        ),
        (
            &["render", mine, "--integrator", "normals"],
            "mine-normals.png",
        ),
        (
            &["render", mine, "--integrator", "next-event"],
            "mine-next-event.png",
        ),
        (
            &["render", mine, "--paths", "L(D|S)*E"],
            "mine-L(DorS)0+E.png",
        ),
        (
            &["render", mine, "--without", "bleeding,specular"],
            "mine-without-bleeding-specular.png",
        ),
        (&["render", "lamp"], "lamp.png"),
        (
            &["render", "lamp", "--integrator", "depth"],
            "lamp-depth.png",
        ),
        (&["classify", mine], "classify/mine/strip.png"),
    ] {
        let small = [arguments, &["--size", "8x8", "--spp", "4"]].concat();
        let output = halfdisk(folder.path(), &small);
        let said = complaint(&output);
        assert!(output.status.success(), "{said}");
        let path = format!("out/{name}");
        let said = said.replace(std::path::MAIN_SEPARATOR, "/");
        assert!(said.contains(&format!("wrote {path}\n")), "{said}");
        written.push(folder.path().join(&path).exists());
    }
    assert!(written.iter().all(|there| *there));
}

#[test]
fn folders_that_cannot_be_written_are_told_before_the_work() {
    let folder = folder();
    fs::write(folder.path().join("file"), "").unwrap();
    for (arguments, place) in [
        (&["render", "lamp", "--out", "file/p.png"][..], "file/p.png"),
        (&["classify", "lamp", "--out", "file"], "file/strip.png"),
        (&["cost", "lamp", "--out", "file/cost"], "file/cost"),
        (&["converge", "darts", "--out", "file/in"], "file/in"),
        (&["tour", "--out", "file"], "file"),
    ] {
        let start = std::time::Instant::now();
        let sentence = refused(folder.path(), arguments, 1);
        let sentence = sentence.replace(std::path::MAIN_SEPARATOR, "/");
        assert!(sentence.starts_with(&format!("{place}: ")), "{sentence}");
        assert!(start.elapsed().as_secs() < 10, "{arguments:?}");
    }
}
