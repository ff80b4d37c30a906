//! Pictures side by side: of equal time, and of equal error.

use super::list::Priced;
use super::method::Method;
use super::runs::{Measured, Runs};
use super::size::Verdict;
use crate::render::accuracy::Scale;
use crate::render::{Film, Picture, Pixel, Progress};
use crate::scene::Scene;
use crate::stats::Estimate;

/// A picture, what it took and how wrong it is.
#[derive(Clone, Debug)]
pub struct Shown {
    /// Name of the method.
    pub name: &'static str,
    /// The picture.
    pub film: Film,
    /// Samples per pixel.
    pub spp: u32,
    /// Seconds of the pixel loop.
    pub seconds: f64,
    /// Rays.
    pub rays: u64,
    /// Root mean squared relative error.
    pub error: f64,
    /// The signed error as colours: see [`signed`].
    pub off: Film,
}

/// A picture by a method with so many samples per pixel; `None` where it was asked to stop.
pub fn show(
    scene: &Scene,
    measured: &Measured,
    method: &Method,
    spp: u32,
    seed: u64,
    progress: &impl Progress,
) -> Option<Shown> {
    let rendered = method.render(scene, spp, seed, progress).ok()?;
    if rendered.interrupted {
        return None;
    }
    let truth = measured.truth(method);
    let squares: Estimate = truth.squares(&rendered.film).into_iter().collect();
    Some(Shown {
        name: method.name,
        spp,
        seconds: rendered.time.as_secs_f64(),
        rays: rendered.rays.total(),
        error: squares.mean().max(0.0).sqrt(),
        off: signed(&rendered.film, &truth.picture),
        film: rendered.film,
    })
}

/// Samples per pixel that a method can take in so many seconds.
pub fn affordable(priced: &Priced, seconds: f64) -> u32 {
    (seconds / priced.seconds_per_spp).clamp(1.0, 65_536.0) as u32
}

/// Samples per pixel that a method needs for an error, by its largest pictures; `None` where it
/// levels out above it.
pub fn needed(priced: &Priced, runs: &Runs, error: f64) -> Option<u32> {
    let last = runs.study.sizes.len().checked_sub(1)?;
    let square = runs.study.at(last, |run| run.square).mean();
    let spp = f64::from(runs.largest());
    let stays = match priced.verdict {
        Verdict::Biased => priced.bias?.square.max(0.0),
        _ => 0.0,
    };
    let left = error * error - stays;
    let needed = spp * (square - stays).max(0.0) / left;
    (left > 0.0).then(|| libm::ceil(needed).clamp(1.0, 65_536.0) as u32)
}

/// What is too bright in red, what is too dark in blue; full colour at an error of one half of the
/// brightness around, white for none.
pub fn signed(film: &Film, truth: &Picture) -> Film {
    let scale = Scale::of(truth);
    let colour = |(i, (pixel, truth)): (usize, (&Pixel, &[f64; 3]))| {
        let mean = pixel.mean().unwrap_or([0.0; 3]);
        let off = scale.signed(i, (0..3).map(|c| mean[c] - truth[c]).sum::<f64>() / 3.0);
        let fade = 1.0 - (2.0 * off.abs()).min(1.0);
        let channels = match off > 0.0 {
            true => [1.0, fade, fade],
            false => [fade, fade, 1.0],
        };
        Pixel {
            channels: channels.map(|c| std::iter::once(c).collect()),
            ..Pixel::default()
        }
    };
    let pixels = film.pixels().iter().zip(&truth.values).enumerate();
    let pixels = pixels.map(colour).collect();
    Film::new(film.width(), pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn too_bright_is_red_and_too_dark_is_blue() {
        let grey = |x: f64| Pixel {
            channels: [std::iter::once(x).collect(); 3],
            ..Pixel::default()
        };
        let film = Film::new(3, vec![grey(1.0), grey(1.25), grey(0.1)]);
        let truth = Picture {
            size: [3, 1],
            values: vec![[1.0; 3]; 3],
            errors: None,
        };
        let map = signed(&film, &truth);
        let colours: Vec<[f64; 3]> = map.pixels().iter().filter_map(Pixel::mean).collect();
        assert_eq!(colours[0], [1.0; 3]);
        assert!(colours[1][0] == 1.0 && (colours[1][1] - 0.5).abs() < 0.05);
        assert_eq!(colours[2], [0.0, 0.0, 1.0]);
    }
}
