//! What all statistical tests share: a z test that prints what it would have noticed.

use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::{FOUR, ROUNDING, z_test};

/// Where tests of many numbers draw the line, in standard errors: one right estimate in 92 000 lies beyond.
pub const CRITICAL: f64 = 4.4;

/// Accepts a right estimate, and only where it would have noticed a bias of 1 % of `scale`.
#[track_caller]
pub fn accept(name: &str, estimate: &Estimate, truth: f64, scale: f64) {
    let test = z_test(estimate, truth, FOUR);
    println!("{name}: {:.6}, exact {truth:.6}, {test}", estimate.mean());
    assert!(
        test.passes(),
        "{name}: {} is not {truth}, {test}",
        estimate.mean()
    );
    assert!(test.detects <= 0.01 * scale, "{name}: {test}");
}

/// The same check with a wrong estimate, which it must refuse.
#[track_caller]
pub fn reject(name: &str, estimate: &Estimate, truth: f64) {
    let test = z_test(estimate, truth, FOUR);
    assert!(
        !test.passes(),
        "{name}: {} passes for {truth}, {test}",
        estimate.mean()
    );
}

/// With 90 % probability a normal variable lies below this.
const NINETY_PERCENT: f64 = 1.282;

/// The z score of the difference of two independent means, each with its standard error, and the
/// smallest difference that a line at [`FOUR`] rejects with 90 % power, relative to the second.
pub fn between(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    let (difference, error) = (a.0 - b.0, a.1.hypot(b.1));
    let z = if difference.abs() <= ROUNDING * b.0.abs() {
        0.0
    } else {
        difference / error
    };
    (z, (FOUR + NINETY_PERCENT) * error / b.0.abs())
}

/// Accepts two independent means of the same thing, at a level of 6e-5, and only where it would have
/// noticed a difference of `share` of them.
#[track_caller]
pub fn alike(name: &str, a: (f64, f64), b: (f64, f64), share: f64) {
    let (z, notices) = between(a, b);
    println!(
        "{name}: {:.6} ± {:.1e} and {:.6} ± {:.1e}, z {z:+.2}, would notice {:.2} %",
        a.0,
        a.1,
        b.0,
        b.1,
        100.0 * notices
    );
    assert!(z.abs() <= FOUR, "{name}: {a:?} and {b:?}, z {z:+.2}");
    assert!(notices <= share, "{name}: would notice {notices} only");
}

/// The same check of means of different things, which it must refuse.
#[track_caller]
pub fn unlike(name: &str, a: (f64, f64), b: (f64, f64)) {
    let (z, _) = between(a, b);
    assert!(z.abs() > FOUR, "{name}: {a:?} passes for {b:?}, z {z:+.2}");
}

/// An estimate's mean and standard error.
pub fn of(estimate: &Estimate) -> (f64, f64) {
    (estimate.mean(), estimate.std_error())
}
