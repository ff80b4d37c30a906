//! What the flat world's questions have for answers, in closed form and `f64`.
//!
//! Irradiances are those of a point at the origin whose normal is `+y`; positions are relative to
//! it. With `θ` from the normal the integral of `L cos θ` over a range of directions is
//! `L (sin θ₂ - sin θ₁)`, so nearly everything here is a difference of sines.

use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Radiance that the middle of the floor of the unit square reflects, in W/(m·rad), where the
/// ceiling emits 1 and all four walls have albedo 0.5 (the `room` of the gallery).
///
/// No closed form: radiosity on ever finer patches settles here, to all digits given.
pub const ROOM_FLOOR: f64 = 0.330_679_4;

/// Irradiance under a sky of constant radiance, `2 L`, in W/m.
pub fn sky(radiance: f64) -> f64 {
    2.0 * radiance
}

/// Irradiance from a segment of constant radiance, `L |sin θ₂ - sin θ₁|`, in W/m.
///
/// * `ends` may lie below the horizon; only the part above it counts. The segment does not pass
///   through the origin, and shines to the side where the origin is.
pub fn segment(radiance: f64, ends: [DVec2; 2]) -> f64 {
    above_horizon(ends).map_or(0.0, |ends| {
        let [first, second] = ends.map(|end| end.x / end.length());
        radiance * (second - first).abs()
    })
}

/// The part of a segment with `y >= 0`.
fn above_horizon([a, b]: [DVec2; 2]) -> Option<[DVec2; 2]> {
    let intersection = || DVec2::new((a.x * b.y - b.x * a.y) / (b.y - a.y), 0.0);
    match (a.y >= 0.0, b.y >= 0.0) {
        (true, true) => Some([a, b]),
        (true, false) => Some([a, intersection()]),
        (false, true) => Some([intersection(), b]),
        (false, false) => None,
    }
}

/// Irradiance from a circle of constant radiance, in W/m; above the horizon it is
/// `2 L (r/d) cos β`.
///
/// * `radius` is at most `distance`, that of its centre.
/// * `angle` is the centre's angle β from the normal, in radians; the circle may lie partly below
///   the horizon, or wholly.
pub fn circle(radiance: f64, radius: f64, distance: f64, angle: f64) -> f64 {
    debug_assert!(0.0 < radius && radius <= distance, "the origin is inside");
    let half = libm::asin(radius / distance);
    let sine = |edge: f64| libm::sin(edge.clamp(-FRAC_PI_2, FRAC_PI_2));
    radiance * (sine(angle.abs() + half) - sine(angle.abs() - half))
}

/// Irradiance from a point lamp, `Φ cos θ / 2πr`, in W/m; `position` is not the origin.
pub fn lamp(power: f64, position: DVec2) -> f64 {
    power * position.y.max(0.0) / (TAU * position.length_squared())
}

/// The share of the light leaving segment `a` that reaches segment `b`, if both are diffuse and
/// nothing is between them: the crossed strings less the uncrossed ones, over twice the length of
/// `a`.
///
/// * Each segment has the other wholly on its left-hand side, which is its front.
/// * Reciprocity holds to rounding: `|a| F(a, b) = |b| F(b, a)`.
/// * Source: Hottel, Radiant Heat Transmission, in McAdams, Heat Transmission (3rd ed. 1954).
pub fn form_factor(a: [DVec2; 2], b: [DVec2; 2]) -> f64 {
    let crossed = a[0].distance(b[0]) + a[1].distance(b[1]);
    let uncrossed = a[0].distance(b[1]) + a[1].distance(b[0]);
    (crossed - uncrossed) / (2.0 * a[0].distance(a[1]))
}

