//! How curves are drawn.
//!
//! The legend goes to a corner of the plot where it hides nothing; when the data reach into all
//! four, it moves out to the right and the plot makes room.

use super::{Curve, CurveChart, Style};
use crate::chart::ChartError;
use crate::chart::area::{Area, samples};
use crate::chart::axis::Scale;
use crate::chart::canvas::{Page, Pen, Pixel, disk, palette, px};
use crate::chart::legend::{Key, column_size, draw_column};
use crate::chart::plane::{Plane, Plot, draw_error};

impl Style {
    fn has_marks(self) -> bool {
        matches!(self, Self::Marks | Self::MarksAndLine)
    }

    fn has_line(self) -> bool {
        self != Self::Marks
    }

    pub(super) fn pen(self, index: usize) -> Pen {
        match self {
            Self::Dashed => Pen::dashed(palette(index), 2),
            _ => Pen::solid(palette(index), 2),
        }
    }
}

impl CurveChart {
    pub(super) fn draw(&self, page: &Page<'_>, x: &Scale, y: &Scale) -> Result<(), ChartError> {
        let keys = self.keys();
        let mut plane = Plane {
            x,
            y,
            x_label: &self.x_label,
            y_label: &self.y_label,
            right: 0,
            below: 0,
        };
        let legend = self.place_legend(page, &mut plane, &keys);
        let plot = plane.draw(page)?;
        let mut order: Vec<(usize, &Curve)> = self.curves.iter().enumerate().collect();
        order.sort_by_key(|(_, curve)| curve.style != Style::Dashed);
        for (index, curve) in order {
            curve.draw(&plot, curve.pen(index))?;
        }
        if !keys.is_empty() {
            draw_column(page, legend, &keys)?;
        }
        Ok(())
    }

    fn keys(&self) -> Vec<Key> {
        let named = self.curves.iter().enumerate();
        named
            .filter(|(_, curve)| !curve.name.is_empty())
            .map(|(index, curve)| Key {
                name: curve.name.clone(),
                pen: curve.pen(index),
                line: curve.style.has_line(),
                mark: curve.style.has_marks(),
            })
            .collect()
    }

    /// A free corner of the plot, or a place at its right that the plane then leaves open.
    fn place_legend(&self, page: &Page<'_>, plane: &mut Plane<'_>, keys: &[Key]) -> Area {
        const OFF: i32 = px(10);
        let (width, height) = column_size(keys);
        let plot = plane.plot_area(page);
        let at = |left, top| Area {
            left,
            top,
            width,
            height,
        };
        let (left, right) = (plot.left + OFF, plot.right() - OFF - width);
        let (top, bottom) = (plot.top + OFF, plot.bottom() - OFF - height);
        let corners = [(right, top), (left, top), (right, bottom), (left, bottom)];
        let corners = corners.map(|(left, top)| at(left, top));
        match Area::quietest(corners, &self.obstacles(plane, plot)) {
            Some((corner, 0)) => corner,
            _ => {
                plane.right = width + OFF;
                at(plot.right() - width, plot.top)
            }
        }
    }

    /// What a legend should not hide: lines, dots and error bars.
    fn obstacles(&self, plane: &Plane<'_>, plot: Area) -> Vec<Pixel> {
        let pixel = |x: f64, y: f64| plot.pixel(plane.x.share(x), plane.y.share(y));
        let mut obstacles = Vec::new();
        for curve in &self.curves {
            for point in &curve.points {
                let [low, high] = point.reach();
                obstacles.extend(samples(pixel(point.x, low), pixel(point.x, high)));
            }
            for pair in curve.points.windows(2).filter(|_| curve.style.has_line()) {
                let ends = (pixel(pair[0].x, pair[0].y), pixel(pair[1].x, pair[1].y));
                obstacles.extend(samples(ends.0, ends.1));
            }
        }
        obstacles
    }
}

impl Curve {
    fn draw(&self, plot: &Plot<'_>, pen: Pen) -> Result<(), ChartError> {
        if self.style.has_line() {
            pen.trace(plot, self.points.iter().map(|p| (p.x, p.y)).collect())?;
        }
        for point in &self.points {
            if point.error.is_some() {
                draw_error(plot, point.x, point.reach(), pen)?;
            }
            if self.style.has_marks() {
                disk(plot, (point.x, point.y), 4, pen.colour)?;
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::axis::Axis;
    use crate::chart::canvas::{PAGE, paint};

    /// Room that the plane leaves for the legend of one curve, and whether it hides the curve.
    fn room_and_hidden(points: &[(f64, f64)]) -> (i32, usize) {
        let curve = Curve::new("somewhat long", Style::Line, points.iter().copied());
        let chart = CurveChart {
            curves: vec![curve],
            ..CurveChart::default()
        };
        let x = Scale::around(Axis::Linear, points.iter().map(|point| point.0));
        let y = Scale::around(Axis::Linear, points.iter().map(|point| point.1));
        let mut found = (0, 0);
        let page = paint(PAGE, "", |page| {
            let mut plane = Plane {
                x: &x,
                y: &y,
                x_label: "",
                y_label: "",
                right: 0,
                below: 0,
            };
            let legend = chart.place_legend(page, &mut plane, &chart.keys());
            let obstacles = chart.obstacles(&plane, plane.plot_area(page));
            let hidden = Area::quietest([legend], &obstacles).map_or(0, |(_, hidden)| hidden);
            found = (plane.right, hidden);
            Ok(())
        });
        assert!(page.is_ok());
        found
    }

    #[test]
    fn a_legend_takes_a_free_corner() {
        assert_eq!(room_and_hidden(&[(0.0, 1.0), (1.0, 0.0)]), (0, 0));
        assert_eq!(room_and_hidden(&[(0.0, 0.0), (1.0, 1.0)]), (0, 0));
    }

    #[test]
    fn without_a_free_corner_it_moves_out() {
        let frame = [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0), (0.0, 0.0)];
        let (room, hidden) = room_and_hidden(&frame);
        assert!(room > 0 && hidden == 0);
    }
}
