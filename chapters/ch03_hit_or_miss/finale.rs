//! The darts of the drawing, as beads on a board.

use super::figures::THROWN;
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::lab::estimators::hit_or_miss;
use std::fmt::Write;

/// Edge of the board, and radius of a bead, in scene units.
const BOARD: f64 = 2.0;
const RADIUS: f64 = 0.026;

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let mut text = include_str!("beads.toml").to_owned();
    for ([x, y], score) in hit_or_miss::thrown(THROWN, desk.options.seed) {
        let material = if score > 0.0 { "hit" } else { "miss" };
        let [x, z] = [BOARD * x, BOARD * (1.0 - y)];
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "\n[[objects]]\nmaterial = \"{material}\"\nsphere = {{ center = [{x}, {RADIUS}, {z}], radius = {RADIUS} }}\n"
        );
    }
    let finale = Finale {
        file: "beads.png",
        title: "The darts of the drawing as beads on a board, by the path tracer of chapter 12. Each sample of a pixel is a dart, \
                too: the picture is the mean of many, and its error falls like that of pi. Look at the shadows of the beads, where \
                a sample sees the lamp or not, like a dart that hits or misses.",
        spp: 32,
        stops: 0.7,
    };
    desk.finale_of("beads.toml", &text, &finale)
}
