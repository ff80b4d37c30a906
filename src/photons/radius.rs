//! How large the discs are over which photons are counted, and how fast they shrink.

use crate::scene::{RayCounts, Scene, Tracer};

/// The radius of the first pass, in pixels as they see the scene.
const PIXELS: f64 = 2.0;

/// The largest first radius, as a share of the radius of the ball around the scene.
const OF_THE_SCENE: f64 = 0.125;

/// Rays along each side of the picture that look how far away the scene is.
const LOOKS: u8 = 8;

/// The share of photons that are gained from pass to pass, in `(0, 1)`, for which the mean squared error on
/// surfaces falls fastest, with the power -2/3 of the number of passes.
///
/// Source: Kaplanyan, Dachsbacher, Adaptive Progressive Photon Mapping (TOG 32(2), 2013).
pub const FASTEST: f64 = 2.0 / 3.0;

/// The radius of pass `sample`, the first of which is 0, in radii of the first: the square root of the
/// product of `(k + alpha) / (k + 1)` for `k` up to `sample`, about `(sample + 1)^((alpha - 1) / 2)`.
///
/// Passes are independent of each other, and the noise of one grows as its disc shrinks; of their mean
/// both fall, noise and blur, where `alpha` is in `(0, 1)`. At 1 radii stay, and so does the blur.
///
/// Source: Knaus, Zwicker, Progressive Photon Mapping: A Probabilistic Approach (TOG 30(3), 2011),
/// equation 21.
pub fn shrunk(alpha: f64, sample: u32) -> f64 {
    let factor = |k: u32| (f64::from(k) + alpha) / (f64::from(k) + 1.0);
    (1..=sample).map(factor).product::<f64>().sqrt()
}

/// The radius of the first pass by `walks` photon paths, in scene units, and the rays that looked for it.
///
/// Two pixels wide on the surface that the eye sees: at the middle of the distances to what a few rays
/// through the picture meet. With fewer paths than pixels it is larger, so that as many photons fall on a disc. At
/// most an eighth of the radius of the ball around the scene, also where these rays meet nothing; 0 where
/// that ball is empty or has no bounds.
pub fn first(scene: &Scene, walks: u32) -> (f32, RayCounts) {
    let mut tracer = Tracer::new(scene);
    let middle = |i: u8| (f32::from(i) + 0.5) / f32::from(LOOKS);
    let places = (0..LOOKS).flat_map(|i| (0..LOOKS).map(move |j| [middle(i), middle(j)]));
    let mut distances: Vec<f32> = places
        // Of no sample: rays that are counted as the camera's are one for each sample.
        .filter_map(|[s, t]| tracer.secondary_ray(&scene.camera.ray(s, t)))
        .map(|hit| hit.t)
        .collect();
    distances.sort_by(f32::total_cmp);
    let most = OF_THE_SCENE * f64::from(scene.emission_choice.around().radius);
    let pixel = (f64::from(scene.camera.film_area()) / f64::from(walks.max(1))).sqrt();
    let seen = distances.get(distances.len() / 2);
    let radius = seen.map_or(most, |&t| (PIXELS * pixel * f64::from(t)).min(most));
    (radius as f32, tracer.counts())
}
