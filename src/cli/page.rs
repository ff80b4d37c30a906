//! The gallery page: a card for each chapter, with its pictures, numbers and ledger folded below.

mod cards;

use super::Stop;
use crate::lab::chapter::{Number, Record};
use crate::numeric::three_digits;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, Value, context};
use std::path::{Component, Path};

/// The page as HTML, to be saved in `folder`; pictures are linked from the folders beside it. Each record comes
/// with the name of its program.
pub(super) fn html(records: &[(Record, &str)], folder: &Path) -> Result<String, Stop> {
    let home = home(folder);
    let chapters: Vec<_> = records
        .iter()
        .map(|(record, program)| chapter(record, program, folder, home.as_ref()))
        .collect();
    let of_ledgers = |part: fn(&crate::lab::ledger::Ledger) -> f64| -> f64 {
        let ledgers = records.iter().filter_map(|(r, _)| r.ledger.as_ref());
        ledgers.map(part).sum()
    };
    let book = home
        .as_ref()
        .and_then(|home| home.link("book/html/index.html"));
    filled(
        "the gallery page",
        include_str!("page/page.html"),
        context! {
            chapters,
            book,
            hero => hero(records),
            rays => with_unit(of_ledgers(|l| l.rays as f64)),
            seconds => format!("{:.0}", of_ledgers(|l| l.seconds)),
            quick => records.iter().any(|(record, _)| record.quick),
        },
    )
}

/// The picture at the top: that of the last chapter that has one.
fn hero(records: &[(Record, &str)]) -> Option<Value> {
    let mut chapters = records.iter().rev().filter(|(r, _)| r.chapter != "scenes");
    chapters.find_map(|(record, _)| {
        let card = cards::of(&record.chapter)?;
        let figure = record.figures.iter().find(|f| f.file == card.picture)?;
        figure.file.ends_with(".png").then(|| {
            context! { chapter => &record.chapter, file => &figure.file, caption => &figure.caption }
        })
    })
}

/// All that the page says of a chapter.
fn chapter(record: &Record, program: &str, folder: &Path, home: Option<&Home>) -> Value {
    let card = cards::of(&record.chapter);
    let figure = |file: &str| record.figures.iter().find(|f| f.file == file);
    // A chapter without a card, or a run without its picture, still shows something.
    let best = card
        .and_then(|card| figure(card.picture))
        .or(record.figures.last());
    let number = card.and_then(|card| {
        let [name, words] = card.number;
        let number = record.numbers.get(name)?;
        Some(context! { number => shown(number), words })
    });
    // A picture of another chapter is named with its folder.
    let compare = card.and_then(|card| card.compare).and_then(|pair| {
        let pair = pair.map(|[file, word]| match file.contains('/') {
            true => [file.to_owned(), word.to_owned()],
            false => [format!("{}/{file}", record.chapter), word.to_owned()],
        });
        let all = pair.iter().all(|[file, _]| folder.join(file).exists());
        all.then_some(pair)
    });
    let link = |path: &str| home.and_then(|home| home.link(path));
    let pages = [
        format!("book/html/{program}.html"),
        format!("book/src/{program}.md"),
    ];
    let source = format!("chapters/{}/main.rs", program.replace('-', "_"));
    let lines: Vec<String> = record.numbers.values().map(Number::line).collect();
    context! {
        record => Serde(record),
        number_of => record.chapter.trim_start_matches("ch"),
        best => Serde(best),
        number,
        compare => Serde(compare),
        page => pages.iter().find_map(|page| link(page)),
        program => link(&source),
        scene => card.filter(|card| !card.scene.is_empty()).and_then(|card| link(card.scene)),
        lines,
    }
}

/// A number of a card: three digits, whole ones with gaps.
fn shown(number: &Number) -> String {
    let x = number.value;
    let sign = if x < 0.0 { "−" } else { "" };
    let size = x.abs();
    if size < 999.5 && size.fract() != 0.0 {
        let digits = three_digits(size);
        return format!("{sign}{digits}");
    }
    // Of a large number that no count gave, three digits are known at most.
    let whole = if size.fract() == 0.0 || size < 1e4 {
        format!("{size:.0}")
    } else {
        let unit = libm::pow(10.0, libm::floor(libm::log10(size)) - 2.0);
        format!("{:.0}", (size / unit).round() * unit)
    };
    format!("{sign}{}", with_gaps(&whole))
}

/// Digits in groups of three, where there are more than four.
fn with_gaps(digits: &str) -> String {
    if digits.len() < 5 {
        return digits.to_owned();
    }
    let first = digits.len() % 3;
    let mut groups = Vec::new();
    if first > 0 {
        groups.push(&digits[..first]);
    }
    let rest = &digits[first..];
    groups.extend((0..rest.len() / 3).map(|group| &rest[3 * group..3 * group + 3]));
    groups.join("\u{202f}")
}

/// A large number in words.
fn with_unit(x: f64) -> String {
    match x {
        x if x >= 1e9 => format!("{} billion", three_digits(x / 1e9)),
        x if x >= 1e6 => format!("{} million", three_digits(x / 1e6)),
        x => format!("{x:.0}"),
    }
}

