//! Pictures that are made in parts.

use super::{SCENE, complaint, folder, halfdisk, shades};
use std::fs;
use std::path::Path;

fn run(folder: &Path, arguments: &str) -> Result<(), String> {
    let words: Vec<&str> = arguments.split(' ').collect();
    let output = halfdisk(folder, &words);
    match output.status.code() {
        Some(0) => Ok(()),
        Some(2) => Err(complaint(&output)),
        other => panic!("{arguments}: {other:?}: {}", complaint(&output)),
    }
}

/// Renders the shards of a picture, and returns the names of their files.
fn shards(folder: &Path, settings: &str, count: u32) -> Vec<String> {
    let shard = |index| {
        let file = format!("part-{index}-of-{count}.exr");
        run(
            folder,
            &format!("render {settings} --shard {index}/{count} --out {file} -q"),
        )
        .unwrap();
        file
    };
    (1..=count).map(shard).collect()
}

#[test]
fn shards_make_the_bytes_of_the_whole_picture() {
    let folder = folder();
    let folder = folder.path();
    for (settings, counts) in [
        ("cornell --size 70x50 --spp 6 --seed 2", &[2, 7, 64][..]),
        ("caustic --size 70x50 --spp 4", &[2, 7]),
        (
            "caustic --size 40x40 --spp 4 --integrator light-tracer",
            &[2, 7],
        ),
        (
            "spheres --size 40x40 --spp 3 --integrator photons --photons 500",
            &[2, 7],
        ),
        ("mixture --size 40x40 --spp 4 --paths L(D|S)+E", &[3]),
        ("spheres --size 40x40 --spp 1 --integrator depth", &[3]),
    ] {
        run(folder, &format!("render {settings} --out whole.exr -q")).unwrap();
        for &count in counts {
            let mut parts = shards(folder, settings, count);
            parts.reverse();
            run(
                folder,
                &format!("merge {} --out merged.exr", parts.join(" ")),
            )
            .unwrap();
            let [whole, merged] =
                ["whole.exr", "merged.exr"].map(|f| fs::read(folder.join(f)).unwrap());
            assert!(whole == merged, "{settings}, {count} shards");
        }
        // Shades, too, where they are no radiance.
        run(folder, &format!("render {settings} --out whole.png -q")).unwrap();
        let count = counts[counts.len() - 1];
        let parts: Vec<_> = (1..=count)
            .map(|i| format!("part-{i}-of-{count}.exr"))
            .collect();
        run(
            folder,
            &format!("merge {} --out merged.png", parts.join(" ")),
        )
        .unwrap();
        let [whole, merged] = ["whole.png", "merged.png"].map(|f| shades(&folder.join(f)));
        assert!(whole == merged, "{settings}");
    }
}

#[test]
fn parts_that_do_not_fit_are_refused_by_name() {
    let folder = folder();
    let folder = folder.path();
    fs::write(folder.join("mine.toml"), SCENE).unwrap();
    let parts = shards(folder, "mine.toml --size 40x20 --spp 3", 3);
    let part = |settings: &str, file: &str| {
        run(folder, &format!("render {settings} --out {file} -q")).unwrap()
    };
    part(
        "mine.toml --size 40x20 --spp 3 --seed 1 --shard 2/3",
        "seed.exr",
    );
    part("mine.toml --size 40x20 --spp 2 --shard 2/3", "spp.exr");
    part("mine.toml --size 40x24 --spp 3 --shard 2/3", "size.exr");
    part("mine.toml --size 40x20 --spp 3 --shard 2/4", "four.exr");
    part("mine.toml --size 40x20 --spp 3", "whole.exr");
    fs::write(
        folder.join("mine.toml"),
        SCENE.replace("intensity = 9", "intensity = 8"),
    )
    .unwrap();
    part("mine.toml --size 40x20 --spp 3 --shard 2/3", "scene.exr");
    let bytes = fs::read(folder.join(&parts[1])).unwrap();
    fs::write(folder.join("cut.exr"), &bytes[..bytes.len() / 2]).unwrap();
    let [one, two, three] = &parts[..] else {
        panic!()
    };
    for (files, said) in [
        (
            format!("{one} {three}"),
            "missing: the shards 2/3".to_owned(),
        ),
        (
            format!("{one} {two} {three} {two}"),
            format!("{two}: is shard 2/3, as {two} is"),
        ),
        (
            format!("{one} seed.exr {three}"),
            format!("seed.exr: has another seed, 1 rather than 0, than that of {one}"),
        ),
        (
            format!("{one} spp.exr {three}"),
            "spp.exr: has another number of samples".to_owned(),
        ),
        (
            format!("{one} size.exr {three}"),
            "size.exr: is of another size than that of part-1-of-3.exr".to_owned(),
        ),
        (
            format!("{one} four.exr {three}"),
            "four.exr: is one of 4 shards".to_owned(),
        ),
        (
            format!("{one} whole.exr {three}"),
            "whole.exr: is no shard".to_owned(),
        ),
        (
            format!("{one} scene.exr {three}"),
            "scene.exr: is of another state of the scene".to_owned(),
        ),
        (format!("{one} cut.exr {three}"), "cut.exr".to_owned()),
        (format!("{one} nix.exr"), "nix.exr".to_owned()),
    ] {
        let output = halfdisk(
            folder,
            &format!("merge {files} --out m.exr")
                .split(' ')
                .collect::<Vec<_>>(),
        );
        assert!(!output.status.success(), "{files}");
        let complaint = complaint(&output);
        assert!(complaint.contains(&said), "{files}: {complaint}");
        assert!(!folder.join("m.exr").exists(), "{files}");
    }
    for wrong in ["0/3", "4/3", "3", "1/0"] {
        assert!(
            run(
                folder,
                &format!("render mine.toml --shard {wrong} --out a.exr")
            )
            .is_err(),
            "{wrong}"
        );
    }
    let refused = run(folder, "render mine.toml --shard 1/2 --out a.png").unwrap_err();
    assert!(
        refused.contains("--shard: only .exr files can be put together, not a.png"),
        "{refused}"
    );
}

