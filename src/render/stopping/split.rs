//! How much of the work starts at the lights, where some does.
//!
//! Of a picture that is the sum of paths from the eye and of paths from the lights, each sample has the variance
//! `V_e + V_l / m` and takes `C_e + m C_l` rays, with `m` paths from the lights. Their product is least at
//! `m² = (V_l / V_e) (C_e / C_l)`: the shares of the variance are then as the shares of the rays.
//!
//! Rays are counted, not seconds, so that the same scene and seed give the same split everywhere.

use crate::color::Rgb;
use crate::geometry::Ray;
use crate::integrators::{Integrator, Passes, Path, Splat};
use crate::render::accuracy::Scale;
use crate::render::{Film, Pixel, Recorder, Session};
use crate::sampling::stream::Stream;
use crate::scene::{Scene, Tracer};
use crate::stats::Estimate;

/// The pictures of the two parts.
const EYE: usize = 0;
const LIGHTS: usize = 1;

/// An integrator whose light from the eye and from the lights is recorded in a picture each.
pub(super) struct InParts<'a>(pub(super) &'a dyn Integrator);

impl Recorder for InParts<'_> {
    type Notes = ();

    fn pictures(&self) -> usize {
        2
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        self.0.passes(scene)
    }

    fn arrive(&self, light: Rgb, _: impl Iterator<Item = Splat>, parts: &mut [Rgb], _: &mut ()) {
        parts[LIGHTS] = light;
    }

    fn record(
        &self,
        tracer: &mut Tracer,
        ray: &Ray,
        stream: &Stream,
        parts: &mut [Rgb],
        _: &mut (),
    ) -> Rgb {
        parts[EYE] = self.0.li(tracer, ray, stream);
        parts[EYE]
    }
}

/// What is better than the number of paths from the lights that a pilot had.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Split {
    /// Paths from the lights in each sample of all pixels.
    pub light_paths: u32,
    /// The squared error of as many samples, in that of the pilot.
    pub square: f64,
    /// The rays of a sample, in those of the pilot.
    pub rays: f64,
}

/// The split goes by factors of two, for the least product is flat: half or twice the best number costs a ninth
/// more at most. And it goes no further than this factor, for what a pilot saw little of it knows little of.
const FARTHEST: i32 = 4;
/// A change that promises less than this share of the work is left.
const WORTH_IT: f64 = 0.05;

impl Split {
    /// The better split, from a pilot of so many paths from the lights; `None` where there is none.
    pub(super) fn better(session: &Session<InParts>, light_paths: u32) -> Option<Split> {
        let scale = Scale::of(&session.film().picture());
        let squares = [EYE, LIGHTS].map(|part| noise(&session.further(part), &scale));
        let lights = session.pass_rays().total() as f64;
        let rays = [session.rays().total() as f64 - lights, lights];
        Split::of(squares, rays, light_paths)
    }

    /// The same from the squared errors of both parts and their rays, from the eye first.
    fn of(squares: [f64; 2], rays: [f64; 2], light_paths: u32) -> Option<Split> {
        let best = (squares[LIGHTS] / squares[EYE] * rays[EYE] / rays[LIGHTS]).sqrt();
        if !best.is_normal() || light_paths == 0 {
            return None;
        }
        let doublings = (libm::log2(best).round() as i32).clamp(-FARTHEST, FARTHEST);
        let paths = (f64::from(light_paths) * 2_f64.powi(doublings)).round();
        let light_paths_then = paths.clamp(1.0, f64::from(Path::MOST_LIGHT_PATHS)) as u32;
        let factor = f64::from(light_paths_then) / f64::from(light_paths);
        let of = |[eye, lights]: [f64; 2], factor: f64| (eye + lights * factor) / (eye + lights);
        let split = Split {
            light_paths: light_paths_then,
            square: of(squares, 1.0 / factor),
            rays: of(rays, factor),
        };
        (split.square * split.rays < 1.0 - WORTH_IT).then_some(split)
    }
}

/// The mean over the pixels of a part's squared standard error, relative to the brightness of the whole picture.
fn noise(part: &Film, scale: &Scale) -> f64 {
    let square = |pixel: &Pixel| pixel.std_errors().iter().map(|e| e * e).sum::<f64>() / 3.0;
    let squares = part.pixels().iter().enumerate();
    squares
        .map(|(i, pixel)| scale.relative(i, square(pixel)))
        .collect::<Estimate>()
        .mean()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_better_split_has_the_least_squared_error_times_rays() {
        // By hand: 64 + 1/m and 1 + m are least together at m = 1/8: (64 + 8) 9/8 = 81 for 65 · 2 = 130.
        let split = Split::of([64.0, 1.0], [1.0, 1.0], 800).expect("better");
        assert_eq!(split.light_paths, 100);
        assert!((split.square * split.rays - 81.0 / 130.0).abs() < 1e-12);
        let other = Split::of([1.0, 64.0], [1.0, 1.0], 100).expect("better");
        assert_eq!(other.light_paths, 800);
        // No power of two on the way is better.
        for (squares, rays) in [
            ([5.0, 1.0], [7.0, 1.0]),
            ([1.0, 3.0], [1.0, 9.0]),
            ([1.0, 40.0], [30.0, 1.0]),
        ] {
            let product = |k: i32| {
                let m = 2_f64.powi(k);
                (squares[0] + squares[1] / m) * (rays[0] + rays[1] * m)
            };
            let least = (-FARTHEST..=FARTHEST)
                .map(product)
                .fold(f64::INFINITY, f64::min)
                / product(0);
            let found = Split::of(squares, rays, 1 << 10).map_or(1.0, |s| s.square * s.rays);
            assert!(
                found <= (1.0 + WORTH_IT) * least,
                "{squares:?} {rays:?}: {found} {least}"
            );
        }
    }

    #[test]
    fn what_a_pilot_did_not_see_changes_nothing() {
        assert_eq!(Split::of([1.0, 0.0], [1.0, 1.0], 100), None);
        assert_eq!(Split::of([0.0, 1.0], [1.0, 1.0], 100), None);
        assert_eq!(Split::of([f64::INFINITY, 1.0], [1.0, 1.0], 100), None);
        assert_eq!(Split::of([f64::NAN, 1.0], [1.0, 1.0], 100), None);
        assert_eq!(Split::of([64.0, 1.0], [1.0, 0.0], 100), None);
        assert_eq!(Split::of([1.0, 1.0], [1.0, 1.0], 100), None);
    }
}
