//! A flat shape cut by straight lines: a tree whose leaves are patches.
//!
//! Every cut is a line across the piece it cuts, whether to make pieces small or because another
//! surface touches there. Whoever looks for the patch at a point follows the lines down.

use super::quadrature::parallelogram;
use glam::DVec3;

/// The line through `point` in the plane of a shape, and the unit vector across it in that plane.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub point: DVec3,
    pub across: DVec3,
}

impl Line {
    /// The line through two points of a plane with unit normal `n`; `None` where they are one.
    pub fn through([a, b]: [DVec3; 2], n: DVec3) -> Option<Line> {
        let across = (b - a).cross(n).try_normalize()?;
        Some(Line { point: a, across })
    }

    fn side(&self, p: DVec3) -> f64 {
        self.across.dot(p - self.point)
    }

    /// The parts of a convex polygon behind and in front of the line; `None` where one of them is no
    /// wider than `close`.
    pub fn split(&self, polygon: &[DVec3], close: f64) -> Option<[Vec<DVec3>; 2]> {
        let sides: Vec<f64> = polygon.iter().map(|p| self.side(*p)).collect();
        let low = sides.iter().copied().fold(f64::INFINITY, f64::min);
        let high = sides.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if low >= -close || high <= close {
            return None;
        }
        let mut parts = [Vec::new(), Vec::new()];
        for (i, &here) in polygon.iter().enumerate() {
            let next = (i + 1) % polygon.len();
            // Corners within rounding of the line are on it, or slivers would come of them.
            let side = |s: f64| if s.abs() <= close { 0.0 } else { s };
            let [at, then] = [side(sides[i]), side(sides[next])];
            if at <= 0.0 {
                parts[0].push(here);
            }
            if at >= 0.0 {
                parts[1].push(here);
            }
            if at * then < 0.0 {
                let p = here + (polygon[next] - here) * (at / (at - then));
                parts.iter_mut().for_each(|part| part.push(p));
            }
        }
        Some(parts)
    }
}

/// A node of the tree.
#[derive(Clone, Debug)]
enum Node {
    Cut { line: Line, parts: [usize; 2] },
    Leaf { piece: usize },
}

/// A flat convex shape in pieces.
#[derive(Clone, Debug)]
pub(super) struct Pieces {
    /// Unit normal of the shape's front.
    pub normal: DVec3,
    /// Points this close to each other are one.
    pub close: f64,
    /// The pieces in the order of the tree: convex, and as wound as the shape.
    pub polygons: Vec<Vec<DVec3>>,
    /// The root first.
    nodes: Vec<Node>,
}

impl Pieces {
    /// The whole shape as one piece.
    pub fn whole(polygon: Vec<DVec3>, normal: DVec3, close: f64) -> Self {
        Pieces {
            normal,
            close,
            polygons: vec![polygon],
            nodes: vec![Node::Leaf { piece: 0 }],
        }
    }

    /// Cuts every piece that `wanted` gives a line for, once; true where any was cut.
    pub fn cut(&mut self, wanted: impl Fn(&[DVec3]) -> Option<Line>) -> bool {
        let mut any = false;
        for at in 0..self.nodes.len() {
            let Node::Leaf { piece } = self.nodes[at] else {
                continue;
            };
            let polygon = &self.polygons[piece];
            let Some(line) = wanted(polygon) else {
                continue;
            };
            let Some([behind, ahead]) = line.split(polygon, self.close) else {
                continue;
            };
            any = true;
            self.polygons[piece] = behind;
            self.polygons.push(ahead);
            let new = self.polygons.len() - 1;
            let parts = [self.nodes.len(), self.nodes.len() + 1];
            self.nodes.push(Node::Leaf { piece });
            self.nodes.push(Node::Leaf { piece: new });
            self.nodes[at] = Node::Cut { line, parts };
        }
        any
    }

    /// Cuts pieces until no edge is longer than `size`.
    pub fn subdivide(&mut self, size: f64) {
        let normal = self.normal;
        while self.cut(|polygon| halving(polygon, normal, size)) {}
    }

