//! `{{#ledger}}`: what every chapter paid and what it got, in one table.

use std::path::{Path, PathBuf};

use crate::data::{Compared, Ledger, REMEDY, Run};
use crate::digits::{ERROR_DIGITS, plain, significant};
use crate::markup::escape;

/// Digits shown of what was measured: enough to compare chapters.
const DIGITS: usize = 3;
/// Stands for what a chapter does not estimate.
const NOTHING: &str = "–";

/// A page of the book, as a place to link to.
pub struct PageLink {
    /// The page's file below the book's sources.
    pub file: PathBuf,
    /// Its name, which begins with the number of the chapter.
    pub name: String,
}

/// The table, for the page whose file is `here`; chapters without a ledger are left out.
pub fn expand(
    arguments: &[&str],
    run: &Run,
    pages: &[PageLink],
    here: &Path,
) -> Result<String, String> {
    if !arguments.is_empty() {
        return Err("the ledger takes no arguments".to_string());
    }
    let mut rows = String::new();
    for key in run.chapters() {
        let chapter = run.chapter(key)?;
        if let Some(ledger) = &chapter.ledger {
            let name = linked_name(key, &chapter.title, pages, here);
            rows.push_str(&row(&name, ledger));
        }
    }
    if rows.is_empty() {
        return Err(format!("no chapter has a ledger; {REMEDY}"));
    }
    Ok(format!(
        "<div class=\"table-wrapper\"><table class=\"ledger\"><thead><tr><th>Chapter</th>\
         <th>Rays</th><th>Seconds</th><th>Variance</th><th>Largest |z|, of how many</th>\
         <th>Surprising from</th><th>Efficiency</th></tr></thead><tbody>{rows}</tbody></table></div>"
    ))
}

fn row(name: &str, ledger: &Ledger) -> String {
    let measured = |value: Option<f64>, digits| {
        value.map_or(NOTHING.to_string(), |value| significant(value, digits))
    };
    let cells = [
        plain(ledger.rays),
        significant(ledger.seconds, DIGITS),
        measured(ledger.variance, DIGITS),
        (ledger.compared.as_ref()).map_or(NOTHING.to_string(), of_how_many),
        measured(ledger.compared.as_ref().map(|c| c.surprising), ERROR_DIGITS),
        measured(ledger.efficiency, DIGITS),
    ];
    let gain = escape(&ledger.gain);
    format!(
        "<tr><td>{name}<p>{gain}</p></td><td>{}</td></tr>",
        cells.join("</td><td>")
    )
}

/// The largest |z| beside the number of comparisons, without which it says nothing.
fn of_how_many(compared: &Compared) -> String {
    let largest = match compared.largest_z {
        Some(z) => significant(z, DIGITS),
        None => "∞".to_string(),
    };
    format!("{largest} of {}", plain(compared.comparisons))
}

/// The chapter's name, linked if the book has a page `key.md` or `key-….md`.
fn linked_name(key: &str, title: &str, pages: &[PageLink], here: &Path) -> String {
    let is_its_page = |page: &&PageLink| {
        let stem = page.file.file_stem().unwrap_or_default().to_string_lossy();
        (stem.strip_prefix(key)).is_some_and(|rest| rest.is_empty() || rest.starts_with('-'))
    };
    match pages.iter().find(is_its_page) {
        Some(page) => {
            let up = "../".repeat(here.components().count().saturating_sub(1));
            let file = escape(&page.file.to_string_lossy());
            format!("<a href=\"{up}{file}\">{}</a>", escape(&page.name))
        }
        None => escape(title),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::tests::{broken, fixtures};

    fn table(page: &str, here: &str) -> String {
        let pages = [PageLink {
            file: PathBuf::from(page),
            name: "1. From the <eye>".to_string(),
        }];
        expand(&[], &fixtures(), &pages, Path::new(here)).unwrap()
    }

    #[test]
    fn a_row_shows_the_account_and_the_gain() {
        let html = table("ch01.md", "ledger.md").replace('\u{202f}', " ");
        assert!(
            html.contains(
                "<tr><td><a href=\"ch01.md\">1. From the &lt;eye&gt;</a>\
                 <p>Twice the time &amp; a quarter of the noise.</p></td><td>2 000 000</td>\
                 <td>1.25</td><td>–</td><td>2.8 of 24</td><td>4.1</td><td>65</td></tr>"
            ),
            "{html}"
        );
    }

    #[test]
    fn links_lead_from_the_page_that_holds_the_ledger() {
        let html = table("part/ch01-eye.md", "back/ledger.md");
        assert!(html.contains("href=\"../part/ch01-eye.md\""), "{html}");
    }

    #[test]
    fn a_page_of_another_chapter_is_not_linked() {
        let html = table("ch010.md", "ledger.md");
        assert!(html.contains("<td>From the eye<p>"), "{html}");
    }

    #[test]
    fn broken_or_missing_data_and_arguments_are_refused() {
        let refusal = |arguments: &[&str], run: &Run| {
            expand(arguments, run, &[], Path::new("ledger.md")).unwrap_err()
        };
        assert!(refusal(&[], &broken()).starts_with("cannot read ch01/data.json"));
        let empty = Run::load(PathBuf::from("nowhere"));
        assert!(refusal(&[], &empty).starts_with("no chapter has a ledger"));
        assert_eq!(
            refusal(&["ch01"], &fixtures()),
            "the ledger takes no arguments"
        );
    }
}
