//! A window on the floor below a lamp of the flat world: the photons in it, and what it reads.

use halfdisk::flatland::FlatWorld;
use halfdisk::integrators::Photons;
use halfdisk::integrators::world::FlatTracer;
use halfdisk::photons::Photon;
use halfdisk::sampling::stream::Stream;
use halfdisk::space::Flat;
use std::f64::consts::PI;

/// A lamp at height 1 over a floor; its power is such that the floor below it gets 1 W/m.
pub const LAMP: &str = "name = 'lamp'\nwindow = { min = [-1.6, -0.25], max = [1.6, 1.2] }\n\
    [[objects]]\nalbedo = 0.5\nsegment = { from = [-4, 0], to = [4, 0] }\n\
    [[lamps]]\npoint = { position = [0, 1], power = 6.283185307179586 }\n";

/// The photons that so many walks leave where they land first.
pub fn first_photons(world: &FlatWorld, walks: u32, seed: u64, run: u32) -> Vec<Photon<Flat>> {
    let by = Photons::in_space::<Flat>(2);
    let mut tracer = FlatTracer::new(world);
    let mut found = Vec::new();
    for walk in 0..walks {
        let stream = Stream::new(seed, walk, run);
        by.trace(&mut tracer, 0.0, &stream, &mut |photon| found.push(photon));
    }
    found
}

// ANCHOR: parts
/// What a window of this radius reads in the mean at the foot of the lamp, where the truth is 1;
/// and the variance of it.
pub fn window(radius: f64, walks: u32) -> (f64, f64) {
    // The share of the lamp's light that falls into the window, times its power 2 π.
    let share = libm::atan(radius) / PI;
    let over = 2.0 * PI / (2.0 * radius);
    let variance = share * (1.0 - share) / f64::from(walks);
    (share * over, variance * over * over)
}
// ANCHOR_END: parts
