//! The gallery page: every chapter's pictures, charts and numbers, and the ledger.

use super::Stop;
use crate::desk::Record;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, context};

/// The page as HTML; pictures are linked from the folders beside it.
pub(super) fn html(records: &[Record]) -> Result<String, Stop> {
    let mut environment = Environment::new();
    environment.set_auto_escape_callback(|_| AutoEscape::Html);
    let failure = |e: minijinja::Error| Stop::Failure(format!("the gallery page: {e:#}"));
    environment
        .add_template("page", include_str!("page.html"))
        .map_err(failure)?;
    let chapters: Vec<_> = records
        .iter()
        .map(|record| {
            let lines: Vec<String> = record.numbers.values().map(|n| n.line()).collect();
            context! { record => Serde(record), lines }
        })
        .collect();
    environment
        .get_template("page")
        .and_then(|page| page.render(context! { chapters }))
        .map_err(failure)
}
