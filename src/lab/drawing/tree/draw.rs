//! How a tree is drawn.
//!
//! Edges run sideways first and then down. A node's words have the space below it to themselves,
//! and an edge's word the space at the right of its last stretch.

use super::layout::{columns, level};
use super::{EdgeKind, Nodes, TreeDrawing, TreeNode};
use crate::lab::drawing::font::{SMALL, text_width};
use crate::lab::drawing::palette::{BLUE, GREY, INK, VERMILLION};
use crate::lab::drawing::svg::{Letters, MIDDLE, Pen, Place, START, Svg};

const RADIUS: f64 = 5.0;
/// Height of one line of words below a node.
const LINE: f64 = SMALL + 4.0;
/// From one level to the next: two lines of words, then a stretch of edge.
const LEVEL: f64 = 2.0 * LINE + 46.0;
const MARGIN: f64 = 16.0;
/// Length of the camera's own edge above the root.
const STUB: f64 = 36.0;

impl EdgeKind {
    pub(super) const ALL: [Self; 3] = [Self::Camera, Self::Reflected, Self::Transmitted];

    /// Its name and the pen that draws it.
    fn key(self) -> (&'static str, Pen) {
        match self {
            Self::Camera => ("camera ray", Pen::solid(INK, 1.6)),
            Self::Reflected => ("reflected", Pen::solid(BLUE, 1.6)),
            Self::Transmitted => ("transmitted", Pen::solid(VERMILLION, 1.6)),
        }
    }

    fn pen(self) -> Pen {
        self.key().1
    }
}

impl TreeNode {
    /// Width of the widest word that hangs on the node.
    fn width(&self) -> f64 {
        let wide = |text: &str| text_width(text, SMALL);
        let below = wide(&self.label).max(self.note.as_deref().map_or(0.0, wide));
        below.max(2.0 * (RADIUS + wide(&self.edge_label)))
    }

    fn lines(&self) -> f64 {
        f64::from(u8::from(!self.label.is_empty()) + u8::from(self.note.is_some()))
    }
}

impl TreeDrawing {
    pub(super) fn draw(&self, tree: &Nodes<'_>, width: f64) -> String {
        let columns = columns(tree);
        let leaves = columns.values().fold(0.0_f64, |most, &c| most.max(c)) + 1.0;
        let widest = self.nodes.iter().map(TreeNode::width).fold(0.0, f64::max);
        // A small tree spreads out, though not so far that its edges lose each other.
        let spread = ((width - 2.0 * MARGIN) / leaves)
            .min(150.0)
            .max(widest + 8.0);
        let width = width.max(leaves * spread + 2.0 * MARGIN);
        let mut svg = Svg::default();
        let top = svg.headline(&self.title, width) + STUB;
        let start = 0.5 * (width - leaves * spread + spread);
        let place = |id: u64| {
            let column = columns.get(&id).copied().unwrap_or_default();
            [start + column * spread, top + f64::from(level(id)) * LEVEL]
        };
        for (&id, node) in tree {
            let to = place(id);
            match tree.get(&(id / 2)) {
                Some(parent) => draw_edge(&mut svg, node, [place(parent.id), to], parent.lines()),
                None => draw_edge(&mut svg, node, [[to[0], to[1] - STUB], to], 0.0),
            }
        }
        for (&id, node) in tree {
            draw_node(&mut svg, node, place(id));
        }
        let deepest = tree.keys().map(|&id| level(id)).max().unwrap_or(0);
        let below = top + f64::from(deepest) * LEVEL + RADIUS + 2.0 * LINE + MARGIN;
        let occurs = |kind: &EdgeKind| self.nodes.iter().any(|node| node.kind == *kind);
        let kinds = EdgeKind::ALL.into_iter().filter(occurs);
        let keys: Vec<_> = kinds.map(EdgeKind::key).collect();
        let height = below + svg.legend(below, width, &keys) + 0.5 * MARGIN;
        svg.page([width, height], 1.0)
    }
}

/// An edge with its word. Straight below its parent it starts under the parent's `lines`.
fn draw_edge(svg: &mut Svg, node: &TreeNode, [from, to]: [Place; 2], lines: f64) {
    let pen = node.kind.pen();
    if from[0] == to[0] {
        let skip = if lines == 0.0 {
            0.0
        } else {
            RADIUS + lines * LINE + 4.0
        };
        svg.polyline(&[[from[0], from[1] + skip], to], pen, false);
    } else {
        svg.polyline(&[from, [to[0], from[1]], to], pen, false);
    }
    let letters = Letters {
        colour: pen.colour,
        ..Letters::new(SMALL, START)
    };
    let at = [to[0] + RADIUS, to[1] - RADIUS - 0.5 * LINE];
    svg.text(at, &node.edge_label, letters);
}

fn draw_node(svg: &mut Svg, node: &TreeNode, at: Place) {
    svg.disk(at, RADIUS, node.kind.pen().colour);
    let mut letters = Letters::new(SMALL, MIDDLE);
    let below = [at[0], at[1] + RADIUS + 2.0 + 0.5 * LINE];
    svg.text(below, &node.label, letters);
    if let Some(note) = &node.note {
        letters.colour = GREY;
        svg.text([below[0], below[1] + LINE], note, letters);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_straight_down_starts_below_the_words_of_its_parent() {
        let edge = |label: &str| {
            let nodes = vec![
                TreeNode::new(1, EdgeKind::Camera, label, ""),
                TreeNode::new(2, EdgeKind::Reflected, "", ""),
            ];
            let title = String::new();
            TreeDrawing { title, nodes }.to_svg().unwrap()
        };
        // The root lies at 20 for the headline and 36 for its own edge, its child 78 below.
        assert!(
            edge("").contains("points=\"360,56 360,134\""),
            "{}",
            edge("")
        );
        assert!(
            edge("glass").contains("points=\"360,81 360,134\""),
            "{}",
            edge("glass")
        );
    }

    #[test]
    fn children_stand_at_both_sides_of_their_parent() {
        let nodes = vec![
            TreeNode::new(1, EdgeKind::Camera, "", ""),
            TreeNode::new(2, EdgeKind::Reflected, "", ""),
            TreeNode::new(3, EdgeKind::Transmitted, "", ""),
        ];
        let title = String::new();
        let svg = TreeDrawing { title, nodes }.to_svg().unwrap();
        // 150 pixels to a leaf, around the middle of 720.
        for points in ["360,56 285,56 285,134", "360,56 435,56 435,134"] {
            assert!(svg.contains(points), "{points} in {svg}");
        }
    }
}
