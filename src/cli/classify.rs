//! `halfdisk classify`.

use super::answer::answer;
use super::{Stop, folder, reduced, sheet};
use crate::integrators::{Entry, LADDER, Path};
use crate::lab::chapter::{Bar, on_ctrl_c, tell, whole};
use crate::lab::effects::by_class::by_class;
use crate::lab::effects::language::{self, Class, Finds, finds};
use crate::lab::effects::words::{Share, Words, words_watched};
use crate::notation::Word;
use crate::numeric::count;
use crate::output::{self, Display as Shades, Provenance};
use crate::render::{Film, Options, Recorded};
use crate::sampling::stream::Sampler;
use crate::scene::{Scene, gallery};
use crate::stats::Measurement;
use clap::Args;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::{self, Display, Formatter};
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
    #[arg(long, value_name = "WxH", value_parser = super::choices::size)]
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

/// A scene's light by its paths.
#[derive(Serialize)]
struct Sorted {
    scene: String,
    mean: Option<Measurement>,
    words: Option<Vec<OfWord>>,
    classes: Vec<OfClass>,
    strip: String,
    /// The same pictures under their names, each as bright as it can be shown.
    drawn: Vec<String>,
    sum_is_off_by: f64,
    interrupted: bool,
    /// All paths, as an expression.
    #[serde(skip)]
    paths: String,
    /// Words to print.
    #[serde(skip)]
    shown: usize,
    /// What integrators miss, a line each.
    #[serde(skip)]
    missing: String,
}

/// The light of a word.
#[derive(Serialize)]
struct OfWord {
    word: String,
    share: Measurement,
    paths: u64,
    /// Its part of the picture's mean.
    #[serde(skip)]
    light: f64,
}

/// The light of a class.
#[derive(Serialize)]
struct OfClass {
    class: Class,
    words: &'static str,
    share: Measurement,
    found_by: BTreeMap<&'static str, Finds>,
}

impl Classify {
    pub(super) fn run(self) -> Result<(), Stop> {
        let scene = gallery::load(&self.scene)?;
        let size = self
            .size
            .unwrap_or_else(|| reduced(scene.size, scene.size[1], HEIGHT));
        let scene = scene.sized(size);
        let Some(paths) = language::of_scene(&scene.inventory) else {
            return Err(Stop::Input(format!(
                "{}: no light reaches the eye, so there is nothing to sort (see `halfdisk effects`)",
                scene.name
            )));
        };
        let folder = folder(&self.out, "classify", &self.scene);
        let strip = folder.join("strip.png");
        output::prepare(&strip, &scene)?;
        output::prepare(&folder.join("classes.png"), &scene)?;

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
        let whole = &rendered.film;
        let films: Vec<&Film> = pictures.iter().chain([whole]).collect();
        let kept =
            output::write_somewhere(&strip, &Film::beside(&films), Shades::Radiance, &facts)?;
        // What the strip shows is told even where this cannot be written.
        let (drawn, undrawn) = match sheet(&folder.join("classes"), &scene, &classes, &films) {
            Ok(drawn) => (drawn, None),
            Err(why) => (Vec::new(), Some(why)),
        };

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
        let sorted = Sorted {
            mean: words.as_ref().map(|words| words.total.measurement()),
            words: words.as_ref().map(by_word),
            classes: by_class_of(&scene, &classes, &pictures),
            strip: kept.path.display().to_string(),
            drawn,
            sum_is_off_by: largest_difference(&pictures, whole),
            interrupted: words.is_none(),
            paths: paths.to_string(),
            shown: self.words,
            missing: LADDER.iter().filter_map(|e| missing(e, &scene)).collect(),
            scene: scene.name,
        };
        if !self.json {
            for file in [&sorted.strip].into_iter().chain(&sorted.drawn) {
                tell(format_args!("wrote {file}"));
            }
        }
        answer(&sorted, self.json)?;
        if let Some(what) = kept.complaint() {
            return Err(Stop::Failure(what));
        }
        undrawn.map_or(Ok(()), Err)?;
        if rendered.interrupted {
            let fewest = fewest.unwrap_or(0);
            tell(format_args!(
                "interrupted: the classes have at least {fewest} of {spp} samples, the words were not counted"
            ));
            return Err(Stop::Interrupted);
        }
        if sorted.interrupted {
            tell("interrupted: all classes are kept, the words were not counted");
            return Err(Stop::Interrupted);
        }
        Ok(())
    }
}

