//! Caustics of a point, traced from there.

use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;

/// Glass and a mirror on a table in the evening; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let finale = Finale {
        file: "evening.png",
        title: "Caustics of one lamp without extent, by path tracing with paths from the lamp: a bright spot behind each ball \
                of glass, and the light that the mirror throws on the table. Look into the mirror and through the glass: \
                there the spots are missing, and only photons would show them.",
        spp: 32,
        stops: 0.5,
    };
    let (file, text) = ("evening.toml", include_str!("evening.toml"));
    let scene = gallery::from_text(Source { file, text }, None, |_| {})?;
    let path = Path::new(scene.suggested.max_depth);
    // Most of what is to be seen comes from the lamp.
    let more = path.with(2 * path.light_paths_of(&scene));
    Ok(desk.finale(&scene, &more, &finale)?.rays.total())
}
