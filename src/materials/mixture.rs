//! A surface that does three things with light: scatters it, mirrors it, lets it through.

use super::glass::refract;
use super::mirror::reflect;
use super::{Branch, BsdfSample, Event, Lambert, Specular};
use crate::color::Rgb;
use glam::Vec3;

/// Diffuse, specular and transmitted light in constant shares, on both sides: `kd / π`, a mirror
/// that reflects `ks`, and an interface that lets `kt` through at every angle.
///
/// What cannot be refracted, under total reflection, is mirrored. The shares of each channel add up
/// to at most 1; the rest is absorbed.
///
/// Source: the slides' three shares and the choice between them; Lafortune, Willems, Using the
/// Modified Phong Reflectance Model for Physically Based Rendering (Report CW 197, KU Leuven 1994),
/// section 4, for the probability in the weight.
#[derive(Clone, Copy, Debug)]
pub struct Mixture {
    /// The share scattered diffusely.
    pub kd: Rgb,
    /// The share mirrored.
    pub ks: Rgb,
    /// The share refracted.
    pub kt: Rgb,
    /// Index of refraction of the medium behind the surface.
    pub ior: f32,
}

/// How the probabilities of a mixture's parts are chosen. Each is right, they differ in variance;
/// a part without any light is never chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// All parts alike.
    Equal,
    /// In proportion to the mean of their channels.
    ByMean,
    /// In proportion to their luminance.
    ByLuminance,
    /// The means of their channels themselves. What these leave of 1 is the probability of being
    /// absorbed: the path ends, as a photon does.
    Analog,
}

impl Choice {
    fn importance(self, k: Rgb) -> f64 {
        let [r, g, b] = k.channels().map(f64::from);
        match self {
            Choice::Equal => f64::from(u8::from(!k.is_black())),
            Choice::ByMean | Choice::Analog => (r + g + b) / 3.0,
            Choice::ByLuminance => 0.2126 * r + 0.7152 * g + 0.0722 * b,
        }
    }

    /// What the importances are shares of.
    fn whole(self, importances: [f64; 3]) -> f64 {
        match self {
            Choice::Analog => 1.0,
            _ => importances.iter().sum(),
        }
    }
}

impl Mixture {
    /// The smooth part, `kd / π` on the side of `wo`, in 1/sr.
    pub fn f(&self, wo: Vec3, wi: Vec3) -> Rgb {
        self.diffuse().f(wo, wi)
    }

    /// Density of [`Mixture::scatter`] at `wi`, in 1/sr: the probability of the diffuse part, times
    /// `cos / π`.
    pub fn pdf(&self, wo: Vec3, wi: Vec3) -> f32 {
        self.pdf_by(Choice::ByMean, wo, wi)
    }

    /// Goes on with one part, chosen by the mean of its channels.
    pub fn scatter(&self, wo: Vec3, choice: f32, u: [f32; 2]) -> Option<BsdfSample> {
        self.scatter_by(Choice::ByMean, wo, choice, u)
    }

    /// Density of [`Mixture::scatter_by`] at `wi`, in 1/sr.
    pub fn pdf_by(&self, rule: Choice, wo: Vec3, wi: Vec3) -> f32 {
        let [diffuse, ..] = self.probabilities(rule);
        if diffuse > 0.0 {
            diffuse as f32 * self.diffuse().pdf(wo, wi)
        } else {
            0.0
        }
    }

    /// With what probability each part is chosen, in the order of the fields; what they leave of 1
    /// is absorbed.
    pub fn probabilities(&self, rule: Choice) -> [f64; 3] {
        let parts = self.importances(rule);
        let whole = rule.whole(parts);
        parts.map(|part| if part > 0.0 { part / whole } else { 0.0 })
    }

    // ANCHOR: scatter_by
    /// Goes on with one of the three parts: with `R` in `[0, k_tot)`, below `kd` diffusely, below
    /// `kd + ks` mirrored, else transmitted. Its weight is its own share over the probability with
    /// which it was chosen: `k_tot` where the shares are grey and `rule` goes by them. `None` where
    /// the light is absorbed.
    pub fn scatter_by(
        &self,
        rule: Choice,
        wo: Vec3,
        choice: f32,
        u: [f32; 2],
    ) -> Option<BsdfSample> {
        let [d, s, t] = self.importances(rule);
        let whole = rule.whole([d, s, t]);
        let specular = |wi, weight| BsdfSample {
            wi,
            weight,
            pdf: None,
            event: Event::Specular,
        };
        let r = f64::from(choice) * whole;
        if r < d {
            let wi = self.diffuse().sample(wo, u)?;
            Some(BsdfSample {
                wi,
                weight: over(self.kd, d / whole),
                pdf: Some(self.pdf_by(rule, wo, wi)),
                event: Event::Diffuse,
            })
        } else if r < d + s {
            Some(specular(reflect(wo), over(self.ks, s / whole)))
        } else if r < d + s + t {
            let through = refract(wo, self.ior).unwrap_or(reflect(wo));
            Some(specular(through, over(self.kt, t / whole)))
        } else {
            None
        }
    }
    // ANCHOR_END: scatter_by

    /// The mirrored and the refracted direction; under total reflection both shares are mirrored.
    pub fn specular(&self, wo: Vec3) -> Specular {
        let branch = |wi, weight: Rgb| (!weight.is_black()).then_some(Branch { wi, weight });
        match refract(wo, self.ior) {
            Some(through) => Specular {
                reflected: branch(reflect(wo), self.ks),
                transmitted: branch(through, self.kt),
            },
            None => Specular {
                reflected: branch(reflect(wo), self.ks + self.kt),
                transmitted: None,
            },
        }
    }

    /// All that is not absorbed.
    pub fn k_tot(&self) -> Rgb {
        self.kd + self.ks + self.kt
    }

    fn diffuse(&self) -> Lambert {
        Lambert { albedo: self.kd }
    }

    fn importances(&self, rule: Choice) -> [f64; 3] {
        [self.kd, self.ks, self.kt].map(|k| rule.importance(k))
    }
}

/// A share over the probability of its choice.
fn over(k: Rgb, p: f64) -> Rgb {
    Rgb::from(k.channels().map(|k| (f64::from(k) / p) as f32))
}
