//! Density by the distance of the k-th nearest photon: the other way to choose a disc.

use super::{Photon, PhotonMap};
use crate::space::Space;

/// How many photons are said to lie on the disc that reaches to the `k`-th nearest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Count {
    /// `k - 1`: the last one lies on the edge by construction, and says how large the disc is, not how full.
    /// Unbiased where photons lie evenly.
    LessOne,
    /// `k`, the mistake: reads `k / (k - 1)` times the density.
    All,
}

/// The density of points whose squared distances from a place are given, in points per measure of the
/// surface: `(k - 1) / V`, where `V` is the disc that reaches to the `k`-th nearest.
///
/// `None` where there are fewer than `k`, `k` is below 2, or the `k`-th lies on the very place, so that its disc
/// has no measure. Where photons lie evenly its relative variance is `1 / (k - 2)`.
///
/// Source: Loftsgaarden, Quesenberry, A Nonparametric Estimate of a Multivariate Density Function (Annals of
/// Mathematical Statistics 36(3), 1965); the expectation `E[1 / V] = N f / (k - 1)` follows from the Gamma
/// distribution of the power on the disc.
pub fn density<S: Space>(squared_distances: &mut [f64], k: usize, count: Count) -> Option<f64> {
    if k < 2 || squared_distances.len() < k {
        return None;
    }
    let (_, furthest, _) = squared_distances.select_nth_unstable_by(k - 1, f64::total_cmp);
    let measure = S::disc(furthest.sqrt());
    let counted = match count {
        Count::LessOne => k - 1,
        Count::All => k,
    };
    (measure > 0.0).then(|| counted as f64 / measure)
}

impl<S: Space> PhotonMap<S> {
    /// The irradiance by the `k` nearest photons of the surface around `p` with normal `n`, mean over channels, in
    /// W/m² (flat: W/m): their mean power times their [`density`]. `None` as there; photons farther away than
    /// a radius of the map are not looked at.
    pub fn irradiance_by_nearest(
        &self,
        p: S::Vector,
        n: S::Vector,
        k: usize,
        count: Count,
    ) -> Option<f64> {
        let mut found: Vec<(f64, f64)> = Vec::new();
        self.near(p, |photon: &Photon<S>| {
            if let Some(aside2) = self.aside2(p, n, self.radius(), photon) {
                let power = photon.power.channels().map(f64::from);
                found.push((f64::from(aside2), power.iter().sum::<f64>() / 3.0));
            }
        });
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut distances: Vec<f64> = found.iter().map(|(aside2, _)| *aside2).collect();
        let density = density::<S>(&mut distances, k, count)?;
        // The one on the edge has no part in it.
        let inside = found[..k - 1].iter().map(|(_, power)| power);
        let mean = inside.sum::<f64>() / (k - 1) as f64;
        Some(density * mean / f64::from(self.walks()))
    }
}
