//! Ray trees: one camera ray and everything it splits into.
//!
//! Rays are numbered as in a heap: the camera ray is 1, and ray `i` reflects as `2i` and
//! transmits as `2i + 1`.

mod draw;
mod layout;

use std::collections::BTreeMap;

use super::{ChartError, FULL};

/// A tree of rays.
#[derive(Clone, Debug, Default)]
pub struct TreeDrawing {
    /// Headline.
    pub title: String,
    /// The nodes in any order; every one but the root needs its parent.
    pub nodes: Vec<TreeNode>,
}

/// The nodes of a tree by number.
type Nodes<'t> = BTreeMap<u64, &'t TreeNode>;

/// A place where a ray ended.
#[derive(Clone, Debug, PartialEq)]
pub struct TreeNode {
    /// Heap number: 1 for the camera ray, `2i` and `2i + 1` for what ray `i` split into.
    pub id: u64,
    /// What was hit.
    pub label: String,
    /// A word beside the ray that led here, such as its weight.
    pub edge_label: String,
    /// How that ray came about.
    pub kind: EdgeKind,
    /// A second line below the label.
    pub note: Option<String>,
}

/// How a ray came about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeKind {
    /// It left the camera.
    Camera,
    /// It bounced off a surface.
    Reflected,
    /// It went through a surface.
    Transmitted,
}

impl TreeNode {
    /// A node without a note.
    pub fn new(
        id: u64,
        kind: EdgeKind,
        label: impl Into<String>,
        edge_label: impl Into<String>,
    ) -> Self {
        Self {
            id,
            label: label.into(),
            edge_label: edge_label.into(),
            kind,
            note: None,
        }
    }
}

impl TreeDrawing {
    /// The drawing as SVG text, as wide as a page, or as its leaves need.
    pub fn to_svg(&self) -> Result<String, ChartError> {
        Ok(self.draw(&self.tree()?, f64::from(FULL)))
    }

    /// The nodes by number, each of them hanging from another or being the root.
    fn tree(&self) -> Result<Nodes<'_>, ChartError> {
        if self.nodes.is_empty() {
            return Err(ChartError::Empty(self.title.clone()));
        }
        let broken = |id| ChartError::BrokenTree {
            chart: self.title.clone(),
            id,
        };
        let mut tree = BTreeMap::new();
        for node in &self.nodes {
            if tree.insert(node.id, node).is_some() {
                return Err(broken(node.id));
            }
        }
        let orphan = |&&id: &&u64| id == 0 || (id > 1 && !tree.contains_key(&(id / 2)));
        match tree.keys().find(orphan) {
            Some(&id) => Err(broken(id)),
            None => Ok(tree),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    /// A tree in which every ray above the last level splits, unless its number is a multiple
    /// of `dead`.
    fn tree(levels: u32, dead: u64) -> TreeDrawing {
        let mut nodes = vec![TreeNode::new(1, EdgeKind::Camera, "glass", "1")];
        for id in 2..1 << levels {
            let parent = id / 2;
            if nodes.iter().any(|node| node.id == parent) && parent % dead != 0 {
                let kind = EdgeKind::ALL[1 + id as usize % 2];
                nodes.push(TreeNode::new(id, kind, "glass", "0.5"));
            }
        }
        TreeDrawing {
            title: "split".into(),
            nodes,
        }
    }

    #[test]
    fn every_node_is_a_circle() {
        let drawing = tree(5, 3);
        let svg = drawing.to_svg().unwrap();
        assert_eq!(svg.matches("<circle").count(), drawing.nodes.len());
    }

    #[test]
    fn a_wide_tree_grows_beyond_the_usual_page() {
        let wide = format!(" width=\"{FULL}\"");
        assert!(tree(2, 9).to_svg().unwrap().contains(&wide));
        assert!(!tree(7, 1000).to_svg().unwrap().contains(&wide));
    }

    #[test]
    fn the_deepest_number_has_no_children_to_look_for() {
        let chain = (0..64).map(|i| TreeNode::new(u64::MAX >> i, EdgeKind::Camera, "", ""));
        let drawing = TreeDrawing {
            title: "chain".into(),
            nodes: chain.collect(),
        };
        assert!(drawing.to_svg().is_ok());
    }

    #[test]
    fn empty_orphaned_and_doubled_nodes_are_refused() {
        let refusal = TreeDrawing::default().to_svg();
        assert_eq!(refusal, Err(ChartError::Empty(String::new())));
        for id in [0, 1, 12] {
            let mut drawing = tree(3, 9);
            drawing.nodes.retain(|node| node.id != 6);
            drawing
                .nodes
                .push(TreeNode::new(id, EdgeKind::Camera, "", ""));
            let chart = "split".into();
            assert_eq!(drawing.to_svg(), Err(ChartError::BrokenTree { chart, id }));
        }
    }
}
