//! Makes text safe to stand inside HTML, and HTML safe to stand inside Markdown.

/// Escapes plain text for an HTML element or a quoted attribute, on one line.
///
/// One line matters: a blank line would end the block of HTML that the text stands in.
pub fn escape(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words
        .join(" ")
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Rewrites the text between the tags so that Markdown finds no markup of its own in it.
///
/// Inline HTML is not opaque to Markdown: it still sees emphasis in `<mo>*</mo>`, or the border of
/// a table's cell in `<mo>|</mo>`. So every ASCII punctuation mark outside a tag becomes a numeric
/// character reference, except the three that references are written with. A `<` that opens no tag
/// is text too: `x < y` may come as `<mo><</mo>`.
pub fn hide_from_markdown(html: &str) -> String {
    let mut hidden = String::with_capacity(2 * html.len());
    let mut in_tag = false;
    for (at, c) in html.char_indices() {
        in_tag |= c == '<' && html[at + 1..].starts_with(|c: char| c == '/' || c.is_alphabetic());
        match c {
            '\n' | '\r' => hidden.push(' '),
            _ if in_tag || "&#;".contains(c) => hidden.push(c),
            _ if c.is_ascii_punctuation() => hidden.push_str(&format!("&#{};", u32::from(c))),
            _ => hidden.push(c),
        }
        in_tag &= c != '>';
    }
    hidden
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escaped_text_is_one_line_without_markup() {
        assert_eq!(
            escape("a < b &\n\n\"c\" > d"),
            "a &lt; b &amp; &quot;c&quot; &gt; d"
        );
    }

    #[test]
    fn punctuation_hides_in_text_and_stays_in_tags() {
        assert_eq!(
            hide_from_markdown("<mo a=\"x_y\">*</mo>\n<mi>&lt;é</mi><mo/>|<mo><</mo><mo>></mo>"),
            "<mo a=\"x_y\">&#42;</mo> <mi>&lt;é</mi><mo/>&#124;<mo>&#60;</mo><mo>&#62;</mo>"
        );
    }
}
