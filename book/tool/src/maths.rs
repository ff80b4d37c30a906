//! Turns the `$…$` and `$$…$$` of a page into MathML, which browsers draw without any script.

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{ParserError, Storage, push_mathml};

use crate::edit::Edit;
use crate::markup::hide_from_markdown;

/// How mdBook reads Markdown, and maths besides.
pub const DIALECT: Options = Options::ENABLE_TABLES
    .union(Options::ENABLE_FOOTNOTES)
    .union(Options::ENABLE_STRIKETHROUGH)
    .union(Options::ENABLE_TASKLISTS)
    .union(Options::ENABLE_HEADING_ATTRIBUTES)
    .union(Options::ENABLE_SMART_PUNCTUATION)
    .union(Options::ENABLE_DEFINITION_LIST)
    .union(Options::ENABLE_GFM)
    .union(Options::ENABLE_MATH);

/// What an author of a torn formula, or of a price, needs to know.
const LONE_DOLLAR: &str = "this `$` belongs to no formula. Markdown tears formulas at blank lines, \
                           at lines that start like a list (`+ `, `- `) and, in tables, at `|` \
                           (write `\\vert`); it reads none in HTML. A dollar sign is `\\$`";

/// An edit for every formula, and a refusal for every dollar that is left over.
///
/// A left-over dollar is most often half of a formula that Markdown has torn apart and would print
/// as it stands.
pub fn edits(source: &str) -> Vec<Edit> {
    let mut edits = Vec::new();
    let mut in_code = false;
    for (event, span) in Parser::new_ext(source, DIALECT).into_offset_iter() {
        match event {
            Event::Start(Tag::CodeBlock(_)) => in_code = true,
            Event::End(TagEnd::CodeBlock) => in_code = false,
            Event::InlineMath(latex) => edits.push(Edit {
                span,
                text: mathml(&latex, DisplayMode::Inline),
            }),
            Event::DisplayMath(latex) => edits.push(Edit {
                span,
                text: mathml(&latex, DisplayMode::Block),
            }),
            Event::Text(_) | Event::Html(_) if !in_code => {
                let dollars = source[span.clone()].match_indices('$');
                edits.extend(
                    dollars
                        .map(|(at, _)| span.start + at)
                        .filter(|&at| !source[..at].ends_with('\\'))
                        .map(|at| Edit {
                            span: at..at + 1,
                            text: Err(LONE_DOLLAR.to_string()),
                        }),
                );
            }
            _ => {}
        }
    }
    edits
}

/// One formula as MathML on one line.
///
/// A displayed formula stays part of its paragraph, as it is part of the sentence around it. The
/// `<span>` gives it a line of its own and room to scroll; a block of HTML would have to be fenced
/// off with blank lines, which break lists and quotes.
fn mathml(latex: &str, display_mode: DisplayMode) -> Result<String, String> {
    let refusal = |says: &str| {
        let formula: Vec<&str> = latex.split_whitespace().collect();
        format!("bad formula `{}`: {says}", formula.join(" "))
    };
    if latex.contains("{{#") {
        return Err(refusal("a directive cannot stand inside a formula"));
    }
    let storage = Storage::new();
    let events = pulldown_latex::Parser::new(latex, &storage)
        .collect::<Result<Vec<_>, ParserError>>()
        .map_err(|error| refusal(first_line(&error.to_string())))?;
    let config = RenderConfig {
        display_mode,
        ..RenderConfig::default()
    };
    let mut html = String::new();
    push_mathml(
        &mut html,
        events.into_iter().map(Ok::<_, ParserError>),
        config,
    )
    .map_err(|error| refusal(&error.to_string()))?;
    if let Some(element) = wrong_children(&html) {
        // Browsers set a power of three children on the line.
        return Err(refusal(&format!(
            "this becomes invalid MathML, `<{element}>` with a wrong number of parts; instead of `\\cos^2\\theta` \
             write `(\\cos\\theta)^2`"
        )));
    }
    let html = hide_from_markdown(&tighten(html));
    Ok(match display_mode {
        DisplayMode::Inline => html,
        DisplayMode::Block => format!("<span class=\"formula\">{html}</span>"),
    })
}

/// How many children an element of MathML must have, for those where browsers care.
const CHILDREN: [(&str, usize); 8] = [
    ("msup", 2),
    ("msub", 2),
    ("mfrac", 2),
    ("mroot", 2),
    ("mover", 2),
    ("munder", 2),
    ("msubsup", 3),
    ("munderover", 3),
];

/// The first element that has not as many children as it must have, or that does not end.
fn wrong_children(html: &str) -> Option<String> {
    // The elements around the place that is read, each with the number of its children so far.
    let mut open: Vec<(&str, usize)> = Vec::new();
    for tag in html.split('<').skip(1) {
        let inside = tag.split('>').next().unwrap_or_default();
        let name = inside
            .trim_start_matches('/')
            .split([' ', '/'])
            .next()
            .unwrap_or_default();
        if !name.starts_with(char::is_alphabetic) {
            // A sign in the text.
            continue;
        }
        if inside.starts_with('/') {
            let Some((opened, children)) = open.pop() else {
                return Some(name.to_string());
            };
            let must = CHILDREN.iter().find(|(known, _)| *known == name);
            if opened != name || must.is_some_and(|&(_, must)| must != children) {
                return Some(opened.to_string());
            }
        } else {
            if let Some((_, children)) = open.last_mut() {
                *children += 1;
            }
            if !inside.ends_with('/') {
                open.push((name, 0));
            }
        }
    }
    open.pop().map(|(name, _)| name.to_string())
}

