//! How much of a disc lies on its surface: at the edge of a plate a half, in its corner a quarter.
//!
//! A density estimate divides by the whole disc, and so reads too little near an edge. To divide by the part
//! that lies on the surface is the cure where that part is known: Silverman, Density Estimation for
//! Statistics and Data Analysis (1986), section 2.10.

/// The share of a window from `at - radius` to `at + radius` that lies on a line from 0 to `length`; all
/// in the same unit, `radius` positive.
pub fn share_on_line(at: f64, length: f64, radius: f64) -> f64 {
    let reach = (at + radius).min(length) - (at - radius).max(0.0);
    (reach / (2.0 * radius)).max(0.0)
}

/// The share of a disc around `at` that lies on the rectangle from the origin to `size`; `radius` positive.
///
/// By the parts of its area to the lower left of each corner of the rectangle.
pub fn share_on_rectangle(at: [f64; 2], size: [f64; 2], radius: f64) -> f64 {
    let below = |corner: [f64; 2]| {
        let [x, y] = [0, 1].map(|i| (corner[i] - at[i]) / radius);
        quadrant(x, y)
    };
    let [w, h] = size;
    let area = below([w, h]) - below([0.0, h]) - below([w, 0.0]) + below([0.0, 0.0]);
    (area / std::f64::consts::PI).clamp(0.0, 1.0)
}

/// The area of the unit disc with coordinates below `x` and `y`.
fn quadrant(x: f64, y: f64) -> f64 {
    let (x, y) = (x.clamp(-1.0, 1.0), y.clamp(-1.0, 1.0));
    // The antiderivative of the half chord.
    let chord = |t: f64| 0.5 * (t * (1.0 - t * t).max(0.0).sqrt() + libm::asin(t));
    let half_width = (1.0 - y * y).max(0.0).sqrt();
    // At abscissa t the disc reaches from -h(t) to the smaller of h(t) and y.
    let strip = |from: f64, to: f64, capped: bool| {
        let to = to.min(x);
        if to <= from {
            return 0.0;
        }
        let arcs = chord(to) - chord(from);
        match capped {
            true => arcs + y * (to - from),
            false => 2.0 * arcs,
        }
    };
    let middle = strip(-half_width, half_width, true);
    match y >= 0.0 {
        true => strip(-1.0, -half_width, false) + middle + strip(half_width, 1.0, false),
        false => middle,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_and_quarters() {
        for (at, share) in [
            (0.0, 0.5),
            (5.0, 1.0),
            (10.0, 0.5),
            (0.5, 0.75),
            (-2.0, 0.0),
        ] {
            assert_eq!(share_on_line(at, 10.0, 1.0), share, "{at}");
        }
        let plate = |at| share_on_rectangle(at, [10.0, 10.0], 1.0);
        for (at, share) in [
            ([5.0, 5.0], 1.0),
            ([0.0, 5.0], 0.5),
            ([5.0, 10.0], 0.5),
            ([0.0, 0.0], 0.25),
            ([10.0, 0.0], 0.25),
            ([-1.5, 5.0], 0.0),
        ] {
            assert!((plate(at) - share).abs() < 1e-14, "{at:?}: {}", plate(at));
        }
        // A disc wider than the plate.
        let all = share_on_rectangle([5.0, 5.0], [10.0, 10.0], 100.0);
        assert!(
            (all - 100.0 / (1e4 * std::f64::consts::PI)).abs() < 1e-12,
            "{all}"
        );
    }

    #[test]
    fn any_place_by_counting_points() {
        const N: i32 = 400;
        for at in [[0.3, 0.2], [1.9, 0.7], [-0.4, 1.2], [2.5, -0.3]] {
            let (size, radius) = ([2.0, 1.0], 0.8);
            let step = |i: i32| 2.0 * (f64::from(i) + 0.5) / f64::from(N) - 1.0;
            let mut counts = [0.0; 2];
            for (i, j) in (0..N * N).map(|k| (k % N, k / N)) {
                let [x, y] = [step(i), step(j)];
                if x * x + y * y < 1.0 {
                    let on = |k: usize, t: f64| (0.0..size[k]).contains(&(at[k] + radius * t));
                    counts[0] += 1.0;
                    counts[1] += f64::from(u8::from(on(0, x) && on(1, y)));
                }
            }
            let share = share_on_rectangle(at, size, radius);
            assert!(
                (share - counts[1] / counts[0]).abs() < 2e-3,
                "{at:?}: {share}"
            );
        }
    }
}
