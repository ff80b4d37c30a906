//! A ray of either world.

use super::Space;

/// A half line from `origin`.
#[derive(Clone, Copy, Debug)]
pub struct Ray<S: Space> {
    /// Where it starts.
    pub origin: S::Vector,
    /// Where it goes, unit.
    pub direction: S::Vector,
}

impl<S: Space> Ray<S> {
    /// The point at distance `t`.
    pub fn at(&self, t: f32) -> S::Vector {
        self.origin + self.direction * t
    }
}
