//! Rays: the flat world seen from above, true to scale and without axes.

mod draw;
mod round;
mod view;

pub use round::{Arc, Circle};
pub use view::Bounds;

use super::ChartError;

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
    /// The place; a word beside it goes to the side where it hides least.
    pub at: [f64; 2],
    /// The word.
    pub text: String,
}

impl RayDrawing {
    /// The drawing as SVG text. Its height follows the shape of the view.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        self.check()?;
        self.draw()
    }

    fn check(&self) -> Result<(), ChartError> {
        self.finite("view", &[self.view.min, self.view.max], |&at| vec![at])?;
        self.finite("strokes", &self.strokes, |stroke| {
            vec![stroke.from, stroke.to]
        })?;
        self.finite("circles", &self.circles, |circle| {
            vec![circle.center, [circle.radius; 2]]
        })?;
        self.finite("arcs", &self.arcs, |arc| {
            vec![arc.center, [arc.radius; 2], [arc.start, arc.turn]]
        })?;
        self.finite("lamps", &self.lamps, |lamp| vec![lamp.at])?;
        self.finite("dots", &self.dots, |dot| vec![dot.at])?;
        self.finite("labels", &self.labels, |label| vec![label.at])?;
        self.finite("captions", &self.captions, |caption| vec![caption.at])?;
        let lists = [
            self.strokes.len(),
            self.circles.len(),
            self.arcs.len(),
            self.lamps.len(),
            self.dots.len(),
            self.labels.len(),
            self.captions.len(),
        ];
        let nothing = lists == [0; 7];
        if nothing || self.view.size().iter().any(|&size| size <= 0.0) {
            return Err(ChartError::Empty(self.title.clone()));
        }
        Ok(())
    }

    /// Refuses the first entry of a list that does not lie at finite places.
    fn finite<T>(
        &self,
        series: &str,
        list: &[T],
        places: impl Fn(&T) -> Vec<[f64; 2]>,
    ) -> Result<(), ChartError> {
        let lost = |entry| places(entry).as_flattened().iter().any(|x| !x.is_finite());
        match list.iter().position(lost) {
            None => Ok(()),
            Some(index) => Err(ChartError::NonFinite {
                chart: self.title.clone(),
                series: series.to_owned(),
                index,
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use plotters::style::RGBColor;

    fn drawing() -> RayDrawing {
        let lost = |i| Stroke::new(StrokeKind::Lost, [0.0, 0.0], [f64::from(i), 9.0]);
        let wall = Stroke::new(StrokeKind::Wall, [-1.0, -0.5], [1.0, -0.5]);
        let useful = Stroke::arrow(StrokeKind::Useful, [0.0, 0.0], [0.5, -0.5]);
        RayDrawing {
            title: "lamp".into(),
            strokes: [wall, useful].into_iter().chain((0..5).map(lost)).collect(),
            dots: vec![Dot { at: [0.0, 0.0] }],
            labels: vec![Label {
                at: [0.0, 0.0],
                text: "lamp".into(),
            }],
            ..RayDrawing::default()
        }
    }

    #[test]
    fn the_same_drawing_gives_the_same_bytes() {
        assert_eq!(drawing().to_svg(), drawing().to_svg());
    }

    #[test]
    fn every_stroke_is_drawn_once_and_the_legend_names_each_kind() {
        let svg = drawing().to_svg().unwrap();
        assert_eq!(svg.matches("<polyline").count(), 7 + 3);
        assert_eq!(svg.matches("<polygon").count(), 1);
        assert!(svg.contains("lost ray") && !svg.contains("normal"));
    }

    #[test]
    fn a_circle_is_one_line_and_is_cut_at_the_edge_of_the_view() {
        let lines = |center| {
            let mut round = drawing();
            let (radius, kind) = (0.25, StrokeKind::Wall);
            round.circles = vec![Circle {
                center,
                radius,
                kind,
            }];
            round.to_svg().unwrap().matches("<polyline").count() - (7 + 3)
        };
        assert_eq!(lines([0.0, 0.0]), 1);
        assert_eq!(lines([3.0, 0.0]), 0);
        assert!(lines([1.0, 0.0]) > 1);
    }

    #[test]
    fn lost_rays_lie_beneath_useful_ones() {
        let svg = drawing().to_svg().unwrap();
        let first_of = |kind: StrokeKind| {
            let RGBColor(r, g, b) = kind.pen().colour;
            svg.find(&format!("stroke=\"#{r:02X}{g:02X}{b:02X}\""))
        };
        assert!(first_of(StrokeKind::Lost) < first_of(StrokeKind::Useful));
        assert!(first_of(StrokeKind::Useful) < first_of(StrokeKind::Wall));
    }

    #[test]
    fn nothing_and_nowhere_are_refused() {
        let empty = RayDrawing::default();
        assert_eq!(empty.to_svg(), Err(ChartError::Empty(String::new())));
        let mut flat = drawing();
        flat.view.max[1] = flat.view.min[1];
        assert_eq!(flat.to_svg(), Err(ChartError::Empty("lamp".into())));
        let mut lost = drawing();
        lost.strokes[2].to[0] = f64::INFINITY;
        let expected = ChartError::NonFinite {
            chart: "lamp".into(),
            series: "strokes".into(),
            index: 2,
        };
        assert_eq!(lost.to_svg(), Err(expected));
    }
}
