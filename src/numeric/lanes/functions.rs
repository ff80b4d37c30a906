//! The functions of [`numeric`](crate::numeric), sixteen at a time and bit for bit.

use super::{Floats, Vector, Wides, Words, floats, words};
use fearless_simd::prelude::*;
use std::f64::consts::FRAC_PI_2;

/// Sine and cosine of angles in radians: [`numeric::sin_cos`](crate::numeric::sin_cos).
///
/// * Domain: `[0, 2π]`.
#[inline(always)]
pub fn sin_cos<S: Simd>(s: S, x: Floats<S>) -> (Floats<S>, Floats<S>) {
    // Beyond π/4, 3π/4, 5π/4 and 7π/4, as the plain function rounds these.
    let q1 = x.simd_gt(floats(s, f32::from_bits(0x3f49_0fda)));
    let q2 = x.simd_gt(floats(s, f32::from_bits(0x4016_cbe3)));
    let q3 = x.simd_gt(floats(s, f32::from_bits(0x407b_53d1)));
    let q4 = x.simd_gt(floats(s, f32::from_bits(0x40af_eddf)));
    let angle = Wides::from(x);
    // How far from the nearest multiple of π/2.
    let y = Wides::select(q1, Wides::splat(s, FRAC_PI_2) - angle, angle);
    let y = Wides::select(q2, angle - 2.0 * FRAC_PI_2, y);
    let y = Wides::select(q3, angle - 3.0 * FRAC_PI_2, y);
    let y = Wides::select(q4, angle - 4.0 * FRAC_PI_2, y);
    let (sin, cos) = polynomials(s, y);
    // Below 2^-12 an angle is its sine, and 1 its cosine.
    let tiny = x.simd_lt(floats(s, f32::from_bits(0x3980_0000)));
    let (sin, cos) = (tiny.select(x, sin), tiny.select(floats(s, 1.0), cos));
    let swapped = (q1 & !q2) | (q3 & !q4);
    let a = swapped.select(cos, sin);
    let b = swapped.select(sin, cos);
    ((q2 & !q4).select(-a, a), (q2 & !q3).select(-b, b))
}

/// Sine and cosine near zero: the polynomials of `libm`, which are those of FreeBSD's `k_sinf` and `k_cosf`, in
/// the order of their operations.
#[inline(always)]
fn polynomials<S: Simd>(s: S, x: Wides<S>) -> (Floats<S>, Floats<S>) {
    const SIN: [f64; 4] = [
        -0.166_666_666_416_265_24,
        0.008_333_329_385_889_463,
        -0.000_198_393_348_360_966_32,
        0.000_002_718_311_493_989_822,
    ];
    const COS: [f64; 4] = [
        -0.499_999_997_251_031,
        0.041_666_623_323_739_06,
        -0.001_388_676_377_460_993,
        0.000_024_390_448_796_277_41,
    ];
    let z = x * x;
    let w = z * z;
    let cube = z * x;
    let rest = Wides::splat(s, SIN[2]) + z * SIN[3];
    let sin = (x + cube * (Wides::splat(s, SIN[0]) + z * SIN[1])) + cube * w * rest;
    let rest = Wides::splat(s, COS[2]) + z * COS[3];
    let cos = ((Wides::splat(s, 1.0) + z * COS[0]) + w * COS[1]) + (w * z) * rest;
    (sin.narrow(), cos.narrow())
}

/// Ray origins off their surfaces: [`numeric::offset_origin`](crate::numeric::offset_origin).
#[inline(always)]
pub fn offset_origin<S: Simd>(
    s: S,
    p: Vector<S>,
    error: Vector<S>,
    n: Vector<S>,
    direction: Vector<S>,
) -> Vector<S> {
    let distance = n.abs().dot(error);
    let behind = direction.dot(n).simd_lt(floats(s, 0.0));
    let side = behind.select(floats(s, -1.0), floats(s, 1.0));
    let offset = n * (side * distance);
    Vector {
        x: away(s, p.x, offset.x),
        y: away(s, p.y, offset.y),
        z: away(s, p.z, offset.z),
    }
}

