//! How rays are drawn.
//!
//! Strokes are cut at the edge of the view, so a ray may be as long as it likes. What matters
//! most is drawn last: two hundred lost rays never bury the one that counts.

use std::collections::BTreeSet;
use std::f64::consts::TAU;

use plotters::prelude::{Color, Polygon};
use plotters::style::text_anchor::{HPos, VPos};

use super::view::Sheet;
use super::{Circle, Label, RayDrawing, Stroke, StrokeKind};
use crate::chart::ChartError;
use crate::chart::area::{Area, samples};
use crate::chart::canvas::{
    BLUE, GREEN, GREY, INK, Letters, ORANGE, PAGE, PALE, Page, Pen, Pixel, SKY, SMALL, VERMILLION,
    disk, paint, px, text_width,
};
use crate::chart::legend::{Key, draw_strip, strip_height};

impl StrokeKind {
    pub(super) fn pen(self) -> Pen {
        match self {
            Self::Lost => Pen::solid(PALE, 1),
            Self::Axis => Pen::dashed(GREY, 1),
            Self::Normal => Pen::solid(GREEN, 2),
            Self::Camera => Pen::solid(GREY, 2),
            Self::Shadow => Pen::dashed(SKY, 2),
            Self::Reflected => Pen::solid(BLUE, 2),
            Self::Transmitted => Pen::solid(VERMILLION, 2),
            Self::Useful => Pen::solid(VERMILLION, 2),
            Self::Lamp => Pen::solid(ORANGE, 6),
            Self::Wall => Pen::solid(INK, 4),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Lost => "lost ray",
            Self::Axis => "axis",
            Self::Normal => "normal",
            Self::Camera => "ray from the eye",
            Self::Shadow => "line to the lamp",
            Self::Reflected => "reflected",
            Self::Transmitted => "transmitted",
            Self::Useful => "useful ray",
            Self::Lamp => "lamp",
            Self::Wall => "wall",
        }
    }
}

impl RayDrawing {
    pub(super) fn draw(&self) -> Result<String, ChartError> {
        const GAP: i32 = px(12);
        let width = PAGE.0;
        let keys = self.keys();
        let sheet = Sheet::fit(self.view, width);
        let below = sheet.area.bottom() + GAP;
        let height = below + strip_height(&keys, width) + GAP;
        paint((width, height), &self.title, |page| {
            self.draw_on(page, &sheet)?;
            draw_strip(page, below, &keys)
        })
    }

    /// One key for each kind that occurs, what lies on top first.
    fn keys(&self) -> Vec<Key> {
        let round = self.circles.iter().map(|c| c.kind);
        let kinds: BTreeSet<StrokeKind> =
            self.strokes.iter().map(|s| s.kind).chain(round).collect();
        let key = |kind: StrokeKind| Key::line(kind.name(), kind.pen());
        kinds.into_iter().rev().map(key).collect()
    }

    fn draw_on(&self, page: &Page<'_>, sheet: &Sheet) -> Result<(), ChartError> {
        let mut strokes: Vec<&Stroke> = self.strokes.iter().collect();
        strokes.sort_by_key(|stroke| stroke.kind);
        let mut obstacles = Vec::new();
        for stroke in strokes {
            if let Some([from, to]) = self.view.clip(stroke.from, stroke.to) {
                let ends = (sheet.pixel(from), sheet.pixel(to));
                stroke.kind.pen().trace(page, vec![ends.0, ends.1])?;
                obstacles.extend(samples(ends.0, ends.1));
                if stroke.arrow && to == stroke.to {
                    draw_head(page, ends, stroke.kind.pen())?;
                }
            }
        }
        for circle in &self.circles {
            self.draw_circle(page, sheet, circle)?;
        }
        for dot in self.dots.iter().filter(|dot| self.view.holds(dot.at)) {
            let at = sheet.pixel(dot.at);
            disk(page, at, 5, INK)?;
            obstacles.push(at);
        }
        for label in self.labels.iter().filter(|label| self.view.holds(label.at)) {
            let area = draw_label(page, sheet, label, &obstacles)?;
            // Words weigh more than lines: the next label must not land on this one.
            obstacles.extend(area.grid().flat_map(|at| [at; 8]));
        }
        Ok(())
    }
}

