//! How a path goes on from a surface: as its material scatters, or towards what focuses light.
//!
//! Two densities are mixed, and every direction counts by the mixture, whichever drew it: Veach,
//! Guibas, Optimally Combining Sampling Techniques for Monte Carlo Rendering (SIGGRAPH 1995),
//! "One-sample model". Where a point sees nothing specular only the material's is left, and no
//! further number is drawn.

use super::walkable::SolidPoint;
use crate::color::Rgb;
use crate::materials::{Among, Event, kinds};
use crate::sampling::stream::Numbers;
use crate::scene::{Scene, SeenCasters};
use glam::Vec3;

/// A surface, and what it may look for.
pub(super) struct Onward<'a, const KINDS: u8> {
    pub(super) at: &'a SolidPoint<'a>,
    pub(super) material: Among<KINDS>,
    /// What its smooth part does with light; `None` where there is none.
    pub(super) smooth: Option<Event>,
    seen: SeenCasters,
}

/// A direction drawn.
pub(super) struct Step {
    /// Unit, in world coordinates.
    pub(super) direction: Vec3,
    /// `f cos / pdf`.
    pub(super) weight: Rgb,
    /// The weight it would have, had the material drawn it: what a surface leaves of the light, where
    /// `weight` also tells how much rarer or more frequent such directions are than they would be.
    pub(super) kept: Rgb,
    /// In 1/sr; `None` for a perfectly specular direction.
    pub(super) pdf: Option<f32>,
    /// What happened.
    pub(super) event: Event,
}

impl<'a, const KINDS: u8> Onward<'a, KINDS> {
    pub(super) fn new(scene: &Scene, at: &'a SolidPoint<'a>, material: Among<KINDS>) -> Self {
        let smooth = material.smooth_event();
        let casters = KINDS & kinds::SPECULAR != 0 && !scene.casters.is_empty();
        let seen = if casters && smooth.is_some() {
            scene.casters.seen_from(at.hit.surface.p)
        } else {
            SeenCasters::default()
        };
        Onward {
            at,
            material,
            smooth,
            seen,
        }
    }

    /// Draws where the path goes on; `None` where it ends. `branch` decides who draws.
    ///
    /// Density: [`Onward::pdf`], in 1/sr.
    pub(super) fn sample(
        &self,
        numbers: &mut Numbers,
        branch: impl FnOnce() -> f32,
    ) -> Option<Step> {
        let (u, choice) = (numbers.two(), numbers.one());
        let seen = &self.seen;
        if seen.is_empty() {
            let drawn = self.material.scatter(self.at.wo, choice, u)?;
            return Some(Step {
                direction: self.at.frame.to_world(drawn.wi).normalize(),
                weight: drawn.weight,
                kept: drawn.weight,
                pdf: drawn.pdf,
                event: drawn.event,
            });
        }
        let (wi, direction) = if branch() < seen.share() {
            let direction = seen.sample(choice, u).normalize();
            (self.at.frame.to_local(direction), direction)
        } else {
            let drawn = self.material.scatter(self.at.wo, choice, u)?;
            let direction = self.at.frame.to_world(drawn.wi).normalize();
            if drawn.pdf.is_none() {
                return Some(Step {
                    direction,
                    weight: drawn.weight / (1.0 - seen.share()),
                    kept: drawn.weight,
                    pdf: None,
                    event: drawn.event,
                });
            }
            (drawn.wi, direction)
        };
        let event = self.smooth?;
        let scattered = self.material.f(self.at.wo, wi) * wi.z.abs();
        let by_material = self.material.pdf(self.at.wo, wi);
        let pdf = mix(by_material, seen, direction);
        (!scattered.is_black() && pdf > 0.0).then(|| Step {
            direction,
            weight: scattered / pdf,
            kept: scattered / if by_material > 0.0 { by_material } else { pdf },
            pdf: Some(pdf),
            event,
        })
    }

    /// Density of [`Onward::sample`] at a direction that is not perfectly specular, given in local
    /// and in world coordinates, in 1/sr.
    pub(super) fn pdf(&self, wi: Vec3, direction: Vec3) -> f32 {
        let by_material = self.material.pdf(self.at.wo, wi);
        if self.seen.is_empty() {
            by_material
        } else {
            mix(by_material, &self.seen, direction)
        }
    }
}

/// The density of a direction that is drawn by the material or towards what focuses light.
fn mix(by_material: f32, seen: &SeenCasters, direction: Vec3) -> f32 {
    (1.0 - seen.share()) * by_material + seen.share() * seen.pdf(direction)
}
