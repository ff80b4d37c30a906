//! Prepares the whole book: every page is checked and rewritten before anything fails.

use std::path::{Path, PathBuf};

use mdbook_preprocessor::book::{Book, Chapter};

use crate::data::Run;
use crate::directives::{self, Directive};
use crate::edit::{Problem, rewrite};
use crate::ledger::{self, PageLink};
use crate::live::Live;
use crate::{figures, includes, listings, maths, numbers, terms, typed};

/// What every page is prepared with.
pub struct Preparation {
    /// The folder of the book's sources.
    pub sources: PathBuf,
    /// What to put before a page's path in a problem, so that it leads from the repository's root.
    pub shown_as: PathBuf,
    /// What the tour measured.
    pub run: Run,
    /// The figures that compute.
    pub live: Live,
}

impl Preparation {
    /// Rewrites all pages of the book, or lists all that is wrong with it.
    pub fn prepare(&self, book: &mut Book) -> Result<(), Vec<Problem>> {
        let links: Vec<PageLink> = book
            .chapters()
            .filter_map(|page| {
                Some(PageLink {
                    file: page.path.clone()?,
                    name: page.name.clone(),
                })
            })
            .collect();
        let mut problems = self.terms_too_early(book);
        book.for_each_chapter_mut(|page| problems.extend(self.prepare_page(page, &links)));
        problems.sort();
        problems.dedup();
        if problems.is_empty() {
            Ok(())
        } else {
            Err(problems)
        }
    }

    /// Terms of the glossary that stand on a page before they are explained.
    fn terms_too_early(&self, book: &Book) -> Vec<Problem> {
        let pages = book.chapters().filter_map(|page| {
            let file = page.path.as_deref()?.to_string_lossy().into_owned();
            Some((file, page.content.clone()))
        });
        let found = terms::used_too_early(&pages.collect::<Vec<_>>());
        let problem = |(file, says)| Problem {
            page: self.shown_as.join(file),
            line: 1,
            says,
        };
        found.into_iter().map(problem).collect()
    }

    /// Rewrites one page; what cannot be rewritten is returned instead.
    fn prepare_page(&self, page: &mut Chapter, links: &[PageLink]) -> Vec<Problem> {
        let file = page.source_path.as_deref().unwrap_or(Path::new(""));
        let mut edits = maths::edits(&page.content);
        edits.extend(typed::edits(&page.content));
        edits.extend(directives::edits(&page.content, |directive| {
            self.expand(directive, file, links)
        }));
        match rewrite(&page.content, edits) {
            Ok(text) => {
                let call = self.live.call(file, &text);
                page.content = text + &call;
                Vec::new()
            }
            Err(failures) => failures
                .into_iter()
                .map(|(line, says)| Problem {
                    page: self.shown_as.join(file),
                    line,
                    says,
                })
                .collect(),
        }
    }

    /// The folder that a page's includes are seen from.
    fn beside(&self, file: &Path) -> PathBuf {
        self.sources.join(file.parent().unwrap_or(file))
    }

    /// What stands for a directive on the page in `file`.
    fn expand(
        &self,
        directive: &Directive,
        file: &Path,
        links: &[PageLink],
    ) -> Result<String, String> {
        let Directive {
            source,
            name,
            arguments,
            ..
        } = directive;
        match *name {
            "number" => numbers::expand(arguments, &self.run),
            "figure" => block(directive, figures::expand(arguments, &self.run)?),
            "figures" => block(directive, figures::expand_row(arguments, &self.run)?),
            "live" => block(directive, self.live.expand(arguments, &self.run)?),
            "ledger" => block(
                directive,
                ledger::expand(arguments, &self.run, links, file)?,
            ),
            "include" | "rustdoc_include" => {
                includes::check(arguments, &self.beside(file)).map(|()| source.to_string())
            }
            "listing" => block(directive, listings::expand(arguments, &self.beside(file))?),
            "changes" => block(directive, listings::changes(arguments, &self.beside(file))?),
            "title" => Ok(source.to_string()),
            _ => Err(format!(
                "unknown directive `{name}` (known: changes, figure, figures, include, ledger, \
                 listing, live, number, rustdoc_include, title)"
            )),
        }
    }
}

