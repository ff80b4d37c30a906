//! Pictures of the same thing are accepted, and others refused.

use super::pictures::{Verdict, in_blocks};
use halfdisk::integrators::Path;
use halfdisk::render::{Options, Picture, render};
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;

/// The Cornell box, whose red wall has this albedo.
fn room(red: &str, seed: u64) -> Picture {
    let text = include_str!("../../examples/scenes/cornell.toml");
    let text = &text.replace("[0.65, 0.05, 0.05]", red);
    let source = Source {
        file: "cornell.toml",
        text,
    };
    let scene = gallery::from_text(source, None, |_| {}).unwrap();
    let options = Options {
        spp: 32,
        seed,
        ..Options::default()
    };
    render(&scene.sized([64; 2]), &Path::new(6), &options, &())
        .film
        .picture()
}

/// A picture one pixel to the right.
fn shifted(picture: &Picture) -> Picture {
    let width = picture.size[0] as usize;
    let mut shifted = picture.clone();
    for row in shifted.values.chunks_mut(width) {
        row.copy_within(..width - 1, 1);
    }
    shifted
}

/// A picture that is brighter by this factor, in the pixels and channels asked for.
fn scaled(picture: &Picture, by: f64, of: impl Fn(usize, usize) -> bool) -> Picture {
    let mut scaled = picture.clone();
    for (i, value) in scaled.values.iter_mut().enumerate() {
        (0..3).for_each(|c| value[c] *= if of(i, c) { by } else { 1.0 });
    }
    scaled
}

fn verdict(a: &Picture, b: &Picture) -> Verdict {
    Verdict::of(&in_blocks(a), &in_blocks(b))
}

#[test]
fn a_picture_at_another_seed_is_accepted_and_one_of_something_else_is_not() {
    let red = "[0.65, 0.05, 0.05]";
    let stored = room(red, 1);
    for seed in 2..5 {
        let verdict = verdict(&stored, &room(red, seed));
        assert!(verdict.accepts(), "seed {seed}: {verdict}");
        assert!(verdict.notices < 0.02, "{verdict}");
    }
    let other = room(red, 5);
    let wrong = [
        ("an edge moved", shifted(&other)),
        ("3 % brighter", scaled(&other, 1.03, |_, _| true)),
        ("a wall less red", room("[0.55, 0.05, 0.05]", 5)),
    ];
    for (what, picture) in wrong {
        let verdict = verdict(&stored, &picture);
        println!("{what}: {verdict}");
        assert!(!verdict.accepts(), "{what}: {verdict}");
    }
}

#[test]
fn single_samples_are_judged_by_their_neighbours() {
    let stored = room("[0.65, 0.05, 0.05]", 1);
    let single = |seed| Picture {
        errors: None,
        ..room("[0.65, 0.05, 0.05]", seed)
    };
    let verdict_of = |picture: &Picture| verdict(&single(1), picture);
    for seed in 2..6 {
        let verdict = verdict_of(&single(seed));
        println!("{verdict}");
        assert!(verdict.accepts(), "seed {seed}: {verdict}");
    }
    assert!(!verdict_of(&shifted(&single(2))).accepts());
    assert!(!verdict_of(&scaled(&single(2), 1.05, |_, _| true)).accepts());
    // They overstate the error, and not by much.
    let [known, guessed] = [&stored, &single(1)].map(|p| verdict(p, p).notices);
    assert!(guessed < 2.0 * known, "{guessed} {known}");
}
