//! Eight triangles side by side, of which a glance leaves one or two to be tested.

use super::node::WIDTH;
use crate::geometry::{PreparedRay, Triangle};
use crate::numeric::gamma;
use glam::Vec3;

/// Up to eight triangles that follow each other in the order of the tree.
#[derive(Clone, Debug)]
pub(super) struct Packet {
    /// The three corners, for each the three coordinates, for each the triangles.
    corners: [[[f32; WIDTH]; 3]; 3],
    /// The place of the first triangle in the order of the tree.
    pub(super) first: u32,
    /// A bit for each triangle.
    present: u32,
}

impl Packet {
    pub(super) fn new(first: usize, triangles: &[Triangle]) -> Self {
        let mut packet = Packet {
            corners: [[[0.0; WIDTH]; 3]; 3],
            first: first as u32,
            present: 0,
        };
        for (lane, t) in triangles.iter().enumerate() {
            for (corner, of) in [t.a, t.b, t.c].into_iter().zip(&mut packet.corners) {
                for (x, lanes) in corner.to_array().into_iter().zip(of) {
                    lanes[lane] = x;
                }
            }
            packet.present |= 1 << lane;
        }
        packet
    }

    /// One of the triangles.
    #[inline(always)]
    pub(super) fn triangle(&self, lane: usize) -> Triangle {
        let [a, b, c] = self
            .corners
            .each_ref()
            .map(|[x, y, z]| Vec3::new(x[lane], y[lane], z[lane]));
        Triangle { a, b, c }
    }

    /// A mask of the triangles that the ray may cross; certainly not the others.
    ///
    /// The edge functions of [`Triangle::cross`] in `f32`, each with a bound on its error: a
    /// triangle is out where one of them is certainly positive and another certainly negative.
    /// Infinities and NaN are never certain.
    #[inline(always)]
    pub(super) fn candidates(&self, ray: &PreparedRay) -> u32 {
        let [ax, ay, az] = ray.axes;
        let mut xs = [[0.0; WIDTH]; 3];
        let mut ys = [[0.0; WIDTH]; 3];
        for k in 0..3 {
            let [x, y, z] = [ax, ay, az].map(|axis| &self.corners[k][axis]);
            let [ox, oy, oz] = [ax, ay, az].map(|axis| ray.origin[axis]);
            for lane in 0..WIDTH {
                let height = z[lane] - oz;
                xs[k][lane] = (x[lane] - ox) - ray.shear[0] * height;
                ys[k][lane] = (y[lane] - oy) - ray.shear[1] * height;
            }
        }
        let mut highest = [f32::NEG_INFINITY; WIDTH];
        let mut lowest = [f32::INFINITY; WIDTH];
        for (p, q) in [(1, 2), (2, 0), (0, 1)] {
            for lane in 0..WIDTH {
                let left = xs[q][lane] * ys[p][lane];
                let right = ys[q][lane] * xs[p][lane];
                let edge = left - right;
                // Three roundings, of which the products' may be in the last subnormal digit.
                let error = (left.abs() + right.abs()) * gamma(4) + f32::MIN_POSITIVE;
                let (low, high) = (edge + error, edge - error);
                highest[lane] = if high > highest[lane] {
                    high
                } else {
                    highest[lane]
                };
                lowest[lane] = if low < lowest[lane] {
                    low
                } else {
                    lowest[lane]
                };
            }
        }
        let mut out = 0;
        for lane in 0..WIDTH {
            out |= u32::from((highest[lane] > 0.0) & (lowest[lane] < 0.0)) << lane;
        }
        self.present & !out
    }
}
