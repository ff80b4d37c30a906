//! A ray of either world.

use super::Space;

/// A half line from `origin`, as far as `t_max`, at one moment.
#[derive(Clone, Copy, Debug)]
pub struct Ray<S: Space> {
    /// Where it starts.
    pub origin: S::Vector,
    /// Where it goes; distances along it count in units of this vector's length.
    pub direction: S::Vector,
    /// How far it reaches; infinite for all but shadow rays.
    pub t_max: f32,
    /// When it looks: from 0, where the shutter opens, to 1, where it closes.
    pub time: f32,
}

impl<S: Space> Ray<S> {
    /// A ray without end, at the moment the shutter opens.
    pub fn new(origin: S::Vector, direction: S::Vector) -> Self {
        Ray {
            origin,
            direction,
            t_max: f32::INFINITY,
            time: 0.0,
        }
    }

    /// The same ray at another moment.
    #[must_use]
    pub fn at_time(self, time: f32) -> Self {
        debug_assert!((0.0..=1.0).contains(&time), "{time}");
        Ray { time, ..self }
    }

    /// The point at distance `t`.
    pub fn at(&self, t: f32) -> S::Vector {
        self.origin + self.direction * t
    }
}
