//! Perfectly specular directions with their weights.

use super::{BsdfSample, Event};
use crate::color::Rgb;
use glam::Vec3;

/// One perfectly specular direction.
#[derive(Clone, Copy, Debug)]
pub struct Branch {
    /// Where the light comes from, unit.
    pub wi: Vec3,
    /// The share of its radiance that goes on to `wo`.
    pub weight: Rgb,
}

/// The perfectly specular part of a BSDF for one `wo`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Specular {
    /// The mirror direction.
    pub reflected: Option<Branch>,
    /// The refracted direction.
    pub transmitted: Option<Branch>,
}

impl Specular {
    /// One of the branches, drawn with a probability proportional to its weight (the mean of its
    /// channels), its weight divided by that probability; `None` where nothing goes on.
    ///
    /// Glass so goes on mirrored with probability `R`, refracted with `1 - R`, and either way with
    /// weight exactly one; the only branch of a mirror is taken for sure, and keeps its weight.
    ///
    /// * `u`: in `[0, 1)`. Weights of glass and uniforms are multiples of 2^-24, so its
    ///   probabilities are exact.
    pub fn choose(&self, u: f32) -> Option<Branch> {
        let mean = |b: Option<Branch>| {
            let channels = b.map_or([0.0; 3], |b| b.weight.channels());
            channels.map(f64::from).iter().sum::<f64>() / 3.0
        };
        let (reflected, transmitted) = (mean(self.reflected), mean(self.transmitted));
        let p_reflected = reflected / (reflected + transmitted);
        // Where both weigh nothing this is NaN, and neither comparison holds.
        let (branch, p) = if f64::from(u) < p_reflected {
            (self.reflected, p_reflected)
        } else if p_reflected < 1.0 {
            (self.transmitted, 1.0 - p_reflected)
        } else {
            return None;
        };
        branch.map(|b| Branch {
            wi: b.wi,
            weight: b.weight / p as f32,
        })
    }

    /// The same as a way for a path to go on.
    pub fn scatter(&self, choice: f32) -> Option<BsdfSample> {
        self.choose(choice).map(|branch| BsdfSample {
            wi: branch.wi,
            weight: branch.weight,
            pdf: None,
            event: Event::Specular,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::materials::{Glass, Mirror};

    fn branch(wi: Vec3, weight: Rgb) -> Option<Branch> {
        Some(Branch { wi, weight })
    }

    #[test]
    fn a_branch_of_glass_is_chosen_as_often_as_it_weighs_and_then_weighs_one() {
        let wo = Vec3::new(0.96, 0.0, 0.28);
        let both = Glass { ior: 1.5 }.specular(wo);
        let share = both.reflected.expect("glass reflects").weight.r;
        assert!(share > 0.2 && share < 0.4, "{share}");
        let below = both.choose(share.next_down()).expect("a branch");
        let at = both.choose(share).expect("a branch");
        assert!(below.wi.z > 0.0 && at.wi.z < 0.0, "{below:?} {at:?}");
        assert_eq!((below.weight, at.weight), (Rgb::WHITE, Rgb::WHITE));
    }

    #[test]
    fn the_expected_weight_of_each_branch_is_its_own() {
        let (a, b) = (Rgb::new(0.5, 0.25, 0.0), Rgb::new(0.0, 0.125, 0.625));
        let both = Specular {
            reflected: branch(Vec3::Z, a),
            transmitted: branch(-Vec3::Z, b),
        };
        let n = 1 << 12;
        let mut sums = [Rgb::BLACK; 2];
        for k in 0..n {
            let chosen = both.choose(k as f32 / n as f32).expect("a branch");
            sums[usize::from(chosen.wi.z < 0.0)] += chosen.weight * (1.0 / n as f32);
        }
        for (sum, own) in sums.into_iter().zip([a, b]) {
            let off = sum - own;
            assert!(off.channels().iter().all(|x| x.abs() < 1e-3), "{sum:?}");
        }
    }

    #[test]
    fn where_nothing_goes_on_nothing_is_chosen() {
        let black = Specular {
            reflected: branch(Vec3::Z, Rgb::BLACK),
            transmitted: None,
        };
        for nothing in [Specular::default(), black] {
            assert!(nothing.choose(0.0).is_none());
        }
        let mirror = Mirror {
            reflectance: Rgb::new(0.9, 0.5, 0.1),
        };
        for u in [0.0, 1.0_f32.next_down()] {
            let only = mirror.specular(Vec3::Z).choose(u).expect("its branch");
            assert_eq!(only.weight, mirror.reflectance);
        }
    }
}
