//! What the colours mean: a column inside or beside a plot, or a strip below a drawing.

use plotters::style::text_anchor::{HPos, VPos};

use super::ChartError;
use super::area::Area;
use super::canvas::{Letters, PALE, Page, Pen, Pixel, SMALL, disk, px, text_width};

/// Length of the piece of line in front of a name.
const SWATCH: i32 = px(28);
/// Empty space between swatch and name, and around a column.
const GAP: i32 = px(8);
const ROW: i32 = px(22);

/// One line of a legend.
#[derive(Clone)]
pub(super) struct Key {
    pub(super) name: String,
    pub(super) pen: Pen,
    pub(super) line: bool,
    pub(super) mark: bool,
}

impl Key {
    /// A name beside a piece of the line it stands for.
    pub(super) fn line(name: impl Into<String>, pen: Pen) -> Self {
        Self {
            name: name.into(),
            pen,
            line: true,
            mark: false,
        }
    }

    fn width(&self) -> i32 {
        SWATCH + GAP + text_width(&self.name, SMALL)
    }

    /// Draws swatch and name, left edge and middle at `at`.
    fn draw(&self, page: &Page<'_>, (x, y): Pixel) -> Result<(), ChartError> {
        if self.line {
            self.pen.trace(page, vec![(x, y), (x + SWATCH, y)])?;
        }
        if self.mark {
            disk(page, (x + SWATCH / 2, y), 4, self.pen.colour)?;
        }
        let letters = Letters::new(SMALL).anchored(HPos::Left, VPos::Center);
        letters.write(page, (x + SWATCH + GAP, y), &self.name)
    }
}

/// Width and height of the keys one below another, with a margin all around.
pub(super) fn column_size(keys: &[Key]) -> (i32, i32) {
    let widest = keys.iter().map(Key::width).max().unwrap_or(0);
    (widest + 2 * GAP, keys.len() as i32 * ROW + GAP)
}

/// Draws the keys one below another in a framed white box.
pub(super) fn draw_column(page: &Page<'_>, area: Area, keys: &[Key]) -> Result<(), ChartError> {
    area.blank(page, 0.9)?;
    Pen::solid(PALE, 1).trace(page, area.outline())?;
    for (row, key) in (0..).zip(keys) {
        let middle = area.top + GAP / 2 + row * ROW + ROW / 2;
        key.draw(page, (area.left + GAP, middle))?;
    }
    Ok(())
}

/// Height of [`draw_strip`] on a page of the given width.
pub(super) fn strip_height(keys: &[Key], width: i32) -> i32 {
    rows(keys, width).len() as i32 * ROW
}

/// Draws the keys side by side, centred, in as many rows as the page needs.
pub(super) fn draw_strip(page: &Page<'_>, top: i32, keys: &[Key]) -> Result<(), ChartError> {
    let width = page.dim_in_pixel().0 as i32;
    for (index, row) in (0..).zip(rows(keys, width)) {
        let mut x = (width - row_width(row)) / 2;
        for key in row {
            key.draw(page, (x, top + index * ROW + ROW / 2))?;
            x += key.width() + 2 * GAP;
        }
    }
    Ok(())
}

fn row_width(row: &[Key]) -> i32 {
    let gaps = 2 * GAP * (row.len() as i32 - 1).max(0);
    row.iter().map(Key::width).sum::<i32>() + gaps
}

/// Cuts the keys into rows that fit the page; a key wider than the page gets a row of its own.
fn rows(keys: &[Key], width: i32) -> Vec<&[Key]> {
    let mut rows = Vec::new();
    let mut rest = keys;
    while !rest.is_empty() {
        let fitting = (1..=rest.len())
            .take_while(|&n| row_width(&rest[..n]) <= width - 2 * GAP)
            .last()
            .unwrap_or(1);
        let (row, later) = rest.split_at(fitting);
        rows.push(row);
        rest = later;
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::canvas::palette;

    #[test]
    fn a_strip_breaks_into_rows_and_loses_no_key() {
        let keys: Vec<Key> = (0..9)
            .map(|i| Key::line(format!("a rather long name {i}"), Pen::solid(palette(i), 2)))
            .collect();
        let rows = rows(&keys, px(600));
        assert!(rows.len() > 1);
        assert_eq!(rows.iter().map(|row| row.len()).sum::<usize>(), keys.len());
        assert!(rows.iter().all(|row| row_width(row) <= px(600)));
    }

    #[test]
    fn a_key_wider_than_the_page_still_gets_a_row() {
        let keys = [Key::line("x".repeat(200), Pen::solid(palette(0), 2))];
        assert_eq!(rows(&keys, px(300)).len(), 1);
    }
}
