//! What the last run of the tour measured: one `data.json` a chapter, beside its pictures.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

/// The advice that ends every complaint about data.
pub const REMEDY: &str = "`cargo run --release -- tour` makes the data";

/// All chapters that the run left in its folder, by the name of their sub-folder.
///
/// A chapter whose file cannot be read keeps its complaint, for whoever asks for the chapter.
pub struct Run {
    folder: PathBuf,
    chapters: BTreeMap<String, Result<Chapter, String>>,
}

/// One chapter's measurements; of the file's fields, those that the book shows.
#[derive(Debug, Deserialize)]
pub struct Chapter {
    /// The chapter's title.
    pub title: String,
    /// True for a quick run, whose few samples may not have met all that a page names.
    #[serde(default)]
    pub quick: bool,
    /// Measured numbers by name.
    #[serde(default)]
    pub numbers: BTreeMap<String, Number>,
    /// Pictures, each a file beside the data.
    #[serde(default)]
    pub figures: Vec<Figure>,
    /// The chapter's line in the ledger, if it keeps one.
    pub ledger: Option<Ledger>,
}

/// A measured number.
#[derive(Debug, Deserialize)]
pub struct Number {
    /// The number itself.
    pub value: f64,
    /// Its standard error.
    pub error: Option<f64>,
    /// What theory says it should be.
    pub exact: Option<f64>,
    /// The unit of all three.
    pub unit: Option<String>,
}

/// A picture.
#[derive(Debug, Deserialize)]
pub struct Figure {
    /// The name of its file.
    pub file: String,
    /// What it shows, for readers who see it and for those who do not.
    pub caption: String,
}

/// What a chapter paid, and what it got for it.
#[derive(Debug, Deserialize)]
pub struct Ledger {
    /// Rays traced.
    pub rays: f64,
    /// Seconds spent.
    pub seconds: f64,
    /// How far its results are from known truths, where there are any.
    pub compared: Option<Compared>,
    /// The same in a sentence.
    #[serde(default)]
    pub gain: String,
}

/// The largest of several distances from known truths.
#[derive(Debug, Deserialize)]
pub struct Compared {
    /// The largest, in standard errors; none where it is without end, for which JSON has no word.
    pub largest_z: Option<f64>,
    /// Of so many.
    pub comparisons: f64,
    /// What the largest of so many exceeds by chance once in a thousand runs.
    pub surprising: f64,
}

impl Chapter {
    /// What stands for a number that the chapter lacks: a dash for one that a quick run was too short for, else an
    /// error.
    pub fn without(&self, chapter: &str, name: &str) -> Result<String, String> {
        match self.quick {
            true => Ok("–".to_string()),
            false => Err(unknown(
                &format!("number in {chapter}"),
                name,
                self.numbers.keys(),
            )),
        }
    }
}

impl Run {
    /// Reads every chapter in `folder`; a folder that is not there holds no chapters.
    pub fn load(folder: PathBuf) -> Self {
        let chapters = fs::read_dir(&folder)
            .into_iter()
            .flatten()
            .flatten()
            .filter_map(|entry| entry.file_name().into_string().ok())
            .filter(|name| folder.join(name).join("data.json").is_file())
            .map(|name| {
                let chapter = read(&folder.join(&name).join("data.json"))
                    .map_err(|error| format!("cannot read {name}/data.json: {error}"));
                (name, chapter)
            })
            .collect();
        Self { folder, chapters }
    }

    /// One chapter's measurements.
    pub fn chapter(&self, name: &str) -> Result<&Chapter, String> {
        match self.chapters.get(name) {
            Some(chapter) => chapter.as_ref().map_err(|says| format!("{says}; {REMEDY}")),
            None => Err(unknown("chapter", name, self.chapters.keys())),
        }
    }

    /// The names of all chapters, in order.
    pub fn chapters(&self) -> impl Iterator<Item = &str> {
        self.chapters.keys().map(String::as_str)
    }

    /// A figure, and the path of its picture.
    pub fn figure(&self, chapter: &str, file: &str) -> Result<(&Figure, PathBuf), String> {
        let figures = &self.chapter(chapter)?.figures;
        let known = figures.iter().map(|figure| &figure.file);
        (figures.iter().find(|figure| figure.file == file))
            .map(|figure| (figure, self.folder.join(chapter).join(file)))
            .ok_or_else(|| unknown(&format!("figure in {chapter}"), file, known))
    }
}

fn read(file: &Path) -> Result<Chapter, String> {
    let text = fs::read_to_string(file).map_err(|error| error.to_string())?;
    serde_json::from_str(&text).map_err(|error| error.to_string())
}

/// The sentence for a name that the run does not know.
fn unknown<'a>(kind: &str, name: &str, known: impl Iterator<Item = &'a String>) -> String {
    let known: Vec<&str> = known.map(String::as_str).collect();
    let known = if known.is_empty() {
        "none".to_string()
    } else {
        known.join(", ")
    };
    format!("unknown {kind}: `{name}` (known: {known}); {REMEDY}")
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// The run that the tests of every module read.
    pub fn fixtures() -> Run {
        load("fixtures/good")
    }

    /// A run whose only file is cut off.
    pub fn broken() -> Run {
        load("fixtures/bad")
    }

    fn load(folder: &str) -> Run {
        Run::load(Path::new(env!("CARGO_MANIFEST_DIR")).join(folder))
    }

    #[test]
    fn a_chapter_is_read_with_what_it_leaves_out() {
        let run = fixtures();
        assert_eq!(run.chapters().collect::<Vec<_>>(), ["ch01"]);
        let depth = &run.chapter("ch01").unwrap().numbers["depth"];
        assert_eq!((depth.value, depth.error, depth.exact), (4.0, None, None));
        let ledger = run.chapter("ch01").unwrap().ledger.as_ref().unwrap();
        assert_eq!((ledger.rays, ledger.seconds), (2e6, 1.25));
    }

    #[test]
    fn what_is_unknown_is_refused_with_what_is_known() {
        let run = fixtures();
        for (refusal, says) in [
            (
                run.chapter("ch09").unwrap_err(),
                "chapter: `ch09` (known: ch01)",
            ),
            (
                run.chapter("ch01")
                    .unwrap()
                    .without("ch01", "hits")
                    .unwrap_err(),
                "number in ch01: `hits` (known: depth, hits_3d)",
            ),
            (
                run.figure("ch01", "b.png").unwrap_err(),
                "figure in ch01: `b.png` (known: image.png, lost.png, plot.svg)",
            ),
        ] {
            assert_eq!(refusal, format!("unknown {says}; {REMEDY}"));
        }
        let quick: Chapter = serde_json::from_str(r#"{"title": "Quick", "quick": true}"#).unwrap();
        assert_eq!(quick.without("ch01", "hits").as_deref(), Ok("–"));
        let nothing = Run::load(PathBuf::from("nowhere"));
        assert!(
            nothing
                .chapter("ch01")
                .unwrap_err()
                .contains("(known: none)")
        );
    }

    #[test]
    fn a_broken_file_is_refused_where_it_is_used() {
        let refusal = broken().chapter("ch01").unwrap_err();
        assert!(
            refusal.starts_with("cannot read ch01/data.json: "),
            "{refusal}"
        );
        assert!(refusal.ends_with(REMEDY), "{refusal}");
    }
}
