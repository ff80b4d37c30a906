//! How rays are drawn.
//!
//! Strokes are cut at the edge of the view, so a ray may be as long as it likes. What matters
//! most is drawn last: two hundred lost rays never bury the one that counts.

use std::collections::BTreeSet;

use plotters::prelude::{Color, Polygon};
use plotters::style::text_anchor::{HPos, VPos};

use super::view::Sheet;
use super::{Arc, Label, RayDrawing, Stroke, StrokeKind};
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
            Self::Miss => Pen::solid(VERMILLION, 2),
            Self::Hit => Pen::solid(BLUE, 2),
            Self::Lost => Pen::solid(PALE, 1),
            Self::ToSky => Pen::solid(SKY, 1),
            Self::ToSurface => Pen::solid(BLUE, 1),
            Self::ToEmitter => Pen::solid(ORANGE, 2),
            Self::Above => Pen::solid(BLUE, 1),
            Self::Below => Pen::solid(VERMILLION, 1),
            Self::HalfDisk => Pen::solid(GREY, 1),
            Self::Axis => Pen::dashed(GREY, 1),
            Self::Normal => Pen::solid(GREEN, 2),
            Self::Camera => Pen::solid(GREY, 2),
            Self::Shadow => Pen::dashed(SKY, 2),
            Self::Reflected => Pen::solid(BLUE, 2),
            Self::Transmitted => Pen::solid(VERMILLION, 2),
            Self::Useful => Pen::solid(VERMILLION, 2),
            Self::Outline => Pen::solid(INK, 2),
            Self::Lamp => Pen::solid(ORANGE, 6),
            Self::Wall => Pen::solid(INK, 4),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Miss => "miss",
            Self::Hit => "hit",
            Self::Lost => "lost ray",
            Self::ToSky => "ray to the sky",
            Self::ToSurface => "ray to a surface",
            Self::ToEmitter => "ray to a lamp",
            Self::Above => "ray above the surface",
            Self::Below => "ray below the surface",
            Self::HalfDisk => "half disk",
            Self::Axis => "axis",
            Self::Normal => "normal",
            Self::Camera => "ray from the eye",
            Self::Shadow => "line to the lamp",
            Self::Reflected => "reflected",
            Self::Transmitted => "transmitted",
            Self::Useful => "useful ray",
            Self::Outline => "outline",
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
        let round = self.round().map(|arc| arc.kind);
        let lamps = self.lamps.iter().map(|_| StrokeKind::Lamp);
        let straight = self.strokes.iter().map(|s| s.kind);
        let kinds: BTreeSet<StrokeKind> = straight.chain(round).chain(lamps).collect();
        let key = |kind: StrokeKind| Key::line(kind.name(), kind.pen());
        kinds.into_iter().rev().map(key).collect()
    }

    /// Everything round, as arcs.
    fn round(&self) -> impl Iterator<Item = Arc> {
        let circles = self.circles.iter().copied().map(Arc::from);
        circles.chain(self.arcs.iter().copied())
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
        self.draw_joints(page, sheet)?;
        for arc in self.round() {
            arc.draw(page, sheet, &self.view)?;
        }
        for lamp in self.lamps.iter().filter(|lamp| self.view.holds(lamp.at)) {
            disk(page, sheet.pixel(lamp.at), 6, StrokeKind::Lamp.pen().colour)?;
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
        let letters = Letters::new(SMALL).anchored(HPos::Center, VPos::Center);
        for caption in &self.captions {
            letters.write(page, sheet.pixel(caption.at), &caption.text)?;
        }
        Ok(())
    }

    /// Fills the notch where one thick line ends and the next begins.
    fn draw_joints(&self, page: &Page<'_>, sheet: &Sheet) -> Result<(), ChartError> {
        let thick = |stroke: &&Stroke| stroke.kind >= StrokeKind::Lamp;
        for end in self.strokes.iter().filter(thick) {
            let mut others = self.strokes.iter().filter(thick);
            if self.view.holds(end.to) && others.any(|s| s.kind == end.kind && s.from == end.to) {
                let pen = end.kind.pen();
                disk(page, sheet.pixel(end.to), pen.width / 2, pen.colour)?;
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
    fn walls_that_go_on_leave_no_notch() {
        let discs = |corner| {
            let wall = |from, to| Stroke::new(StrokeKind::Wall, from, to);
            let drawing = RayDrawing {
                strokes: vec![wall([0.0, 0.5], [0.0, 0.0]), wall(corner, [0.5, 0.0])],
                ..RayDrawing::default()
            };
            drawing.to_svg().unwrap().matches("<circle").count()
        };
        assert_eq!((discs([0.0, 0.0]), discs([0.1, 0.0])), (1, 0));
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