/// Takes the space from around bars and slashes: browsers set them like relations, `|x|` as wide
/// as `a = b`, and TeX does not. The micro sign becomes the letter mu, which has an italic.
fn tighten(html: String) -> String {
    let html = html.replace('\u{b5}', "\u{3bc}");
    ["/", "|", "‖"].iter().fold(html, |html, tight| {
        html.replace(
            &format!(">{tight}</mo>"),
            &format!(" lspace=\"0\" rspace=\"0\">{tight}</mo>"),
        )
    })
}

/// The parser's errors go on with a drawing of the place; a problem is one line.
fn first_line(message: &str) -> &str {
    message.lines().next().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::edit::rewrite;

    fn written(source: &str) -> String {
        rewrite(source, edits(source)).unwrap()
    }

    fn refused(source: &str) -> Vec<(usize, String)> {
        rewrite(source, edits(source)).unwrap_err()
    }

    #[test]
    fn formulas_are_replaced_and_the_rest_stays() {
        assert_eq!(
            written("A *b* $x$,\r\n\\$5."),
            "A *b* <math display=\"inline\"><mi>x</mi></math>,\r\n\\$5."
        );
    }

    #[test]
    fn bars_and_slashes_stand_tight_and_relations_do_not() {
        let page = written("$\\lvert x \\rvert / 2 \\mid y = 1$");
        assert_eq!(page.matches("lspace=\"0\"").count(), 3, "{page}");
    }

    #[test]
    fn mu_is_a_letter_and_no_unit() {
        assert!(written("$\\mu$").contains("<mi>\u{3bc}</mi>"));
    }

    #[test]
    fn code_keeps_its_dollars() {
        let source = "`$x$`\n\n```text\n$y$ and $\n```\n\n    $z\n";
        assert_eq!(written(source), source);
    }

    #[test]
    fn a_displayed_formula_is_one_line_even_in_a_quote() {
        assert_eq!(
            written("> So\n> $$\n> x\n> y\n> $$\n"),
            "> So\n> <span class=\"formula\"><math display=\"block\"><mi>x</mi><mi>y</mi></math></span>\n"
        );
    }

    #[test]
    fn what_markdown_would_take_for_its_own_is_hidden() {
        let page = written("| a |\n|---|\n| $\\vert a_1 * b * c_2 \\vert$ |\n");
        let row = page.lines().nth(2).unwrap();
        assert_eq!(row.matches('|').count(), 2, "{row}");
        assert!(!row.contains(['*', '_']), "{row}");
        assert!(row.contains("&#124;"), "{row}");
    }

    #[test]
    fn bad_latex_is_refused_with_its_line_and_formula() {
        let failures = refused("Good: $x$.\n\n$\\foo$ and $$\n\\frac{a}\n$$\n");
        assert_eq!(failures.len(), 2);
        assert_eq!(failures[0].0, 3);
        assert!(failures[0].1.starts_with("bad formula `\\foo`: "));
        assert!(failures[1].1.starts_with("bad formula `\\frac{a}`: "));
        assert!(failures.iter().all(|(_, says)| !says.contains('\n')));
    }

    #[test]
    fn a_power_of_a_functions_name_after_a_factor_is_refused() {
        let failures = refused("$A \\cos^4\\theta$");
        assert!(failures[0].1.contains("invalid MathML"), "{failures:?}");
        assert!(written("$A (\\cos\\theta)^4$").contains("<msup>"));
    }

    #[test]
    fn elements_with_a_wrong_number_of_children_are_noticed() {
        for (html, wrong) in [
            ("<math><msup><mi>x</mi><mn>2</mn></msup></math>", None),
            (
                "<math><mo><</mo><mspace width=\"1em\"/><mi>x</mi></math>",
                None,
            ),
            ("<msup><mspace/><mi>cos</mi><mn>4</mn></msup>", Some("msup")),
            (
                "<msup><mrow><mi>a</mi><mi>b</mi></mrow><mn>2</mn></msup>",
                None,
            ),
            ("<mrow><mfrac><mn>1</mn></mfrac></mrow>", Some("mfrac")),
            ("<msubsup><mi>a</mi><mi>b</mi></msubsup>", Some("msubsup")),
            ("<mrow><mi>a</mi>", Some("mrow")),
            ("<mi>a</mi></mrow>", Some("mrow")),
        ] {
            assert_eq!(wrong_children(html).as_deref(), wrong, "{html}");
        }
    }

    #[test]
    fn a_directive_inside_a_formula_is_refused() {
        let failures = refused("$n = {{#number ch01.n}}$");
        assert!(failures[0].1.contains("cannot stand inside a formula"));
    }

    #[test]
    fn left_over_dollars_are_refused() {
        for torn in [
            "$ x $",
            "$$\nx\n\ny\n$$",
            "$$\nx\n  + y\n$$",
            "| a |\n|---|\n| $|x|$ |\n",
            "<p>$x$</p>",
        ] {
            let failures = refused(torn);
            assert!(
                failures.iter().all(|(_, says)| says == LONE_DOLLAR),
                "{torn}"
            );
        }
    }
}