#[inline(always)]
fn away<S: Simd>(s: S, p: Floats<S>, offset: Floats<S>) -> Floats<S> {
    let zero = floats(s, 0.0);
    let moved = p + offset;
    let up = !(offset.simd_gt(zero) ^ moved.simd_gt(zero));
    let number: Words<S> = moved.bitcast();
    let step = up.select(words(s, 1), words(s, u32::MAX));
    let stepped: Floats<S> = (number + step).bitcast();
    let from_zero = floats(s, f32::from_bits(1)).copysign(offset);
    let left = moved.simd_eq(zero).select(from_zero, stepped);
    offset.simd_eq(zero).select(moved, left)
}

/// Vectors as powers of two and directions:
/// [`numeric::scale_and_direction`](crate::numeric::scale_and_direction).
#[inline(always)]
pub fn scale_and_direction<S: Simd>(s: S, v: Vector<S>) -> (Floats<S>, Vector<S>) {
    let number: Words<S> = v.abs().max_element().bitcast();
    let power: Floats<S> = (number & words(s, 0x7f80_0000)).bitcast();
    let scale = power.simd_gt(floats(s, 0.0)).select(power, floats(s, 1.0));
    (scale, v * (floats(s, 1.0) / scale))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric;
    use crate::numeric::lanes::{LANES, Row, Row3, levels};
    use crate::sampling::stream::{Purpose, Stream};
    use fearless_simd::dispatch;
    use glam::Vec3;
    use std::f32::consts::TAU;

    #[test]
    fn sine_and_cosine_of_every_turn_are_those_of_the_plain_functions() {
        // Every angle that a uniform can become, sixteen neighbours at a time; all of them where optimised.
        let step = if cfg!(debug_assertions) { 997 } else { 1 };
        for level in levels() {
            for first in (0..1 << 20).step_by(step) {
                let angle =
                    |i: usize| (first * LANES as u32 + i as u32) as f32 / 16_777_216.0 * TAU;
                let row = Row(std::array::from_fn(angle));
                let (sin, cos) = dispatch!(level, s => {
                    let (sin, cos) = sin_cos(s, row.get(s));
                    (Row::from(sin), Row::from(cos))
                });
                for (i, &x) in row.0.iter().enumerate() {
                    let here = (sin.0[i].to_bits(), cos.0[i].to_bits());
                    let (sin, cos) = numeric::sin_cos(x);
                    assert_eq!(here, (sin.to_bits(), cos.to_bits()), "{x} {level:?}");
                }
            }
        }
    }

    #[test]
    fn origins_and_directions_are_those_of_the_plain_functions() {
        for sample in 0..20_000 {
            let mut numbers = Stream::new(5, 0, sample).at(0, Purpose::Direction);
            let size = libm::exp2(f64::from(numbers.one() * 60.0 - 30.0)) as f32;
            // Zeros of both signs among them.
            let mut row = |size: f32| {
                let mut one = || {
                    let x = (numbers.one() - 0.5) * size;
                    if numbers.one() < 0.1 { x * 0.0 } else { x }
                };
                Row3([(); 3].map(|()| Row(std::array::from_fn(|_| one()))))
            };
            let (p, error, n, to) = (row(size), row(size * 1e-6), row(2.0), row(2.0));
            for level in levels() {
                let (origin, scale, direction) = dispatch!(level, s => {
                    let origin = offset_origin(s, p.get(s), error.get(s).abs(), n.get(s), to.get(s));
                    let (scale, direction) = scale_and_direction(s, p.get(s));
                    (Row3::from(origin), Row::from(scale), Row3::from(direction))
                });
                for lane in 0..LANES {
                    let [p, error, n, to] = [&p, &error, &n, &to].map(|v| Vec3::from(v.lane(lane)));
                    let expected = numeric::offset_origin(p, error.abs(), n, to);
                    let bits = |v: [f32; 3]| v.map(f32::to_bits);
                    assert_eq!(
                        bits(origin.lane(lane)),
                        bits(expected.into()),
                        "{p} {n} {to}"
                    );
                    let (k, way) = numeric::scale_and_direction(p);
                    assert_eq!(scale.0[lane].to_bits(), k.to_bits());
                    assert_eq!(bits(direction.lane(lane)), bits(way.into()), "{p}");
                }
            }
        }
    }
}
