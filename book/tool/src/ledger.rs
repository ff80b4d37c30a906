//! `{{#ledger}}`: what every chapter paid and what it got, in one table.
//!
//! Variance and efficiency are in the data, and not in the table: each chapter estimates something else, so
//! that nobody could compare two rows of them.

use std::path::{Path, PathBuf};

use crate::data::{Compared, Ledger, REMEDY, Run};
use crate::digits::{ERROR_DIGITS, plain, significant};
use crate::markup::escape;

/// Stands for what a chapter does not compare.
const NOTHING: &str = "–";

/// A page of the book, as a place to link to.
pub struct PageLink {
    /// The page's file below the book's sources.
    pub file: PathBuf,
    /// Its name, which begins with the number of the chapter.
    pub name: String,
}

/// The table, for the page whose file is `here`; chapters without a ledger are left out, and what is no
/// chapter, such as the pictures of the reference pages.
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
    for key in run.chapters().filter(|key| key.starts_with("ch")) {
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
        "<div class=\"table-wrapper\"><table class=\"ledger\"><thead><tr><th>Chapter, and what it gains</th>\
         <th>Rays in all</th><th>Seconds in all</th><th>Known truths compared</th><th>Largest |z| of them</th>\
         <th>Surprising from</th></tr></thead><tbody>{rows}</tbody></table></div>"
    ))
}

fn row(name: &str, ledger: &Ledger) -> String {
    let compared = |cell: fn(&Compared) -> String| {
        (ledger.compared.as_ref()).map_or(NOTHING.to_string(), cell)
    };
    let cells = [
        plain(ledger.rays),
        significant(ledger.seconds, ERROR_DIGITS),
        compared(|c| plain(c.comparisons)),
        compared(largest),
        compared(|c| significant(c.surprising, ERROR_DIGITS)),
    ];
    let gain = escape(&ledger.gain);
    format!(
        "<tr><td>{name}<p>{gain}</p></td><td>{}</td></tr>",
        cells.join("</td><td>")
    )
}

/// The largest |z|; that of an estimate without an error that is not the truth has no end.
fn largest(compared: &Compared) -> String {
    match compared.largest_z {
        Some(z) => significant(z, ERROR_DIGITS),
        None => "∞".to_string(),
    }
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
                 <td>1.2</td><td>24</td><td>2.8</td><td>4.1</td></tr>"
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
        // Pictures are no chapter, and spend nothing that a chapter could be measured by.
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fixtures");
        let pictures = Run::load(folder.join("pictures"));
        assert!(refusal(&[], &pictures).starts_with("no chapter has a ledger"));
        assert_eq!(
            refusal(&["ch01"], &fixtures()),
            "the ledger takes no arguments"
        );
    }
}
