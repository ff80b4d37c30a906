//! Light that has bounced many times.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "steps.png",
        title: "White steps in the sun by the path tracer, with roulette from the fifth segment on. Look at the sides \
                that the sun does not reach: the steps below them send up light that has bounced, and a depth cut would \
                darken them.",
        spp: 32,
        stops: 0.0,
    };
    desk.finale_of("steps.toml", include_str!("steps.toml"), &finale)
}
