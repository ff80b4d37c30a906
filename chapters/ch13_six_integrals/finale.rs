//! All six integrals in one picture.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "row.png",
        title: "All six integrals at once, by the path tracer. Look at the edges (pixel), the shadows (lamp), the \
                ball in front that is out of focus (lens), the blue ball in flight (time), the reflections in the \
                brushed tray (gloss), and the shadows, which the sky and the floor keep from being black (hemisphere).",
        spp: 32,
        stops: -0.2,
    };
    desk.finale_of("row.toml", include_str!("row.toml"), &finale)
}
