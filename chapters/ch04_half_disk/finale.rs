//! What the half disk sees, in space.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "penumbra.png",
        title: "Five slats at growing heights under a square lamp, by the path tracer. Look at the edges of their \
                shadows: a point of the floor sees all of the lamp, a part of it or none. The higher the slat, the \
                wider the band between.",
        spp: 32,
        stops: 0.0,
    };
    desk.finale_of("penumbra.toml", include_str!("penumbra.toml"), &finale)
}