/// Draws the classes and, last, all of the light.
fn sheet(
    name: &std::path::Path,
    scene: &Scene,
    classes: &[Class],
    films: &[&Film],
) -> Result<Vec<String>, Stop> {
    let whole = films.last().map_or(0.0, |film| film.mean().0);
    let names = classes.iter().map(|class| (class.name(), class.text()));
    let all: Vec<sheet::OfClass> = names
        .chain([("all light", "L(D|S|G)*E")])
        .zip(films)
        .map(|((name, words), film)| sheet::OfClass {
            name,
            words,
            film,
            share: film.mean().0 / whole,
        })
        .collect();
    let title = format!("{}: the light by its paths", scene.name);
    sheet::write(name, title, &all)
}

/// By how much the sum of all classes misses the whole picture, in the worst pixel, relative to the
/// picture's mean: rounding, for both come from the same samples.
fn largest_difference(pictures: &[Film], whole: &Film) -> f64 {
    let pictures: Vec<_> = pictures.iter().map(|film| film.picture().values).collect();
    let mut worst = 0.0_f64;
    for (i, pixel) in whole.picture().values.iter().enumerate() {
        for c in 0..3 {
            let sum: f64 = pictures.iter().map(|p| p[i][c]).sum();
            worst = worst.max((sum - pixel[c]).abs());
        }
    }
    worst / whole.mean().0
}

fn by_word(words: &Words) -> Vec<OfWord> {
    let total = words.total.mean();
    let of = |(word, share): (&Word, &Share)| OfWord {
        word: word.to_string(),
        share: share.light.measurement().map(|x| x / total),
        paths: share.paths,
        light: share.light.mean(),
    };
    words.shares.iter().map(of).collect()
}

fn by_class_of(scene: &Scene, classes: &[Class], pictures: &[Film]) -> Vec<OfClass> {
    let sum: f64 = pictures.iter().map(|film| film.mean().0).sum();
    let of = |(class, film): (&Class, &Film)| OfClass {
        class: *class,
        words: class.text(),
        share: Measurement::from(film.mean()).map(|x| x / sum),
        found_by: LADDER
            .map(|entry| (entry.name, finds(&entry, *class, &scene.inventory)))
            .into(),
    };
    classes.iter().zip(pictures).map(of).collect()
}

fn percent(share: Measurement) -> String {
    let Measurement { value, error } = share.percent();
    format!("{value:>7.3} ± {error:.3} %")
}

impl Sorted {
    /// The words that bring most of the light.
    fn words(&self, words: &[OfWord], f: &mut Formatter) -> fmt::Result {
        let mut words: Vec<&OfWord> = words.iter().collect();
        words.sort_by(|a, b| b.light.total_cmp(&a.light));
        writeln!(f, "\nword         share of the light")?;
        let (shown, rest) = words.split_at(self.shown.min(words.len()));
        for word in shown {
            writeln!(f, "{:<12} {}", word.word, percent(word.share))?;
        }
        if rest.is_empty() {
            return Ok(());
        }
        let light: f64 = rest.iter().map(|word| word.light).sum();
        let total = self.mean.map_or(1.0, |mean| mean.value);
        let label = count(rest.len(), "other", "others");
        writeln!(f, "{label:<12} {:>7.3} %", 100.0 * light / total)
    }
}

impl Display for Sorted {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        writeln!(f, "{}: paths {}", self.scene, self.paths)?;
        self.words
            .iter()
            .try_for_each(|words| self.words(words, f))?;
        writeln!(f, "\n{:<35} {:<25} share of the light", "class", "words")?;
        for OfClass {
            class,
            words,
            share,
            ..
        } in &self.classes
        {
            writeln!(f, "{:<35} {words:<25} {}", class.name(), percent(*share))?;
        }
        let names = LADDER.map(|entry| entry.name);
        writeln!(f, "\n{:<25} {}", "found by", names.join("  "))?;
        for class in &self.classes {
            let mut line = format!("{:<26}", class.words);
            for name in names {
                let mark = match class.found_by[name] {
                    Finds::All => "all",
                    Finds::Part => "part",
                    Finds::Nothing | Finds::Absent => "-",
                };
                line += &format!("{mark:<width$}", width = name.len() + 2);
            }
            writeln!(f, "{}", line.trim_end())?;
        }
        let off = self.sum_is_off_by;
        write!(f, "{}", self.missing)?;
        for entry in LADDER {
            if let Some(why) = entry.biased {
                writeln!(f, "{} is biased: {why}", entry.name)?;
            }
        }
        writeln!(
            f,
            "the classes add up to the picture within {off:.0e} of its mean"
        )
    }
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
