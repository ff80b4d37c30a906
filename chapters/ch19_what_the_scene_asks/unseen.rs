//! The point over the ball of glass in two pictures: as paths have it, and as photons do.

use crate::report::load;
use halfdisk::integrators::{Integrator, Path, Photons};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::render::{Options, render};

/// Paints them; the rays they took.
pub fn pictures(desk: &mut Desk) -> Result<u64, DeskError> {
    let scene = load(|_| {})?.sized(desk.choose([176; 2], [32; 2]));
    let depth = scene.suggested.max_depth;
    let photons = Photons {
        walks: Some(desk.choose(1 << 16, 1 << 12)),
        ..Photons::new(depth)
    };
    let methods: [(&str, &dyn Integrator, &str); 2] = [
        (
            "point_path.png",
            &Path::new(depth),
            "Path tracing: the spot on the floor is there, traced from the light. Look into the ball: where it shows the \
             floor, the spot is missing.",
        ),
        (
            "point_photons.png",
            &photons,
            "Photons: the same with all of its light. Look at the streak in the lower part of the ball, and at the arc \
             near its upper rim: both are images of the spot, a little blurred.",
        ),
    ];
    let mut rays = 0;
    for (file, method, caption) in methods {
        let options = Options {
            spp: desk.spp(16, 8),
            seed: desk.options.seed,
            ..Options::default()
        };
        let made = render(&scene, method, &options, &desk.bar(file));
        if made.interrupted {
            return Err(DeskError::Interrupted);
        }
        rays += made.rays.total();
        desk.picture(file, caption, &made.film, &scene)?;
    }
    Ok(rays)
}
