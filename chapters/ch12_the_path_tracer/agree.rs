//! All walks so far, in one scene: the same mean, and what each pays for it.

use crate::SEGMENTS;
use crate::price::{Renders, renders};
use halfdisk::integrators::{Path, Settings, WALKS, Whitted};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::scene::gallery;

/// What the path tracer found in the scene.
pub struct Agreed {
    /// Rays of all walks.
    pub rays: u64,
    /// Variance of one of its samples.
    pub variance: f64,
    /// Rays of one of its samples.
    pub per_sample: f64,
}

/// The box with a mirror and a glass ball, by every walk that finds all of its light.
pub fn work(desk: &mut Desk) -> Result<Agreed, DeskError> {
    let side = desk.choose(24, 16);
    let scene = gallery::load("spheres")?.sized([side; 2]);
    let mut by_path = Renders::default();
    let mut rays = 0;
    // The last of the walks comes first: the others are compared with it.
    for entry in WALKS.into_iter().rev() {
        if entry.name == Whitted::ENTRY.name {
            continue;
        }
        let by = entry.prepare(&scene, &Settings::new(SEGMENTS))?;
        let is_path = entry.name == Path::ENTRY.name;
        // Independent of each other, and of the path tracer.
        let seed = 100 + WALKS.iter().position(|w| w.name == entry.name).unwrap_or(0) as u64;
        let found = renders(desk, &scene, &by, seed)?;
        rays += found.rays;
        if is_path {
            by_path = found.clone();
        }
        let key = entry.name.replace('-', "_");
        let (mean, error) = found.mean();
        let number = Number::new(&format!("spheres by {}: mean", entry.name), mean);
        let number = Number {
            error: Some(error),
            ..number
        };
        desk.number(&format!("spheres_{key}"), number);
        let [variance, per_sample] = found.of_one();
        for (what, says, value) in [
            ("variance", "  variance of a sample", variance),
            ("rays", "  rays of a sample", per_sample),
        ] {
            desk.value(&format!("spheres_{key}_{what}"), says, value);
        }
        if is_path {
            continue;
        }
        let (of_path, path_error) = by_path.mean();
        let z = (mean - of_path) / error.hypot(path_error);
        desk.value(
            &format!("spheres_{key}_z"),
            "  distance from path, standard errors",
            z,
        );
        if let Some((price, error)) = found.price(&by_path) {
            let number = Number::new("  variance times rays, over that of path", price);
            let error = Some(error);
            desk.number(&format!("spheres_{key}_price"), Number { error, ..number });
        }
    }
    let [variance, per_sample] = by_path.of_one();
    Ok(Agreed {
        rays,
        variance,
        per_sample,
    })
}
