//! What all statistical tests share: a z test that prints what it would have noticed.

use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::{FOUR, z_test};

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
