//! What a render leaves.

use super::{BadSample, Faults, Film, Pixel};
use crate::scene::RayCounts;
use crate::stats::{Estimate, Measurement};
use std::time::Duration;

/// A finished or interrupted render.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture.
    pub film: Film,
    /// Rays traced.
    pub rays: RayCounts,
    /// Those of them that passes prepared.
    pub pass_rays: RayCounts,
    /// Those of them that were traced before the render went on from a state: see
    /// [`Session::resume`](super::Session::resume).
    pub rays_before: RayCounts,
    /// The processor's instructions by which paths were taken sixteen at a time; `None` for one at a time.
    pub lanes: Option<&'static str>,
    /// Time spent in the pixel loop since then; zero where there is no clock.
    pub time: Duration,
    /// Samples that came out as NaN or infinity. They are in no mean, and never painted over.
    pub non_finite: u64,
    /// These and others that no light can have brought, by cause.
    pub faults: Faults,
    /// The first of them all in row order.
    pub first_bad: Option<BadSample>,
    /// The largest channel of a sample without fault.
    pub largest: f32,
    /// True where it was stopped before its last sample.
    pub interrupted: bool,
    /// The lamps that walks have met: see [`Tracer::lights_met`](crate::scene::Tracer::lights_met).
    pub lights_met: u64,
    /// The mean of the picture by each pass alone, where something was prepared for it and samples are
    /// independent; without values elsewhere.
    pub passes: Estimate,
}

impl Rendered {
    /// True where every pixel has samples, and all of them are black.
    pub fn is_black(&self) -> bool {
        let black = |p: &Pixel| p.mean() == Some([0.0; 3]);
        self.non_finite == 0 && self.film.pixels().iter().all(black)
    }

    /// The mean of the picture and its error: never less than [`rounding`] lets it be known, and infinite
    /// where no sample found any light.
    ///
    /// Where light of one path comes to many pixels, these are not independent, and the means of whole passes
    /// tell the error.
    pub fn mean(&self) -> (f64, f64) {
        let samples = self.film.pixels().iter().map(|pixel| pixel.count()).max();
        let of_passes = match &self.passes {
            // All passes are alike, though those of a render that went on are known only from there.
            passes if passes.count() >= 2 => {
                (passes.variance() / samples.unwrap_or(1) as f64).sqrt()
            }
            _ => 0.0,
        };
        let Measurement { value, error } = known_mean(&self.film, of_passes, &self.rays);
        (value, error)
    }
}

/// The mean of a film and its error, which is at least that by whole pictures, however independent its pixels seem, and that
/// of rounding; infinite where there is no light.
pub(crate) fn known_mean(film: &Film, of_pictures: f64, rays: &RayCounts) -> Measurement {
    let (mean, of_pixels) = film.mean();
    let least = match mean {
        0.0 => f64::INFINITY,
        _ => mean.abs() * rounding(rays),
    };
    (mean, of_pixels.max(of_pictures).max(least)).into()
}

/// The relative error below which the scatter of samples says nothing: each sample is a product and a
/// sum in `f32` along a path, rounded once for each segment, alike in all samples.
pub fn rounding(rays: &RayCounts) -> f64 {
    let segments = (rays.camera + rays.secondary) as f64 / rays.camera.max(1) as f64;
    0.5 * f64::from(f32::EPSILON) * segments
}
