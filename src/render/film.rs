//! What the samples add up to.

use super::{Picture, Shard};
use crate::color::Rgb;
use crate::stats::Estimate;
use std::ops::Range;

/// A pixel: an estimate for each channel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pixel {
    /// Red, green, blue.
    pub channels: [Estimate; 3],
    /// Of samples that lie evenly: the means of equally long runs that are independent of each other.
    /// Without samples where each sample is independent.
    pub runs: [Estimate; 3],
    /// How many samples those runs have together.
    pub in_runs: u64,
    /// How many samples were taken, with those that were not finite.
    pub taken: u32,
}

impl Pixel {
    /// Adds a finite sample.
    pub fn add(&mut self, sample: Rgb) {
        debug_assert!(sample.is_finite(), "{sample:?}");
        for (estimate, x) in self.channels.iter_mut().zip(sample.channels()) {
            estimate.add(f64::from(x));
        }
    }

    /// Ends a run of even samples, of what was added since the last one. Where it is as long as all
    /// before it (`doubles`), what came before counts as one run, so that all have the same length.
    pub fn end_run(&mut self, doubles: bool) {
        let (n, before) = (self.count(), self.in_runs);
        if n == before {
            return;
        }
        self.in_runs = n;
        for (runs, all) in self.runs.iter_mut().zip(&self.channels) {
            let start = runs.mean();
            if doubles && before > 0 {
                *runs = Estimate::new();
                runs.add(start);
            }
            // The mean since then; a constant leaves no rounding error.
            runs.add(all.mean() + (all.mean() - start) * before as f64 / (n - before) as f64);
        }
    }

    // ANCHOR: merge
    /// Adds the samples of another picture of the same pixel, independent of these.
    pub(super) fn merge(&mut self, other: &Pixel) {
        for (own, its) in [
            (&mut self.channels, &other.channels),
            (&mut self.runs, &other.runs),
        ] {
            own.iter_mut().zip(its).for_each(|(a, b)| *a = a.merge(b));
        }
        self.in_runs += other.in_runs;
        self.taken = self.taken.saturating_add(other.taken);
    }
    // ANCHOR_END: merge

    /// How many samples were added.
    pub fn count(&self) -> u64 {
        self.channels[0].count()
    }

    /// The standard error of each channel's mean: from the scatter of independent runs where samples
    /// lie evenly, else from that of the samples. Infinite below two samples, where it is unknown.
    ///
    /// Of less than two runs nothing but the samples' scatter is known, which overstates it. Samples
    /// after the last whole run count as if they were as good as those before.
    pub fn std_errors(&self) -> [f64; 3] {
        [0, 1, 2].map(|i| match &self.runs[i] {
            runs if runs.count() >= 2 => {
                runs.std_error() * (self.in_runs as f64 / self.count() as f64).sqrt()
            }
            _ => self.channels[i].std_error(),
        })
    }

    /// The mean of the samples; `None` where there are none.
    pub fn mean(&self) -> Option<[f64; 3]> {
        (self.count() > 0).then(|| self.channels.map(|e| e.mean()))
    }
}

/// Where a sample came out as NaN or infinity: enough to trace it again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct BadSample {
    /// Column, from the left.
    pub x: u32,
    /// Row, from the top.
    pub y: u32,
    /// Number of the sample in its pixel.
    pub sample: u32,
}

/// A picture with its errors: for each pixel the mean and the variance of its samples, in `f64`.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: u32,
    /// Row by row from the top.
    pixels: Vec<Pixel>,
}

impl Film {
    /// A film from its pixels, row by row from the top.
    ///
    /// # Panics
    ///
    /// Where the number of pixels is not a multiple of `width`.
    pub fn new(width: u32, pixels: Vec<Pixel>) -> Self {
        assert_eq!(pixels.len() % width as usize, 0);
        Film { width, pixels }
    }

    /// Width in pixels.
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    pub fn height(&self) -> u32 {
        (self.pixels.len() / self.width as usize) as u32
    }

    /// The pixels, row by row from the top.
    pub fn pixels(&self) -> &[Pixel] {
        &self.pixels
    }

    /// The same, to be changed.
    pub(super) fn pixels_mut(&mut self) -> &mut [Pixel] {
        &mut self.pixels
    }

