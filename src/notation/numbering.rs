//! Numbers for things that are met again, such as states.

use std::collections::HashMap;
use std::hash::Hash;

/// Numbers things as they appear, from 0.
pub(super) struct Numbering<T> {
    /// The things by their numbers.
    pub items: Vec<T>,
    numbers: HashMap<T, u32>,
}

impl<T> Default for Numbering<T> {
    fn default() -> Self {
        Numbering {
            items: Vec::new(),
            numbers: HashMap::new(),
        }
    }
}

impl<T: Copy + Eq + Hash> Numbering<T> {
    /// The number of `item`, a new one where it is new.
    pub fn number(&mut self, item: T) -> u32 {
        *self.numbers.entry(item).or_insert_with(|| {
            self.items.push(item);
            self.items.len() as u32 - 1
        })
    }
}