/// A block of HTML, closed by a blank line as Markdown wants it.
fn block(directive: &Directive, html: String) -> Result<String, String> {
    if directive.alone {
        Ok(html + "\n")
    } else {
        Err("this needs a line of its own".to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::data::tests::fixtures;
    use crate::live::tests::live;

    fn prepared(pages: &[(&str, &str)]) -> Result<Vec<String>, Vec<String>> {
        let preparation = Preparation {
            sources: PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("src"),
            shown_as: PathBuf::from("book/src"),
            run: fixtures(),
            live: live(true),
        };
        let mut book = Book::new();
        for (file, text) in pages {
            book.push_item(Chapter::new(file, text.to_string(), *file, Vec::new()));
        }
        match preparation.prepare(&mut book) {
            Ok(()) => Ok(book.chapters().map(|page| page.content.clone()).collect()),
            Err(problems) => Err(problems.iter().map(Problem::to_string).collect()),
        }
    }

    #[test]
    fn a_page_is_rewritten_in_all_its_parts() {
        let page = "$x$ is {{#number ch01.depth}}.\n\n{{#ledger}}\nEnd.\n{{#include edit.rs}}\n";
        let written = prepared(&[("ch01.md", page)]).unwrap().remove(0);
        assert!(written.starts_with("<math display=\"inline\"><mi>x</mi></math> is 4.\n\n<div"));
        assert!(written.ends_with("</div>\n\nEnd.\n{{#include edit.rs}}\n"));
        assert!(written.contains("<a href=\"ch01.md\">"));
    }

    #[test]
    fn a_page_with_a_live_figure_ends_with_its_script() {
        let written = prepared(&[("a.md", "{{#live path ch01/plot.svg}}\n\nEnd.\n")]).unwrap();
        assert!(written[0].starts_with("<figure data-live=\"path\"><img"));
        assert!(written[0].ends_with("End.\n\n\n<script defer src=\"figures.js\"></script>\n"));
    }

    #[test]
    fn a_term_before_its_explanation_stops_the_book() {
        let glossary = "| **radiance** | what a ray carries | [Light](b.md) |\n";
        let pages = [
            ("a.md", "Radiance."),
            ("b.md", "Radiance is this."),
            ("glossary.md", glossary),
        ];
        let problems = prepared(&pages).unwrap_err();
        assert_eq!(problems.len(), 1);
        assert!(problems[0].starts_with("book/src/a.md:1: `radiance` is explained in b.md"));
    }

    #[test]
    fn a_typed_number_with_too_many_digits_stops_the_book() {
        let problems = prepared(&[("a.md", "One.\n\nIt reads 0.31301.")]).unwrap_err();
        assert_eq!(problems.len(), 1);
        assert!(problems[0].starts_with("book/src/a.md:3: `0.31301` has more than 4 digits"));
    }

    #[test]
    fn nested_pages_are_prepared_too() {
        let mut parent = Chapter::new("a", String::new(), "a.md", Vec::new());
        let child = Chapter::new("b", "$\\foo$".to_string(), "part/b.md", Vec::new());
        parent.sub_items.push(child.into());
        let preparation = Preparation {
            sources: PathBuf::new(),
            shown_as: PathBuf::from("book/src"),
            run: fixtures(),
            live: live(false),
        };
        let problems = preparation
            .prepare(&mut Book::new_with_items(vec![parent.into()]))
            .unwrap_err();
        assert_eq!(problems[0].page, Path::new("book/src/part/b.md"));
    }

    #[test]
    fn all_problems_of_all_pages_are_listed_in_order() {
        let second = "{{#nubmer ch01.depth}}\n\n{{#include nowhere.rs}} $\\foo$\n";
        let first = "See {{#figure ch01/image.png}} and\n{{#number ch02.depth}}";
        let problems = prepared(&[("ch02.md", second), ("ch01.md", first)]).unwrap_err();
        let starts = [
            "book/src/ch01.md:1: {{#figure ch01/image.png}}: this needs a line of its own",
            "book/src/ch01.md:2: {{#number ch02.depth}}: unknown chapter: `ch02` (known: ch01); ",
            "book/src/ch02.md:1: {{#nubmer ch01.depth}}: unknown directive `nubmer` (known: ",
            "book/src/ch02.md:3: bad formula `\\foo`: ",
            "book/src/ch02.md:3: {{#include nowhere.rs}}: cannot read `nowhere.rs`: ",
        ];
        assert_eq!(problems.len(), starts.len());
        for (problem, start) in problems.iter().zip(starts) {
            assert!(problem.starts_with(start), "{problem}");
        }
    }
}
