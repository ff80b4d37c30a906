//! The radius in pictures: the same photons on discs of three sizes.

use super::scene;
use halfdisk::integrators::Photons;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::render::{Film, Options, render};

/// First and only radii, in scene units; the caustic is about 0.3 wide.
const RADII: [f32; 3] = [0.004, 0.02, 0.1];

pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    desk.say("\nthe radius in pictures");
    let scene = scene("ball.toml", include_str!("ball.toml"))?;
    let scene = scene.sized(desk.choose([160; 2], [48; 2]));
    let mut films = Vec::new();
    let mut rays = 0;
    for radius in RADII {
        let photons = Photons {
            radius: Some(radius),
            alpha: 1.0,
            walks: Some(desk.choose(1 << 17, 1 << 14)),
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
        films.push(made.film);
    }
    let strip: Vec<&Film> = films.iter().collect();
    let [a, b, c] = RADII;
    let caption = format!(
        "A caustic by the same number of photons, on discs of radius {a}, {b} and {c}: noise, both, blur. Only the caustic \
         is blurred; the light around it comes straight from the lamp, and is found by shadow rays."
    );
    desk.picture("sweep.png", &caption, &Film::beside(&strip), &scene)?;
    Ok(rays)
}
