//! A picture with a known price.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "pyramid.png",
        title: "Thirty balls in a pyramid, by the path tracer. Look into the gaps between the balls: they need the most samples, \
                for most of their light has bounced.",
        spp: 32,
        stops: 0.5,
    };
    desk.finale_of("pyramid.toml", include_str!("pyramid.toml"), &finale)
}
