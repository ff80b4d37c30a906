//! How rays are drawn.
//!
//! What lies outside the view is cut off, so a ray may be as long as it likes. What matters most is
//! drawn last: two hundred lost rays never bury the one that counts.

use std::collections::BTreeSet;

use super::{Bounds, RayDrawing, Stroke, StrokeKind};
use crate::lab::drawing::font::{SMALL, TEXT, text_width};
use crate::lab::drawing::palette::{BLUE, GREEN, GREY, INK, ORANGE, PALE, SKY, VERMILLION};
use crate::lab::drawing::svg::{Letters, MIDDLE, Pen, Place, START, Svg};

impl StrokeKind {
    /// Its name and the pen that draws it.
    fn key(self) -> (&'static str, Pen) {
        match self {
            Self::Miss => ("miss", Pen::solid(VERMILLION, 1.6)),
            Self::Hit => ("hit", Pen::solid(BLUE, 1.6)),
            Self::Lost => ("lost ray", Pen::solid(PALE, 0.8)),
            Self::ToSky => ("ray to the sky", Pen::solid(SKY, 0.8)),
            Self::ToSurface => ("ray to a surface", Pen::solid(BLUE, 0.8)),
            Self::ToEmitter => ("ray to a lamp", Pen::solid(ORANGE, 1.6)),
            Self::Above => ("ray above the surface", Pen::solid(BLUE, 0.8)),
            Self::Below => ("ray below the surface", Pen::solid(VERMILLION, 0.8)),
            Self::HalfDisk => ("half disk", Pen::solid(GREY, 1.0)),
            Self::Axis => ("axis", Pen::dashed(GREY, 1.0)),
            Self::Normal => ("normal", Pen::solid(GREEN, 1.6)),
            Self::Camera => ("ray from the eye", Pen::solid(GREY, 1.6)),
            Self::Shadow => ("line to the lamp", Pen::dashed(SKY, 1.6)),
            Self::Reflected => ("reflected", Pen::solid(BLUE, 1.6)),
            Self::Transmitted => ("transmitted", Pen::solid(VERMILLION, 1.6)),
            Self::Useful => ("useful ray", Pen::solid(VERMILLION, 1.6)),
            Self::Outline => ("outline", Pen::solid(INK, 1.6)),
            Self::Lamp => ("lamp", Pen::solid(ORANGE, 5.0)),
            Self::Wall => ("wall", Pen::solid(INK, 3.0)),
        }
    }

    fn pen(self) -> Pen {
        self.key().1
    }
}

/// A view laid onto the page, with one scale for both axes.
struct Sheet {
    view: Bounds,
    /// Pixels for a unit of the plane.
    scale: f64,
    /// Where the upper left corner of the view lies.
    corner: Place,
}

impl Sheet {
    /// As large as a page of the given width allows, but never too tall for a screen.
    fn fit(view: Bounds, width: f64, top: f64) -> Self {
        const MARGIN: f64 = 12.0;
        const TALLEST: f64 = 560.0;
        let [wide, tall] = view.size();
        let scale = ((width - 2.0 * MARGIN) / wide).min(TALLEST / tall);
        let corner = [0.5 * (width - scale * wide), top];
        Self {
            view,
            scale,
            corner,
        }
    }

    fn place(&self, at: [f64; 2]) -> Place {
        let right = at[0] - self.view.min[0];
        let down = self.view.max[1] - at[1];
        [
            self.corner[0] + self.scale * right,
            self.corner[1] + self.scale * down,
        ]
    }

    /// The upper left and the lower right corner of the view, and a little around it, where the pens of
    /// lines at its edges go.
    fn window(&self) -> [Place; 2] {
        const AROUND: f64 = 6.0;
        let Bounds { min, max } = self.view;
        let [from, to] = [[min[0], max[1]], [max[0], min[1]]].map(|at| self.place(at));
        [from.map(|x| x - AROUND), to.map(|x| x + AROUND)]
    }
}

