//! The pictures of the book's pages on scene files and recipes.
//!
//! Question: what can a scene file say, and how does it look? Each picture is that of a file in
//! `examples/recipes/`, or of `stage.toml` with another material or another light.

mod stage;

use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Chapter, Desk, DeskError, Number};
use halfdisk::lab::ledger::Ledger;
use halfdisk::output::save;
use halfdisk::render::accuracy::{Accuracy, Measure};
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::Estimate;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "scenes",
    title: "Scene files",
    question: "What can a scene file say, and how does it look?",
};

/// The files that are rendered as they stand: name, text, samples of a pixel, and what to look at.
const FILES: [(&str, &str, u32, &str); 8] = [
    (
        "mine",
        include_str!("../../examples/recipes/mine.toml"),
        32,
        "The scene above: one clay for the ball and the ground, and a square light overhead, out of view.",
    ),
    (
        "flask",
        include_str!("../../examples/recipes/flask.toml"),
        32,
        "Two round flasks before a striped wall. The left one is full of water and turns what is behind it \
         about; the right one is empty and hardly bends a ray.",
    ),
    (
        "tumbler",
        include_str!("../../examples/recipes/tumbler.toml"),
        32,
        "A square tumbler, half full of water. The stripes break where the water begins.",
    ),
    (
        "bubble",
        include_str!("../../examples/recipes/bubble.toml"),
        32,
        "A ball of glass with a bubble in it. The ball turns the stripes about, and the bubble turns them back.",
    ),
    (
        "sun",
        include_str!("../../examples/recipes/sun.toml"),
        32,
        "A sun of the right size and a blue sky. Edges of shadows are sharp near what casts them, and shadows are \
         blue, for only the sky lights them.",
    ),
    (
        "window",
        include_str!("../../examples/recipes/window.toml"),
        32,
        "A room that is lit by its window alone.",
    ),
    (
        "metals",
        include_str!("../../examples/recipes/metals.toml"),
        64,
        "From the left: silver, aluminium, gold, copper and iron, from smooth to rough.",
    ),
    (
        "bulb",
        include_str!("../../examples/recipes/bulb.toml"),
        32,
        "100 W of light from a ball of radius 0.1 m.",
    ),
];

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    let mut drawn = Drawn::default();
    for (name, text, spp, caption) in FILES {
        drawn.picture(desk, name, text, spp, caption)?;
    }
    stage::work(desk, &mut drawn)?;
    desk.value(
        "worst",
        "largest error of any of these pictures, %",
        drawn.worst,
    );
    desk.value("pictures", "pictures", f64::from(drawn.count));
    drawn.rays += window(desk)? + bulb(desk)?;
    Ok(Ledger {
        rays: drawn.rays,
        ..Ledger::of(
            "Each material, each light and each recipe has a picture that is made from the very file.",
        )
    })
}

/// What has been drawn so far.
#[derive(Debug, Default)]
struct Drawn {
    count: u32,
    rays: u64,
    /// The largest error of a picture, in per cent.
    worst: f64,
}

impl Drawn {
    /// Renders a scene file as a user would, and keeps its picture and its error.
    fn picture(
        &mut self,
        desk: &mut Desk,
        name: &str,
        text: &str,
        spp: u32,
        caption: &str,
    ) -> Result<(), DeskError> {
        let scene = scene(desk, name, text)?;
        let [width, height] = scene.size;
        let scene = scene.sized(desk.choose([width, height], [width / 6, height / 6]));
        let rendered = rendered(desk, name, &scene, spp)?;
        let error = percent(&rendered);
        desk.value(
            &format!("error_{name}"),
            &format!("{name}: error of the picture, %"),
            error,
        );
        desk.picture(&format!("{name}.png"), caption, &rendered.film, &scene)?;
        self.count += 1;
        self.rays += rendered.rays.total();
        self.worst = self.worst.max(error);
        Ok(())
    }
}

/// The scene of a text. What it names beside itself is put into the folder of the results first.
fn scene(desk: &Desk, name: &str, text: &str) -> Result<Scene, DeskError> {
    let folder = desk.options.out.join(CHAPTER.id);
    let dusk = folder.join("dusk.hdr");
    save(&dusk, include_bytes!("../../examples/recipes/dusk.hdr"))
        .map_err(|e| DeskError::File(dusk.display().to_string(), e))?;
    let source = Source { file: name, text };
    Ok(gallery::from_text(source, Some(&folder), |_| {})?)
}

fn rendered(desk: &Desk, name: &str, scene: &Scene, spp: u32) -> Result<Rendered, DeskError> {
    let options = Options {
        spp: desk.options.spp.unwrap_or(spp),
        seed: desk.options.seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let path = Path::new(scene.suggested.max_depth);
    let rendered = render(scene, &path, &options, &desk.bar(name));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}

/// The error of a picture in per cent, to two decimals.
fn percent(rendered: &Rendered) -> f64 {
    let error = Accuracy::of(&rendered.film).error(Measure::RootMeanSquare);
    (10_000.0 * error).round() / 100.0
}

/// What a light in the window gains over a sky beyond it.
fn window(desk: &mut Desk) -> Result<u64, DeskError> {
    desk.say("\na light in the window, or an open window");
    let text = include_str!("../../examples/recipes/window.toml");
    let (before, rest) = text.split_once("# ANCHOR: window").unwrap_or((text, ""));
    let after = rest
        .split_once("# ANCHOR_END: window")
        .map_or("", |(_, after)| after);
    let open = format!("{before}[environment]\nradiance = [6, 8, 11]\n{after}");
    let mut errors = [0.0; 2];
    let mut rays = 0;
    for (error, text) in errors.iter_mut().zip([text, &open]) {
        let scene = scene(desk, "window", text)?.sized(desk.choose([64, 48], [32, 24]));
        let rendered = rendered(desk, "window", &scene, 32)?;
        rays += rendered.rays.total();
        *error = percent(&rendered);
    }
    let [lamp, sky] = errors;
    desk.value("window_lamp", "error with a light in the window, %", lamp);
    desk.value("window_sky", "error with an open window, %", sky);
    desk.value(
        "window_gain",
        "the second over the first",
        (100.0 * sky / lamp).round() / 100.0,
    );
    Ok(rays)
}

/// The bulb's direct light on the floor below it: of its radiance, by area and distance, times the albedo.
fn bulb(desk: &mut Desk) -> Result<u64, DeskError> {
    let text = include_str!("../../examples/recipes/bulb.toml")
        .replace("from = [0.6, 1.9, 5.2]", "from = [0, 1, 0.7]")
        .replace("to = [0.15, 1.25, 0]", "to = [0, 0, 0]")
        .replace("fov = 34", "fov = 0.01")
        .replace("max_depth = 8", "max_depth = 2");
    let scene = scene(desk, "bulb", &text)?.sized([8, 8]);
    let rendered = rendered(desk, "bulb", &scene, 256)?;
    let green: Estimate = (rendered.film.pixels().iter())
        .filter_map(|pixel| pixel.mean())
        .map(|mean| mean[1])
        .collect();
    let exact = 0.55 * 253.3 * (0.1 / 2.0_f64).powi(2);
    let says = "radiance of the floor two metres below the bulb, green";
    let error = Some(green.std_error());
    desk.number(
        "bulb",
        Number {
            error,
            ..Number::new(says, green.mean()).exact(exact)
        },
    );
    Ok(rendered.rays.total())
}
