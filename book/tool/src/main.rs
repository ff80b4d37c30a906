//! The mdBook preprocessor of the halfdisk book.
//!
//! mdBook passes the book through here before it expands includes. Formulas become MathML; numbers,
//! figures and the ledger come from the data of the last run; includes are checked. Whatever cannot
//! be found fails the build, all of it at once, because a book that prints a wrong number is worse
//! than no book.

mod book;
mod data;
mod digits;
mod directives;
mod edit;
mod figures;
mod includes;
mod ledger;
mod listings;
mod live;
mod markup;
mod maths;
mod numbers;
mod terms;
mod typed;

use std::io;
use std::path::PathBuf;
use std::process::ExitCode;

use mdbook_preprocessor::PreprocessorContext;

use book::Preparation;
use data::Run;
use live::Live;

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    if arguments.next().as_deref() == Some("supports") {
        return match arguments.next().as_deref() {
            Some("html") => ExitCode::SUCCESS,
            _ => ExitCode::FAILURE,
        };
    }
    match prepare_book() {
        Ok(()) => ExitCode::SUCCESS,
        Err(complaints) => {
            eprintln!("{complaints}");
            ExitCode::FAILURE
        }
    }
}

/// Reads the book from the standard input and writes it, prepared, to the standard output.
fn prepare_book() -> Result<(), String> {
    let (context, mut book) = mdbook_preprocessor::parse_input(io::stdin())
        .map_err(|error| format!("cannot understand mdBook: {error:#}"))?;
    preparation(&context)?
        .prepare(&mut book)
        .map_err(|problems| {
            let lines: Vec<String> = problems.iter().map(ToString::to_string).collect();
            lines.join("\n")
        })?;
    serde_json::to_writer(io::stdout(), &book)
        .map_err(|error| format!("cannot answer mdBook: {error}"))
}

/// The settings of this book, of which only the folder of the data can be chosen.
fn preparation(context: &PreprocessorContext) -> Result<Preparation, String> {
    let data = context
        .config
        .get("preprocessor.halfdisk.data")
        .map_err(|error| format!("cannot read book.toml: {error:#}"))?
        .unwrap_or_else(|| PathBuf::from("../out"));
    let sources = &context.config.book.src;
    let folder = context.root.file_name().unwrap_or_default();
    let folder_of_pages = context.root.join(sources);
    Ok(Preparation {
        live: Live::build(&context.root, &folder_of_pages)?,
        sources: folder_of_pages,
        shown_as: PathBuf::from(folder).join(sources),
        run: Run::load(context.root.join(data)),
    })
}
