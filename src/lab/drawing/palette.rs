//! Colours: those of Okabe and Ito, which stay apart for colour-blind eyes, and their dark counterparts.

pub(super) use plotters::style::RGBColor as Colour;

pub(super) const BLUE: Colour = Colour(0, 114, 178);
pub(super) const VERMILLION: Colour = Colour(213, 94, 0);
pub(super) const GREEN: Colour = Colour(0, 158, 115);
pub(super) const ORANGE: Colour = Colour(230, 159, 0);
pub(super) const SKY: Colour = Colour(86, 180, 233);
pub(super) const PURPLE: Colour = Colour(204, 121, 167);
pub(super) const UMBER: Colour = Colour(122, 72, 32);
pub(super) const PAPER: Colour = Colour(255, 255, 255);
pub(super) const INK: Colour = Colour(34, 34, 34);
pub(super) const GREY: Colour = Colour(110, 110, 110);
pub(super) const PALE: Colour = Colour(195, 195, 195);
pub(super) const FAINT: Colour = Colour(236, 236, 236);

/// Their yellow is left out: it fades on white. An umber and a grey follow for charts of many curves.
const SERIES: [Colour; 9] = [
    BLUE, VERMILLION, GREEN, PURPLE, ORANGE, SKY, INK, UMBER, GREY,
];

/// What becomes of colours that would be lost on a dark page.
const DARK: [(Colour, Colour); 9] = [
    (PAPER, Colour(27, 30, 36)),
    (INK, Colour(225, 228, 232)),
    (GREY, Colour(160, 165, 172)),
    (PALE, Colour(84, 89, 97)),
    (FAINT, Colour(46, 50, 58)),
    (BLUE, Colour(64, 154, 222)),
    (VERMILLION, Colour(238, 119, 33)),
    (SKY, Colour(150, 214, 250)),
    (UMBER, Colour(184, 132, 90)),
];

/// Colour number `index` of a chart, starting over when all are used up.
pub(super) fn series(index: usize) -> Colour {
    SERIES[index % SERIES.len()]
}

/// A colour as SVG and its style sheets write it.
pub(super) fn hex(Colour(r, g, b): Colour) -> String {
    format!("#{r:02X}{g:02X}{b:02X}")
}

/// A style sheet that exchanges the colours on pages whose colour scheme is dark. Each drawing keeps
/// paper of its own, so it can be read even where its scheme is not that of the page around it.
pub(super) fn dark_style() -> String {
    let mut style = String::from("@media (prefers-color-scheme: dark) {");
    for (light, dark) in DARK {
        let (light, dark) = (hex(light), hex(dark));
        style += &format!(
            "\n[fill=\"{light}\"] {{ fill: {dark} }} [stroke=\"{light}\"] {{ stroke: {dark} }}"
        );
    }
    style + "\n}"
}
