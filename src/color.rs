//! [`Rgb`], a radiometric triple, and the way to a screen.
//!
//! A colour is deliberately not a vector: it has no length, no dot product and no direction, and
//! the compiler refuses to mix the two. Values are linear; there is no colour management.

use std::iter::Sum;
use std::ops::{Add, AddAssign, Div, Mul, MulAssign, Sub};

/// Three independent linear channels: a radiance in W/(m² sr), a reflectance, a weight.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rgb {
    /// Red.
    pub r: f32,
    /// Green.
    pub g: f32,
    /// Blue.
    pub b: f32,
}

impl Rgb {
    /// No light, nothing reflected.
    pub const BLACK: Rgb = Rgb::grey(0.0);
    /// One in every channel.
    pub const WHITE: Rgb = Rgb::grey(1.0);

    /// A colour from its channels.
    pub const fn new(r: f32, g: f32, b: f32) -> Self {
        Rgb { r, g, b }
    }

    /// The same value in every channel.
    pub const fn grey(value: f32) -> Self {
        Rgb::new(value, value, value)
    }

    /// The channels in order.
    pub const fn channels(self) -> [f32; 3] {
        [self.r, self.g, self.b]
    }

    /// Luminance with the weights of ITU-R BT.709 (2015), item 3.2.
    pub fn luminance(self) -> f32 {
        0.2126 * self.r + 0.7152 * self.g + 0.0722 * self.b
    }

    /// The mean of the channels.
    pub fn mean(self) -> f32 {
        (self.r + self.g + self.b) / 3.0
    }

    /// The largest channel.
    pub fn max_channel(self) -> f32 {
        self.r.max(self.g).max(self.b)
    }

    /// True where every channel is a finite number.
    pub fn is_finite(self) -> bool {
        self.r.is_finite() && self.g.is_finite() && self.b.is_finite()
    }

    /// Channel by channel the smaller of two colours.
    #[must_use]
    pub fn min(self, o: Rgb) -> Rgb {
        Rgb::new(self.r.min(o.r), self.g.min(o.g), self.b.min(o.b))
    }

    /// Channel by channel the larger of two colours.
    #[must_use]
    pub fn max(self, o: Rgb) -> Rgb {
        Rgb::new(self.r.max(o.r), self.g.max(o.g), self.b.max(o.b))
    }

    /// True where no channel carries anything.
    pub fn is_black(self) -> bool {
        self == Rgb::BLACK
    }
}

impl From<[f32; 3]> for Rgb {
    fn from([r, g, b]: [f32; 3]) -> Self {
        Rgb { r, g, b }
    }
}

impl Add for Rgb {
    type Output = Rgb;
    fn add(self, o: Rgb) -> Rgb {
        Rgb::new(self.r + o.r, self.g + o.g, self.b + o.b)
    }
}

impl AddAssign for Rgb {
    fn add_assign(&mut self, o: Rgb) {
        *self = *self + o;
    }
}

impl Sub for Rgb {
    type Output = Rgb;
    fn sub(self, o: Rgb) -> Rgb {
        Rgb::new(self.r - o.r, self.g - o.g, self.b - o.b)
    }
}

impl Mul for Rgb {
    type Output = Rgb;
    fn mul(self, o: Rgb) -> Rgb {
        Rgb::new(self.r * o.r, self.g * o.g, self.b * o.b)
    }
}

impl MulAssign for Rgb {
    fn mul_assign(&mut self, o: Rgb) {
        *self = *self * o;
    }
}

impl Mul<f32> for Rgb {
    type Output = Rgb;
    fn mul(self, s: f32) -> Rgb {
        Rgb::new(self.r * s, self.g * s, self.b * s)
    }
}

impl Mul<Rgb> for f32 {
    type Output = Rgb;
    fn mul(self, c: Rgb) -> Rgb {
        c * self
    }
}

impl Div<f32> for Rgb {
    type Output = Rgb;
    fn div(self, s: f32) -> Rgb {
        Rgb::new(self.r / s, self.g / s, self.b / s)
    }
}

impl Sum for Rgb {
    fn sum<I: Iterator<Item = Rgb>>(colors: I) -> Rgb {
        colors.fold(Rgb::BLACK, Add::add)
    }
}

/// The sRGB transfer curve: linear `[0, 1]` to encoded `[0, 1]`, clamped at both ends.
///
/// Source: IEC 61966-2-1 (1999), section "Encoding characteristics".
pub fn srgb_encode(linear: f64) -> f64 {
    let x = linear.clamp(0.0, 1.0);
    if x <= 0.003_130_8 {
        12.92 * x
    } else {
        1.055 * libm::pow(x, 1.0 / 2.4) - 0.055
    }
}

/// The inverse of [`srgb_encode`]: encoded `[0, 1]` to linear `[0, 1]`, clamped at both ends.
pub fn srgb_decode(encoded: f64) -> f64 {
    let x = encoded.clamp(0.0, 1.0);
    if x <= 0.040_45 {
        x / 12.92
    } else {
        libm::pow((x + 0.055) / 1.055, 2.4)
    }
}

/// A value in `[0, 1]` to one of 256 equally wide levels; outside it clamps.
///
/// `(256 x) as u8`, not `(255 x + 0.5) as u8`: every level is then equally wide, and `k / 255`
/// still comes back as `k`. NaN has no level: callers mark such pixels before they come here.
pub fn quantise(x: f64) -> u8 {
    (x * 256.0).clamp(0.0, 255.0) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_level_comes_back() {
        for k in 0..=255_u8 {
            assert_eq!(quantise(f64::from(k) / 255.0), k);
        }
        assert_eq!(quantise(-3.0), 0);
        assert_eq!(quantise(1e9), 255);
    }

    #[test]
    fn every_level_is_as_wide_as_every_other() {
        // 1000 values in each 256th of [0, 1), in the middle of their steps.
        let mut counts = [0; 256];
        for i in 0..256_000 {
            counts[usize::from(quantise((f64::from(i) + 0.5) / 256_000.0))] += 1;
        }
        assert_eq!(counts, [1000; 256]);
    }

    #[test]
    fn the_transfer_curve_is_monotone_and_meets_at_its_knee() {
        let knee = 0.003_130_8;
        assert!((srgb_encode(knee + 1e-12) - srgb_encode(knee)).abs() < 1e-6);
        let levels: Vec<u8> = (0..=10_000)
            .map(|i| quantise(srgb_encode(f64::from(i) / 10_000.0)))
            .collect();
        assert!(levels.is_sorted());
        assert_eq!((levels[0], levels[10_000]), (0, 255));
        // Middle grey: 0.2140 linear is level 127 or 128 of 255 (a plain quantiser would say 54).
        assert!((127..=128).contains(&quantise(srgb_encode(0.2140))));
    }

    #[test]
    fn the_transfer_curve_comes_back() {
        for k in 0..=255 {
            let x = f64::from(k) / 255.0;
            assert!((srgb_encode(srgb_decode(x)) - x).abs() < 1e-6, "{x}");
        }
        assert_eq!((srgb_decode(-1.0), srgb_decode(2.0)), (0.0, 1.0));
    }

    #[test]
    fn luminance_weighs_a_grey_as_itself() {
        assert!((Rgb::grey(0.7).luminance() - 0.7).abs() < 1e-6);
    }
}
