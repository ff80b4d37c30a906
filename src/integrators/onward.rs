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

/// The share of rays that look towards mirrors and glass, where a point sees some.
const TOWARDS_CASTERS: f32 = 0.3;

/// A surface, and what it may look for.
pub(super) struct Onward<'a, const KINDS: u8> {
    pub(super) at: &'a SolidPoint<'a>,
    pub(super) material: Among<KINDS>,
    /// What its smooth part does with light; `None` where there is none.
    pub(super) smooth: Option<Event>,
    seen: Option<SeenCasters>,
}

/// A direction drawn.
pub(super) struct Step {
    /// Unit, in world coordinates.
    pub(super) direction: Vec3,
    /// `f cos / pdf`.
    pub(super) weight: Rgb,
    /// In 1/sr; `None` for a perfectly specular direction.
    pub(super) pdf: Option<f32>,
    /// What happened.
    pub(super) event: Event,
}

impl<'a, const KINDS: u8> Onward<'a, KINDS> {
    pub(super) fn new(scene: &Scene, at: &'a SolidPoint<'a>, material: Among<KINDS>) -> Self {
        let smooth = material.smooth_event();
        let casters = KINDS & kinds::SPECULAR != 0 && !scene.casters.is_empty();
        let seen = (casters && smooth.is_some())
            .then(|| scene.casters.seen_from(at.hit.surface.p))
            .filter(|seen| !seen.is_empty());
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
        let Some(seen) = &self.seen else {
            let drawn = self.material.scatter(self.at.wo, choice, u)?;
            return Some(Step {
                direction: self.at.frame.to_world(drawn.wi).normalize(),
                weight: drawn.weight,
                pdf: drawn.pdf,
                event: drawn.event,
            });
        };
        let (wi, direction) = if branch() < TOWARDS_CASTERS {
            let direction = seen.sample(choice, u).normalize();
            (self.at.frame.to_local(direction), direction)
        } else {
            let drawn = self.material.scatter(self.at.wo, choice, u)?;
            let direction = self.at.frame.to_world(drawn.wi).normalize();
            if drawn.pdf.is_none() {
                return Some(Step {
                    direction,
                    weight: drawn.weight / (1.0 - TOWARDS_CASTERS),
                    pdf: None,
                    event: drawn.event,
                });
            }
            (drawn.wi, direction)
        };
        let event = self.smooth?;
        let scattered = self.material.f(self.at.wo, wi) * wi.z.abs();
        let pdf = self.pdf(wi, direction);
        (!scattered.is_black() && pdf > 0.0).then(|| Step {
            direction,
            weight: scattered / pdf,
            pdf: Some(pdf),
            event,
        })
    }

    /// Density of [`Onward::sample`] at a direction that is not perfectly specular, given in local
    /// and in world coordinates, in 1/sr.
    pub(super) fn pdf(&self, wi: Vec3, direction: Vec3) -> f32 {
        let by_material = self.material.pdf(self.at.wo, wi);
        match &self.seen {
            Some(seen) => {
                let by_casters = seen.pdf(direction);
                (1.0 - TOWARDS_CASTERS) * by_material + TOWARDS_CASTERS * by_casters
            }
            None => by_material,
        }
    }
}