/// Where the sources lie, seen from the page.
struct Home {
    sources: std::path::PathBuf,
    /// The way from the page to the sources, which ends with a slash.
    way: String,
}

/// The folder of the sources that this program was built from, if it is still there.
fn home(folder: &Path) -> Option<Home> {
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).canonicalize().ok()?;
    let folder = folder.canonicalize().ok()?;
    let way = match folder.strip_prefix(&sources) {
        Ok(below) => {
            let steps = below
                .components()
                .filter(|c| matches!(c, Component::Normal(_)));
            "../".repeat(steps.count())
        }
        Err(_) => format!("file://{}/", sources.display()),
    };
    Some(Home { sources, way })
}

impl Home {
    /// The link to a file of the sources, if there is one.
    fn link(&self, path: &str) -> Option<String> {
        self.sources
            .join(path)
            .exists()
            .then(|| format!("{}{path}", self.way))
    }
}

/// A page from its template, in which what is filled in is text and no HTML.
pub(super) fn filled(name: &str, template: &str, values: Value) -> Result<String, Stop> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    let page = environment.render_str(template, values);
    page.map_err(|e| Stop::Failure(format!("{name}: {e:#}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::chapter::Figure;
    use crate::lab::ledger::Ledger;
    use crate::stats::z_test::Largest;

    fn record() -> Record {
        let ledger = Ledger {
            compared: Some(Largest { z: 2.796, of: 24 }.into()),
            ..Ledger::of("gained")
        };
        let figure = |file: &str| Figure {
            file: file.to_owned(),
            caption: format!("what {file} shows"),
        };
        Record {
            chapter: "ch01".to_owned(),
            title: "From the eye".to_owned(),
            question: "Why?".to_owned(),
            seed: 1,
            quick: true,
            numbers: [("wasted".to_owned(), Number::new("rays wasted", 380.28))].into(),
            figures: ["light.png", "image.png", "courtyard.png"]
                .map(figure)
                .into(),
            ledger: Some(ledger),
        }
    }

    fn page(record: Record) -> String {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("ch01")).unwrap();
        for figure in &record.figures {
            std::fs::write(folder.path().join("ch01").join(&figure.file), "").unwrap();
        }
        let records = [(record, "ch01-from-the-eye")];
        let page = html(&records, folder.path()).unwrap_or_else(|e| panic!("{e:?}"));
        page.replace("&#x2f;", "/")
    }

    #[test]
    fn the_ledger_gives_the_largest_z_with_the_number_of_comparisons_and_no_sign() {
        let page = page(record());
        assert!(
            page.contains("<td>2.80 of 24</td>\n  <td>4.1</td>"),
            "{page}"
        );
        assert!(!page.contains("+2.80") && !page.contains("bias"), "{page}");
    }

    #[test]
    fn a_card_has_a_picture_a_number_and_links_that_lead_somewhere() {
        let whole = page(record());
        for part in [
            "src=\"ch01/courtyard.png\"",
            "<b>380</b> rays from the lamp are wasted",
            "data-before=\"ch01/light.png\"",
            "/chapters/ch01_from_the_eye/main.rs\">Program",
            "/examples/scenes/courtyard.toml\">Scene",
            "/ch01-from-the-eye.",
        ] {
            assert!(whole.contains(part), "{part} in {whole}");
        }
        // A run that lacks them has a card all the same.
        let mut less = record();
        less.numbers.clear();
        less.figures.truncate(1);
        let less = page(less);
        assert!(less.contains("src=\"ch01/light.png\""), "{less}");
        assert!(!less.contains("<b>380"), "{less}");
        assert!(!less.contains("data-before=\"ch01"), "{less}");
    }

    /// The cards name what the chapters' quick runs, which the tests keep, really have.
    #[test]
    fn every_card_names_what_its_chapter_has() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        for (id, program) in crate::cli::tour::programs_by_id() {
            let card = cards::of(id).unwrap_or_else(|| panic!("{program} has no card"));
            if !card.scene.is_empty() {
                assert!(folder.join(card.scene).exists(), "{id}: {}", card.scene);
            }
            // No snapshot is kept of the pictures of the reference pages.
            if id == "scenes" {
                continue;
            }
            let kept = format!("tests/snapshots/halfdisk__chapters__{id}-data.snap");
            let kept = std::fs::read_to_string(folder.join(kept)).unwrap();
            let compared = card.compare.iter().flatten().map(|[file, _]| *file);
            let own = compared.filter(|file| !file.contains('/'));
            for name in own.chain([card.picture]) {
                assert!(
                    kept.contains(&format!("\"file\": \"{name}\"")),
                    "{id}: {name}"
                );
            }
            let number = format!("\"{}\": ", card.number[0]);
            assert!(kept.contains(&number), "{id}: {number}");
        }
    }

    #[test]
    fn numbers_are_short_and_large_ones_have_gaps() {
        let of = |x| shown(&Number::new("", x));
        assert_eq!(of(380.285), "380");
        assert_eq!(of(-0.4943), "−0.49");
        assert_eq!(of(16383.0), "16\u{202f}383");
        assert_eq!(of(2_684_017.3), "2\u{202f}680\u{202f}000");
        assert_eq!(of(3.0), "3");
        assert_eq!(with_unit(2.284e9), "2.28 billion");
    }
}
