//! The drawing room: numbers and rays become SVG text.
//!
//! Five drawings live here, and all of them work alike: fill in a plain struct,
//! call `to_svg`, get the text of a picture. Nothing touches a file, and the same struct always
//! gives the same bytes.
//!
//! * [`CurveChart`] — measurements with error bars against closed forms, on linear or log axes;
//! * [`BarChart`] — a few labelled values side by side;
//! * [`RayDrawing`] — walls, lamps and rays of the flat world, true to scale;
//! * [`TreeDrawing`] — the tree of reflected and transmitted rays below one camera ray;
//! * [`HeatMap`] — a value for each pixel of a picture, as a colour.
//!
//! [`walk`] draws the rays of a walk. [`flat`] fills in a [`RayDrawing`] from a flat world and the half disk over one of its points.
//! Behind them: `canvas` (page, pens, letters), `area` (boxes, and where they hide least), `legend`
//! (what the colours mean), `axis` and `ticks` (from values to places and words), and `plane` (the
//! grid of a chart).

mod area;
mod axis;
mod bars;
mod canvas;
mod convergence;
mod cost;
mod curves;
pub mod flat;
mod heat;
mod legend;
mod plane;
mod rays;
mod requirement;
mod ticks;
mod tree;
pub mod walk;

pub use axis::Axis;
pub use bars::{Bar, BarChart, BarGroup};
pub use convergence::convergence_chart;
pub use cost::{Against, cost_chart};
pub use curves::{Curve, CurveChart, Point, Style};
pub use heat::HeatMap;
pub use rays::{Arc, Bounds, Circle, Dot, Label, RayDrawing, Stroke, StrokeKind};
pub use requirement::required_chart;
pub use tree::{EdgeKind, TreeDrawing, TreeNode};

/// Width and height of a drawing in pixels, where its content does not ask for more.
pub const SIZE: (u32, u32) = (860, 540);

/// Why a drawing could not be made.
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
