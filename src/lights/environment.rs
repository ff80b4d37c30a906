//! Light from infinitely far away, from every direction another: an image around the scene.

use super::{Incident, LightSample, mean};
use crate::color::Rgb;
use crate::geometry::Surface;
use crate::sampling::discrete::{Discrete, refined};
use glam::{DVec3, Vec3};
use std::f64::consts::{FRAC_1_PI, PI, TAU};

/// Of the 53 bits of a uniform, the first 24 refine one choice, the others a second.
const FINER: f64 = (1 << 24) as f64;

/// An image around the scene, in latitude and longitude.
///
/// Rows run from the top (`+y`) to the bottom, each over the same angle; the middle of a row is in
/// the direction `-z`, and columns run towards `+x`: to the right for who looks along `-z`. Radiance
/// is constant in each pixel, so that sampling by it is exact, at the poles as well.
#[derive(Clone, Debug)]
pub struct EnvironmentLight {
    width: usize,
    /// Row by row, in W/(m² sr).
    pixels: Vec<Rgb>,
    /// Cosines of the polar angle at the edges of the rows, from 1 to -1.
    cosines: Vec<f64>,
    rows: Discrete,
    /// The columns of each row; `None` where it is black.
    columns: Vec<Option<Discrete>>,
    /// How far the image is turned about `+y`, in radians, counter-clockwise seen from above.
    turn: f64,
}

impl EnvironmentLight {
    /// The light of an image, `width` pixels to a row; `None` where all is black.
    ///
    /// * `pixels`: whole rows of radiances, finite and not negative.
    /// * `turn`: rotation of the image about `+y` in radians, counter-clockwise seen from above.
    pub fn new(width: usize, pixels: Vec<Rgb>, turn: f64) -> Option<Self> {
        let height = pixels.len() / width;
        debug_assert_eq!(pixels.len(), width * height);
        let cosines: Vec<f64> = (0..=height)
            .map(|i| libm::cos(PI * i as f64 / height as f64))
            .collect();
        let columns: Vec<Option<Discrete>> = pixels
            .chunks_exact(width)
            .map(|row| Discrete::new(row.iter().map(|p| luminance(*p))))
            .collect();
        let weight = |(i, row): (usize, &Option<Discrete>)| {
            let sum = row.as_ref().map_or(0.0, Discrete::total);
            sum * (cosines[i] - cosines[i + 1])
        };
        Some(EnvironmentLight {
            rows: Discrete::new(columns.iter().enumerate().map(weight))?,
            width,
            pixels,
            cosines,
            columns,
            turn,
        })
    }

    /// The largest channel of any pixel.
    pub fn brightest(&self) -> f32 {
        let largest = self.pixels.iter().map(|p| p.max_channel());
        largest.fold(0.0, f32::max)
    }

    /// Radiance from the unit direction `w`.
    pub fn radiance(&self, w: Vec3) -> Rgb {
        let (row, column) = self.pixel(w);
        self.pixels[row * self.width + column]
    }

    /// Draws a direction with a density proportional to the luminance it has; `None` where rounding
    /// takes it into a black pixel.
    ///
    /// * Domain: `u` in `[0, 1)²`; `pick` in `[0, 1)` refines both, so that no pixel is too faint to
    ///   be drawn.
    /// * Method: a row by its luminance times its solid angle, a column by its luminance, and in the
    ///   pixel uniformly in solid angle: the cosine of the polar angle is uniform.
    /// * Density: [`EnvironmentLight::pdf`].
    pub fn sample(&self, from: &Surface, pick: f64, u: [f32; 2]) -> Option<LightSample> {
        let (wi, pdf) = self.sample_direction(pick, u)?;
        let li = self.radiance(wi);
        Some(LightSample::from_afar(
            from,
            wi,
            Incident::Radiance { li, pdf },
        ))
    }

    /// The direction of [`EnvironmentLight::sample`], with its density in 1/sr.
    pub(super) fn sample_direction(&self, pick: f64, u: [f32; 2]) -> Option<(Vec3, f32)> {
        let below = [pick, (pick * FINER).fract()];
        let row = self.rows.sample(refined(u[0], below[0]));
        let columns = self.columns[row.index].as_ref()?;
        let column = columns.sample(refined(u[1], below[1]));
        let [top, bottom] = [self.cosines[row.index], self.cosines[row.index + 1]];
        let cos = top + row.rest * (bottom - top);
        let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
        let across = (column.index as f64 + column.rest) / self.width as f64;
        let (sin_phi, cos_phi) = libm::sincos(TAU * (across - 0.5) - self.turn);
        let wi = DVec3::new(sin * sin_phi, cos, -sin * cos_phi).as_vec3();
        let pdf = self.pdf(wi);
        (pdf > 0.0).then_some((wi, pdf))
    }

    /// Density of [`EnvironmentLight::sample`] in the unit direction `w`, in 1/sr: the probability of
    /// its pixel over the pixel's solid angle.
    pub fn pdf(&self, w: Vec3) -> f32 {
        let (row, column) = self.pixel(w);
        let in_row = self.columns[row].as_ref();
        let in_row = in_row.map_or(0.0, |c| f64::from(c.probability(column)));
        let probability = f64::from(self.rows.probability(row)) * in_row;
        (probability / self.solid_angle(row)) as f32
    }

    /// Irradiance of a surface that all of it would face, `∫ L dω`, mean over channels, in W/m².
    pub fn fluence(&self) -> f64 {
        let rows = self.pixels.chunks_exact(self.width).enumerate();
        rows.map(|(i, row)| self.solid_angle(i) * row.iter().map(|p| mean(*p)).sum::<f64>())
            .sum()
    }

    /// Solid angle of each pixel of a row, in sr.
    fn solid_angle(&self, row: usize) -> f64 {
        TAU / self.width as f64 * (self.cosines[row] - self.cosines[row + 1])
    }

    /// Row and column of the pixel in direction `w`.
    fn pixel(&self, w: Vec3) -> (usize, usize) {
        let w = w.as_dvec3();
        let theta = libm::atan2((w.x * w.x + w.z * w.z).sqrt(), w.y);
        let across = (libm::atan2(w.x, -w.z) + self.turn) / TAU + 0.5;
        let index = |share: f64, count: usize| ((share * count as f64) as usize).min(count - 1);
        (
            index(theta * FRAC_1_PI, self.columns.len()),
            index(across - across.floor(), self.width),
        )
    }
}

/// Luminance in `f64`, so that none of a light's is lost.
fn luminance(light: Rgb) -> f64 {
    let [r, g, b] = light.channels().map(f64::from);
    0.2126 * r + 0.7152 * g + 0.0722 * b
}
