//! Round things: circles and pieces of them.

use std::f64::consts::TAU;

use super::StrokeKind;
use super::view::{Bounds, Sheet};
use crate::chart::ChartError;
use crate::chart::canvas::Page;

/// A round thing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    /// Its centre.
    pub center: [f64; 2],
    /// Its radius.
    pub radius: f64,
    /// What it stands for.
    pub kind: StrokeKind,
}

/// A piece of a circle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arc {
    /// Centre of the circle.
    pub center: [f64; 2],
    /// Radius of the circle.
    pub radius: f64,
    /// The angle where it begins, in radians, counter-clockwise from the right.
    pub start: f64,
    /// How far it goes on from there, counter-clockwise, in radians.
    pub turn: f64,
    /// What it stands for.
    pub kind: StrokeKind,
}

impl From<Circle> for Arc {
    fn from(circle: Circle) -> Self {
        Self {
            center: circle.center,
            radius: circle.radius,
            start: 0.0,
            turn: TAU,
            kind: circle.kind,
        }
    }
}

impl Arc {
    /// One line where the whole arc is in view, so that it has no joints; else what is in view.
    pub(super) fn draw(
        &self,
        page: &Page<'_>,
        sheet: &Sheet,
        view: &Bounds,
    ) -> Result<(), ChartError> {
        let corners = self.corners();
        if corners.iter().all(|&at| view.holds(at)) {
            let outline = corners.into_iter().map(|at| sheet.pixel(at)).collect();
            return self.kind.pen().trace(page, outline);
        }
        for side in corners.windows(2) {
            if let Some(ends) = view.clip(side[0], side[1]) {
                let line = ends.map(|at| sheet.pixel(at)).to_vec();
                self.kind.pen().trace(page, line)?;
            }
        }
        Ok(())
    }

    /// The corners of a chain that looks round: 96 sides to the full circle.
    fn corners(&self) -> Vec<[f64; 2]> {
        let sides = (self.turn.abs() / TAU * 96.0).ceil().clamp(1.0, 96.0) as i32;
        let corner = |i: i32| {
            let angle = self.start + self.turn * f64::from(i) / f64::from(sides);
            let (sin, cos) = libm::sincos(angle);
            [
                self.center[0] + self.radius * cos,
                self.center[1] + self.radius * sin,
            ]
        };
        (0..=sides).map(corner).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn a_half_circle_begins_and_ends_on_its_diameter() {
        let arc = Arc {
            center: [1.0, 2.0],
            radius: 0.5,
            start: -FRAC_PI_2,
            turn: PI,
            kind: StrokeKind::HalfDisk,
        };
        let corners = arc.corners();
        assert_eq!(corners.len(), 49);
        let near = |at: [f64; 2], x: f64, y: f64| (at[0] - x).abs() + (at[1] - y).abs() < 1e-12;
        assert!(near(corners[0], 1.0, 1.5) && near(corners[48], 1.0, 2.5));
        assert!(near(corners[24], 1.5, 2.0));
    }
}
