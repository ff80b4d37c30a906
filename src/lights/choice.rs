//! Which of many lights to ask.

use super::Light;
use crate::sampling::discrete::Discrete;

/// Chooses one of a scene's lights, with a probability proportional to its power.
#[derive(Clone, Debug, Default)]
pub struct LightChoice(Option<Discrete>);

impl LightChoice {
    /// The choice among `lights` in a scene of this radius (see [`Light::power`]).
    pub fn by_power(lights: &[Light], scene_radius: f32) -> Self {
        let power = |light: &Light| f64::from(light.power(scene_radius));
        LightChoice(Discrete::new(lights.iter().map(power)))
    }

    /// The index of a light and its probability, positive; `None` where there is no light.
    pub fn choose(&self, u: f32) -> Option<(usize, f32)> {
        let choice = self.0.as_ref()?.sample(u);
        Some((choice.index, choice.probability))
    }

    /// The probability with which [`LightChoice::choose`] returns the light `index`.
    pub fn probability(&self, index: usize) -> f32 {
        self.0.as_ref().map_or(0.0, |d| d.probability(index))
    }
}