impl RayDrawing {
    /// One line where the whole circle is in view, so that it has no joints; else what is in view.
    fn draw_circle(&self, page: &Page<'_>, sheet: &Sheet, c: &Circle) -> Result<(), ChartError> {
        const SIDES: i32 = 96;
        let corner = |i: i32| {
            let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(SIDES));
            [c.center[0] + c.radius * cos, c.center[1] + c.radius * sin]
        };
        let corners: Vec<[f64; 2]> = (0..=SIDES).map(corner).collect();
        if corners.iter().all(|&at| self.view.holds(at)) {
            let outline = corners.into_iter().map(|at| sheet.pixel(at)).collect();
            return c.kind.pen().trace(page, outline);
        }
        for side in corners.windows(2) {
            if let Some(ends) = self.view.clip(side[0], side[1]) {
                let line = ends.map(|at| sheet.pixel(at)).to_vec();
                c.kind.pen().trace(page, line)?;
            }
        }
        Ok(())
    }
}

/// A filled triangle at the end of a stroke.
fn draw_head(page: &Page<'_>, (from, to): (Pixel, Pixel), pen: Pen) -> Result<(), ChartError> {
    const LENGTH: f64 = px(11) as f64;
    const HALF_WIDTH: f64 = 0.4 * LENGTH;
    let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
    let length = (dx * dx + dy * dy).sqrt();
    if length < LENGTH {
        return Ok(());
    }
    let (dx, dy) = (dx / length, dy / length);
    let corner = |back: f64, side: f64| {
        let x = f64::from(to.0) - back * dx - side * dy;
        let y = f64::from(to.1) - back * dy + side * dx;
        (x.round() as i32, y.round() as i32)
    };
    let corners = [to, corner(LENGTH, HALF_WIDTH), corner(LENGTH, -HALF_WIDTH)];
    Ok(page.draw(&Polygon::new(corners, pen.colour.filled()))?)
}

/// Writes a word on the quietest side of its place, and tells where it stands.
fn draw_label(
    page: &Page<'_>,
    sheet: &Sheet,
    label: &Label,
    obstacles: &[Pixel],
) -> Result<Area, ChartError> {
    const OFF: i32 = px(9);
    let (x, y) = sheet.pixel(label.at);
    let (width, height) = (text_width(&label.text, SMALL) + px(4), SMALL + px(4));
    let (left, right, middle) = (x - OFF - width, x + OFF, x - width / 2);
    let (above, below, beside) = (y - OFF - height, y + OFF, y - height / 2);
    let corners = [(right, above), (left, above), (right, below), (left, below)];
    let sides = [
        (middle, above),
        (middle, below),
        (right, beside),
        (left, beside),
    ];
    let page_width = page.dim_in_pixel().0 as i32;
    let boxes = corners.into_iter().chain(sides).map(|(left, top)| Area {
        // A word near the edge of the page slides back onto it.
        left: left.min(page_width - width).max(0),
        top,
        width,
        height,
    });
    let (area, _) = Area::quietest(boxes, obstacles).unwrap_or((sheet.area, 0));
    area.blank(page, 0.8)?;
    let centre = (area.left + width / 2, area.top + height / 2);
    let letters = Letters::new(SMALL).anchored(HPos::Center, VPos::Center);
    letters.write(page, centre, &label.text)?;
    Ok(area)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heads(to: [f64; 2]) -> usize {
        let drawing = RayDrawing {
            strokes: vec![Stroke::arrow(StrokeKind::Useful, [0.0, 0.0], to)],
            ..RayDrawing::default()
        };
        drawing.to_svg().unwrap().matches("<polygon").count()
    }

    #[test]
    fn an_arrow_that_leaves_the_view_loses_its_head() {
        assert_eq!(heads([0.5, 0.5]), 1);
        assert_eq!(heads([5.0, 0.5]), 0);
    }

    #[test]
    fn two_labels_of_one_place_keep_apart() {
        let label = |text: &str| Label {
            at: [0.0, 0.0],
            text: text.into(),
        };
        let sheet = Sheet::fit(RayDrawing::default().view, PAGE.0);
        let page = paint(PAGE, "", |page| {
            let first = draw_label(page, &sheet, &label("first"), &[])?;
            let taken: Vec<Pixel> = first.grid().collect();
            let second = draw_label(page, &sheet, &label("second"), &taken)?;
            assert!(taken.iter().all(|&at| !second.holds(at)));
            Ok(())
        });
        assert!(page.is_ok());
    }
}
