//! Chapter 1, exercise 2: the slit and the disc at twice the distance.
//!
//! The slit fills an angle, which falls with the distance; the disc fills a solid angle, which
//! falls with its square. So the counts fall to about a half and about a quarter.

#![allow(clippy::print_stdout)]

#[path = "../../chapters/ch01_from_the_eye/aperture.rs"]
mod aperture;

use aperture::{count_through_disc, count_through_slit, disc_chance, slit_chance};

const RAYS: u32 = 1_000_000;

fn main() {
    for (name, near, far) in [
        ("slit", slit(3.0), slit(6.0)),
        ("disc", disc(3.0), disc(6.0)),
    ] {
        let ((hits_near, chance_near), (hits_far, chance_far)) = (near, far);
        println!(
            "{name}: {hits_near:.0} rays, twice as far {hits_far:.0}: factor {:.4}, predicted {:.4}",
            hits_far / hits_near,
            chance_far / chance_near
        );
    }
}

/// Rays through a slit of width 0.4, and the chance of one.
fn slit(distance: f32) -> (f64, f64) {
    let hits = count_through_slit(0.4, distance, RAYS, 1).mean() * f64::from(RAYS);
    (hits, slit_chance(0.4, distance.into()))
}

/// Rays through a disc of radius 0.2, and the chance of one.
fn disc(distance: f32) -> (f64, f64) {
    let hits = count_through_disc(0.2, distance, RAYS, 1).mean() * f64::from(RAYS);
    (hits, disc_chance(0.2, distance.into()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slit_halves_and_the_disc_quarters() {
        for ((hits, chance), factor) in [(slit(6.0), 0.5), (disc(6.0), 0.25)] {
            let expected = chance * f64::from(RAYS);
            assert!(
                (hits - expected).abs() <= 4.0 * expected.sqrt(),
                "{hits} for {expected}"
            );
            let near = if factor == 0.5 {
                slit(3.0).1
            } else {
                disc(3.0).1
            };
            assert!((chance / near - factor).abs() < 0.01, "{}", chance / near);
        }
    }
}
