//! A picture as numbers: values, and their errors where they are known.

use super::{Film, Pixel};

/// What is left of a film when only values and errors count; also what a file of an image holds.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Picture {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Red, green, blue of each pixel, linear, row by row from the top.
    pub values: Vec<[f64; 3]>,
    /// The standard error of each value, where it is known.
    pub errors: Option<Vec<[f64; 3]>>,
}

impl From<&Film> for Picture {
    /// Pixels without a sample are NaN.
    fn from(film: &Film) -> Self {
        let pixels = film.pixels();
        Picture {
            size: [film.width(), film.height()],
            values: pixels
                .iter()
                .map(|p| p.mean().unwrap_or([f64::NAN; 3]))
                .collect(),
            errors: Some(pixels.iter().map(Pixel::std_errors).collect()),
        }
    }
}

impl Picture {
    /// The mean over all pixels and channels, and its standard error: pixels are independent, the
    /// channels of each share their samples and count as fully correlated.
    pub fn mean(&self) -> (f64, Option<f64>) {
        let n = self.values.len() as f64;
        let third = |p: &[f64; 3]| p.iter().sum::<f64>() / 3.0;
        let mean = self.values.iter().map(third).sum::<f64>() / n;
        let error = self.errors.as_ref().map(|errors| {
            let squares: f64 = errors.iter().map(|p| third(p).powi(2)).sum();
            squares.sqrt() / n
        });
        (mean, error)
    }

    /// The picture of means over squares of `side` pixels; what is left over at the right and the
    /// bottom is dropped. Pixels are independent, so the squares of their errors add: where light
    /// comes by rare events, a square has seen enough of them to know its error, and a pixel has not.
    #[must_use]
    pub fn in_squares(&self, side: u32) -> Picture {
        let size = self.size.map(|n| n / side);
        let count = f64::from(side * side);
        let sum = |values: &[[f64; 3]], x: u32, y: u32, f: fn(f64) -> f64| {
            let mut sum = [0.0; 3];
            for row in y * side..(y + 1) * side {
                let start = (row * self.size[0] + x * side) as usize;
                for pixel in &values[start..start + side as usize] {
                    (0..3).for_each(|i| sum[i] += f(pixel[i]));
                }
            }
            sum
        };
        let squares = || (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
        Picture {
            size,
            values: squares()
                .map(|(x, y)| sum(&self.values, x, y, |v| v).map(|v| v / count))
                .collect(),
            errors: self.errors.as_ref().map(|errors| {
                let error = |(x, y)| sum(errors, x, y, |e| e * e).map(|v| v.sqrt() / count);
                squares().map(error).collect()
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn squares_of_pixels_are_means_whose_errors_shrink() {
        let picture = Picture {
            size: [5, 2],
            values: (0..10).map(|i| [f64::from(i), 1.0, 0.0]).collect(),
            errors: Some(vec![[2.0, 1.0, 0.0]; 10]),
        };
        let squares = picture.in_squares(2);
        assert_eq!(squares.size, [2, 1]);
        // Columns 0 and 1, then 2 and 3, of the rows 0..5 and 5..10.
        assert_eq!(squares.values, [[3.0, 1.0, 0.0], [5.0, 1.0, 0.0]]);
        assert_eq!(squares.errors, Some(vec![[1.0, 0.5, 0.0]; 2]));
        let (mean, error) = squares.mean();
        assert!((mean - 5.0 / 3.0).abs() < 1e-15, "{mean}");
        let expected = 0.5_f64.hypot(0.5) / 2.0;
        assert!(error.is_some_and(|e| (e - expected).abs() < 1e-15));
    }
}
