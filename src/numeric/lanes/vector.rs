//! A vector for each lane.

use super::{Floats, Mask, Row, WideVector, Wides, floats};
use fearless_simd::prelude::*;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A vector in space for each lane: the operations of `glam::Vec3`, in the same order.
#[derive(Clone, Copy, Debug)]
pub struct Vector<S: Simd> {
    /// First coordinates.
    pub x: Floats<S>,
    /// Second coordinates.
    pub y: Floats<S>,
    /// Third coordinates.
    pub z: Floats<S>,
}

/// A vector in space for each lane, in memory.
#[derive(Clone, Copy, Debug, Default)]
pub struct Row3(pub [Row; 3]);

impl Row3 {
    /// The numbers as vectors.
    #[inline(always)]
    pub fn get<S: Simd>(&self, s: S) -> Vector<S> {
        let [x, y, z] = &self.0;
        Vector {
            x: x.get(s),
            y: y.get(s),
            z: z.get(s),
        }
    }

    /// Stores vectors.
    #[inline(always)]
    pub fn set<S: Simd>(&mut self, v: Vector<S>) {
        let [x, y, z] = &mut self.0;
        x.set(v.x);
        y.set(v.y);
        z.set(v.z);
    }

    /// Stores vectors in some of the lanes.
    #[inline(always)]
    pub fn set_where<S: Simd>(&mut self, s: S, mask: Mask<S>, v: Vector<S>) {
        let old = self.get(s);
        self.set(Vector::select(mask, v, old));
    }

    /// That of one lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> [f32; 3] {
        let [x, y, z] = &self.0;
        [x.0[lane], y.0[lane], z.0[lane]]
    }

    /// Stores that of one lane.
    #[inline(always)]
    pub fn set_lane(&mut self, lane: usize, v: impl Into<[f32; 3]>) {
        for (row, x) in self.0.iter_mut().zip(v.into()) {
            row.0[lane] = x;
        }
    }
}

impl<S: Simd> From<Vector<S>> for Row3 {
    #[inline(always)]
    fn from(v: Vector<S>) -> Row3 {
        let mut row = Row3::default();
        row.set(v);
        row
    }
}

impl<S: Simd> Vector<S> {
    /// The vectors of these coordinates.
    #[inline(always)]
    pub fn new(x: Floats<S>, y: Floats<S>, z: Floats<S>) -> Self {
        Vector { x, y, z }
    }

    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(s: S, v: impl Into<[f32; 3]>) -> Self {
        let [x, y, z] = v.into();
        Vector {
            x: floats(s, x),
            y: floats(s, y),
            z: floats(s, z),
        }
    }

    /// One of the coordinates: the first for 0, the second for 1, else the third.
    #[inline(always)]
    pub fn coordinate(self, axis: usize) -> Floats<S> {
        match axis {
            0 => self.x,
            1 => self.y,
            _ => self.z,
        }
    }

    /// The dot product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> Floats<S> {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    /// Coordinate by coordinate.
    #[inline(always)]
    #[must_use]
    pub fn times(self, o: Self) -> Self {
        Vector {
            x: self.x * o.x,
            y: self.y * o.y,
            z: self.z * o.z,
        }
    }

    /// Without signs.
    #[inline(always)]
    #[must_use]
    pub fn abs(self) -> Self {
        Vector {
            x: self.x.abs(),
            y: self.y.abs(),
            z: self.z.abs(),
        }
    }

    /// The largest coordinate.
    #[inline(always)]
    pub fn max_element(self) -> Floats<S> {
        self.x.max(self.y).max(self.z)
    }

    /// Of length one.
    #[inline(always)]
    #[must_use]
    pub fn normalize(self) -> Self {
        self * (1.0 / self.dot(self).sqrt())
    }

    /// `yes` where the mask is set, else `no`.
    #[inline(always)]
    pub fn select(mask: Mask<S>, yes: Self, no: Self) -> Self {
        Vector {
            x: mask.select(yes.x, no.x),
            y: mask.select(yes.y, no.y),
            z: mask.select(yes.z, no.z),
        }
    }

    /// Lanes in which all coordinates are zero.
    #[inline(always)]
    pub fn is_zero(self, s: S) -> Mask<S> {
        let zero = floats(s, 0.0);
        self.x.simd_eq(zero) & self.y.simd_eq(zero) & self.z.simd_eq(zero)
    }

    /// In `f64`.
    #[inline(always)]
    pub fn widen(self) -> WideVector<S> {
        WideVector {
            x: Wides::from(self.x),
            y: Wides::from(self.y),
            z: Wides::from(self.z),
        }
    }
}

impl<S: Simd> Add for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, o: Self) -> Self {
        Vector {
            x: self.x + o.x,
            y: self.y + o.y,
            z: self.z + o.z,
        }
    }
}

impl<S: Simd> Sub for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        Vector {
            x: self.x - o.x,
            y: self.y - o.y,
            z: self.z - o.z,
        }
    }
}

impl<S: Simd> Mul<Floats<S>> for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, k: Floats<S>) -> Self {
        Vector {
            x: self.x * k,
            y: self.y * k,
            z: self.z * k,
        }
    }
}

impl<S: Simd> Mul<f32> for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, k: f32) -> Self {
        Vector {
            x: self.x * k,
            y: self.y * k,
            z: self.z * k,
        }
    }
}

impl<S: Simd> Div<Floats<S>> for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn div(self, k: Floats<S>) -> Self {
        Vector {
            x: self.x / k,
            y: self.y / k,
            z: self.z / k,
        }
    }
}

impl<S: Simd> Neg for Vector<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Vector {
            x: -self.x,
            y: -self.y,
            z: -self.z,
        }
    }
}
