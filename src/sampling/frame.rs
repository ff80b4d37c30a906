//! Local coordinates around a unit normal, where `z` is the normal.

use glam::Vec3;

/// Two tangents and a normal: an orthonormal, right-handed basis.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    tangent: Vec3,
    bitangent: Vec3,
    normal: Vec3,
}

impl Frame {
    /// The frame whose `z` axis is the unit normal `n`.
    ///
    /// Source: Duff et al., Building an Orthonormal Basis, Revisited (JCGT 6(1), 2017), which has
    /// no bad direction: the version before it loses every digit near `n = (0, 0, -1)`.
    pub fn new(n: Vec3) -> Self {
        debug_assert!((n.length() - 1.0).abs() < 1e-4, "not a unit normal: {n}");
        let (tangent, bitangent) = n.any_orthonormal_pair();
        Frame {
            tangent,
            bitangent,
            normal: n,
        }
    }

    /// From world coordinates to local ones.
    pub fn to_local(&self, w: Vec3) -> Vec3 {
        Vec3::new(
            w.dot(self.tangent),
            w.dot(self.bitangent),
            w.dot(self.normal),
        )
    }

    /// From local coordinates to world ones.
    pub fn to_world(&self, w: Vec3) -> Vec3 {
        self.tangent * w.x + self.bitangent * w.y + self.normal * w.z
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::{
        stream::{Purpose, Stream},
        warps,
    };

    fn rms_error(n: Vec3) -> f64 {
        let f = Frame::new(n);
        let axes = [f.tangent, f.bitangent, f.normal].map(Vec3::as_dvec3);
        let mut sum = 0.0;
        for (i, a) in axes.iter().enumerate() {
            for (j, b) in axes.iter().enumerate() {
                sum += (a.dot(*b) - f64::from(u8::from(i == j))).powi(2);
            }
        }
        (sum / 9.0).sqrt()
    }

    #[test]
    fn orthonormal_everywhere_also_where_older_recipes_fail() {
        // The two vectors Duff et al. print, near -Z, and the six axes.
        let hard = [
            Vec3::new(0.000_385_273_16, 0.000_384_600_16, -0.999_999_9),
            Vec3::new(-0.000_197_872_2, -0.000_148_574_8, -0.999_999_96),
        ];
        for n in [Vec3::X, Vec3::Y, Vec3::Z] {
            assert!(rms_error(n) == 0.0 && rms_error(-n) == 0.0);
        }
        let mut worst: f64 = hard.into_iter().map(rms_error).fold(0.0, f64::max);
        for i in 0..100_000 {
            let mut u = Stream::new(3, i, 0).at(0, Purpose::Direction);
            let near_pole = Vec3::new(
                (u.one() - 0.5) * 4e-3,
                (u.one() - 0.5) * 4e-3,
                if u.one() < 0.5 { 1.0 } else { -1.0 },
            )
            .normalize();
            worst = worst
                .max(rms_error(near_pole))
                .max(rms_error(warps::sample_sphere(u.two())));
        }
        // The normals themselves are unit only to f32 precision, which is most of what is seen.
        assert!(worst < 2e-7, "worst rms error {worst:e}");
    }

    #[test]
    fn there_and_back() {
        let f = Frame::new(Vec3::new(0.6, -0.8, 0.0));
        let w = Vec3::new(0.1, 0.2, 0.97);
        assert!((f.to_world(f.to_local(w)) - w).length() < 1e-6);
        assert!((f.to_local(Vec3::new(0.6, -0.8, 0.0)) - Vec3::Z).length() < 1e-6);
    }
}