    /// The pixel in column `x` from the left and row `y` from the top.
    pub fn pixel(&self, x: u32, y: u32) -> &Pixel {
        &self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// The pixel in column `x` and row `y`, to be changed.
    pub(super) fn pixel_mut(&mut self, [x, y]: [u32; 2]) -> &mut Pixel {
        &mut self.pixels[y as usize * self.width as usize + x as usize]
    }

    /// The tiles of a shard one below the other, each filled up to a square: all that a picture has of which no more was
    /// rendered.
    #[must_use]
    pub fn packed(&self, shard: Shard) -> Film {
        let size = [self.width, self.height()];
        let [width, height] = Film::packed_size(shard, size);
        let mut packed = Film::empty([width, height]);
        for [from, to] in shard.places(size) {
            *packed.pixel_mut(to) = *self.pixel(from[0], from[1]);
        }
        packed
    }

    /// The size of [`Film::packed`] of a picture of this size.
    pub(crate) fn packed_size(shard: Shard, size: [u32; 2]) -> [u32; 2] {
        let tiles = shard.tiles(size).count() as u32;
        // A shard may have no tile, but no picture has no pixel.
        [Shard::TILE, (tiles * Shard::TILE).max(1)]
    }

    /// Puts the pixels of a shard from [`Film::packed`] in their places.
    ///
    /// # Panics
    ///
    /// Where that was packed from a picture of another size.
    pub fn unpack(&mut self, packed: &Film, shard: Shard) {
        let size = [self.width, self.height()];
        let packed_size = [packed.width, packed.height()];
        assert_eq!(packed_size, Film::packed_size(shard, size));
        for [to, from] in shard.places(size) {
            *self.pixel_mut(to) = *packed.pixel(from[0], from[1]);
        }
    }

    /// A film without any sample.
    pub(crate) fn empty([width, height]: [u32; 2]) -> Film {
        Film::new(
            width,
            vec![Pixel::default(); width as usize * height as usize],
        )
    }

    /// Some of its rows, as a picture of its own.
    ///
    /// # Panics
    ///
    /// Where there are no such rows.
    #[must_use]
    pub fn rows(&self, rows: Range<u32>) -> Film {
        let [start, end] = [rows.start, rows.end].map(|row| row as usize * self.width as usize);
        Film::new(self.width, self.pixels[start..end].to_vec())
    }

    /// Films of one height side by side, from the left.
    ///
    /// # Panics
    ///
    /// Where their heights differ.
    pub fn beside(films: &[&Film]) -> Film {
        let height = films.first().map_or(0, |film| film.height());
        assert!(films.iter().all(|film| film.height() == height));
        let mut pixels = Vec::new();
        for y in 0..height as usize {
            for film in films {
                let width = film.width as usize;
                pixels.extend_from_slice(&film.pixels[y * width..(y + 1) * width]);
            }
        }
        Film::new(films.iter().map(|film| film.width).sum(), pixels)
    }

    /// The mean of the picture over pixels and channels, and its standard error.
    ///
    /// Pixels are independent, so their squared errors add. The channels of a pixel share their
    /// samples; they are taken as fully correlated, which can only overstate the error.
    pub fn mean(&self) -> (f64, f64) {
        let mut values = Estimate::new();
        let mut squared_error = 0.0;
        for pixel in self.pixels.iter().filter(|p| p.count() > 0) {
            let third = |channels: [f64; 3]| channels.iter().sum::<f64>() / 3.0;
            values.add(third(pixel.channels.map(|e| e.mean())));
            squared_error += third(pixel.std_errors()).powi(2);
        }
        let n = values.count().max(1) as f64;
        (values.mean(), squared_error.sqrt() / n)
    }

    /// Values and errors alone.
    pub fn picture(&self) -> Picture {
        self.into()
    }

    /// The variance of one sample, mean over pixels and channels; of even samples, as if each were
    /// alone.
    pub fn sample_variance(&self) -> f64 {
        let channels = self.pixels.iter().flat_map(|p| p.channels);
        channels.map(|e| e.variance()).collect::<Estimate>().mean()
    }

    /// The largest mean of any channel of any pixel; 0 for a black picture.
    pub fn max(&self) -> f64 {
        let means = self.pixels.iter().filter_map(Pixel::mean).flatten();
        means.fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::stream::even_run;

    /// A sample's value: anything that scatters.
    fn value(sample: u32) -> Rgb {
        let x = sample.wrapping_mul(0x9e37_79b9) >> 8;
        Rgb::grey(x as f32 / 16_777_216.0)
    }

    #[test]
    fn runs_are_of_one_length_and_have_the_mean_of_all_their_samples() {
        let mut pixel = Pixel::default();
        for (end, runs) in [(16, 1), (32, 2), (64, 2), (128, 2), (192, 3), (256, 4)] {
            (pixel.count() as u32..end).for_each(|i| pixel.add(value(i)));
            let run = even_run(end - 1);
            pixel.end_run(run.end == 2 * run.start);
            for i in 0..3 {
                assert_eq!(pixel.runs[i].count(), runs, "{end}");
                let off = pixel.runs[i].mean() - pixel.channels[i].mean();
                assert!(off.abs() < 1e-15, "{end}: {off:e}");
            }
            assert_eq!(pixel.in_runs, u64::from(end));
        }
    }

    #[test]
    fn samples_after_the_last_run_count_as_if_they_were_as_good() {
        let mut pixel = Pixel::default();
        for end in [64, 128] {
            (pixel.count() as u32..end).for_each(|i| pixel.add(value(i)));
            pixel.end_run(true);
        }
        let [whole, ..] = pixel.std_errors();
        (128..288).for_each(|i| pixel.add(value(i)));
        let [more, ..] = pixel.std_errors();
        assert!((more / whole - (128.0 / 288.0_f64).sqrt()).abs() < 1e-12);
    }
}
