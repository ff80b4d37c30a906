//! Caustics of a point, traced from there.

use super::scene;
use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::sampling::stream::Sampler;

/// Glass and a mirror on a table in the evening; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let scene = scene("evening.toml", include_str!("evening.toml"))?;
    let finale = Finale {
        file: "evening.png",
        title: "Caustics of one lamp without extent, by path tracing with paths from the lamp: a bright spot behind each ball \
                of glass, and the light that the mirror throws on the table. Look into the mirror and through the glass: \
                there the spots are missing, and only photons would show them.",
        spp: 16,
        sampler: Sampler::Sobol,
        stops: 0.7,
    };
    let path = Path::new(scene.suggested.max_depth);
    Ok(desk.finale(&scene, &path, &finale)?.rays.total())
}
