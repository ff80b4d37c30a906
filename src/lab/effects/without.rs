//! An effect left out on purpose. The picture is wrong by what is missing, and should say by how
//! much.

use super::language::{self, Class, Wanted};
use super::measure::Setup;
use crate::notation::Expression;
use crate::scene::description::{Description, Material};
use crate::scene::value::{Albedo, NotNegative};
use crate::scene::{Effect, Scene, SceneError};

/// What is left out.
#[derive(Clone, Debug, Default)]
pub struct Without(Vec<Effect>);

impl FromIterator<Effect> for Without {
    fn from_iter<I: IntoIterator<Item = Effect>>(effects: I) -> Self {
        Without(effects.into_iter().collect())
    }
}

impl Without {
    /// Nothing.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The effects.
    pub fn effects(&self) -> &[Effect] {
        &self.0
    }

    /// What is left of a scene and of the paths that are wanted, or else of all.
    pub fn of(&self, scene: Scene, paths: Option<&Expression>) -> Result<Setup, SceneError> {
        let scene = match self.is_empty() {
            true => scene,
            false => scene.changed(|said| self.change(said))?,
        };
        let wanted = self.restrict(paths);
        Ok(Setup { scene, wanted })
    }

    /// Takes lights, lens and motion out of a scene before it is built.
    pub fn change(&self, said: &mut Description) {
        for effect in &self.0 {
            match effect {
                Effect::PointLights => said.lights.clear(),
                Effect::AreaLights => put_out(said),
                Effect::Sky => (said.background, said.environment) = (None, None),
                Effect::Lens => said.camera.lens_radius = NotNegative(0.0),
                // Everything stays where it is when the shutter opens.
                Effect::Motion => said.camera.shutter.0[1] = said.camera.shutter.0[0],
                Effect::Diffuse
                | Effect::Specular
                | Effect::Gloss
                | Effect::Bleeding
                | Effect::Caustics => {}
            }
        }
    }

    /// The paths that are left of those wanted; `None` where every path counts.
    pub fn restrict(&self, wanted: Option<&Expression>) -> Option<Wanted> {
        let everything = language::everything();
        let lost = self.0.iter().filter_map(|effect| lost(*effect));
        let lost: Vec<Expression> = lost.map(language::known).collect();
        (wanted.is_some() || !lost.is_empty()).then(|| {
            lost.iter()
                .fold(Wanted::new(wanted.unwrap_or(&everything)), Wanted::but)
        })
    }
}

/// Lamps go out: what shone and did nothing else is black, and stands where it stood.
fn put_out(said: &mut Description) {
    let black = "what does not shine";
    let material = Material::Lambert {
        albedo: Albedo([0.0; 3]).into(),
    };
    for object in &mut said.objects {
        object.emits = None;
        if object.material.is_none() {
            object.material = Some(black.to_owned());
            said.materials.insert(black.to_owned(), material.clone());
        }
    }
}

/// The paths that an effect brings; `None` for one that is no matter of paths.
pub fn lost(effect: Effect) -> Option<&'static str> {
    match effect {
        Effect::Diffuse => Some(".*D.*"),
        Effect::Specular => Some(".*S.*"),
        Effect::Gloss => Some(".*G.*"),
        Effect::Bleeding => Some(Class::Bleeding.text()),
        Effect::Caustics => Some(Class::Caustic.text()),
        Effect::PointLights | Effect::AreaLights | Effect::Sky | Effect::Lens | Effect::Motion => {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Which of some words an effect brings.
    fn brings(effect: Effect) -> Vec<&'static str> {
        let words = [
            "LE", "LSE", "LDE", "LGE", "LDSE", "LSDE", "LSGE", "LSSDE", "LSDSE", "LSDDE", "LDDE",
            "LGDE", "LDSDE", "LDDSE",
        ];
        let language = language::known(lost(effect).unwrap());
        let has = |word: &&str| {
            let word = language::known(word);
            language.light_first().includes(word.light_first())
        };
        words.into_iter().filter(has).collect()
    }

    #[test]
    fn caustics_and_bleeding_are_those_of_the_classes() {
        for (effect, class) in [
            (Effect::Caustics, Class::Caustic),
            (Effect::Bleeding, Class::Bleeding),
        ] {
            assert_eq!(lost(effect), Some(class.text()));
        }
        // Between L and the first rough surface there is nothing but S.
        let caustics = ["LSDE", "LSGE", "LSSDE", "LSDSE", "LSDDE"];
        assert_eq!(brings(Effect::Caustics), caustics);
        // Two rough surfaces, the first of which the light itself lights.
        let bleeding = ["LDDE", "LGDE", "LDSDE", "LDDSE"];
        assert_eq!(brings(Effect::Bleeding), bleeding);
    }
}
