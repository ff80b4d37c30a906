//! `halfdisk render`.

use super::demand::{Demand, bias_line};
use super::left_out::LeftOut;
use super::maps::Maps;
use super::report::{as_json, rarely_asked_line, report};
use super::stop::{self, Ending};
use super::{Stop, answer, stem, use_threads};
use crate::desk::{Bar, on_ctrl_c, tell, whole};
use crate::effects::measure::Setup;
use crate::integrators::{
    Albedo, Depth, Integrator, Named, Normals, Path as PathTracer, RarelyAsked, Restricted,
    Whitted, rarely_asked,
};
use crate::output::{self, Display, Provenance};
use crate::render::target::{Outcome, render_to};
use crate::render::{self, Options, Rendered};
use crate::sampling::stream::Sampler;
use crate::scene::{Scene, build::film_size, field::Field};
use clap::{Args, ValueEnum};
use serde_json::json;
use std::path::PathBuf;

/// Render a scene.
///
/// The picture is a pure function of scene, integrator, seed and samples per pixel. Ctrl-C keeps what
/// is there; a second one ends at once.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Render {
    /// A scene of the gallery (see `halfdisk scenes`), or a path to a .toml file
    scene: String,
    /// How light is computed
    #[arg(long, value_enum, default_value_t = Method::Path)]
    integrator: Method,
    #[command(flatten)]
    ending: Ending,
    /// Longest path in segments: the camera ray is the first, the one to the light the last
    /// [default: the scene's suggestion]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u32..=100_000))]
    max_depth: Option<u32>,
    /// How the samples of a pixel lie to each other [default: sobol for path, else independent]
    #[arg(long, value_enum)]
    sampler: Option<Points>,
    /// Image size in pixels, such as 640x480 [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Seed of all random numbers: the same seed gives the same bytes
    #[arg(long, default_value_t = 0, allow_negative_numbers = true, value_parser = whole(0..=u64::MAX))]
    seed: u64,
    /// Threads to render on; changes no bit of the picture [default: one for each core]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u16..=1024))]
    threads: Option<u16>,
    /// The picture: .png for screens, .exr with errors and sample counts, .hdr
    /// [default: out/FILE.png after the scene's file; by another integrator than path out/FILE-NAME.png]
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    maps: Maps,
    /// Print what was rendered as JSON, to stdout
    #[arg(long)]
    json: bool,
    /// Keep every effect at work, those that the scene lacks at no strength: the same picture,
    /// later. For comparisons
    #[arg(long)]
    all_effects: bool,
    /// No progress bar and no report
    #[arg(long, short)]
    quiet: bool,
    #[command(flatten)]
    demand: Demand,
}

const AFTER_HELP: &str = "\
Examples:
  halfdisk render cornell
      a scene of the gallery, as its file suggests, in out/cornell.png
  halfdisk render cornell --integrator normals
      is the geometry right? colours are directions
  halfdisk render mine.toml --size 640x480 --spp 256 --out mine.exr
      a scene of your own, with the error of each pixel beside its value
  halfdisk render gloss --target-error 2% --maps
      as many samples as it takes; and where they are needed
  halfdisk render caustic --time 30s
      the best picture of half a minute, and how good it is
  halfdisk render mine.toml --spp 4 --json --quiet
      a first look, and the facts for a program";

/// The integrators by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Method {
    /// Path tracing with everything: shadow rays, both techniques weighted, roulette; all
    /// materials, lamps and cameras
    Path,
    /// Shadow, mirror and glass rays; no light between diffuse surfaces
    Whitted,
    /// A random walk, all paths L(S|D)*E; finds lamps and sky by chance only, and point and
    /// directional lights never
    Kajiya,
    /// The same walk with a shadow ray to each lamp at diffuse surfaces: the same light with less
    /// noise; of point and directional lights LD(S|D)*E
    NextEvent,
    /// A shadow ray to each lamp and one ray that is diffuse or specular or transmitted, chosen by
    /// the shares of a mixture: the light of next-event
    WhichRay,
    /// The same with both techniques weighted: aiming at every lamp, and finding it by chance
    Combine,
    /// The random walk of kajiya without a longest path: it ends by Russian roulette
    Roulette,
    /// Debugging view: the normal at the first hit, as colour
    Normals,
    /// Debugging view: the share of light the first hit sends back
    Albedo,
    /// Debugging view: the distance to the first hit (white is the farthest)
    Depth,
}

/// The samplers by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Points {
    /// Each sample without regard to the others; their scatter tells the error of their mean
    Independent,
    /// Owen-scrambled Sobol' points in runs of up to 64: evenly spread, so the error is smaller; the
    /// scatter of the runs tells it; best with 16, 32 or a multiple of 64 samples per pixel
    Sobol,
}

pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let (width, height) = text.split_once(['x', 'X']).unwrap_or_default();
    let (Ok(width), Ok(height)) = (width.parse(), height.parse()) else {
        return Err("a size is two whole numbers, such as 640x480".to_owned());
    };
    // The same bounds as for a scene file, but it is not the file that is wrong here.
    film_size(&Field::top(), [width, height]).map_err(|problem| problem.what)
}

impl Render {
    pub(super) fn run(self) -> Result<(), Stop> {
        if cfg!(debug_assertions) && !self.quiet {
            tell("note: built for development; `cargo run --release` is several times faster");
        }
        let Setup { mut scene, wanted } = self.demand.load(&self.scene, |description| {
            if let Some(size) = self.size {
                description.film.size = size.map(i64::from);
            }
        })?;
        if wanted.is_some() && self.integrator != Method::Path {
            return Err(Stop::Input(format!(
                "--integrator {}: only `path` knows which paths it follows, and can leave some out",
                self.integrator.name()
            )));
        }
        if self.all_effects {
            scene = scene.with_all_effects();
        }
        if self.all_effects && self.integrator != Method::Path {
            return Err(Stop::Input(format!(
                "--all-effects: only `path` leaves out what a scene lacks, not `{}`",
                self.integrator.name()
            )));
        }
        let max_depth = self.max_depth(&scene)?;
        // Checked before any work, so that none is lost to a misspelt name or a closed folder.
        let path = self.path();
        output::prepare(&path, &scene)?;
        for map in self.maps.pictures(&path) {
            output::prepare(&map, &scene)?;
        }
        use_threads(self.threads)?;

        let mut left_out = self
            .integrator
            .named()
            .map(|named| LeftOut::new(&scene, named, wanted.as_ref()));
        if !self.quiet
            && let Some(left_out) = &left_out
        {
            tell(left_out.notes(&scene));
        }
        let outcome = match (self.integrator, self.integrator.named()) {
            (Method::Normals, _) => self.with(&scene, &Normals),
            (Method::Albedo, _) => self.with(&scene, &Albedo),
            (Method::Depth, _) => self.with(&scene, &Depth),
            (_, named) => match &wanted {
                None => self.with(&scene, &named.unwrap_or(Named::Path).with(max_depth)),
                Some(wanted) => {
                    let path = PathTracer::new(max_depth);
                    let paths = &wanted.eye_first;
                    self.with(&scene, &Restricted { path, paths })
                }
            },
        };
        let rendered = &outcome.rendered;
        if rendered.interrupted && rendered.film.pixels().iter().all(|p| p.count() == 0) {
            tell("interrupted before the first sample: nothing is written");
            return Err(Stop::Interrupted);
        }
        left_out.iter_mut().for_each(|l| l.see(&scene, rendered));
        let display = match self.integrator {
            Method::Normals | Method::Albedo => Display::Data { white: 1.0 },
            Method::Depth => Display::Data {
                white: rendered.film.max(),
            },
            _ => Display::Radiance,
        };
        let (spp, seed) = (u64::from(outcome.spp), outcome.seed);
        let facts = Provenance {
            sampler: self.sampler(),
            ..Provenance::new(&scene, &self.integrator.name(), max_depth, spp, seed)
        };
        // All files first: what follows is for people, or may fail.
        let kept = output::write_somewhere(&path, &rendered.film, display, &facts)?;
        let path = &kept.path;
        let goal = self.ending.goal();
        let maps = self.maps.write(path, &rendered.film, &goal);
        let biased = !self.demand.is_everything() && !rendered.interrupted;
        let bias = if biased {
            let quiet = Bar::hidden(on_ctrl_c());
            self.demand
                .bias(&self.scene, scene.size, outcome.spp, &quiet)?
        } else {
            None
        };
        let unmeasured = biased && bias.is_none();
        let too_bright = self.too_bright(&scene, rendered, max_depth);
        let black = left_out
            .as_ref()
            .filter(|_| rendered.is_black())
            .map(|left_out| left_out.why_black(&scene, max_depth));
        let asked = self.rarely_asked(&scene, rendered, max_depth);
        if !self.quiet {
            let mut text = report(&scene, &outcome, self.sampler(), too_bright);
            text += &asked.map_or_else(String::new, rarely_asked_line);
            let left_out = left_out.as_ref();
            text += &left_out.map_or_else(String::new, LeftOut::after);
            text += &stop::report(&outcome, &goal, self.sampler(), left_out);
            if let Some(why) = &black {
                text += &format!("the picture is black: {why}\n");
            }
            if let Some(bias) = &bias {
                text += &bias_line(bias);
            } else if unmeasured {
                text +=
                    "interrupted: the picture is complete, but what it lacks was not measured\n";
            }
            text += &format!("wrote {}", path.display());
            if let Ok((maps, missing)) = &maps {
                maps.iter()
                    .for_each(|map| text += &format!("\nwrote {map}"));
                missing
                    .iter()
                    .for_each(|why| text += &format!("\nnote: {why}"));
            }
            tell(text);
        }
        let mut printed = Ok(());
        if self.json {
            let mut object = as_json(&scene, &facts, &outcome, too_bright, path);
            let written = maps.as_ref().map_or(&[][..], |(maps, _)| maps);
            object["accuracy"] = stop::as_json(&outcome, &goal, self.sampler());
            object["maps"] = json!(written);
            object["black"] = json!(black);
            object["rarely_asked"] = json!(asked);
            object["lamps_unmet"] = json!(left_out.as_ref().map_or(0, LeftOut::unmet));
            object["left_out"] = json!(left_out.map(|left_out| left_out.as_json(bias.as_ref())));
            printed = answer(&(serde_json::to_string_pretty(&object)? + "\n"));
        }
        if let Some(what) = kept.complaint() {
            return Err(Stop::Failure(what));
        }
        maps?;
        printed?;
        if rendered.interrupted || unmeasured {
            return Err(Stop::Interrupted);
        }
        Ok(())
    }

