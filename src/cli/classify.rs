//! `halfdisk classify`.

use super::{Stop, answer, stem};
use crate::desk::{Bar, on_ctrl_c, tell, whole};
use crate::effects::by_class::by_class;
use crate::effects::language::{self, Class, Finds, finds};
use crate::effects::words::{Words, words_watched};
use crate::integrators::{Entry, LADDER, Path};
use crate::notation::Word;
use crate::numeric::count;
use crate::output::{self, Display, Provenance};
use crate::render::{Film, Options, Recorded};
use crate::sampling::stream::Sampler;
use crate::scene::{Scene, gallery};
use clap::Args;
use serde_json::json;
use std::path::PathBuf;

/// Sort a scene's light by its paths, written as words from the light to the eye: L light, D diffuse,
/// S mirror or glass, G gloss, E eye.
///
/// Prints how much light each word and each class of words brings, and which integrator finds which
/// class; writes a strip of pictures, one for each class, that add up to the last. Ctrl-C keeps the
/// samples that are finished.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Classify {
    /// A scene of the gallery (see `halfdisk scenes`), or a path to a .toml file
    scene: String,
    /// Samples per pixel
    #[arg(long, default_value_t = 32, allow_negative_numbers = true, value_parser = whole(4_u32..=65_536))]
    spp: u32,
    /// Image size in pixels, such as 320x240 [default: the scene's, at most 256 pixels high]
    #[arg(long, value_name = "WxH", value_parser = super::render::size)]
    size: Option<[u32; 2]>,
    /// Words to print
    #[arg(long, default_value_t = 12, allow_negative_numbers = true, value_parser = whole(0..=usize::MAX))]
    words: usize,
    /// Seed of all random numbers
    #[arg(long, default_value_t = 0, allow_negative_numbers = true, value_parser = whole(0..=u64::MAX))]
    seed: u64,
    /// Folder for the pictures [default: out/classify/FILE, after the scene's file]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print all of it as JSON
    #[arg(long)]
    json: bool,
}

const AFTER_HELP: &str = "\
Examples:
  halfdisk classify caustic
      words with their share of the light, classes, and a strip of pictures
  halfdisk render caustic --paths 'LS+DE'
      one class alone, as a picture";

/// Renders whose scatter tells the error of a share.
const REPLICATES: u32 = 4;
/// Height of pictures nobody asked for in another size.
const HEIGHT: u32 = 256;

/// The same shape at most so high.
fn small([width, height]: [u32; 2]) -> [u32; 2] {
    let smaller = height.min(HEIGHT);
    let narrower = u64::from(width) * u64::from(smaller) / u64::from(height);
    [narrower.max(1) as u32, smaller]
}

/// A class and its picture.
struct Sorted {
    class: Class,
    film: Film,
}

impl Classify {
    pub(super) fn run(self) -> Result<(), Stop> {
        let scene = gallery::load(&self.scene)?;
        let size = self.size.unwrap_or_else(|| small(scene.size));
        let scene = scene.sized(size);
        let Some(paths) = language::of_scene(&scene.inventory) else {
            return Err(Stop::Input(format!(
                "{}: no light reaches the eye, so there is nothing to sort (see `halfdisk effects`)",
                scene.name
            )));
        };
        let folder = self.out.clone();
        let folder =
            folder.unwrap_or_else(|| PathBuf::from("out/classify").join(stem(&self.scene)));
        let strip = folder.join("strip.png");
        output::prepare(&strip, &scene)?;

        let path = Path::new(scene.suggested.max_depth);
        let options = Options {
            spp: self.spp,
            seed: self.seed,
            sampler: Sampler::Sobol,
            ..Options::default()
        };
        let spp = u64::from(self.spp);
        let facts = Provenance::new(&scene, "path", path.max_depth, spp, self.seed);
        let there = |class: &Class| finds(&Path::ENTRY, *class, &scene.inventory) != Finds::Absent;
        let classes: Vec<Class> = Class::ALL.into_iter().filter(there).collect();
        let bar = Bar::new("classes", on_ctrl_c());
        let Recorded {
            rendered, pictures, ..
        } = by_class(&scene, path, &classes, &options, &bar);
        drop(bar);
        let fewest = rendered.film.pixels().iter().map(|p| p.count()).min();
        if rendered.interrupted && fewest == Some(0) {
            tell("interrupted before the first sample: nothing is written");
            return Err(Stop::Interrupted);
        }
        let sorted: Vec<Sorted> = (classes.into_iter().zip(pictures))
            .map(|(class, film)| Sorted { class, film })
            .collect();
        let whole = &rendered.film;
        let off = largest_difference(&sorted, whole);
        let films = sorted.iter().map(|s| &s.film).chain([whole]);
        let films: Vec<&Film> = films.collect();
        let kept =
            output::write_somewhere(&strip, &Film::beside(&films), Display::Radiance, &facts)?;
        let strip = &kept.path;

        let quarter = Options {
            spp: self.spp / REPLICATES,
            ..options
        };
        let bar = Bar::new("words", on_ctrl_c());
        let words = match rendered.interrupted {
            true => None,
            false => words_watched(&scene, &path, &quarter, REPLICATES, &bar),
        };
        drop(bar);
        if self.json {
            let words = words.as_ref();
            let mut object = as_json(&scene, words, &sorted, &strip.display().to_string());
            object["sum_is_off_by"] = json!(off);
            object["interrupted"] = json!(words.is_none());
            answer(&(serde_json::to_string_pretty(&object)? + "\n"))?;
        } else {
            tell(format_args!("wrote {}", strip.display()));
            let mut text = format!("{}: paths {paths}\n", scene.name);
            if let Some(words) = &words {
                text += &describe_words(words, self.words);
            }
            text += &describe_classes(&scene, &sorted);
            text += &format!("the classes add up to the picture within {off:.0e} of its mean\n");
            answer(&text)?;
        }
        if let Some(what) = kept.complaint() {
            return Err(Stop::Failure(what));
        }
        if rendered.interrupted {
            let fewest = fewest.unwrap_or(0);
            tell(format_args!(
                "interrupted: the classes have at least {fewest} of {spp} samples, the words were not counted"
            ));
            return Err(Stop::Interrupted);
        }
        if words.is_none() {
            tell("interrupted: all classes are kept, the words were not counted");
            return Err(Stop::Interrupted);
        }
        Ok(())
    }
}

