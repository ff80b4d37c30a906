//! Three metal plates and one lamp.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "plates.png",
        title: "Three metal plates, each turned to mirror the lamp into the eye: polished, brushed and dull. By the \
                path tracer, which weighs both techniques. Look at the left plate, where chance finds the lamp, and \
                at the right one, where only aiming does.",
        spp: 32,
        stops: 0.0,
    };
    desk.finale_of("plates.toml", include_str!("plates.toml"), &finale)
}
