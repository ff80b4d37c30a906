//! Gauss points on a patch.

use glam::DVec3;
use std::f64::consts::PI;

/// Abscissae in `(0, 1)` and weights, which add up to 1, of the Gauss-Legendre rule of `n` points:
/// exact for polynomials up to degree `2 n - 1`.
pub fn gauss_legendre(n: usize) -> Vec<[f64; 2]> {
    (0..n).rev().map(|i| point(i, n)).collect()
}

/// The same rule with its points drawn towards both ends, by `x = t³ (10 - 15 t + 6 t²)`: for integrands that
/// jump or have no slope there. Its weights add up to 1 from three points on.
///
/// Source: Korobov, Number-Theoretic Methods of Approximate Analysis (1963), for changes of variable whose
/// slope is 0 at the ends.
pub fn graded(n: usize) -> Vec<[f64; 2]> {
    let pull = |[t, weight]: [f64; 2]| {
        let x = t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
        let slope = 30.0 * t * t * (1.0 - t) * (1.0 - t);
        [x, weight * slope]
    };
    gauss_legendre(n).into_iter().map(pull).collect()
}

/// Newton's iteration for the `i`-th root of the Legendre polynomial of degree `n`.
fn point(i: usize, n: usize) -> [f64; 2] {
    let degree = n as f64;
    let mut x = libm::cos(PI * (i as f64 + 0.75) / (degree + 0.5));
    let mut slope = 1.0;
    for _ in 0..64 {
        let [mut before, mut value] = [1.0, x];
        for k in 2..=n {
            let k = k as f64;
            let next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k;
            [before, value] = [value, next];
        }
        slope = degree * (x * value - before) / (x * x - 1.0);
        let step = value / slope;
        x -= step;
        if step.abs() < 1e-16 {
            break;
        }
    }
    [0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)]
}

/// Points inside a convex polygon and their shares of its area.
///
/// * A parallelogram gets the products of the rule with itself; any other polygon is a fan of
///   triangles, each a square with one side drawn together (Stroud, Approximate Calculation of
///   Multiple Integrals, 1971).
pub fn points_on(polygon: &[DVec3], rule: &[[f64; 2]]) -> Vec<(DVec3, f64)> {
    let pairs = || rule.iter().flat_map(|s| rule.iter().map(move |t| (*s, *t)));
    if let Some([corner, u, v]) = parallelogram(polygon) {
        let point = |([s, ws], [t, wt]): ([f64; 2], [f64; 2])| (corner + u * s + v * t, ws * wt);
        return pairs().map(point).collect();
    }
    let whole = area_vector(polygon).length();
    let mut points = Vec::new();
    for pair in polygon.windows(2).skip(1) {
        let [a, b, c] = [polygon[0], pair[0], pair[1]];
        let share = (b - a).cross(c - a).length() / whole;
        points.extend(pairs().map(|([s, ws], [t, wt])| {
            let place = a + (b - a) * (s * (1.0 - t)) + (c - a) * (s * t);
            (place, share * 2.0 * s * ws * wt)
        }));
    }
    points
}

/// The first corner and the two edges from it, where a polygon is a parallelogram.
pub(super) fn parallelogram(polygon: &[DVec3]) -> Option<[DVec3; 3]> {
    let &[a, b, c, d] = polygon else { return None };
    let size = (c - a).abs().max_element().max((d - b).abs().max_element());
    ((a + c - b - d).abs().max_element() <= 1e-6 * size).then(|| {
        // The middle plane's edges, which differ from the corners by roundings alone.
        let (u, v) = (0.5 * (b - a + c - d), 0.5 * (d - a + c - b));
        [0.25 * (a + b + c + d) - 0.5 * (u + v), u, v]
    })
}

/// Twice the area of a flat polygon times its normal, by Newell's sum.
pub(super) fn area_vector(polygon: &[DVec3]) -> DVec3 {
    let Some(&origin) = polygon.first() else {
        return DVec3::ZERO;
    };
    let fan = polygon.windows(2).skip(1);
    fan.map(|pair| (pair[0] - origin).cross(pair[1] - origin))
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rule_integrates_its_polynomials() {
        for n in [1, 2, 4, 8, 16] {
            let rule = gauss_legendre(n);
            for degree in 0..2 * n {
                let sum: f64 = rule
                    .iter()
                    .map(|[x, w]| w * libm::pow(*x, degree as f64))
                    .sum();
                let exact = 1.0 / (degree as f64 + 1.0);
                assert!(
                    (sum - exact).abs() < 1e-14,
                    "{n} points, degree {degree}: {sum}"
                );
            }
            assert!(rule.is_sorted_by(|a, b| a[0] < b[0]));
        }
    }

    #[test]
    fn a_graded_rule_integrates_too() {
        for n in [3, 8, 32] {
            let mean = |f: fn(f64) -> f64| graded(n).iter().map(|[x, w]| w * f(*x)).sum::<f64>();
            assert!((mean(|_| 1.0) - 1.0).abs() < 1e-14);
            assert!((mean(|x| x) - 0.5).abs() < 1e-14);
        }
        // A root has no slope at its end.
        let off = |rule: Vec<[f64; 2]>| {
            let sum: f64 = rule.iter().map(|[x, w]| w * x.sqrt()).sum();
            (sum - 2.0 / 3.0).abs()
        };
        let [plain, drawn] = [gauss_legendre(16), graded(16)].map(off);
        assert!(drawn < 1e-9 && plain > 1e-5, "{plain:e} {drawn:e}");
    }

    #[test]
    fn polygons_keep_their_moments() {
        let rule = gauss_legendre(3);
        let corner = |[x, y]: [f64; 2]| DVec3::new(x, y, 1.0);
        let triangle = [[0.0, 0.0], [2.0, 0.0], [0.0, 3.0]].map(corner);
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]].map(corner);
        let house = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 2.0], [0.0, 1.0]].map(corner);
        for (polygon, mean) in [
            (&triangle[..], [2.0 / 3.0, 1.0]),
            (&square, [1.0, 0.5]),
            (&house, [1.0, 7.0 / 9.0]),
        ] {
            let points = points_on(polygon, &rule);
            let weights: f64 = points.iter().map(|(_, w)| w).sum();
            let centre: DVec3 = points.iter().map(|(p, w)| *p * *w).sum();
            assert!((weights - 1.0).abs() < 1e-15, "{weights}");
            assert!((centre - corner(mean)).length() < 1e-14, "{centre}");
        }
    }
}
