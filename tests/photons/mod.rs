//! What photons show is the light, blurred as much as they say.
//!
//! | What | Test | Figure seen |
//! |---|---|---|
//! | The map against a loop | `map::*` | the same photons, 1e-3 to 1e6 |
//! | Power | `power::*`, `flat::*` | closed rooms: `Φ ρ^k` after each bounce |
//! | A lamp in a plane mirror | `mirrored::*` | its image, blurred as the radius says |
//! | Edges, corners | `density::*` | 1/2 and 1/4; 1 by the part on the surface |
//! | The k nearest | `density::*` | `k / (k - 1)` where `k` are counted |
//! | Focus and caustics | `optics::*` | ellipses, aplanatic point, slab, nephroid |
//! | Rates | `rates::*` | -1/3 on surfaces, -2/5 on lines; a fixed radius levels out |
//! | Odd input | `input::*` | |

mod density;
mod flat;
mod input;
mod map;
mod mirrored;
mod optics;
mod pictures;
mod power;
mod rates;

use halfdisk::integrators::{Integrator, Photons};
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Purpose;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::Estimate;

pub fn scene(text: &str) -> Scene {
    let text = format!("name = 'test'\nfilm.size = [8, 8]\n{text}");
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

pub fn rendered(scene: &Scene, integrator: &dyn Integrator, spp: u32, seed: u64) -> Rendered {
    let options = Options {
        spp,
        seed,
        // Looks at the middle of each pixel.
        fixed: &[Purpose::Pixel],
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &());
    assert_eq!(rendered.faults, Default::default(), "{}", scene.name);
    rendered
}

/// Photons whose discs stay as they are.
pub fn fixed(max_depth: u32, radius: f32, walks: u32) -> Photons {
    Photons {
        radius: Some(radius),
        alpha: 1.0,
        walks: Some(walks),
        ..Photons::new(max_depth)
    }
}

/// The mean of pictures with maps of their own, and its error: pixels of one map are no independent
/// numbers, so it is from the means of whole pictures.
pub fn mean(scene: &Scene, integrator: &Photons, spp: u32, seeds: u64) -> (f64, f64) {
    let one = |seed| rendered(scene, integrator, spp, seed).film.mean().0;
    let means: Estimate = (0..seeds).map(one).collect();
    (means.mean(), means.std_error())
}
