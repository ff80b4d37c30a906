//! Roulette of the path tracer in a glowing room: its mean, its variance and its rays in closed form.

use crate::left_out::{LeftOut, PathWithout};
use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::estimators::walks;
use halfdisk::scene::description::Material;
use halfdisk::scene::value::Albedo;
use halfdisk::scene::{Scene, SceneError, gallery};
use halfdisk::stats::z_test::{FOUR, Largest, z_test};

/// So long that what it cuts off is below rounding.
const ENDLESS: u32 = 512;

fn room(albedo: f64) -> Result<Scene, SceneError> {
    gallery::load_with("furnace", |said| {
        for material in said.materials.values_mut() {
            *material = Material::Lambert {
                albedo: Albedo([albedo; 3]).into(),
            };
        }
    })
}

/// Radiance of a room whose walls emit 1 and reflect `rho`.
fn mean(rho: f64) -> f64 {
    1.0 / (1.0 - rho)
}

// ANCHOR: variance
/// Variance of a path that finds its light by chance there, and plays roulette after so many
/// surfaces.
///
/// Up to there all paths are alike. Then a path carries `s = ρ^bounces`, and survives with that
/// probability. From then on it carries 1, and survives each surface with the probability `ρ`.
/// (`s` is at least 0.05, the smallest probability that the path tracer allows.)
fn variance(rho: f64, bounces: i32) -> f64 {
    let s = rho.powi(bounces);
    (s * (1.0 + rho) - s * s) / (1.0 - rho).powi(2)
}
// ANCHOR_END: variance

/// Segments of such a path: one more than the surfaces it meets for sure, and those that it survives to.
fn segments(rho: f64, bounces: i32) -> f64 {
    f64::from(bounces) + rho.powi(bounces) / (1.0 - rho)
}

/// The path tracer by chance, and as it is; how far means are from the truth, and the rays.
pub fn work(desk: &mut Desk) -> Result<(Largest, u64), DeskError> {
    let (mut compared, mut rays) = (Largest::default(), 0);
    let count = desk.choose(24_000, 10_000);
    let bounces = Path::new(ENDLESS).roulette_from as i32;
    for percent in [60, 90] {
        let rho = f64::from(percent) / 100.0;
        let scene = room(rho)?;
        let ray = scene.camera.ray(0.3, 0.6);
        let truth = mean(rho);
        for (left_out, key, says) in [
            (LeftOut::Aiming, "chance", "by chance"),
            (LeftOut::Nothing, "path", "path"),
        ] {
            let by = PathWithout {
                max_depth: ENDLESS,
                left_out,
            };
            let seed = desk.options.seed;
            let found = walks::solid(&scene, &ray, &by, truth, count, seed);
            rays += found.rays;
            compared.add(z_test(&found.estimate, truth, FOUR).z);
            let says = format!("glowing room of albedo {rho}, {says}");
            let name = |what: &str| format!("furnace_{key}{what}_{percent}");
            desk.estimate(&name(""), &says, &found.estimate, Some(truth));
            let exact = (left_out == LeftOut::Aiming).then(|| variance(rho, bounces));
            desk.estimate(&name("_variance"), "  variance", &found.squares, exact);
            if left_out == LeftOut::Aiming {
                let exact = segments(rho, bounces);
                desk.known(&name("_rays"), "  rays", found.rays_each(), exact);
            } else {
                desk.value(&name("_rays"), "  rays", found.rays_each());
            }
        }
    }
    Ok((compared, rays))
}
