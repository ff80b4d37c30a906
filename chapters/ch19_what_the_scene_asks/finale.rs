//! Two scenes that need nearly all that the book is about.

use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::lab::effects::plan::plan;
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::gallery;

/// A still life indoors, and a courtyard outdoors: their plans, and pictures of both; the rays that took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let mut rays = 0;
    for (name, file, spp, stops, title) in [
        (
            "courtyard",
            "courtyard.png",
            32,
            0.2,
            "A courtyard at noon. Look at the blue of the shadows, which only the sky lights; at the tint of the tiles on \
             the walls above them; and at the mirror ball, which shows what lies behind you.",
        ),
        (
            "final",
            "final.png",
            16,
            0.2,
            "A still life. The sun falls through one window and the sky through another. Look at the caustic of the glass \
             ball on the cloth, at the window in the gold, at the red that the wall lends the books, and at the chess \
             board upside down in the glass.",
        ),
    ] {
        let scene = gallery::load(name)?;
        let asks = plan(&scene).lines.iter().filter(|l| l.simulated).count();
        let says = format!("effects that {name} asks for");
        desk.value(&format!("asks_of_{name}"), &says, asks as f64);
        let finale = Finale {
            file,
            title,
            spp,
            sampler: Sampler::Sobol,
            stops,
        };
        let path = Path::new(scene.suggested.max_depth);
        rays += desk.finale(&scene, &path, &finale)?.rays.total();
    }
    Ok(rays)
}
