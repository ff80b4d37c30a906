//! The matrix that turns the half disk to a surface.

use glam::{Mat2, Vec2};

/// The matrix whose columns are the tangent `T = (n.y, -n.x)` and the unit normal `n`.
///
/// It takes local coordinates, where `y` is the normal, to those of the world: `(cos θ, sin θ)`
/// with θ from the tangent becomes `cos θ T + sin θ n`. It is a rotation, so its inverse is its
/// transpose; using the transpose in its place turns the half disk the wrong way, and sends the
/// share `2α/π` of the rays below a surface tilted by `α ≤ π/2`.
///
/// ```
/// use glam::Vec2;
/// use halfdisk::flatland::frame;
///
/// let n = Vec2::new(0.6, 0.8);
/// assert_eq!(frame(n) * Vec2::Y, n);
/// assert_eq!(frame(n).transpose() * n, Vec2::Y);
/// ```
pub fn frame(n: Vec2) -> Mat2 {
    debug_assert!((n.length() - 1.0).abs() < 1e-4, "not a unit normal: {n}");
    Mat2::from_cols(Vec2::new(n.y, -n.x), n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::sin_cos;
    use std::f32::consts::{FRAC_PI_2, PI, TAU};

    #[test]
    fn a_rotation_for_every_normal() {
        for i in 0..1000 {
            let (sin, cos) = sin_cos(TAU * i as f32 / 1000.0);
            let m = frame(Vec2::new(sin, cos));
            assert!((m.determinant() - 1.0).abs() < 2e-7);
            assert!(m.col(0).dot(m.col(1)).abs() < 2e-7);
        }
    }

    #[test]
    fn no_ray_below_the_surface_and_a_known_share_with_the_transpose() {
        let rays = 3600;
        for degrees in [0, 30, 45, 60, 90] {
            let tilt = FRAC_PI_2 * degrees as f32 / 90.0;
            let (sin, cos) = sin_cos(tilt);
            let n = Vec2::new(sin, cos);
            let below = |m: Mat2| {
                let ray = |i: usize| {
                    let (sin, cos) = sin_cos(PI * (i as f32 + 0.5) / rays as f32);
                    m * Vec2::new(cos, sin)
                };
                (0..rays).filter(|&i| ray(i).dot(n) < 0.0).count()
            };
            assert_eq!(below(frame(n)), 0);
            // Evenly spaced angles: 2α/π of them, up to one at the rim.
            let wrong = below(frame(n).transpose());
            assert!(
                wrong.abs_diff(rays * degrees / 90) <= 1,
                "{degrees}: {wrong}"
            );
        }
    }
}
