//! Fourteen balls that touch.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "balls.png",
        title: "Fourteen balls in a row, each half as wide as the one before; the last one is 0.24 mm wide where the \
                first is two metres. By the path tracer. Look where they touch: all touch each other and the floor, and no shadow has a gap \
                or a stain.",
        spp: 32,
        stops: 0.5,
    };
    desk.finale_of("balls.toml", include_str!("balls.toml"), &finale)
}