/// By how much the sum of all classes misses the whole picture, in the worst pixel, relative to the
/// picture's mean: rounding, for both come from the same samples.
fn largest_difference(sorted: &[Sorted], whole: &Film) -> f64 {
    let pictures: Vec<_> = sorted.iter().map(|s| s.film.picture().values).collect();
    let mut worst = 0.0_f64;
    for (i, pixel) in whole.picture().values.iter().enumerate() {
        for c in 0..3 {
            let sum: f64 = pictures.iter().map(|p| p[i][c]).sum();
            worst = worst.max((sum - pixel[c]).abs());
        }
    }
    worst / whole.mean().0
}

fn percent(value: f64, error: f64) -> String {
    format!("{:>7.3} ± {:.3} %", 100.0 * value, 100.0 * error)
}

fn describe_words(words: &Words, shown: usize) -> String {
    let total = words.total.mean();
    let mut by_share: Vec<_> = words.shares.iter().collect();
    by_share.sort_by(|a, b| b.1.light.mean().total_cmp(&a.1.light.mean()));
    let mut text = "\nword         share of the light\n".to_owned();
    for (word, share) in by_share.iter().take(shown) {
        let light = &share.light;
        let line = percent(light.mean() / total, light.std_error() / total);
        text += &format!("{:<12} {line}\n", word.to_string());
    }
    if let Some(rest) = by_share.get(shown..).filter(|rest| !rest.is_empty()) {
        let light: f64 = rest.iter().map(|(_, share)| share.light.mean()).sum();
        let label = count(rest.len(), "other", "others");
        text += &format!("{label:<12} {:>7.3} %\n", 100.0 * light / total);
    }
    text
}

fn describe_classes(scene: &Scene, sorted: &[Sorted]) -> String {
    let total: f64 = sorted.iter().map(|s| s.film.mean().0).sum();
    let mut text = format!("\n{:<35} {:<25} share of the light\n", "class", "words");
    for Sorted { class, film } in sorted {
        let (mean, error) = film.mean();
        let share = percent(mean / total, error / total);
        text += &format!("{:<35} {:<25} {share}\n", class.name(), class.text());
    }
    text += &format!(
        "\n{:<25} {}\n",
        "found by",
        LADDER.map(|entry| entry.name).join("  ")
    );
    for Sorted { class, .. } in sorted {
        text += &format!("{:<26}", class.text());
        for entry in LADDER {
            let mark = match finds(&entry, *class, &scene.inventory) {
                Finds::All => "all",
                Finds::Part => "part",
                Finds::Nothing | Finds::Absent => "-",
            };
            text += &format!("{mark:<width$}", width = entry.name.len() + 2);
        }
        text = text.trim_end().to_owned() + "\n";
    }
    let missed: Vec<String> = LADDER
        .iter()
        .filter_map(|entry| missing(entry, scene))
        .collect();
    text + &missed.concat()
}

/// The first words an integrator misses of the light of lamps with extent.
fn missing(entry: &Entry, scene: &Scene) -> Option<String> {
    let (all, finds) = (language::of_scene(&scene.inventory)?, entry.finds()?);
    let found = if scene.inventory.light_can_be_met() {
        finds.lamps
    } else {
        finds.points
    };
    let Some(found) = language::paths(&found) else {
        return Some(format!("{} misses all of it\n", entry.name));
    };
    let missing = all.light_first().difference(found.light_first());
    let words: Vec<String> = missing.shortest(6).iter().map(Word::to_string).collect();
    (!words.is_empty()).then(|| format!("{} misses {} …\n", entry.name, words.join(", ")))
}

fn as_json(
    scene: &Scene,
    words: Option<&Words>,
    sorted: &[Sorted],
    strip: &str,
) -> serde_json::Value {
    let by_word = words.map(|words| -> Vec<_> {
        let total = words.total.mean();
        let shares = words.shares.iter();
        shares
            .map(|(word, share)| {
                json!({
                    "word": word.to_string(),
                    "share": {
                        "value": share.light.mean() / total,
                        "error": share.light.std_error() / total,
                    },
                    "paths": share.paths,
                })
            })
            .collect()
    });
    let sum: f64 = sorted.iter().map(|s| s.film.mean().0).sum();
    let classes: Vec<_> = sorted
        .iter()
        .map(|Sorted { class, film }| {
            let (mean, error) = film.mean();
            let found_by: serde_json::Map<String, serde_json::Value> = LADDER
                .iter()
                .map(|entry| {
                    let finds = finds(entry, *class, &scene.inventory);
                    (entry.name.to_owned(), json!(finds))
                })
                .collect();
            json!({
                "class": class,
                "words": class.text(),
                "share": { "value": mean / sum, "error": error / sum },
                "found_by": found_by,
            })
        })
        .collect();
    json!({
        "scene": scene.name,
        "mean": words.map(|words| json!({
            "value": words.total.mean(), "error": words.total.std_error(),
        })),
        "words": by_word,
        "classes": classes,
        "strip": strip,
    })
}
