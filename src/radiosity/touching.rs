//! Where surfaces touch or cross a flat shape: lines along which its patches are cut.
//!
//! Light changes its course there: a wall that stands in the middle of a patch would be lit on one
//! side and lend its light to the other. Cutting the patch is the first step of discontinuity meshing
//! (Lischinski, Tampieri, Greenberg, Discontinuity Meshing for Accurate Radiosity, IEEE CG&A 12(6),
//! 1992); edges of shadows are not cut.

use super::pieces::{Line, Pieces};
use glam::DVec3;

/// A flat convex polygon with what it takes to be compared.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    pub polygon: Vec<DVec3>,
    /// Unit.
    pub normal: DVec3,
    /// A bound on the rounding of its corners.
    pub close: f64,
    pub low: DVec3,
    pub high: DVec3,
}

impl Outline {
    pub fn new(polygon: Vec<DVec3>, normal: DVec3, close: f64) -> Self {
        let low = polygon.iter().copied().reduce(DVec3::min);
        let high = polygon.iter().copied().reduce(DVec3::max);
        Outline {
            low: low.unwrap_or_default(),
            high: high.unwrap_or_default(),
            polygon,
            normal,
            close,
        }
    }

    /// Signed distance of a point from the plane.
    pub fn height(&self, p: DVec3) -> f64 {
        self.normal.dot(p - self.polygon[0])
    }

    fn boxes_meet(&self, other: &Outline) -> bool {
        let room = DVec3::splat(self.close.max(other.close));
        (self.low - room).cmple(other.high).all() && (other.low - room).cmple(self.high).all()
    }

    /// True where both lie in one plane, up to rounding.
    pub fn is_coplanar(&self, other: &Outline) -> bool {
        let close = self.close.max(other.close);
        let within =
            |a: &Outline, b: &Outline| b.polygon.iter().all(|p| a.height(*p).abs() <= close);
        within(self, other) && within(other, self)
    }

    /// True where a point of the plane is inside, or on the rim.
    pub fn holds(&self, p: DVec3) -> bool {
        let next = self.polygon.iter().cycle().skip(1);
        let mut edges = self.polygon.iter().zip(next);
        edges.all(|(a, b)| (*b - *a).cross(p - *a).dot(self.normal) >= 0.0)
    }

    /// The segments in which another polygon meets this plane: its edges where both are coplanar.
    fn segments(&self, other: &Outline) -> Vec<[DVec3; 2]> {
        if !self.boxes_meet(other) {
            return Vec::new();
        }
        let edges = other
            .polygon
            .iter()
            .zip(other.polygon.iter().cycle().skip(1));
        if self.is_coplanar(other) {
            return edges.map(|(a, b)| [*a, *b]).collect();
        }
        let close = self.close.max(other.close);
        let mut points = Vec::new();
        for (a, b) in edges {
            let [ha, hb] = [a, b].map(|p| self.height(*p));
            if ha.abs() <= close {
                points.push(*a);
            } else if hb.abs() > close && ha * hb < 0.0 {
                points.push(*a + (*b - *a) * (ha / (ha - hb)));
            }
        }
        // Convex: the two that are farthest apart are the ends.
        let pairs = (0..points.len()).flat_map(|i| (0..i).map(move |j| [i, j]));
        let ends = pairs.map(|pair| pair.map(|i| points[i]));
        let longest = ends.max_by(|a, b| a[0].distance(a[1]).total_cmp(&b[0].distance(b[1])));
        longest.into_iter().collect()
    }

    /// Cuts pieces of this shape where the others touch or cross it.
    pub fn cut_where_touched<'a>(
        &self,
        pieces: &mut Pieces,
        others: impl Iterator<Item = &'a Outline>,
    ) {
        for other in others {
            for segment in self.segments(other) {
                let crossed = |polygon: &[DVec3]| {
                    let line = Line::through(segment, self.normal)?;
                    (inside(segment, polygon, self.normal) > 2.0 * pieces_close(self, other))
                        .then_some(line)
                };
                pieces.cut(crossed);
            }
        }
    }
}

fn pieces_close(a: &Outline, b: &Outline) -> f64 {
    a.close.max(b.close)
}

/// How much of a segment's length is inside a convex polygon of its plane.
fn inside([a, b]: [DVec3; 2], polygon: &[DVec3], normal: DVec3) -> f64 {
    let [mut from, mut to] = [0.0_f64, 1.0_f64];
    let winding = super::quadrature::area_vector(polygon).dot(normal).signum();
    for (p, q) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let inwards = normal.cross(*q - *p) * winding;
        let [start, end] = [a, b].map(|x| inwards.dot(x - *p));
        if start <= 0.0 && end <= 0.0 {
            return 0.0;
        }
        let crossing = start / (start - end);
        if start < 0.0 {
            from = from.max(crossing);
        } else if end < 0.0 {
            to = to.min(crossing);
        }
    }
    (to - from).max(0.0) * a.distance(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(corners: &[[f64; 3]]) -> Outline {
        let polygon: Vec<DVec3> = corners.iter().copied().map(DVec3::from).collect();
        let normal = super::super::quadrature::area_vector(&polygon).normalize();
        Outline::new(polygon, normal, 1e-7)
    }

    fn floor() -> Outline {
        outline(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]])
    }

    fn cut_by(other: Outline) -> usize {
        let floor = floor();
        let mut pieces = Pieces::whole(floor.polygon.clone(), floor.normal, floor.close);
        floor.cut_where_touched(&mut pieces, [other].iter());
        pieces.polygons.len()
    }

    #[test]
    fn a_wall_in_the_middle_cuts_and_one_at_the_rim_does_not() {
        let wall =
            |x: f64, low: f64| outline(&[[x, 0.1, low], [x, 0.9, low], [x, 0.9, 1.], [x, 0.1, 1.]]);
        assert_eq!(cut_by(wall(0.5, 0.0)), 2);
        assert_eq!(cut_by(wall(0.5, -1.0)), 2, "it passes through");
        assert_eq!(cut_by(wall(0.5, 0.1)), 1, "it hovers");
        assert_eq!(cut_by(wall(1.0, 0.0)), 1, "at the rim");
        assert_eq!(cut_by(wall(1.5, 0.0)), 1, "outside");
    }

    #[test]
    fn what_lies_in_the_plane_cuts_along_its_edges() {
        let rug = outline(&[
            [0.2, 0.2, 0.],
            [0.8, 0.2, 0.],
            [0.8, 0.8, 0.],
            [0.2, 0.8, 0.],
        ]);
        // Four edges, each across the pieces that it reaches.
        assert_eq!(cut_by(rug), 5);
        assert!(floor().is_coplanar(&floor()));
    }
}
