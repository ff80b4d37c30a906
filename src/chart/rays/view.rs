//! The view: which part of the plane is shown, and where it lands on the page.

use crate::chart::area::Area;
use crate::chart::canvas::{Pixel, TITLE_BAND, px};

/// An upright rectangle of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower left corner.
    pub min: [f64; 2],
    /// Upper right corner.
    pub max: [f64; 2],
}

impl Default for Bounds {
    /// The square that holds the unit disk.
    fn default() -> Self {
        Self {
            min: [-1.0, -1.0],
            max: [1.0, 1.0],
        }
    }
}

impl Bounds {
    /// Extents along both axes.
    pub(super) fn size(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.max[axis] - self.min[axis])
    }

    pub(super) fn holds(&self, at: [f64; 2]) -> bool {
        (0..2).all(|axis| (self.min[axis]..=self.max[axis]).contains(&at[axis]))
    }

    /// The part of a segment inside the rectangle. An end that is inside comes back untouched.
    pub(super) fn clip(&self, from: [f64; 2], to: [f64; 2]) -> Option<[[f64; 2]; 2]> {
        let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            let step = to[axis] - from[axis];
            let (near, far) = (self.min[axis] - from[axis], self.max[axis] - from[axis]);
            if step == 0.0 {
                if near > 0.0 || far < 0.0 {
                    return None;
                }
                continue;
            }
            let (first, last) = (near / step, far / step);
            enter = enter.max(first.min(last));
            leave = leave.min(first.max(last));
        }
        let along = |t: f64| [0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis]));
        let start = if enter == 0.0 { from } else { along(enter) };
        let end = if leave == 1.0 { to } else { along(leave) };
        (enter <= leave).then_some([start, end])
    }
}

/// A view laid onto the page, with one scale for both axes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheet {
    view: Bounds,
    pub(super) area: Area,
}

impl Sheet {
    /// As large as a page of the given width allows, but never too tall for a screen.
    pub(super) fn fit(view: Bounds, page_width: i32) -> Self {
        const MARGIN: i32 = px(20);
        const TALLEST: f64 = px(560) as f64;
        let [wide, tall] = view.size();
        let scale = (f64::from(page_width - 2 * MARGIN) / wide).min(TALLEST / tall);
        // A sliver of a view still gets a line.
        let units = |length: f64| ((length * scale).round() as i32).max(1);
        let area = Area {
            left: (page_width - units(wide)) / 2,
            top: TITLE_BAND,
            width: units(wide),
            height: units(tall),
        };
        Self { view, area }
    }

    pub(super) fn pixel(&self, at: [f64; 2]) -> Pixel {
        let [wide, tall] = self.view.size();
        let across = (at[0] - self.view.min[0]) / wide;
        let up = (at[1] - self.view.min[1]) / tall;
        self.area.pixel(across, up)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::canvas::PAGE;

    #[test]
    fn a_segment_is_cut_at_the_edge() {
        let view = Bounds::default();
        let cut = view.clip([0.0, 0.0], [5.0, 0.0]);
        assert_eq!(cut, Some([[0.0, 0.0], [1.0, 0.0]]));
        assert_eq!(view.clip([2.0, -3.0], [2.0, 3.0]), None);
        assert_eq!(view.clip([0.0, 3.0], [3.0, 0.0]), None);
        let inside = [[0.1, 0.2], [-0.3, 0.7]];
        assert_eq!(view.clip(inside[0], inside[1]), Some(inside));
    }

    #[test]
    fn both_axes_share_one_scale() {
        let view = Bounds {
            min: [-3.0, 0.0],
            max: [5.0, 2.0],
        };
        let sheet = Sheet::fit(view, PAGE.0);
        let origin = sheet.pixel([0.0, 0.0]);
        let (right, up) = (sheet.pixel([2.0, 0.0]), sheet.pixel([0.0, 2.0]));
        assert!(((right.0 - origin.0) - (origin.1 - up.1)).abs() <= 1);
    }
}
