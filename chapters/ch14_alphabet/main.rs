//! Chapter 14: Heckbert's alphabet.
//!
//! Question: which light does a ray tracer miss, and can one say so without tracing a ray?
//! New here: `notation`, `effects::language`, `effects::words`. Decides about all paths
//! `L(D|S|G)*E`. Builds on: chapters 2 (Whitted's tree) and 12 (the path tracer).

mod automaton;
mod coverage;
mod dictionary;
mod figures;
mod finale;

use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Chapter, Desk, DeskError, Number};
use halfdisk::lab::effects::language::Class;
use halfdisk::lab::effects::words::{Words, words};
use halfdisk::lab::ledger::Ledger;
use halfdisk::notation::Word;
use halfdisk::render::Options;
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::{Scene, gallery};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch14",
    title: "Heckbert's alphabet",
    question: "Which light does a ray tracer miss, and can one say so without tracing a ray?",
};

/// The scenes whose light is sorted.
const SCENES: [&str; 4] = ["cornell", "spheres", "caustic", "mixture"];
/// Renders whose scatter tells the error of a share.
const REPLICATES: u32 = 8;

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    // The room is dim for a screen: shown with twice the light.
    desk.expose(1.0);
    // What can be said without a ray.
    automaton::drawing(desk)?;
    dictionary::ask(desk);
    dictionary::missing(desk)?;

    // Every path of four renders, spelt.
    let (mut groups, mut spelt) = (Vec::new(), 0);
    for name in SCENES {
        let side = desk.choose(36, 24);
        let scene = gallery::load(name)?.sized([side; 2]);
        let words = spell(desk, &scene);
        spelt += words.rays;
        desk.say(&format!("\n{name}: {} words", words.shares.len()));
        if matches!(name, "spheres" | "caustic") {
            short_words(desk, name, &words);
        }
        groups.push(figures::shares(desk, name, &words));
    }
    figures::chart(desk, groups)?;

    // One of them, a picture for each class.
    let drawn = figures::strip(desk)?;

    // What each integrator finds: said by the expressions, and measured.
    let (rays, compared) = coverage::work(desk)?;
    let last = finale::work(desk)?;
    Ok(Ledger {
        rays: spelt + drawn.rays + rays + last,
        variance: Some(drawn.variance),
        compared: Some(compared.into()),
        efficiency: Some(1.0 / (drawn.variance * drawn.per_sample)),
        ..Ledger::of(&format!(
            "What is missing is known beforehand, by name: of this room's light Whitted's tree \
             finds {:.0} %.",
            100.0 * drawn.found
        ))
    })
}

/// The light of a scene by words.
fn spell(desk: &Desk, scene: &Scene) -> Words {
    let options = Options {
        spp: desk.spp(32, 8) / REPLICATES,
        seed: desk.options.seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    words(
        scene,
        &Path::new(scene.suggested.max_depth),
        &options,
        REPLICATES,
    )
}

/// Each word of up to three surfaces, and all longer ones together, in percent of the light.
fn short_words(desk: &mut Desk, scene: &str, words: &Words) {
    const SHORT: usize = 5;
    let total = words.total.mean();
    let percent = |light: f64| 100.0 * light / total;
    let mut longer = 0.0;
    for (word, share) in &words.shares {
        let light = percent(share.light.mean());
        if word.0.len() > SHORT {
            longer += light;
            continue;
        }
        let number = Number {
            error: Some(percent(share.light.std_error())),
            ..Number::new(&format!("{scene}: {word}"), light).unit("%")
        };
        desk.number(&format!("{scene}_{word}"), number);
    }
    let says = format!("{scene}: longer words");
    let number = Number::new(&says, (100.0 * longer).round() / 100.0).unit("%");
    desk.number(&format!("{scene}_longer"), number);
    desk.value(
        &format!("{scene}_words"),
        &format!("{scene}: different words"),
        words.shares.len() as f64,
    );
}

/// The light of a class, one estimate from the words that are in it, relative to all light.
fn share_of(class: Class, words: &Words) -> [f64; 2] {
    let expression = class.expression();
    let here = |word: &Word| expression.light_first().accepts(&word.0);
    let own = words.shares.iter().filter(|(word, _)| here(word));
    let (mut mean, mut squared_error) = (0.0, 0.0);
    for (_, share) in own {
        mean += share.light.mean();
        squared_error += share.light.std_error().powi(2);
    }
    [mean, squared_error.sqrt()].map(|x| x / words.total.mean())
}
