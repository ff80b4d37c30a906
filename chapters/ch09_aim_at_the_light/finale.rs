//! One small lamp.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "lantern.png",
        title: "One lamp of four centimetres in a ring of posts, by the path tracer. Look at the shadows: their \
                edges are sharp, for the lamp is small. Of the walks by chance next to none would find it.",
        spp: 32,
        stops: 0.6,
    };
    desk.finale_of("lantern.toml", include_str!("lantern.toml"), &finale)
}
