//! The row of pictures in the README: four scenes side by side.
//!
//! `cargo run --release --example picture_row`

#![allow(clippy::print_stdout)]

use halfdisk::integrators::Whitted;
use halfdisk::output::{self, Display, Provenance};
use halfdisk::render::{Film, Options, Pixel, render};
use halfdisk::scene::gallery;
use std::error::Error;
use std::path::Path;

const SIDE: u32 = 200;
const SCENES: [&str; 4] = ["whitted", "spheres", "caustic", "mesh"];

fn main() -> Result<(), Box<dyn Error>> {
    let options = Options {
        spp: 64,
        ..Options::default()
    };
    let mut films = Vec::new();
    for name in SCENES {
        let scene = gallery::load(name)?.sized([SIDE; 2]);
        let max_depth = scene.suggested.max_depth;
        films.push(render(&scene, &Whitted { max_depth }, &options, &()).film);
    }
    let width = SIDE * SCENES.len() as u32;
    let row: Vec<Pixel> = (0..SIDE)
        .flat_map(|y| {
            films
                .iter()
                .flat_map(move |f| (0..SIDE).map(move |x| *f.pixel(x, y)))
        })
        .collect();

    let mut facts = Provenance::new(&gallery::load("whitted")?, "whitted", 12, 64, options.seed);
    facts.scene = SCENES.join(", ");
    let path = Path::new("book/images/row.png");
    output::write(path, &Film::new(width, row), Display::Radiance, &facts)?;
    println!("wrote {}", path.display());
    Ok(())
}
