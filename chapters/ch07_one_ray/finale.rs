//! Paths of up to eight segments.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "house.png",
        title: "A doll's house in the sun, by paths of up to eight segments. Look at the white things: each has \
                the colour of its room. Trees of sixteen rays would need 16⁷ rays for each sample of it.",
        spp: 32,
        stops: 0.0,
    };
    desk.finale_of("house.toml", include_str!("house.toml"), &finale)
}