#[test]
fn a_class_averages_its_seeds() {
    let folder = folder();
    let folder = folder.path();
    let seeds = [12, 3, 4, 5];
    let files: Vec<String> = seeds
        .map(|seed| {
            // Everybody has a copy of the scene in a place of their own.
            fs::create_dir_all(folder.join(seed.to_string())).unwrap();
            fs::write(folder.join(format!("{seed}/mine.toml")), SCENE).unwrap();
            let file = format!("seed-{seed}.exr");
            let settings = format!("{seed}/mine.toml --spp 5 --seed {seed}");
            run(folder, &format!("render {settings} --out {file} -q")).unwrap();
            file
        })
        .to_vec();
    let mut turned = files.clone();
    turned.reverse();
    let merge = |files: &[String], out: &str| {
        let files = files.join(" ");
        let output = halfdisk(
            folder,
            &format!("merge --seeds {files} --out {out}")
                .split(' ')
                .collect::<Vec<_>>(),
        );
        assert!(output.status.success(), "{}", complaint(&output));
        complaint(&output)
    };
    let said = merge(&files, "a.exr");
    assert!(
        said.starts_with("wrote a.exr of 4 seeds: 20 samples per pixel, noise "),
        "{said}"
    );
    assert!(
        said.contains(" %, mean 0.") && said.contains(" ± 0.0"),
        "{said}"
    );
    merge(&turned, "b.exr");
    let [a, b] = ["a.exr", "b.exr"].map(|file| fs::read(folder.join(file)).unwrap());
    assert!(a == b, "the order of the files");
    merge(&files, "a.png");
    let info = halfdisk(folder, &["info", "a.exr"]);
    let said = String::from_utf8(info.stdout).unwrap();
    assert!(
        said.contains("20 samples per pixel, seed 3")
            && said.contains("average of 4 pictures, of the seeds 3-5, 12: all their samples")
            && said.contains("its first picture is made again by: halfdisk render 3/mine.toml"),
        "{said}"
    );
    let part = |settings: &str, file: &str| {
        run(folder, &format!("render {settings} --out {file} -q")).unwrap()
    };
    part("3/mine.toml --spp 5 --seed 6 --shard 1/2", "shard.exr");
    part(
        "3/mine.toml --spp 5 --seed 6 --integrator combine",
        "other.exr",
    );
    part(
        "3/mine.toml --spp 5 --seed 6 --sampler independent",
        "sampler.exr",
    );
    part("3/mine.toml --spp 5 --seed 6", "flat.png");
    let again = "again.exr";
    fs::copy(folder.join(&files[0]), folder.join(again)).unwrap();
    for (part, said) in [
        (again, "again.exr: has seed 12, as seed-12.exr has"),
        ("a.exr", "a.exr: is an average of several seeds already"),
        ("shard.exr", "shard.exr: is a shard"),
        ("flat.png", "flat.png: says no more than the picture"),
        (
            "other.exr",
            "other.exr: has another integrator, combine rather than path, than that of seed-12.exr",
        ),
        ("sampler.exr", "sampler.exr: has other settings"),
    ] {
        let merge = format!("merge --seeds {} {part} --out m.exr", files.join(" "));
        let refused = run(folder, &merge).unwrap_err();
        assert!(refused.contains(said), "{part}: {refused}");
        assert!(!folder.join("m.exr").exists(), "{part}");
    }
    let merge = format!("merge --seeds {} --out m.exr", files[0]);
    let refused = run(folder, &merge).unwrap_err();
    assert!(
        refused.contains("seed-12.exr: is the only one"),
        "{refused}"
    );
    let refused = run(folder, &format!("merge {} --out m.exr", files[0])).unwrap_err();
    assert!(refused.contains("seed-12.exr: is no shard"), "{refused}");
    let refused = run(folder, "render --resume a.exr --spp 40").unwrap_err();
    assert!(
        refused.contains("--resume a.exr: is an average of several seeds"),
        "{refused}"
    );
}
