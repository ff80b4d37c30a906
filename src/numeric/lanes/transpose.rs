//! Sixteen records into vectors, one for each of their numbers.

use super::{Floats, LANES, Wides};
use fearless_simd::f64x8;
use fearless_simd::prelude::*;

/// The matrix of sixteen rows with rows and columns swapped.
///
/// Each round deals the rows out like two halves of a pack of cards. That turns the four bits of an element's row and the
/// four of its column by one place; four rounds swap them.
#[inline(always)]
pub fn transpose<S: Simd>(mut rows: [Floats<S>; LANES]) -> [Floats<S>; LANES] {
    for _ in 0..4 {
        let before = rows;
        for i in 0..LANES / 2 {
            (rows[2 * i], rows[2 * i + 1]) = before[i].interleave(before[i + LANES / 2]);
        }
    }
    rows
}

/// The same for rows of eight numbers in `f64`.
#[inline(always)]
pub fn transpose_wide<S: Simd>(s: S, rows: &[&[f64; LANES / 2]; LANES]) -> [Wides<S>; LANES / 2] {
    let mut columns = [Wides::splat(s, 0.0); LANES / 2];
    for (i, column) in columns.iter_mut().enumerate() {
        let row = |i: usize| f64x8::from_slice(s, rows[i]);
        *column = Wides(row(i), row(i + LANES / 2));
    }
    for _ in 0..3 {
        let before = columns;
        for i in 0..LANES / 4 {
            let (a, b) = (before[i], before[i + LANES / 4]);
            let (low, high) = (a.0.interleave(b.0), a.1.interleave(b.1));
            columns[2 * i] = Wides(low.0, high.0);
            columns[2 * i + 1] = Wides(low.1, high.1);
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::lanes::{Row, floats, levels};
    use fearless_simd::dispatch;

    #[test]
    fn rows_become_columns() {
        let number = |row: usize, column: usize| (100 * row + column) as f32;
        let rows: [Row; LANES] =
            std::array::from_fn(|row| Row(std::array::from_fn(|column| number(row, column))));
        let wide: [[f64; LANES / 2]; LANES] =
            std::array::from_fn(|row| std::array::from_fn(|column| f64::from(number(row, column))));
        for level in levels() {
            let (columns, halves) = dispatch!(level, s => {
                let mut all = [floats(s, 0.0); LANES];
                for (x, row) in all.iter_mut().zip(&rows) {
                    *x = row.get(s);
                }
                let wide = transpose_wide(s, &wide.each_ref());
                (transpose(all).map(Row::from), wide.map(|x| Row::from(x.narrow())))
            });
            let halves = halves.iter().enumerate();
            for (place, column) in columns.iter().enumerate().chain(halves) {
                for (row, x) in column.0.iter().enumerate() {
                    assert_eq!(*x, number(row, place), "{level:?}");
                }
            }
        }
    }
}
