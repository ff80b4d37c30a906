//! The gallery page: every chapter's pictures, charts and numbers, and the ledger.

use super::Stop;
use crate::lab::chapter::Record;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, Value, context};

/// The page as HTML; pictures are linked from the folders beside it.
pub(super) fn html(records: &[Record]) -> Result<String, Stop> {
    let chapter = |record: &Record| {
        let lines: Vec<String> = record.numbers.values().map(|n| n.line()).collect();
        context! { record => Serde(record), lines }
    };
    let chapters: Vec<_> = records.iter().map(chapter).collect();
    filled(
        "the gallery page",
        include_str!("page.html"),
        context! { chapters },
    )
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
    use crate::lab::ledger::Ledger;
    use crate::stats::z_test::Largest;

    #[test]
    fn the_ledger_gives_the_largest_z_with_the_number_of_comparisons_and_no_sign() {
        let ledger = Ledger {
            compared: Some(Largest { z: 2.796, of: 24 }.into()),
            ..Ledger::of("gained")
        };
        let record = Record {
            chapter: "ch01".to_owned(),
            title: "From the eye".to_owned(),
            question: String::new(),
            seed: 1,
            quick: true,
            numbers: Default::default(),
            figures: Vec::new(),
            ledger: Some(ledger),
        };
        let page = html(&[record]).unwrap_or_else(|e| panic!("{e:?}"));
        assert!(
            page.contains("<td>2.80 of 24</td>\n  <td>4.1</td>"),
            "{page}"
        );
        assert!(!page.contains("+2.80") && !page.contains("bias"), "{page}");
    }
}