    fn with(&self, scene: &Scene, integrator: &impl Integrator) -> Outcome {
        let options = Options {
            spp: self.ending.spp(scene.suggested.spp),
            seed: self.seed,
            sampler: self.sampler(),
            ..Options::default()
        };
        let stop = on_ctrl_c();
        let bar = if self.quiet {
            Bar::hidden(stop)
        } else {
            Bar::new(&scene.name, stop)
        };
        render_to(scene, integrator, &options, &self.ending.goal(), &bar)
    }

    /// Lights that the choice of one at each surface hardly meets in this picture.
    fn rarely_asked(
        &self,
        scene: &Scene,
        rendered: &Rendered,
        max_depth: u32,
    ) -> Option<RarelyAsked> {
        let samples = rendered.film.pixels().iter().map(|p| p.count()).sum();
        match self.integrator {
            Method::Path => rarely_asked(scene, max_depth, samples),
            _ => None,
        }
    }

    /// Pixels that show more light than there can be.
    fn too_bright(&self, scene: &Scene, rendered: &Rendered, max_depth: u32) -> usize {
        let longest = match self.integrator {
            Method::Normals | Method::Albedo | Method::Depth => return 0,
            Method::Roulette => u32::MAX,
            _ => max_depth,
        };
        let bound = scene.brightest(longest);
        bound.map_or(0, |bound| render::too_bright(&rendered.film, bound))
    }

    /// Where the picture goes.
    fn path(&self) -> PathBuf {
        self.out.clone().unwrap_or_else(|| {
            let mut name = stem(&self.scene);
            if self.integrator != Method::Path {
                name += &format!("-{}", self.integrator.name());
            }
            name += &self.demand.suffix();
            PathBuf::from("out").join(name + ".png")
        })
    }

    fn sampler(&self) -> Sampler {
        match (self.sampler, self.integrator) {
            (Some(Points::Sobol), _) | (None, Method::Path) => Sampler::Sobol,
            _ => Sampler::Independent,
        }
    }

    fn max_depth(&self, scene: &Scene) -> Result<u32, Stop> {
        match self.max_depth {
            Some(depth) if self.integrator == Method::Whitted && depth > Whitted::MAX_DEPTH => {
                Err(Stop::Input(format!(
                    "--max-depth {depth}: the tree of `whitted` may double with each segment, \
                     so it ends at {} at the latest",
                    Whitted::MAX_DEPTH
                )))
            }
            Some(depth) => Ok(depth),
            None if self.integrator == Method::Whitted => {
                Ok(scene.suggested.max_depth.min(Whitted::MAX_DEPTH))
            }
            None => Ok(scene.suggested.max_depth),
        }
    }
}

impl Method {
    /// The integrator of that name; `None` for views of something else than light.
    fn named(self) -> Option<Named> {
        match self {
            Method::Path => Some(Named::Path),
            Method::Whitted => Some(Named::Whitted),
            Method::Kajiya => Some(Named::Kajiya),
            Method::NextEvent => Some(Named::NextEvent),
            Method::WhichRay => Some(Named::WhichRay),
            Method::Combine => Some(Named::Combine),
            Method::Roulette => Some(Named::Roulette),
            Method::Normals | Method::Albedo | Method::Depth => None,
        }
    }

    fn name(self) -> String {
        self.to_possible_value()
            .map_or_else(String::new, |v| v.get_name().to_owned())
    }
}
