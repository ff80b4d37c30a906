//! The picture of `halfdisk render`: where it goes, how it is made, the command that makes it again, and what is
//! wrong with it.

use super::choices::Points;
use super::render::Render;
use super::{Stop, stem};
use crate::integrators::{Entry, Path as PathTracer, RarelyAsked, Shows, rarely_asked};
use crate::output::{Display, Provenance};
use crate::render::{self, Film, Rendered};
use crate::sampling::stream::Sampler;
use crate::scene::Scene;
use std::path::PathBuf;

/// How the values of a picture become shades.
pub(super) fn display(integrator: Entry, film: &Film) -> Display {
    match integrator.shows {
        Shows::Light(_) => Display::Radiance,
        Shows::Geometry { white } => Display::Data {
            white: white.unwrap_or_else(|| film.max()),
        },
    }
}

impl Render {
    /// The scene, by the name that was given for it.
    pub(super) fn scene(&self) -> &str {
        self.scene.as_deref().unwrap_or_default()
    }

    /// Where the picture goes.
    pub(super) fn path(&self) -> PathBuf {
        self.out.clone().unwrap_or_else(|| {
            let mut name = stem(self.scene());
            if self.integrator != PathTracer::ENTRY {
                name += &format!("-{}", self.integrator.name);
            }
            name += &self.demand.suffix();
            PathBuf::from("out").join(name + ".png")
        })
    }

    pub(super) fn sampler(&self) -> Sampler {
        match self.sampler {
            Some(Points::Sobol) => Sampler::Sobol,
            None if self.integrator == PathTracer::ENTRY => Sampler::Sobol,
            _ => Sampler::Independent,
        }
    }

    pub(super) fn max_depth(&self, scene: &Scene) -> Result<u32, Stop> {
        let Entry { name, longest, .. } = self.integrator;
        match self.max_depth {
            Some(depth) if depth > longest => Err(Stop::Input(format!(
                "--max-depth {depth}: the paths of `{name}` end after {longest} segments at the latest"
            ))),
            Some(depth) => Ok(depth),
            None => Ok(scene.suggested.max_depth.min(longest)),
        }
    }

    /// The arguments of `halfdisk` that make a picture with these facts again, whatever ended it.
    pub(super) fn again(&self, scene: &Scene, facts: &Provenance) -> Vec<String> {
        let [width, height] = scene.size;
        let sampler = match facts.sampler {
            Sampler::Independent => "independent",
            Sampler::Sobol => "sobol",
        };
        let without: Vec<&str> = self.demand.without.iter().map(|e| e.name()).collect();
        let patches = self.patching.patches.map(|n| n.to_string());
        let patch_size = self.patching.patch_size.map(|length| length.to_string());
        let settings = [
            ("integrator", Some(facts.integrator.clone())),
            ("size", Some(format!("{width}x{height}"))),
            ("spp", Some(facts.spp.to_string())),
            ("seed", Some(facts.seed.to_string())),
            ("sampler", Some(sampler.to_owned())),
            ("max-depth", Some(facts.max_depth.to_string())),
            ("light-paths", facts.light_paths.map(|n| n.to_string())),
            ("photons", self.photons.walks().map(|n| n.to_string())),
            ("radius", self.photons.radius().map(|r| r.to_string())),
            ("patches", patches),
            ("patch-size", patch_size),
            ("exposure", self.exposure.again()),
            ("paths", self.demand.paths.as_ref().map(ToString::to_string)),
            ("without", (!without.is_empty()).then(|| without.join(","))),
        ];
        let mut all = vec!["render".to_owned(), self.scene().to_owned()];
        for (name, value) in settings {
            all.extend(
                value
                    .into_iter()
                    .flat_map(|value| [format!("--{name}"), value]),
            );
        }
        if self.all_effects {
            all.push("--all-effects".to_owned());
        }
        // Last, so that the whole picture's is what comes before it.
        if let Some(shard) = facts.shard {
            all.extend(["--shard".to_owned(), shard.to_string()]);
        }
        all
    }

    /// Lights that the choice of one at each surface hardly meets in this picture.
    pub(super) fn rarely_asked(
        &self,
        scene: &Scene,
        rendered: &Rendered,
        max_depth: u32,
    ) -> Option<RarelyAsked> {
        let samples = rendered.film.pixels().iter().map(|p| p.count()).sum();
        let aims_at_one = self.integrator == PathTracer::ENTRY;
        aims_at_one.then(|| rarely_asked(scene, max_depth, samples))?
    }

    /// Pixels that show more light than there can be.
    pub(super) fn too_bright(&self, scene: &Scene, rendered: &Rendered, max_depth: u32) -> usize {
        if self.integrator.finds().is_none() {
            return 0;
        }
        let longest = match self.integrator.is_endless {
            true => u32::MAX,
            false => max_depth,
        };
        let bound = scene.brightest(longest);
        bound.map_or(0, |bound| render::too_bright(&rendered.film, bound))
    }
}
