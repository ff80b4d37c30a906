//! Chapter 13, exercise 3: a seventh integral, the wavelength, for no ray more.
//!
//! A slab of glass shifts a slanted ray to the side, blue light further than red. A sample draws its
//! wavelength as it draws its moment, and an edge seen through the slab becomes a small spectrum: a
//! ramp whose form is known, for the shift can be solved for the wavelength.

#![allow(clippy::print_stdout)]

use glam::DVec2;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::Estimate;

/// Thickness of the slab, and the angle of the ray in radians.
const SLAB: (f64, f64) = (1.0, 1.0);
/// The wavelengths of the film, in µm; each counts alike.
const FILM: (f64, f64) = (0.4, 0.7);
const PLACES: u32 = 40;
const SAMPLES: u32 = 20_000;

/// Cauchy's index of refraction, `A + B / λ²`, of a heavy flint glass.
fn index(wavelength: f64) -> f64 {
    1.7 + 0.015 / (wavelength * wavelength)
}

/// The direction after an interface that lies across y, by Snell's law.
fn refract(direction: DVec2, ratio: f64) -> DVec2 {
    let x = direction.x * ratio;
    DVec2::new(x, -(1.0 - x * x).sqrt())
}

/// Follows a ray through the slab; how far to the side it leaves, across itself.
fn shift(wavelength: f64) -> f64 {
    let (thickness, angle) = SLAB;
    let (sin, cos) = libm::sincos(angle);
    let outside = DVec2::new(sin, -cos);
    let inside = refract(outside, 1.0 / index(wavelength));
    let leaves = inside * (thickness / -inside.y);
    // The distance of that point from the line the ray would have kept.
    outside.perp_dot(leaves).abs()
}

/// The share of the wavelengths whose shift is at most `x`: the shift, solved for the wavelength.
fn exact(x: f64) -> f64 {
    let (thickness, angle) = SLAB;
    let (sin, cos) = libm::sincos(angle);
    let inner = cos / (1.0 - x / (thickness * sin));
    let index = (sin * sin + inner * inner).sqrt();
    let wavelength = (0.015 / (index - 1.7)).sqrt();
    ((FILM.1 - wavelength) / (FILM.1 - FILM.0)).clamp(0.0, 1.0)
}

/// The edge as the pixel at `x` sees it, where samples draw wavelengths from `film`.
fn read(x: f64, pixel: u32, film: (f64, f64)) -> Estimate {
    let one = |i| {
        let u = Stream::new(8, pixel, i).at(0, Purpose::Integrand).one();
        let wavelength = film.0 + f64::from(u) * (film.1 - film.0);
        f64::from(u8::from(shift(wavelength) <= x))
    };
    (0..SAMPLES).map(one).collect()
}

/// The places of the pixels: from red to blue.
fn places() -> impl Iterator<Item = (u32, f64)> {
    let (red, blue) = (shift(FILM.1), shift(FILM.0));
    (1..PLACES).map(move |i| (i, red + (blue - red) * f64::from(i) / f64::from(PLACES)))
}

/// The largest distance of the profile from its closed form, in standard errors of that.
fn worst(film: (f64, f64)) -> f64 {
    let z = places().map(|(i, x)| {
        let truth = exact(x);
        let error = (truth * (1.0 - truth) / f64::from(SAMPLES)).sqrt();
        (read(x, i, film).mean() - truth).abs() / error
    });
    z.fold(0.0, f64::max)
}

fn main() {
    for (i, x) in places().step_by(4) {
        let read = read(x, i, FILM);
        println!(
            "{x:.5}: {:.4} ± {:.4}, exact {:.4}",
            read.mean(),
            read.std_error(),
            exact(x)
        );
    }
    println!("largest distance: {:.2} standard errors", worst(FILM));
    println!("with a film from 0.42 µm: {:.2}", worst((0.42, 0.7)));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spectrum_of_an_edge_is_the_closed_form() {
        assert!(worst(FILM) <= 4.0, "{}", worst(FILM));
    }

    #[test]
    fn another_film_is_noticed() {
        assert!(worst((0.42, 0.7)) > 6.0);
        assert!(worst((0.4, 0.69)) > 6.0);
    }

    #[test]
    fn the_shift_is_that_of_the_text_book() {
        let (thickness, angle) = SLAB;
        let (sin, cos) = libm::sincos(angle);
        for wavelength in [0.4, 0.5, 0.6, 0.7] {
            let n = index(wavelength);
            let text_book = thickness * sin * (1.0 - cos / (n * n - sin * sin).sqrt());
            assert!((shift(wavelength) - text_book).abs() < 1e-12);
        }
        assert_eq!((exact(shift(0.8)), exact(shift(0.3))), (0.0, 1.0));
    }
}
