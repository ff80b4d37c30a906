//! A picture in a dozen lines: a scene of the gallery, an integrator, a file.
//!
//! `cargo run --release --example minimal`

#![allow(clippy::print_stdout)]

use halfdisk::integrators::Whitted;
use halfdisk::output::{self, Display, Provenance};
use halfdisk::render::{Options, render};
use halfdisk::scene::gallery;
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let scene = gallery::load("spheres")?;
    let options = Options {
        spp: 16,
        ..Options::default()
    };
    let picture = render(&scene, &Whitted { max_depth: 12 }, &options, &());

    let facts = Provenance::new(&scene, "whitted", 12, 16, options.seed);
    let path = Path::new("out/minimal.png");
    output::write(path, &picture.film, Display::Radiance, &facts)?;

    let (mean, error) = picture.film.mean();
    println!("{}: mean {mean:.5} ± {error:.5}", path.display());
    Ok(())
}
