//! Numbers of 64 bits for each lane, in two halves.

use super::{Floats, LANES, Mask, Vector, Words};
use fearless_simd::prelude::*;
use fearless_simd::{f64x8, u64x8};
use std::ops::{Add, BitXor, Div, Mul, Neg, Shr, Sub};

/// One `f64` for each lane: those of the first eight, and of the others.
#[derive(Clone, Copy, Debug)]
pub struct Wides<S: Simd>(pub f64x8<S>, pub f64x8<S>);

impl<S: Simd> From<Floats<S>> for Wides<S> {
    #[inline(always)]
    fn from(x: Floats<S>) -> Self {
        let (low, high) = x.widen();
        Wides(low, high)
    }
}

impl<S: Simd> Wides<S> {
    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(s: S, x: f64) -> Self {
        Wides(f64x8::splat(s, x), f64x8::splat(s, x))
    }

    /// From memory.
    #[inline(always)]
    pub fn load(s: S, x: &[f64; LANES]) -> Self {
        let (low, high) = x.split_at(LANES / 2);
        Wides(f64x8::from_slice(s, low), f64x8::from_slice(s, high))
    }

    /// Rounded to `f32`.
    #[inline(always)]
    pub fn narrow(self) -> Floats<S> {
        self.0.narrow(self.1)
    }

    /// Square roots.
    #[inline(always)]
    #[must_use]
    pub fn sqrt(self) -> Self {
        Wides(self.0.sqrt(), self.1.sqrt())
    }

    /// Lanes in which it is at least the other.
    #[inline(always)]
    pub fn ge(self, o: Self) -> Mask<S> {
        self.0.simd_ge(o.0).narrow(self.1.simd_ge(o.1))
    }

    /// Lanes in which it is above the other.
    #[inline(always)]
    pub fn gt(self, o: Self) -> Mask<S> {
        self.0.simd_gt(o.0).narrow(self.1.simd_gt(o.1))
    }

    /// `yes` where the mask is set, else `no`.
    #[inline(always)]
    pub fn select(mask: Mask<S>, yes: Self, no: Self) -> Self {
        let (low, high) = mask.widen();
        Wides(low.select(yes.0, no.0), high.select(yes.1, no.1))
    }
}

macro_rules! by_halves {
    ($trait:ident, $method:ident, $op:tt) => {
        impl<S: Simd> $trait for Wides<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, o: Self) -> Self {
                Wides(self.0 $op o.0, self.1 $op o.1)
            }
        }

        impl<S: Simd> $trait<f64> for Wides<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, o: f64) -> Self {
                Wides(self.0 $op o, self.1 $op o)
            }
        }
    };
}

by_halves!(Add, add, +);
by_halves!(Sub, sub, -);
by_halves!(Mul, mul, *);
by_halves!(Div, div, /);

impl<S: Simd> Neg for Wides<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Wides(-self.0, -self.1)
    }
}

/// A vector in `f64` for each lane: the operations of `glam::DVec3`, in the same order.
#[derive(Clone, Copy, Debug)]
pub struct WideVector<S: Simd> {
    /// First coordinates.
    pub x: Wides<S>,
    /// Second coordinates.
    pub y: Wides<S>,
    /// Third coordinates.
    pub z: Wides<S>,
}

impl<S: Simd> WideVector<S> {
    /// The same vector in every lane.
    #[inline(always)]
    pub fn splat(s: S, v: impl Into<[f64; 3]>) -> Self {
        let [x, y, z] = v.into();
        WideVector {
            x: Wides::splat(s, x),
            y: Wides::splat(s, y),
            z: Wides::splat(s, z),
        }
    }

    /// The dot product.
    #[inline(always)]
    pub fn dot(self, o: Self) -> Wides<S> {
        self.x * o.x + self.y * o.y + self.z * o.z
    }

    /// The cross product.
    #[inline(always)]
    #[must_use]
    pub fn cross(self, o: Self) -> Self {
        WideVector {
            x: self.y * o.z - o.y * self.z,
            y: self.z * o.x - o.z * self.x,
            z: self.x * o.y - o.x * self.y,
        }
    }

    /// Of length one.
    #[inline(always)]
    #[must_use]
    pub fn normalize(self, s: S) -> Self {
        let scale = Wides::splat(s, 1.0) / self.dot(self).sqrt();
        WideVector {
            x: self.x * scale,
            y: self.y * scale,
            z: self.z * scale,
        }
    }

    /// Rounded to `f32`.
    #[inline(always)]
    pub fn narrow(self) -> Vector<S> {
        Vector {
            x: self.x.narrow(),
            y: self.y.narrow(),
            z: self.z.narrow(),
        }
    }
}

impl<S: Simd> Sub for WideVector<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, o: Self) -> Self {
        WideVector {
            x: self.x - o.x,
            y: self.y - o.y,
            z: self.z - o.z,
        }
    }
}

/// One `u64` for each lane: those of the first eight, and of the others.
#[derive(Clone, Copy, Debug)]
pub struct Words64<S: Simd>(u64x8<S>, u64x8<S>);

impl<S: Simd> Words64<S> {
    /// The same number in every lane.
    #[inline(always)]
    pub fn splat(s: S, x: u64) -> Self {
        Words64(u64x8::splat(s, x), u64x8::splat(s, x))
    }

    /// From memory.
    #[inline(always)]
    pub fn load(s: S, x: &[u64; LANES]) -> Self {
        let (low, high) = x.split_at(LANES / 2);
        Words64(u64x8::from_slice(s, low), u64x8::from_slice(s, high))
    }

    /// The lower 32 bits of each.
    #[inline(always)]
    pub fn low(self) -> Words<S> {
        self.0.narrow(self.1)
    }
}

impl<S: Simd> From<Words<S>> for Words64<S> {
    #[inline(always)]
    fn from(x: Words<S>) -> Self {
        let (low, high) = x.widen();
        Words64(low, high)
    }
}

/// Modulo 2^64.
impl<S: Simd> Mul<u64> for Words64<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, k: u64) -> Self {
        Words64(self.0 * k, self.1 * k)
    }
}

/// Modulo 2^64.
impl<S: Simd> Add<u64> for Words64<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, k: u64) -> Self {
        Words64(self.0 + k, self.1 + k)
    }
}

impl<S: Simd> BitXor for Words64<S> {
    type Output = Self;
    #[inline(always)]
    fn bitxor(self, o: Self) -> Self {
        Words64(self.0 ^ o.0, self.1 ^ o.1)
    }
}

impl<S: Simd> Shr<u32> for Words64<S> {
    type Output = Self;
    #[inline(always)]
    fn shr(self, n: u32) -> Self {
        Words64(self.0 >> n, self.1 >> n)
    }
}
