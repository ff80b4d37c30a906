//! The radius in pictures: the same photons on discs of three sizes.

use super::scene;
use halfdisk::integrators::Photons;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::render::{Options, render};

/// First and only radii, in scene units, and what to look at; the caustic is about 0.3 wide.
const RADII: [(f32, &str, &str); 3] = [
    (
        0.004,
        "small",
        "few photons on each. Look at the specks in the spot: they are noise.",
    ),
    (
        0.02,
        "middle",
        "the grain is coarser and fainter, and the rim a little soft.",
    ),
    (
        0.1,
        "large",
        "no specks, but the rim of the spot is as wide as a disc. More photons would not sharpen it.",
    ),
];

pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    desk.say("\nthe radius in pictures");
    let scene = scene("ball.toml", include_str!("ball.toml"))?;
    let scene = scene.sized(desk.choose([128; 2], [48; 2]));
    let mut rays = 0;
    for (radius, name, look) in RADII {
        let photons = Photons {
            radius: Some(radius),
            alpha: 1.0,
            walks: Some(desk.choose(1 << 16, 1 << 14)),
            ..Photons::new(scene.suggested.max_depth)
        };
        let options = Options {
            spp: desk.spp(8, 4),
            seed: desk.options.seed,
            ..Options::default()
        };
        let made = render(&scene, &photons, &options, &desk.bar("sweep"));
        rays += made.rays.total();
        if made.interrupted {
            return Err(DeskError::Interrupted);
        }
        let caption = format!("Discs of radius {radius}: {look}");
        desk.picture(&format!("sweep_{name}.png"), &caption, &made.film, &scene)?;
    }
    Ok(rays)
}
