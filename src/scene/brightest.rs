//! The most light that can arrive anywhere in a scene.

use super::Scene;
use crate::lights::Light;

impl Scene {
    /// A bound on the radiance that paths of at most `max_depth` segments bring along any ray; `None`
    /// where there is a light without extent, near which light has no bound.
    ///
    /// No surface sends back more than its albedo of the brightest light around it, so with the
    /// brightest emission `L` and the largest albedo `ρ` it is `L (1 + ρ + ρ² + …)`.
    pub fn brightest(&self, max_depth: u32) -> Option<f64> {
        let mut emission = self.background.max_channel();
        for light in &self.lights {
            match light {
                light if light.is_delta() => return None,
                Light::Environment(image) => emission = emission.max(image.brightest()),
                // Those that rays hit are emission of objects, or of what is beyond.
                _ => {}
            }
        }
        let mut albedo = 0.0_f32;
        for object in &self.objects {
            emission = emission.max(object.emission.brightest().max_channel());
            albedo = albedo.max(
                object
                    .material
                    .as_ref()
                    .map_or(0.0, |m| m.brightest().albedo().max_channel()),
            );
        }
        // Shares that add up to one may do so up to a rounding.
        let (emission, albedo) = (f64::from(emission), f64::from(albedo).min(1.0));
        let mut sum = 0.0;
        for _ in 0..max_depth.min(100_000) {
            sum = emission + albedo * sum;
        }
        Some(sum)
    }
}
