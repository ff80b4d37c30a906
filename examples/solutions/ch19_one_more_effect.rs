//! Chapter 19, exercise 2: add one effect to the room, and predict the new report.
//!
//! Each change is one line of the scene file. The prediction names the effects whose line in the
//! report moves from "not simulated" to "simulated", and the light paths that follow.

#![allow(clippy::print_stdout)]

use halfdisk::lab::effects::plan::{Plan, plan};
use halfdisk::scene::description::{Description, Light, Material, Shape};
use halfdisk::scene::value::{Emission, NotNegative, Radiance, Roughness, Shutter, Triple};
use halfdisk::scene::{Effect, SceneError, gallery};

/// A change, and what should follow from it.
struct Prediction {
    change: fn(&mut Description),
    line: &'static str,
    added: &'static [Effect],
    paths: &'static str,
    /// True where light gets lost that no walk from the eye finds.
    loses: bool,
}

impl Prediction {
    fn comes_true(&self, before: &Plan, after: &Plan) -> bool {
        changed(before, after) == self.added
            && after.paths.as_deref() == Some(self.paths)
            && after.out_of_reach.is_some() == self.loses
    }
}

const PREDICTIONS: [Prediction; 5] = [
    Prediction {
        change: |said| {
            for material in said.materials.values_mut() {
                if let Material::Mirror { reflectance } = material.clone() {
                    let roughness = Roughness(0.1);
                    *material = Material::Glossy {
                        reflectance,
                        roughness,
                    };
                }
            }
        },
        line: "glossy = { reflectance = [0.92, 0.92, 0.9], roughness = 0.1 }  # for the mirror",
        added: &[Effect::Gloss],
        // The glass is still there.
        paths: "L(D|S|G)*E",
        loses: false,
    },
    Prediction {
        change: |said| said.camera.lens_radius = NotNegative(12.0),
        line: "lens_radius = 12",
        added: &[Effect::Lens],
        // A lens changes where paths begin, and not what they meet.
        paths: "L(D|S)*E",
        loses: false,
    },
    Prediction {
        change: |said| {
            said.camera.shutter = Shutter([0.0, 1.0]);
            for object in &mut said.objects {
                if let Shape::Sphere { .. } = object.shape {
                    object.motion = Triple([0.0, 20.0, 0.0]);
                }
            }
        },
        line: "motion = [0, 20, 0]  # for the balls, and a shutter that is open",
        added: &[Effect::Motion],
        paths: "L(D|S)*E",
        loses: false,
    },
    Prediction {
        change: |said| said.background = Some(Radiance([0.1, 0.1, 0.2])),
        line: "background = [0.1, 0.1, 0.2]",
        added: &[Effect::Sky],
        paths: "L(D|S)*E",
        loses: false,
    },
    Prediction {
        change: |said| {
            said.lights.push(Light::Point {
                position: Triple([100.0, 400.0, 100.0]),
                intensity: Emission([20_000.0; 3]),
            });
        },
        line: "point = { position = [100, 400, 100], intensity = 20000 }",
        added: &[Effect::PointLights],
        paths: "L(D|S)*E",
        // Its way through the ball to the floor is found by nobody.
        loses: true,
    },
];

fn planned(change: impl FnOnce(&mut Description)) -> Result<Plan, SceneError> {
    Ok(plan(&gallery::load_with("room", change)?))
}

/// The effects that are simulated by the second plan and not by the first, or the other way round.
fn changed(before: &Plan, after: &Plan) -> Vec<Effect> {
    let pairs = before.lines.iter().zip(&after.lines);
    let moved = pairs.filter(|(a, b)| a.simulated != b.simulated);
    moved.map(|(_, line)| line.effect).collect()
}

fn main() -> Result<(), SceneError> {
    let before = planned(|_| {})?;
    for prediction in &PREDICTIONS {
        let after = planned(prediction.change)?;
        println!("{}", prediction.line);
        for effect in changed(&before, &after) {
            let reason = after.lines.iter().find(|line| line.effect == effect);
            let reason = reason.map_or("", |line| line.reason.as_str());
            println!("  now simulated: {}: {reason}", effect.name());
        }
        if let Some(paths) = &after.paths {
            println!("  light paths: {paths}");
        }
        if let Some(lost) = &after.out_of_reach {
            println!("  out of reach: {}", lost.paths);
        }
        let right = prediction.comes_true(&before, &after);
        println!(
            "  {}",
            if right {
                "as predicted"
            } else {
                "not as predicted"
            }
        );
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_prediction_comes_true() {
        let before = planned(|_| {}).unwrap();
        assert_eq!(before.paths.as_deref(), Some("L(D|S)*E"));
        for prediction in &PREDICTIONS {
            let after = planned(prediction.change).unwrap();
            let line = prediction.line;
            assert!(prediction.comes_true(&before, &after), "{line}");
            // The report of the scene as it is would not do.
            assert!(!prediction.comes_true(&before, &before), "{line}");
        }
    }
}