    /// The same in coordinates whose origin is `by` further.
    pub fn move_by(&mut self, by: DVec3) {
        let polygons = self.polygons.iter_mut().flatten();
        polygons.for_each(|p| *p -= by);
        for node in &mut self.nodes {
            if let Node::Cut { line, .. } = node {
                line.point -= by;
            }
        }
    }

    /// The piece in which a point of the plane lies, or to which it is nearest along the cuts.
    pub fn find(&self, p: DVec3) -> usize {
        let mut at = 0;
        loop {
            match &self.nodes[at] {
                Node::Leaf { piece } => return *piece,
                Node::Cut { line, parts } => at = parts[usize::from(line.side(p) > 0.0)],
            }
        }
    }
}

/// The line that cuts a piece across its longest edge, such that equal strips come of it in the end;
/// `None` where no edge is longer than `size`.
fn halving(polygon: &[DVec3], normal: DVec3, size: f64) -> Option<Line> {
    let edge = |i: usize| polygon[(i + 1) % polygon.len()] - polygon[i];
    let lengths = (0..polygon.len()).map(|i| edge(i).length());
    // The first of the longest: later ones must be longer by more than rounding far from the origin, so
    // that the same shape elsewhere is cut in the same order.
    let (longest, length) = lengths.enumerate().fold((0, 0.0), |best, (i, l)| {
        if l > best.1 * (1.0 + 1e-3) {
            (i, l)
        } else {
            best
        }
    });
    // Rounding must not make one strip more of a whole number of them.
    let strips = (length / size - 1e-3).ceil();
    if strips < 2.0 {
        return None;
    }
    let share = (strips / 2.0).floor() / strips;
    let start = polygon[longest] + edge(longest) * share;
    let end = match parallelogram(polygon) {
        // Along the edge beside it.
        Some(_) => start + edge((longest + 1) % 4),
        // To the corner that faces it.
        None if polygon.len() == 3 => polygon[(longest + 2) % 3],
        None => start + normal.cross(edge(longest)),
    };
    Line::through([start, end], normal)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::radiosity::quadrature::area_vector;

    fn square() -> Pieces {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        let polygon = corners.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        Pieces::whole(polygon, DVec3::Z, 1e-7)
    }

    fn area(pieces: &Pieces) -> f64 {
        let areas = pieces.polygons.iter().map(|p| 0.5 * area_vector(p).z);
        areas.sum()
    }

    #[test]
    fn a_square_comes_in_equal_squares() {
        for n in [1, 2, 3, 5, 8] {
            let mut pieces = square();
            pieces.subdivide(1.0 / f64::from(n));
            assert_eq!(pieces.polygons.len(), (n * n) as usize);
            for polygon in &pieces.polygons {
                let own = 0.5 * area_vector(polygon).z;
                assert!((own * f64::from(n * n) - 1.0).abs() < 1e-9, "{own}");
            }
        }
    }

    #[test]
    fn any_point_finds_its_piece() {
        let mut pieces = square();
        let line = Line::through(
            [DVec3::new(0.2, 0.0, 0.0), DVec3::new(0.7, 1.0, 0.0)],
            DVec3::Z,
        );
        assert!(pieces.cut(|_| line));
        pieces.subdivide(0.3);
        assert!((area(&pieces) - 1.0).abs() < 1e-12);
        for (i, polygon) in pieces.polygons.iter().enumerate() {
            let middle = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
            assert_eq!(pieces.find(middle), i);
            let edges = polygon.iter().zip(polygon.iter().cycle().skip(1));
            assert!(edges.into_iter().all(|(a, b)| a.distance(*b) < 0.3 * 1.001));
        }
    }

    #[test]
    fn a_cut_along_the_rim_is_none() {
        let mut pieces = square();
        let rim = Line::through([DVec3::X, DVec3::new(1.0, 1.0, 0.0)], DVec3::Z);
        assert!(!pieces.cut(|_| rim));
        assert_eq!(pieces.polygons.len(), 1);
    }
}
