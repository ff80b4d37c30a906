//! Malley's method in space, as beads.

use glam::Vec3;
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::space::Solid;
use std::fmt::Write;

/// Directions, and the radius of a bead that marks one.
const BEADS: u32 = 225;
const RADIUS: f32 = 0.028;

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let mut text = include_str!("lifted.toml").to_owned();
    let mut numbers = Stream::new(desk.options.seed, 7, 0).at(0, Purpose::Direction);
    for i in 0..BEADS {
        let w = Recipe::StratifiedCosine
            .draw::<Solid>(i, BEADS, &mut numbers)
            .w;
        // The normal is z there, and y in a scene.
        let lifted = Vec3::new(w.x, w.z, -w.y);
        let foot = Vec3::new(w.x, 0.4 * RADIUS, -w.y);
        for (material, at) in [("foot", foot), ("bead", lifted)] {
            let [x, y, z] = at.to_array();
            // Writing to a string cannot fail.
            let _ = write!(
                text,
                "\n[[objects]]\nmaterial = \"{material}\"\nsphere = {{ center = [{x}, {y}, {z}], radius = {RADIUS} }}\n"
            );
        }
    }
    let finale = Finale {
        file: "lifted.png",
        title: "Malley's method in space, by the path tracer of chapter 12: even points of a disc (blue), lifted to the half ball \
                above it (red). Look at the half ball: the beads are dense at its top and sparse at its rim, as the cosine asks.",
        spp: 32,
        stops: 0.2,
    };
    desk.finale_of("lifted.toml", &text, &finale)
}