/// Radiance that the dark one of two endless parallel plates reflects, in W/(m·rad).
///
/// * The bright plate emits `emission` and reflects the share `bright`; the dark one reflects the
///   share `dark` of what it gets. Each sees nothing but the other.
/// * `direct + indirect = dark · emission / (1 - dark · bright)`, where direct is
///   `dark · emission`.
pub fn plates(emission: f64, bright: f64, dark: f64) -> f64 {
    dark * emission / (1.0 - dark * bright)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, SQRT_2};

    /// The integral of `L cos θ` by the midpoint rule, where `seen` tells which directions shine.
    fn quadrature(seen: impl Fn(DVec2) -> bool) -> f64 {
        let n = 200_000;
        let step = PI / f64::from(n);
        let term = |i: i32| {
            let (sin, cos) = libm::sincos(-FRAC_PI_2 + step * (f64::from(i) + 0.5));
            if seen(DVec2::new(sin, cos)) { cos } else { 0.0 }
        };
        (0..n).map(term).sum::<f64>() * step
    }

    fn near(x: f64, y: f64, tolerance: f64) {
        assert!((x - y).abs() < tolerance, "{x} is not {y}");
    }

    #[test]
    fn a_constant_sky() {
        near(sky(1.5), 1.5 * quadrature(|_| true), 1e-9);
    }

    #[test]
    fn segments_above_and_across_the_horizon() {
        let flat = |x0, x1, h| segment(1.0, [DVec2::new(x0, h), DVec2::new(x1, h)]);
        near(flat(-0.5, 0.5, 1.0), 0.894_427_191, 1e-9);
        near(flat(0.2, 2.0, 0.5), 0.598_751_824, 1e-9);
        near(flat(-0.2, -2.0, 0.5), 0.598_751_824, 1e-9);
        let cases = [
            [[1.0, 2.0], [3.0, -1.0]],
            [[-1.0, -0.5], [-0.2, 0.7]],
            [[0.5, 0.1], [-2.0, 4.0]],
        ];
        for ends in cases.map(|c| c.map(DVec2::from)) {
            let seen = |w: DVec2| {
                let (s, t) = (w.perp_dot(ends[0]), w.perp_dot(ends[1]));
                s * t < 0.0 && w.dot(ends[0] + (ends[1] - ends[0]) * (s / (s - t))) > 0.0
            };
            near(segment(1.0, ends), quadrature(seen), 2e-5);
        }
        assert_eq!(flat(-1.0, 1.0, -0.1), 0.0);
    }

    #[test]
    fn circles_sink_below_the_horizon() {
        let at = |angle| circle(1.0, 0.5, 2.0, angle);
        near(at(0.0), 0.5, 1e-9);
        near(at(0.5), 0.438_791_281, 1e-9);
        near(at(-1.5), 0.051_863_933, 1e-9);
        near(at(1.7), 0.007_613_552, 1e-9);
        near(at(2.0), 0.0, 1e-15);
        for angle in [0.0, 0.5, 1.5, 1.7, -1.7] {
            let (sin, cos) = libm::sincos(angle);
            let center = DVec2::new(sin, cos) * 2.0;
            let seen = |w: DVec2| w.perp_dot(center).abs() < 0.5 && w.dot(center) > 0.0;
            near(at(angle), quadrature(seen), 2e-5);
        }
    }

    #[test]
    fn a_far_small_circle_is_a_lamp() {
        // Each length of its rim sends out 2 L, so the whole circle 4π r L.
        let (radius, distance, angle) = (1e-4, 3.0, 0.7);
        let (sin, cos) = libm::sincos(angle);
        let far = lamp(2.0 * TAU * radius, DVec2::new(sin, cos) * distance);
        near(circle(1.0, radius, distance, angle) / far, 1.0, 1e-9);
    }

    #[test]
    fn strings_between_the_walls_of_a_square() {
        let corner = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(DVec2::from);
        let wall = |i: usize| [corner[i], corner[(i + 1) % 4]];
        near(form_factor(wall(0), wall(2)), SQRT_2 - 1.0, 1e-15);
        near(form_factor(wall(0), wall(1)), 1.0 - SQRT_2 / 2.0, 1e-15);
        let row: f64 = (1..4).map(|i| form_factor(wall(0), wall(i))).sum();
        near(row, 1.0, 1e-15);
    }

    #[test]
    fn strings_are_the_mean_irradiance() {
        let a = [[0.0, 0.0], [2.0, 0.0]].map(DVec2::from);
        let b = [[2.5, 0.5], [-0.5, 1.5]].map(DVec2::from);
        let n = 2000;
        let from = |i: i32| DVec2::new(2.0 * (f64::from(i) + 0.5) / f64::from(n), 0.0);
        let at = |i: i32| segment(0.5, b.map(|end| end - from(i)));
        let mean = (0..n).map(at).sum::<f64>() / f64::from(n);
        near(form_factor(a, b), mean, 1e-6);
        near(
            2.0 * form_factor(a, b),
            b[0].distance(b[1]) * form_factor(b, a),
            1e-14,
        );
    }

    #[test]
    fn plates_are_a_geometric_series() {
        let bounces = (0..60).map(|k| 0.5 * libm::pow(0.5 * 0.8, f64::from(k)));
        near(plates(2.0, 0.8, 0.5), 2.0 * bounces.sum::<f64>(), 1e-14);
    }
}
