//! A diffuse hall.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "hall.png",
        title: "A hall without a roof where all is diffuse, in the sun, by the path tracer. Its light is the same from every side, so patches \
                could hold it. Look at the shadows of the piers: patches would blur their edges.",
        spp: 32,
        stops: 0.0,
    };
    desk.finale_of("hall.toml", include_str!("hall.toml"), &finale)
}
