//! The methods whose prices are compared: integrators, points, and a mistake.

use crate::integrators::{Entry, LADDER, Path, Refused, Settings, WALKS};
use crate::lab::mistakes::Clamped;
use crate::render::{Options, Progress, Rendered, render};
use crate::sampling::stream::Sampler;
use crate::scene::Scene;

/// A way to make a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    /// Its name.
    pub name: &'static str,
    /// How it finds light, in a few words.
    pub about: &'static str,
    /// What computes a sample.
    pub integrator: Entry,
    /// Where samples are cut off, if they are.
    pub clamp: Option<f32>,
    /// How the samples of a pixel lie to each other.
    pub sampler: Sampler,
    /// Why its answer may not be the truth, however many samples it takes.
    pub may_be_biased: Option<&'static str>,
}

/// The longest path where none is set: in 10 000 segments any light has found its end.
const ENDLESS: u32 = 10_000;

/// Where `clamped` cuts: at the white of a screen.
pub const CLAMP: f32 = 1.0;

/// Why a method that solves the scene beforehand has no price by samples.
const OF_PATCHES: &str = "its error falls with its patches, not with its samples, and most of its time goes \
                          before the first of them; chapter 15 compares it";

/// The name of the method that others are compared with.
pub const BASE: &str = Path::ENTRY.name;

/// An integrator as it is, with independent samples.
const fn plain(integrator: Entry) -> Method {
    Method {
        name: integrator.name,
        about: integrator.about,
        integrator,
        clamp: None,
        sampler: Sampler::Independent,
        may_be_biased: integrator.leaves_out(),
    }
}

/// All methods: walks from the eye, even points, a mistake, and other integrators.
pub const ALL: [Method; LADDER.len() + 2] = {
    let mut all = [plain(Path::ENTRY); LADDER.len() + 2];
    let mut i = 0;
    while i < WALKS.len() {
        all[i] = plain(WALKS[i]);
        i += 1;
    }
    all[i].name = "path-sobol";
    all[i].about = "path with points that lie evenly";
    all[i].sampler = Sampler::Sobol;
    all[i + 1].name = "clamped";
    all[i + 1].about = "a mistake: path, with bright samples cut off";
    all[i + 1].clamp = Some(CLAMP);
    all[i + 1].may_be_biased = Some("it cuts off what is brighter than 1 in each sample");
    while i < LADDER.len() {
        all[i + 2] = plain(LADDER[i]);
        i += 1;
    }
    all
};

/// How many of [`ALL`], the first ones, walk from the eye.
pub const FROM_THE_EYE: usize = WALKS.len() + 2;

impl serde::Serialize for Method {
    /// Its name.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name)
    }
}

impl<'de> serde::Deserialize<'de> for Method {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        let none = || serde::de::Error::custom(format!("there is no method \"{name}\""));
        Method::find(&name).ok_or_else(none)
    }
}

impl Method {
    /// The method of this name.
    pub fn find(name: &str) -> Option<Method> {
        ALL.into_iter().find(|method| method.name == name)
    }

    /// Why it cannot render `scene`; `None` where it can.
    pub fn cannot(&self, scene: &Scene) -> Option<&'static str> {
        if self.integrator.is_prepared() {
            return Some(OF_PATCHES);
        }
        let points = self.integrator.finds()?.points;
        (points.paths.is_none() && scene.inventory.point_lights > 0).then_some(points.because)
    }

    /// True where paths of any length count, so that the truth is another one than where the scene's
    /// longest path ends them.
    pub fn is_endless(&self) -> bool {
        self.integrator.is_endless
    }

    /// True where its samples are independent, so that its error falls as one over the root of their
    /// number.
    pub fn is_independent(&self) -> bool {
        self.sampler == Sampler::Independent
    }

    /// A picture of `scene`, on the threads of the current pool.
    pub fn render(
        &self,
        scene: &Scene,
        spp: u32,
        seed: u64,
        progress: &impl Progress,
    ) -> Result<Rendered, Refused> {
        let options = Options {
            spp,
            seed,
            sampler: self.sampler,
            ..Options::default()
        };
        let settings = Settings::new(scene.suggested.max_depth);
        let inner = self.integrator.prepare(scene, &settings)?;
        Ok(match self.clamp {
            Some(limit) => render(scene, &Clamped { inner, limit }, &options, progress),
            None => render(scene, &inner, &options, progress),
        })
    }
}

/// A picture whose expectation is the truth: for methods that end their paths with the scene's
/// longest, or for `endless` ones.
pub(super) fn reference(
    scene: &Scene,
    endless: bool,
    spp: u32,
    seed: u64,
    progress: &impl Progress,
) -> Rendered {
    let max_depth = if endless {
        ENDLESS
    } else {
        scene.suggested.max_depth
    };
    let options = Options {
        spp,
        seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    render(scene, &Path::new(max_depth), &options, progress)
}
