//! The drawing room: numbers and rays become SVG text, and charts PNG files as well.
//!
//! Six kinds of figure live here, and all of them work alike: fill in a plain struct, call `to_svg`, get
//! the text of a picture. Nothing touches a file, and the same struct always gives the same bytes.
//!
//! * [`CurveChart`] — measurements with error bars against closed forms, on linear or log axes;
//! * [`BarChart`] — a few labelled values side by side;
//! * [`HeatMap`] — a value for each pixel of a picture, as a colour;
//! * [`Plates`] — pictures side by side, with their names;
//! * [`RayDrawing`] — walls, lamps and rays of the flat world, true to scale;
//! * [`TreeDrawing`] — the tree of reflected and transmitted rays below one camera ray.
//!
//! [`plotters`] draws all but the last two, with its own coordinates, mesh, labels and legend
//! (`plot`). The last two have no axes: a small writer of SVG draws them (`svg`). Figures are drawn at the
//! width at which they are shown ([`FULL`], or [`HALF`] beside another), with letters of at least 11
//! pixels, on paper of their own, which is dark where the page is.

mod bars;
mod curves;
mod font;
mod heat;
mod palette;
mod plates;
mod plot;
mod rays;
mod scale;
mod svg;
mod ticks;
mod tree;

pub use bars::{Bar, BarChart, BarGroup};
pub use curves::{Curve, CurveChart, Point, Style};
pub use heat::HeatMap;
pub use plates::{Plate, Plates};
pub use rays::{Arc, Bounds, Circle, Dot, Label, RayDrawing, Stroke, StrokeKind};
pub use scale::Axis;
pub use tree::{EdgeKind, TreeDrawing, TreeNode};

/// Width in pixels of a figure that has a page's column for itself.
pub const FULL: u32 = 720;
/// Width in pixels of one of two figures side by side.
pub const HALF: u32 = 348;

/// Why a figure could not be drawn.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ChartError {
    /// There is no point, bar, stroke or node to show.
    #[error("nothing to draw in \"{0}\"")]
    Empty(String),
    /// A coordinate, value or error is infinite or not a number.
    #[error("chart \"{chart}\": entry {index} of \"{series}\" is not a finite number")]
    NonFinite {
        /// Title of the chart.
        chart: String,
        /// The curve, bar group or list that holds the number.
        series: String,
        /// Position in that list, from 0.
        index: usize,
    },
    /// A logarithmic axis has no place for zero or below.
    #[error("chart \"{chart}\": entry {index} of \"{series}\" is not positive, on a log axis")]
    NonPositive {
        /// Title of the chart.
        chart: String,
        /// The curve or bar group that holds the number.
        series: String,
        /// Position in that list, from 0.
        index: usize,
    },
    /// A node of a ray tree hangs from nothing, or shares its number with another.
    #[error("tree \"{chart}\": node {id} has no parent or is listed twice")]
    BrokenTree {
        /// Title of the drawing.
        chart: String,
        /// Heap number of the node.
        id: u64,
    },
    /// The drawing library gave up.
    #[error("drawing failed: {0}")]
    Drawing(String),
}

/// No larger number is drawn: sums and differences of two have to stay finite.
const LARGEST: f64 = 1e300;

/// Refuses the first entry of a series of which a number is infinite, none, or too large to draw.
fn finite(
    chart: &str,
    series: &str,
    entries: impl IntoIterator<Item = impl AsRef<[f64]>>,
) -> Result<(), ChartError> {
    let drawn = |x: &f64| x.abs() <= LARGEST;
    let mut entries = entries.into_iter();
    match entries.position(|numbers| !numbers.as_ref().iter().all(drawn)) {
        None => Ok(()),
        Some(index) => Err(ChartError::NonFinite {
            chart: chart.to_owned(),
            series: series.to_owned(),
            index,
        }),
    }
}

/// Refuses the first value of a series that has no place on an axis.
fn placed(
    chart: &str,
    series: &str,
    values: impl IntoIterator<Item = f64>,
    axis: Axis,
) -> Result<(), ChartError> {
    match values.into_iter().position(|value| !axis.admits(value)) {
        None => Ok(()),
        Some(index) => Err(ChartError::NonPositive {
            chart: chart.to_owned(),
            series: series.to_owned(),
            index,
        }),
    }
}
