//! Boxes on a page, and where a word or a legend hides the least.

use plotters::prelude::{Color, Rectangle, WHITE};

use super::ChartError;
use super::canvas::{Page, Pixel, px};

/// An upright box on a page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Area {
    pub(super) left: i32,
    pub(super) top: i32,
    pub(super) width: i32,
    pub(super) height: i32,
}

impl Area {
    pub(super) fn right(self) -> i32 {
        self.left + self.width
    }

    pub(super) fn bottom(self) -> i32 {
        self.top + self.height
    }

    pub(super) fn holds(self, (x, y): Pixel) -> bool {
        (self.left..=self.right()).contains(&x) && (self.top..=self.bottom()).contains(&y)
    }

    /// Its corners, all the way around.
    pub(super) fn outline(self) -> Vec<Pixel> {
        let (left, top, right, bottom) = (self.left, self.top, self.right(), self.bottom());
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        corners.into_iter().chain([(left, top)]).collect()
    }

    /// Places spread over the box, a few apart.
    pub(super) fn grid(self) -> impl Iterator<Item = Pixel> {
        let rows = samples((self.left, self.top), (self.left, self.bottom()));
        rows.flat_map(move |(_, y)| samples((self.left, y), (self.right(), y)))
    }

    /// The place at a share of the way from left to right and from the bottom to the top.
    pub(super) fn pixel(self, across: f64, up: f64) -> Pixel {
        let x = f64::from(self.left) + across * f64::from(self.width);
        let y = f64::from(self.bottom()) - up * f64::from(self.height);
        (x.round() as i32, y.round() as i32)
    }

    /// Covers the box with white that lets `opacity` of what lies beneath disappear.
    pub(super) fn blank(self, page: &Page<'_>, opacity: f64) -> Result<(), ChartError> {
        let corners = [(self.left, self.top), (self.right(), self.bottom())];
        Ok(page.draw(&Rectangle::new(corners, WHITE.mix(opacity).filled()))?)
    }

    /// The first of the boxes that hides the fewest obstacles, and how many it hides.
    pub(super) fn quietest(
        boxes: impl IntoIterator<Item = Self>,
        obstacles: &[Pixel],
    ) -> Option<(Self, usize)> {
        let hidden = |area: Self| obstacles.iter().filter(|&&at| area.holds(at)).count();
        boxes
            .into_iter()
            .map(|area| (area, hidden(area)))
            .min_by_key(|&(_, count)| count)
    }
}

/// Places along a segment, a few apart: what [`Area::quietest`] has to stay clear of.
pub(super) fn samples(from: Pixel, to: Pixel) -> impl Iterator<Item = Pixel> {
    const APART: i32 = px(4);
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let steps = (dx.abs().max(dy.abs()) / APART).max(1);
    (0..=steps).map(move |i| (from.0 + dx * i / steps, from.1 + dy * i / steps))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_quietest_box_hides_least_and_ties_go_to_the_first() {
        let at = |left| Area {
            left,
            top: 0,
            width: 10,
            height: 10,
        };
        let crowd: Vec<Pixel> = samples((0, 5), (25, 5)).collect();
        let (best, hidden) = Area::quietest([at(0), at(40), at(60)], &crowd).unwrap();
        assert_eq!((best, hidden), (at(40), 0));
    }
}
