//! How large the discs are over which photons are counted, and how fast they shrink.

use crate::scene::{RayCounts, Scene, Tracer};
use crate::space::Space;

/// The radius of the first pass, in pixels as they see the scene.
const PIXELS: f64 = 2.0;

/// The largest first radius, as a share of the radius of the ball around the scene.
const OF_THE_SCENE: f64 = 0.125;

/// Rays along each side of the picture that look how far away the scene is.
const LOOKS: u8 = 8;

/// The share of photons that are gained from pass to pass, in `(0, 1)`, for which the mean squared error falls
/// fastest, with the power `-4 / (d + 4)` of the number of passes where surfaces have `d` dimensions: 2/3
/// in space, 4/5 in the flat world.
///
/// Source: Kaplanyan, Dachsbacher, Adaptive Progressive Photon Mapping (TOG 32(2), 2013), for space. In the
/// flat world the measure of a disc is proportional to its radius: the blur is of the order of `N^(2 alpha - 2)`
/// after `N` passes and the noise of `N^(-alpha / 2)`, which fall alike at 4/5.
pub const fn fastest<S: Space>() -> f64 {
    4.0 / (4.0 + S::FALL_OFF as f64)
}

/// The radius of pass `sample`, the first of which is 0, in radii of the first: discs shrink by the product of
/// `(k + alpha) / (k + 1)` for `k` up to `sample`, about `(sample + 1)^(alpha - 1)`.
///
/// Passes are independent of each other, and the noise of one grows as its disc shrinks; of their mean
/// both fall, noise and blur, where `alpha` is in `(0, 1)`. At 1 radii stay, and so does the blur.
///
/// Source: Knaus, Zwicker, Progressive Photon Mapping: A Probabilistic Approach (TOG 30(3), 2011),
/// equation 21.
pub fn shrunk<S: Space>(alpha: f64, sample: u32) -> f64 {
    let factor = |k: u32| (f64::from(k) + alpha) / (f64::from(k) + 1.0);
    let disc = (1..=sample).map(factor).product::<f64>();
    match S::FALL_OFF {
        1 => disc,
        _ => disc.sqrt(),
    }
}

/// The radius at which one pass is as blurred as the mean of the first `passes`, in radii of the first: the
/// root of their mean square, for blur is proportional to the squared radius. 1 for no pass.
pub fn mean<S: Space>(alpha: f64, passes: u32) -> f64 {
    let mut disc = 1.0;
    let mut sum = 0.0;
    for k in 0..passes.max(1) {
        if k > 0 {
            disc *= (f64::from(k) + alpha) / (f64::from(k) + 1.0);
        }
        sum += match S::FALL_OFF {
            1 => disc * disc,
            _ => disc,
        };
    }
    (sum / f64::from(passes.max(1))).sqrt()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::{Flat, Solid};

    #[test]
    fn radii_shrink_as_the_theory_says() {
        assert_eq!([fastest::<Flat>(), fastest::<Solid>()], [0.8, 2.0 / 3.0]);
        assert_eq!(
            [shrunk::<Solid>(0.5, 0), shrunk::<Solid>(1.0, 99)],
            [1.0; 2]
        );
        // As the powers -1/5 and -1/6 of the number of passes.
        let halved = |shrunk: fn(f64, u32) -> f64, alpha, times: u32| {
            let ratio = shrunk(alpha, times * 1000 - 1) / shrunk(alpha, 999);
            assert!((ratio - 0.5).abs() < 1e-4, "{ratio}");
        };
        halved(shrunk::<Flat>, fastest::<Flat>(), 32);
        halved(shrunk::<Solid>, fastest::<Solid>(), 64);
        let squares = |k: u32| shrunk::<Flat>(0.8, k).powi(2);
        let ours = mean::<Flat>(0.8, 50);
        let plain = ((0..50).map(squares).sum::<f64>() / 50.0).sqrt();
        assert!((ours - plain).abs() < 1e-12, "{ours} {plain}");
        assert_eq!([mean::<Solid>(1.0, 9), mean::<Solid>(0.5, 0)], [1.0; 2]);
    }
}
