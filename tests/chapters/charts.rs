//! What the charts of chapters say, and that they can be read where the book shows them.

use std::fs;
use std::path::Path;

/// Drawings that are compared byte by byte: curves, bars, a map, rays, a tree.
pub const ONE_OF_EACH_KIND: [&str; 5] = [
    "ch08-energy",
    "ch08-chart",
    "ch18-variance",
    "ch01-from_eye",
    "ch02-tree",
];

/// Letters are at least so many pixels high.
const LEAST: f64 = 11.0;
/// Width of the book's column, and of one of two figures side by side.
const COLUMN: f64 = 720.0;
const HALF: f64 = 348.0;

/// The width that the book has for a figure, `chapter/file`: every figure is on a page, and no page
/// shrinks it.
fn width_in_the_book(figure: &str) -> f64 {
    let pages = Path::new(env!("CARGO_MANIFEST_DIR")).join("book/src");
    for page in fs::read_dir(pages).unwrap() {
        let text = fs::read_to_string(page.unwrap().path()).unwrap_or_default();
        let shows = |line: &&str| line.starts_with("{{#figure") || line.starts_with("{{#live");
        let mut directives = text.lines().filter(shows);
        if let Some(line) = directives.find(|line| line.contains(figure)) {
            let files = line.matches(&figure[..5]).count();
            assert!(
                !line.contains("width="),
                "{figure}: a drawing has its own width"
            );
            return match files {
                1 => COLUMN,
                2 => HALF,
                more => panic!("{figure} is one of {more} in a row"),
            };
        }
    }
    panic!("{figure} is on no page");
}

/// The words of a chart in their order, without the numbers at its axes. Fails where it is not
/// well-formed, wider than its place in the book, or has letters too small to read there.
pub fn words(figure: &str, svg: &str) -> Vec<String> {
    let document = roxmltree::Document::parse(svg).unwrap_or_else(|e| panic!("{figure}: {e}"));
    let root = document.root_element();
    let number = |node: &roxmltree::Node<'_, '_>, name: &str| {
        let text = node
            .attribute(name)
            .unwrap_or_else(|| panic!("{figure}: no {name}"));
        text.parse::<f64>().unwrap()
    };
    let width = number(&root, "width");
    let place = width_in_the_book(figure);
    assert!(
        width <= place,
        "{figure} is {width} wide, where {place} are shown"
    );
    let view = root
        .attribute("viewBox")
        .unwrap()
        .split(' ')
        .nth(2)
        .unwrap();
    let pixels = width / view.parse::<f64>().unwrap();
    let texts = root.descendants().filter(|node| node.has_tag_name("text"));
    let said = texts.map(|node| {
        let height = pixels * number(&node, "font-size");
        // Units are quarter pixels.
        assert!(
            height >= LEAST - 0.01,
            "{figure}: letters {height} pixels high"
        );
        node.text().unwrap_or_default().trim().to_owned()
    });
    let is_number = |text: &String| text.chars().all(|c| !c.is_alphabetic());
    let words: Vec<String> = said.filter(|text| !is_number(text)).collect();
    assert!(!words.is_empty(), "{figure} says nothing");
    words
}
