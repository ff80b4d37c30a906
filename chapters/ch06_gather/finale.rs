//! Walls that lend their colour.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "bleeding.png",
        title: "White bodies between coloured screens, by the path tracer. Look at the shaded sides: the ball on the \
                left is red where it faces the red screen, the one in the middle is yellow from below, and the block \
                on the right has a blue side.",
        spp: 32,
        stops: 0.3,
    };
    desk.finale_of("bleeding.toml", include_str!("bleeding.toml"), &finale)
}
