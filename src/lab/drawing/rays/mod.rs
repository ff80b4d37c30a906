//! Rays: the flat world seen from above, true to scale and without axes.

mod draw;

use super::{ChartError, FULL, finite};

/// A picture of the plane.
#[derive(Clone, Debug, Default)]
pub struct RayDrawing {
    /// Headline.
    pub title: String,
    /// The part of the plane that is shown.
    pub view: Bounds,
    /// Walls, lamps, rays and other straight things.
    pub strokes: Vec<Stroke>,
    /// Round walls and lamps.
    pub circles: Vec<Circle>,
    /// Pieces of circles, such as the rim of a half disk.
    pub arcs: Vec<Arc>,
    /// Lamps that are points.
    pub lamps: Vec<Dot>,
    /// Places worth a dot, such as the hits of a path.
    pub dots: Vec<Dot>,
    /// Words beside places.
    pub labels: Vec<Label>,
    /// Words in the middle of their places, whatever lies beneath.
    pub captions: Vec<Label>,
    /// Whether the legend is left out, because words stand beside all there is.
    pub bare: bool,
}

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
    fn size(&self) -> [f64; 2] {
        [0, 1].map(|axis| self.max[axis] - self.min[axis])
    }

    fn holds(&self, at: [f64; 2]) -> bool {
        (0..2).all(|axis| (self.min[axis]..=self.max[axis]).contains(&at[axis]))
    }
}

/// A round thing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub center: [f64; 2],
    /// Its radius.
    pub radius: f64,
    /// What it stands for.
    pub kind: StrokeKind,
}

/// A piece of a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Centre of the circle.
    pub center: [f64; 2],
    /// Radius of the circle.
    pub radius: f64,
    /// The angle where it begins, in radians, counter-clockwise from the right.
    pub start: f64,
    /// How far it goes on from there, counter-clockwise, in radians: less than a whole turn.
    pub turn: f64,
    /// What it stands for.
    pub kind: StrokeKind,
}

/// A straight piece of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Where it starts.
    pub from: [f64; 2],
    /// Where it ends.
    pub to: [f64; 2],
    /// What it stands for.
    pub kind: StrokeKind,
    /// Whether its end carries an arrow head.
    pub arrow: bool,
}

impl Label {
    /// A word at a place.
    pub fn new(at: [f64; 2], text: &str) -> Self {
        Self {
            at,
            text: text.to_owned(),
        }
    }
}

impl Stroke {
    /// A stroke without an arrow head.
    pub fn new(kind: StrokeKind, from: [f64; 2], to: [f64; 2]) -> Self {
        Self {
            from,
            to,
            kind,
            arrow: false,
        }
    }

    /// A stroke with an arrow head at its end.
    pub fn arrow(kind: StrokeKind, from: [f64; 2], to: [f64; 2]) -> Self {
        Self {
            arrow: true,
            ..Self::new(kind, from, to)
        }
    }
}

/// What a stroke stands for. The order is the order of drawing: later kinds lie on top.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StrokeKind {
    /// A mark where a dart missed.
    Miss,
    /// A mark where a dart hit.
    Hit,
    /// A ray that found nothing.
    Lost,
    /// A ray that leaves the world.
    ToSky,
    /// A ray that meets a surface.
    ToSurface,
    /// A ray that meets the shining side of a surface.
    ToEmitter,
    /// A ray on the side its surface faces.
    Above,
    /// A ray on the other side, where no light comes from.
    Below,
    /// The half disk of directions over a point.
    HalfDisk,
    /// A line that only helps the eye, such as the axis of a lens.
    Axis,
    /// The direction a surface faces.
    Normal,
    /// A ray from the eye.
    Camera,
    /// A line from a surface to a lamp.
    Shadow,
    /// A mirrored ray.
    Reflected,
    /// A refracted ray.
    Transmitted,
    /// A ray that carries light to where it is wanted.
    Useful,
    /// The edge of a figure, such as the circle that darts are thrown at.
    Outline,
    /// A surface that shines.
    Lamp,
    /// Any other surface.
    Wall,
}

/// A place worth a dot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    /// Where.
    pub at: [f64; 2],
}

/// A word and its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The place; a word beside it stands above and to the right of it.
    pub at: [f64; 2],
    /// The word.
    pub text: String,
}

impl RayDrawing {
    /// The drawing as SVG text, as wide as a page. Its height follows the shape of the view.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.to_svg_at(FULL)
    }

    /// The drawing as SVG text, of a width in pixels.
    pub fn to_svg_at(&self, width: u32) -> Result<String, ChartError> {
        self.check()?;
        Ok(self.draw(f64::from(width)))
    }

    fn check(&self) -> Result<(), ChartError> {
        let place = |dot: &Dot| dot.at.to_vec();
        let word = |label: &Label| label.at.to_vec();
        let strokes = self.strokes.iter().map(|s| [s.from, s.to].concat());
        let circles = self
            .circles
            .iter()
            .map(|c| [c.center, [c.radius; 2]].concat());
        let arcs = self
            .arcs
            .iter()
            .map(|a| [a.center, [a.radius; 2], [a.start, a.turn]].concat());
        let lists: [(&str, Vec<Vec<f64>>); 7] = [
            ("strokes", strokes.collect()),
            ("circles", circles.collect()),
            ("arcs", arcs.collect()),
            ("lamps", self.lamps.iter().map(place).collect()),
            ("dots", self.dots.iter().map(place).collect()),
            ("labels", self.labels.iter().map(word).collect()),
            ("captions", self.captions.iter().map(word).collect()),
        ];
        let corners = [self.view.min, self.view.max, self.view.size()];
        finite(&self.title, "view", corners)?;
        let nothing = lists.iter().all(|(_, list)| list.is_empty());
        if nothing || self.view.size().iter().any(|&size| size <= 0.0) {
            return Err(ChartError::Empty(self.title.clone()));
        }
        let mut lists = lists.iter();
        lists.try_for_each(|(series, list)| finite(&self.title, series, list))
    }
}
