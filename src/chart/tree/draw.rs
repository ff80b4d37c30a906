//! How a tree is drawn.
//!
//! Edges run sideways first and then down. A node's words have the space below it to themselves,
//! and an edge's word the space at the right of its last stretch.

use plotters::style::text_anchor::{HPos, VPos};

use super::layout::{columns, level};
use super::{EdgeKind, Nodes, TreeDrawing, TreeNode};
use crate::chart::ChartError;
use crate::chart::canvas::{
    BLUE, GREY, INK, Letters, PAGE, Page, Pen, Pixel, SMALL, TITLE_BAND, VERMILLION, disk, paint,
    px, text_width,
};
use crate::chart::legend::{Key, draw_strip, strip_height};

const RADIUS: i32 = px(6);
/// Height of one line of words below a node.
const LINE: i32 = SMALL + px(4);
/// From one level to the next: two lines of words, then a stretch of edge.
const LEVEL: i32 = 2 * LINE + px(62);
const MARGIN: i32 = px(24);
/// Length of the camera's own edge above the root.
const STUB: i32 = px(44);

impl EdgeKind {
    pub(super) const ALL: [Self; 3] = [Self::Camera, Self::Reflected, Self::Transmitted];

    fn pen(self) -> Pen {
        match self {
            Self::Camera => Pen::solid(INK, 2),
            Self::Reflected => Pen::solid(BLUE, 2),
            Self::Transmitted => Pen::solid(VERMILLION, 2),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Camera => "camera ray",
            Self::Reflected => "reflected",
            Self::Transmitted => "transmitted",
        }
    }
}

impl TreeNode {
    /// Width of the widest word that hangs on the node.
    fn width(&self) -> i32 {
        let below = [Some(&self.label), self.note.as_ref()]
            .into_iter()
            .flatten();
        let below = below.map(|text| text_width(text, SMALL)).max().unwrap_or(0);
        below.max(RADIUS + text_width(&self.edge_label, SMALL))
    }

    fn lines(&self) -> i32 {
        i32::from(!self.label.is_empty()) + i32::from(self.note.is_some())
    }
}

impl TreeDrawing {
    pub(super) fn draw(&self, tree: &Nodes<'_>) -> Result<String, ChartError> {
        let columns = columns(tree);
        let leaves = columns
            .values()
            .fold(0.0_f64, |most, &column| most.max(column))
            + 1.0;
        let leaves = leaves as i32;
        let widest = self.nodes.iter().map(TreeNode::width).max().unwrap_or(0);
        let room = PAGE.0 - 2 * MARGIN;
        // A small tree spreads out, though not so far that its edges lose each other.
        let spread = (room / leaves).min(px(180)).max(widest + px(16));
        let width = (leaves * spread + 2 * MARGIN).max(PAGE.0);
        let start = (width - leaves * spread + spread) / 2;
        let pixel = |id: u64| {
            let column = columns.get(&id).copied().unwrap_or_default();
            let x = start + (column * f64::from(spread)).round() as i32;
            (x, TITLE_BAND + STUB + level(id) * LEVEL)
        };
        let keys = self.keys();
        let deepest = tree.keys().map(|&id| level(id)).max().unwrap_or(0);
        let below = TITLE_BAND + STUB + deepest * LEVEL + RADIUS + 2 * LINE + MARGIN;
        let height = below + strip_height(&keys, width) + MARGIN / 2;
        paint((width, height), &self.title, |page| {
            draw_tree(page, tree, &pixel)?;
            draw_strip(page, below, &keys)
        })
    }

    fn keys(&self) -> Vec<Key> {
        let occurs = |kind: &EdgeKind| self.nodes.iter().any(|node| node.kind == *kind);
        let kinds = EdgeKind::ALL.into_iter().filter(occurs);
        kinds
            .map(|kind| Key::line(kind.name(), kind.pen()))
            .collect()
    }
}

/// Draws all edges first, then the nodes over their ends.
fn draw_tree(
    page: &Page<'_>,
    tree: &Nodes<'_>,
    pixel: &impl Fn(u64) -> Pixel,
) -> Result<(), ChartError> {
    for (&id, node) in tree {
        let to = pixel(id);
        match tree.get(&(id / 2)) {
            Some(parent) => draw_edge(page, node, (pixel(parent.id), to), parent.lines())?,
            None => draw_edge(page, node, ((to.0, to.1 - STUB), to), 0)?,
        }
    }
    for (&id, node) in tree {
        draw_node(page, node, pixel(id))?;
    }
    Ok(())
}

/// An edge with its word. Straight below its parent it starts under the parent's `lines`.
fn draw_edge(
    page: &Page<'_>,
    node: &TreeNode,
    (from, to): (Pixel, Pixel),
    lines: i32,
) -> Result<(), ChartError> {
    let pen = node.kind.pen();
    if from.0 == to.0 {
        let skip = match lines {
            0 => 0,
            lines => RADIUS + lines * LINE + px(4),
        };
        pen.trace(page, vec![(from.0, from.1 + skip), to])?;
    } else {
        pen.trace(page, vec![from, (to.0, from.1), to])?;
    }
    let letters = Letters::new(SMALL).coloured(pen.colour);
    let at = (to.0 + RADIUS, to.1 - RADIUS - LINE);
    letters.write(page, at, &node.edge_label)
}

fn draw_node(page: &Page<'_>, node: &TreeNode, at: Pixel) -> Result<(), ChartError> {
    disk(page, at, 6, node.kind.pen().colour)?;
    let letters = Letters::new(SMALL).anchored(HPos::Center, VPos::Top);
    let top = at.1 + RADIUS + px(4);
    letters.write(page, (at.0, top), &node.label)?;
    match &node.note {
        Some(note) => letters.coloured(GREY).write(page, (at.0, top + LINE), note),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_straight_down_starts_below_the_words_of_its_parent() {
        let start = |label: &str| {
            let nodes = vec![
                TreeNode::new(1, EdgeKind::Camera, label, ""),
                TreeNode::new(2, EdgeKind::Reflected, "", ""),
            ];
            let title = String::new();
            let svg = TreeDrawing { title, nodes }.to_svg().unwrap();
            let top = TITLE_BAND + STUB;
            let x = PAGE.0 / 2;
            let start = (0..LEVEL).find(|down| svg.contains(&format!("\"{x},{} ", top + down)));
            start.unwrap()
        };
        assert_eq!(start(""), 0);
        assert_eq!(start("glass"), RADIUS + LINE + px(4));
    }
}
