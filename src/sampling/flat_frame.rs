//! Local coordinates around a unit normal of the flat world, where `y` is the normal.

use glam::Vec2;

/// A tangent and a normal: an orthonormal, right-handed basis of the plane.
#[derive(Clone, Copy, Debug)]
pub struct FlatFrame {
    tangent: Vec2,
    normal: Vec2,
}

impl FlatFrame {
    /// The frame whose `y` axis is the unit normal `n`.
    ///
    /// Turning `(x, y)` by a right angle gives `(y, -x)`: no case to distinguish and nothing to
    /// round, where three dimensions need care (see [`Frame`](super::frame::Frame)).
    pub fn new(n: Vec2) -> Self {
        debug_assert!((n.length() - 1.0).abs() < 1e-4, "not a unit normal: {n}");
        FlatFrame {
            tangent: Vec2::new(n.y, -n.x),
            normal: n,
        }
    }

    /// From world coordinates to local ones.
    pub fn to_local(&self, w: Vec2) -> Vec2 {
        Vec2::new(w.dot(self.tangent), w.dot(self.normal))
    }

    /// From local coordinates to world ones: tangent and normal are the columns of the matrix.
    pub fn to_world(&self, w: Vec2) -> Vec2 {
        self.tangent * w.x + self.normal * w.y
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_columns_are_tangent_and_normal_and_the_basis_is_right_handed() {
        for k in 0..64 {
            let (sin, cos) = crate::numeric::sin_cos(k as f32 * 0.1);
            let n = Vec2::new(sin, cos);
            let frame = FlatFrame::new(n);
            assert_eq!(frame.to_world(Vec2::Y), n);
            let tangent = frame.to_world(Vec2::X);
            assert_eq!(tangent.dot(n), 0.0);
            assert!((tangent.perp_dot(n) - 1.0).abs() < 1e-6);
            let w = Vec2::new(0.6, -0.8);
            assert!((frame.to_local(frame.to_world(w)) - w).length() < 1e-6);
        }
    }
}
