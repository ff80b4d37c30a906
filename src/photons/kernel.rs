//! How much a photon counts by its distance.

use crate::space::Space;

/// The weight of a photon on a disc, by its distance from the middle. Its mean over the disc is 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kernel {
    /// All count alike: what is read is the power on the disc over its measure, and its expectation the
    /// mean over the disc.
    Constant,
    /// `(1 + d/2) (1 - t²)` at `t` radii from the middle, where a surface has `d` dimensions: 3/2 of it in the
    /// flat world, 2 in space. Photons count for less towards the edge, so its blur is smaller, at the same
    /// rate.
    ///
    /// Source: Epanechnikov, Non-Parametric Estimation of a Multivariate Probability Density (Theory of
    /// Probability and its Applications 14(1), 1969).
    #[default]
    Epanechnikov,
}

impl Kernel {
    /// The weight at a distance whose square is the share `share2` of the squared radius, in `[0, 1]`.
    pub fn weight<S: Space>(self, share2: f32) -> f32 {
        match self {
            Kernel::Constant => 1.0,
            Kernel::Epanechnikov => (1.0 + 0.5 * S::FALL_OFF as f32) * (1.0 - share2),
        }
    }

    /// The mean of the squared distance along one axis, weighted, in squared radii: half of it, times
    /// the second derivatives of the light, is what the blur changes.
    pub fn spread<S: Space>(self) -> f64 {
        let d = f64::from(S::FALL_OFF);
        match self {
            Kernel::Constant => 1.0 / (d + 2.0),
            Kernel::Epanechnikov => 1.0 / (d + 4.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::{Flat, Solid};

    /// Mean weight and mean weighted squared distance along one axis.
    fn moments<S: Space>(kernel: Kernel) -> [f64; 2] {
        const N: u32 = 100_000;
        let mut sums = [0.0; 2];
        for i in 0..N {
            // Uniform on the disc: of all points, the share u is nearer than u^(1/d).
            let u = (f64::from(i) + 0.5) / f64::from(N);
            let share2 = if S::FALL_OFF == 1 { u * u } else { u };
            let weight = f64::from(kernel.weight::<S>(share2 as f32));
            sums[0] += weight;
            sums[1] += weight * share2 / f64::from(S::FALL_OFF);
        }
        sums.map(|sum| sum / f64::from(N))
    }

    #[test]
    fn kernels_keep_power_and_spread_it_as_they_say() {
        fn check<S: Space>() {
            for kernel in [Kernel::Constant, Kernel::Epanechnikov] {
                let [mean, spread] = moments::<S>(kernel);
                assert!((mean - 1.0).abs() < 1e-5, "{kernel:?}: {mean}");
                let off = spread - kernel.spread::<S>();
                assert!(off.abs() < 1e-5, "{kernel:?}: {spread}");
            }
        }
        check::<Flat>();
        check::<Solid>();
    }
}
