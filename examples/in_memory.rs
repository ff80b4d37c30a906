//! A scene told in code, and its picture in memory: no file, no thread and no clock is needed, so it runs
//! on the web, too.
//!
//! `cargo run --release --example in_memory` writes `out/in_memory.png`.

#![allow(clippy::print_stdout)]

// ANCHOR: in_memory
use halfdisk::integrators::Path;
use halfdisk::output::{Display, Provenance, png_bytes};
use halfdisk::render::{Options, render};
use halfdisk::scene::Scene;
use halfdisk::scene::build::build;
use halfdisk::scene::description::{Camera, Description, Film, Material, Object};
use halfdisk::scene::value::{Radiance, Triple};
use std::error::Error;

/// A grey ball under a white sky. What is not said has a default.
fn ball(side: u32) -> Result<Scene, Box<dyn Error>> {
    let description = Description {
        name: "ball".to_owned(),
        background: Some(Radiance([1.0; 3])),
        camera: Camera {
            from: Triple([0.0, 0.0, 4.0]),
            to: Triple::default(),
            ..Camera::default()
        },
        film: Film {
            size: [side.into(); 2],
        },
        materials: [("grey".to_owned(), Material::default())].into(),
        objects: vec![Object {
            material: Some("grey".to_owned()),
            ..Object::default()
        }],
        ..Description::default()
    };
    Ok(build(description, None)?)
}

/// Its picture, as the bytes of a PNG file.
pub fn picture(side: u32, spp: u32) -> Result<Vec<u8>, Box<dyn Error>> {
    let scene = ball(side)?;
    let (path, options) = (
        Path::new(8),
        Options {
            spp,
            ..Options::default()
        },
    );
    let rendered = render(&scene, &path, &options, &());
    let facts = Provenance::new(&scene, "path", 8, spp.into(), options.seed);
    Ok(png_bytes(&rendered.film, Display::Radiance, &facts)?)
}
// ANCHOR_END: in_memory

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::path::Path::new("out/in_memory.png");
    halfdisk::output::save(path, &picture(256, 16)?)?;
    println!("wrote {}", path.display());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_the_bytes_of_a_png() {
        let bytes = picture(16, 2).unwrap();
        assert!(bytes.starts_with(b"\x89PNG\r\n\x1a\n"));
    }

    #[test]
    fn the_ball_reflects_half_of_a_sky_of_radiance_one() {
        let scene = ball(9).unwrap();
        let film = render(&scene, &Path::new(8), &Options::default(), &()).film;
        let pixel = |x: usize, y: usize| film.pixels()[9 * y + x].mean().unwrap();
        // Every direction above a convex ball is sky, so each sample is exact but for rounding.
        for channel in pixel(4, 4) {
            assert!((channel - 0.5).abs() < 1e-6, "{channel}");
        }
        assert_eq!(pixel(0, 0), [1.0; 3]);
    }
}