impl RayDrawing {
    pub(super) fn draw(&self, width: f64) -> String {
        const GAP: f64 = 10.0;
        let mut svg = Svg::default();
        let top = svg.headline(&self.title, width);
        let sheet = Sheet::fit(self.view, width, top);
        svg.clipped(sheet.window(), |svg| self.draw_lines(svg, &sheet));
        self.write_words(&mut svg, &sheet, width);
        let below = sheet.window()[1][1] + GAP;
        let kinds = if self.bare {
            BTreeSet::new()
        } else {
            self.kinds()
        };
        let keys: Vec<_> = kinds.into_iter().rev().map(StrokeKind::key).collect();
        let height = below + svg.legend(below, width, &keys) + GAP;
        svg.page([width, height], 1.0)
    }

    fn kinds(&self) -> BTreeSet<StrokeKind> {
        let straight = self.strokes.iter().map(|stroke| stroke.kind);
        let circles = self.circles.iter().map(|circle| circle.kind);
        let arcs = self.arcs.iter().map(|arc| arc.kind);
        let lamps = self.lamps.iter().map(|_| StrokeKind::Lamp);
        straight.chain(circles).chain(arcs).chain(lamps).collect()
    }

    fn draw_lines(&self, svg: &mut Svg, sheet: &Sheet) {
        let mut strokes: Vec<&Stroke> = self.strokes.iter().collect();
        strokes.sort_by_key(|stroke| stroke.kind);
        for stroke in strokes {
            let ends = [stroke.from, stroke.to].map(|at| sheet.place(at));
            svg.polyline(&ends, stroke.kind.pen(), stroke.arrow);
        }
        for circle in &self.circles {
            let center = sheet.place(circle.center);
            svg.circle(center, sheet.scale * circle.radius, circle.kind.pen());
        }
        for arc in &self.arcs {
            let (center, radius) = (sheet.place(arc.center), sheet.scale * arc.radius);
            svg.arc(center, radius, arc.start, arc.turn, arc.kind.pen());
        }
        for lamp in &self.lamps {
            svg.disk(sheet.place(lamp.at), 6.0, ORANGE);
        }
        for dot in &self.dots {
            svg.disk(sheet.place(dot.at), 3.5, INK);
        }
    }

