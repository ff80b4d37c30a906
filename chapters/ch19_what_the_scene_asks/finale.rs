//! Two scenes that need nearly all that the book is about.

use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError, Finale};
use halfdisk::lab::effects::plan::plan;
use halfdisk::scene::gallery;

/// The plans of a courtyard and of the still life of chapter 12, and a picture of the first; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    for name in ["courtyard", "final"] {
        let plan = plan(&gallery::load(name)?);
        let asks = plan.lines.iter().filter(|line| line.simulated).count();
        let says = format!("effects that {name} asks for");
        desk.value(&format!("asks_of_{name}"), &says, asks as f64);
    }
    let scene = gallery::load("courtyard")?.sized([512, 256]);
    let finale = Finale {
        file: "courtyard.png",
        title: "A courtyard at noon. Look at the blue of the shadows, which only the sky lights; at the caustic behind the \
                ball of glass; at the tint of the tiles on the walls above them; and at the mirror ball, which shows what \
                lies behind you.",
        spp: 36,
        stops: 0.2,
    };
    let path = Path::new(scene.suggested.max_depth);
    Ok(desk.finale(&scene, &path, &finale)?.rays.total())
}
