//! A room with every class of light.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "room.png",
        title: "Two walls between which every class of light has its place, by the path tracer. Look at the lamp in the \
                mirror ball (LS+E), at the block (LDE), at the bright spot below the glass (LS+DE), and at the \
                faint red on the left face of the block (LDDE).",
        spp: 32,
        stops: 0.3,
    };
    desk.finale_of("room.toml", include_str!("room.toml"), &finale)
}