    /// Labels above and to the right of their places, as far as the page goes, and captions.
    fn write_words(&self, svg: &mut Svg, sheet: &Sheet, width: f64) {
        const OFF: f64 = 7.0;
        for label in self.labels.iter().filter(|label| self.view.holds(label.at)) {
            let [x, y] = sheet.place(label.at);
            let right = width - text_width(&label.text, TEXT) - OFF;
            let letters = Letters {
                halo: true,
                ..Letters::new(TEXT, START)
            };
            svg.text(
                [(x + OFF).min(right), y - OFF - 0.5 * TEXT],
                &label.text,
                letters,
            );
        }
        for caption in &self.captions {
            let letters = Letters {
                halo: true,
                ..Letters::new(SMALL, MIDDLE)
            };
            svg.text(sheet.place(caption.at), &caption.text, letters);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::drawing::palette::hex;
    use crate::lab::drawing::{Arc, ChartError, Circle, Dot, FULL, HALF, Label};

    fn drawing() -> RayDrawing {
        let lost = |i| Stroke::new(StrokeKind::Lost, [0.0, 0.0], [f64::from(i), 9.0]);
        let wall = Stroke::new(StrokeKind::Wall, [-1.0, -0.5], [1.0, -0.5]);
        let useful = Stroke::arrow(StrokeKind::Useful, [0.0, 0.0], [0.5, -0.5]);
        RayDrawing {
            title: "lamp".into(),
            strokes: [wall, useful].into_iter().chain((0..5).map(lost)).collect(),
            dots: vec![Dot { at: [0.0, 0.0] }],
            labels: vec![Label {
                at: [0.9, 0.0],
                text: "a lamp of some size".into(),
            }],
            ..RayDrawing::default()
        }
    }

    #[test]
    fn places_on_paper_follow_from_the_view() {
        let view = Bounds {
            min: [-3.0, 0.0],
            max: [5.0, 2.0],
        };
        // 348 pixels without margins of 12 are 324, for 8 units.
        let sheet = Sheet::fit(view, 348.0, 40.0);
        assert_eq!(sheet.place([-3.0, 2.0]), [12.0, 40.0]);
        assert_eq!(sheet.place([5.0, 0.0]), [336.0, 121.0]);
        assert_eq!(sheet.place([1.0, 1.0]), [174.0, 80.5]);
    }

    #[test]
    fn strokes_arcs_and_circles_lie_at_their_places() {
        let kind = StrokeKind::Wall;
        let drawing = RayDrawing {
            strokes: vec![Stroke::new(kind, [-1.0, -1.0], [1.0, 1.0])],
            circles: vec![Circle {
                center: [0.5, 0.0],
                radius: 0.25,
                kind,
            }],
            arcs: vec![Arc {
                center: [0.0, 0.0],
                radius: 0.5,
                start: 0.0,
                turn: std::f64::consts::PI,
                kind,
            }],
            ..RayDrawing::default()
        };
        // An untitled page of 224 pixels gives 100 to a unit; the view begins at 12, 20.
        let svg = drawing.to_svg_at(224).unwrap();
        for part in [
            "points=\"12,220 212,20\"",
            "cx=\"162\" cy=\"120\" r=\"25\"",
            "d=\"M162,120 A50 50 0 0 0 62,120\"",
        ] {
            assert!(svg.contains(part), "{part} in {svg}");
        }
    }

    #[test]
    fn every_stroke_is_drawn_once_and_the_legend_names_each_kind() {
        let svg = drawing().to_svg().unwrap();
        assert_eq!(svg.matches("<polyline").count(), 7 + 3);
        assert_eq!(svg.matches("marker-end").count(), 1);
        assert!(svg.contains("lost ray") && !svg.contains("normal"));
    }

    #[test]
    fn a_bare_drawing_has_all_strokes_and_no_legend() {
        let bare = RayDrawing {
            bare: true,
            ..drawing()
        };
        let svg = bare.to_svg().unwrap();
        assert_eq!(svg.matches("<polyline").count(), 7);
        assert!(!svg.contains("lost ray"));
    }

    #[test]
    fn lost_rays_lie_beneath_useful_ones() {
        let svg = drawing().to_svg().unwrap();
        let first_of =
            |kind: StrokeKind| svg.find(&format!("none\" stroke=\"{}\"", hex(kind.pen().colour)));
        assert!(first_of(StrokeKind::Lost) < first_of(StrokeKind::Useful));
        assert!(first_of(StrokeKind::Useful) < first_of(StrokeKind::Wall));
    }

    #[test]
    fn a_label_at_the_edge_stays_on_the_page() {
        for width in [FULL, HALF] {
            let svg = drawing().to_svg_at(width).unwrap();
            let (before, _) = svg.split_once("\">a lamp of some size").unwrap();
            let x = before.rsplit_once("<text x=\"").unwrap().1;
            let x: f64 = x.split('"').next().unwrap().parse().unwrap();
            let end = x + text_width("a lamp of some size", TEXT);
            assert!(end <= f64::from(width), "{end} of {width}");
        }
    }

    #[test]
    fn nothing_and_nowhere_are_refused() {
        let empty = RayDrawing::default();
        assert_eq!(empty.to_svg(), Err(ChartError::Empty(String::new())));
        let mut flat = drawing();
        flat.view.max[1] = flat.view.min[1];
        assert_eq!(flat.to_svg(), Err(ChartError::Empty("lamp".into())));
        let mut lost = drawing();
        lost.dots[0].at[1] = f64::NAN;
        let expected = ChartError::NonFinite {
            chart: "lamp".into(),
            series: "dots".into(),
            index: 0,
        };
        assert_eq!(lost.to_svg(), Err(expected));
        let mut vast = drawing();
        vast.view.min[0] = -f64::MAX;
        vast.view.max[0] = f64::MAX;
        assert!(vast.to_svg().is_err());
    }
}
