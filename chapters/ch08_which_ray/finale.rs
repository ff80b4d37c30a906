//! Mixtures of three materials.

use halfdisk::lab::chapter::{Desk, DeskError, Finale};

/// Renders the chapter's last picture; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "shares.png",
        title: "Five balls, from the left: diffuse; a quarter mirror; all mirror; a mixture of all three; and glass. \
                By the path tracer, which chooses one ray at each surface. Look at the bright spots on the table: \
                glass focuses the light of the sun.",
        spp: 32,
        stops: 0.2,
    };
    desk.finale_of("shares.toml", include_str!("shares.toml"), &finale)
}
