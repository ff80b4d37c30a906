//! The plane of a chart: two scales, their grid and their labels, around an empty plot.

use plotters::prelude::*;

use super::ChartError;
use super::area::Area;
use super::axis::Scale;
use super::canvas::{
    FAINT, INK, Letters, NORMAL, PALE, Page, Pen, SMALL, TITLE_BAND, px, text_width,
};

/// A drawing area whose coordinates are values on two [`Scale`]s.
pub(super) type Plot<'a> = DrawingArea<SVGBackend<'a>, Cartesian2d<Scale, Scale>>;

/// Room below the plot for tick labels and the name of the axis.
const BELOW: i32 = px(58);
const MARGIN: i32 = px(22);
/// Length of a tick; the library keeps the same again between tick and label.
const TICK: i32 = px(5);

/// What is needed to lay out a plane.
pub(super) struct Plane<'s> {
    pub(super) x: &'s Scale,
    pub(super) y: &'s Scale,
    pub(super) x_label: &'s str,
    pub(super) y_label: &'s str,
    /// Space kept free at the right of the plot, for a legend.
    pub(super) right: i32,
    /// Additional space between the plot and the name of the x axis.
    pub(super) below: i32,
}

impl Plane<'_> {
    /// Where the plot itself will lie on the page.
    pub(super) fn plot_area(&self, page: &Page<'_>) -> Area {
        let (width, height) = page.dim_in_pixel();
        let left = self.left();
        Area {
            left,
            top: TITLE_BAND,
            width: width as i32 - left - MARGIN - self.right,
            height: height as i32 - TITLE_BAND - BELOW - self.below,
        }
    }

    /// Room at the left for the name of the y axis and its widest tick label.
    fn left(&self) -> i32 {
        let labels = self.y.ticks.iter();
        let widest = labels.map(|tick| text_width(&tick.label, SMALL)).max();
        widest.unwrap_or(0) + NORMAL + 2 * TICK + px(18)
    }

    /// Draws grid, axes and labels, and hands out the area for the data.
    pub(super) fn draw<'a>(&self, page: &Page<'a>) -> Result<Plot<'a>, ChartError> {
        const EDGE: i32 = px(8);
        let mut chart = ChartBuilder::on(page)
            .margin_top(TITLE_BAND)
            .margin_left(EDGE)
            .margin_right(MARGIN + self.right)
            .margin_bottom(EDGE)
            .set_label_area_size(LabelAreaPosition::Left, self.left() - EDGE)
            .set_label_area_size(LabelAreaPosition::Bottom, BELOW + self.below - EDGE)
            .build_cartesian_2d(self.x.clone(), self.y.clone())?;
        chart
            .configure_mesh()
            .bold_line_style(Pen::solid(PALE, 1).shape())
            .light_line_style(Pen::solid(FAINT, 1).shape())
            .axis_style(Pen::solid(INK, 1).shape())
            .set_all_tick_mark_size(TICK)
            .label_style(Letters::new(SMALL).text_style())
            .axis_desc_style(Letters::new(NORMAL).text_style())
            .x_desc(self.x_label)
            .y_desc(self.y_label)
            .draw()?;
        Ok(chart.plotting_area().clone())
    }
}

/// Draws an error bar: a stem with a cap at both ends.
pub(super) fn draw_error(
    plot: &Plot<'_>,
    x: f64,
    ends: [f64; 2],
    pen: Pen,
) -> Result<(), ChartError> {
    const HALF_CAP: i32 = px(4);
    pen.trace(plot, ends.map(|y| (x, y)).to_vec())?;
    for y in ends {
        let cap = PathElement::new(vec![(-HALF_CAP, 0), (HALF_CAP, 0)], pen.shape());
        plot.draw(&(EmptyElement::at((x, y)) + cap))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::axis::Axis;
    use crate::chart::canvas::{PAGE, paint};

    #[test]
    fn the_library_plots_where_the_plane_says() {
        let (x, y) = (
            Scale::around(Axis::Log, [1.0, 1e6]),
            Scale::around(Axis::Linear, [0.0, 1.0]),
        );
        let plane = Plane {
            x: &x,
            y: &y,
            x_label: "n",
            y_label: "error",
            right: px(50),
            below: px(20),
        };
        let svg = paint(PAGE, "", |page| {
            let area = plane.plot_area(page);
            let plot = plane.draw(page)?;
            let (x_range, y_range) = plot.get_pixel_range();
            assert!(
                (x_range.start - area.left).abs() <= 1 && (x_range.end - area.right()).abs() <= 1
            );
            assert!(
                (y_range.start - area.top).abs() <= 1 && (y_range.end - area.bottom()).abs() <= 1
            );
            draw_error(&plot, 10.0, [0.2, 0.4], Pen::solid(INK, 3))
        })
        .unwrap();
        assert!(svg.contains("10⁶") && svg.contains("0.8"));
        assert_eq!(svg.matches("stroke-width=\"12\"").count(), 3);
    }
}
