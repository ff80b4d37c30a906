//! Where nodes go: leaves get columns of their own, parents stand over the middle of their
//! children. Nodes of one level are then never less than a column apart.

use std::collections::BTreeMap;

use super::Nodes;

/// How many rays lead to the camera ray.
pub(super) fn level(id: u64) -> i32 {
    id.ilog2() as i32
}

/// The column of every node, leaves counting from 0 at the left.
pub(super) fn columns(tree: &Nodes<'_>) -> BTreeMap<u64, f64> {
    let mut columns = BTreeMap::new();
    place(1, tree, &mut 0, &mut columns);
    columns
}

/// Places a node and all that hangs from it; `leaves` counts the columns taken so far.
fn place(
    id: u64,
    tree: &Nodes<'_>,
    leaves: &mut u32,
    columns: &mut BTreeMap<u64, f64>,
) -> Option<f64> {
    tree.get(&id)?;
    let child = |bit| id.checked_mul(2).map(|twice| twice + bit);
    let mut below = |bit| place(child(bit)?, tree, leaves, columns);
    let column = match (below(0), below(1)) {
        (Some(left), Some(right)) => (left + right) / 2.0,
        (Some(only), None) | (None, Some(only)) => only,
        (None, None) => {
            *leaves += 1;
            f64::from(*leaves - 1)
        }
    };
    columns.insert(id, column);
    Some(column)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::drawing::tree::{EdgeKind, TreeNode};

    /// The columns of a tree of seven levels, in which ray `i` ends if `dead` divides `i`.
    fn pruned(dead: u64) -> BTreeMap<u64, f64> {
        let node = |id| TreeNode::new(id, EdgeKind::Camera, "", "");
        let mut nodes = vec![node(1)];
        for id in 2..1 << 7 {
            let parent = id / 2;
            if parent % dead != 0 && nodes.iter().any(|node| node.id == parent) {
                nodes.push(node(id));
            }
        }
        columns(&nodes.iter().map(|node| (node.id, node)).collect())
    }

    #[test]
    fn nodes_of_a_level_are_at_least_a_column_apart() {
        for dead in [2, 3, 5, 7, 1000] {
            let mut levels: BTreeMap<i32, Vec<f64>> = BTreeMap::new();
            for (id, column) in pruned(dead) {
                levels.entry(level(id)).or_default().push(column);
            }
            for row in levels.values() {
                assert!(row.windows(2).all(|pair| pair[1] - pair[0] >= 1.0));
            }
        }
    }

    #[test]
    fn parents_stand_over_the_middle_of_their_children() {
        let columns = pruned(1000);
        for (id, column) in &columns {
            if let (Some(left), Some(right)) = (columns.get(&(2 * id)), columns.get(&(2 * id + 1)))
            {
                assert_eq!(*column, (left + right) / 2.0);
            }
        }
    }
}
