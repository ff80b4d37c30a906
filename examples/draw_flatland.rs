//! Draws a flat world, and what its probe sees: a world of the gallery, or a file of your own.
//!
//! `cargo run --release --example draw_flatland -- yard`
//! `cargo run --release --example draw_flatland -- mine.toml`

#![allow(clippy::print_stdout)]

use halfdisk::flatland::{frame, load};
use halfdisk::lab::figures::flat;
use halfdisk::sampling::half_disk;
use halfdisk::sampling::stream::{Purpose, Stream};
use std::error::Error;

const RAYS: u32 = 160;

fn main() -> Result<(), Box<dyn Error>> {
    let name = std::env::args().nth(1).unwrap_or_else(|| "yard".to_owned());
    let world = load(&name)?;
    let drawing = match &world.probe {
        None => flat::world(&world),
        Some(probe) => {
            let turn = frame(probe.surface.n);
            let direction = |i| {
                let u = Stream::new(1, i, 0).at(0, Purpose::Direction).one();
                turn * half_disk::sample_uniform(u)
            };
            let directions: Vec<_> = (0..RAYS).map(direction).collect();
            flat::half_disk(&world, &probe.surface, &directions)
        }
    };
    std::fs::create_dir_all("out")?;
    let path = "out/flatland.svg";
    std::fs::write(path, drawing.to_svg()?)?;
    println!("{}: wrote {path}", world.name);
    Ok(())
}
