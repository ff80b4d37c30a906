//! Chapter 17, exercise 3: a sum in `f32` that remembers what each addition lost.
//!
//! The sum of ten million tenths stops growing properly long before its end: each addition rounds to
//! the spacing of the sum. What was rounded away can be found exactly, as a difference that does not
//! round, and given back with the next term.
//!
//! Source: Kahan, Further Remarks on Reducing Truncation Errors (Communications of the ACM 8(1),
//! 1965).

#![allow(clippy::print_stdout)]

use halfdisk::lab::naive;

/// The mean of samples by a compensated sum.
fn compensated(samples: impl IntoIterator<Item = f32>) -> f32 {
    let (mut sum, mut lost, mut count) = (0.0_f32, 0.0_f32, 0_u32);
    for x in samples {
        let x = x - lost;
        let next = sum + x;
        // In exact arithmetic zero; here what `next` has too much.
        lost = (next - sum) - x;
        sum = next;
        count += 1;
    }
    sum / count as f32
}

fn tenths(count: usize) -> impl Iterator<Item = f32> {
    std::iter::repeat_n(0.1, count)
}

fn main() {
    println!("       n   plain   compensated");
    for power in 1..=7 {
        let count = 10_usize.pow(power);
        let [plain, ours] = [naive::mean(tenths(count)), compensated(tenths(count))];
        println!("{count:8}   {plain:.7}   {ours:.7}");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_lost_comes_back() {
        let off = |mean: f32| (f64::from(mean) / f64::from(0.1_f32) - 1.0).abs();
        assert!(off(compensated(tenths(10_000_000))) < 2e-7);
        assert!(off(naive::mean(tenths(10_000_000))) > 1e-2);
    }

    #[test]
    fn large_and_small_together() {
        let samples = || (0..1_000_000).map(|i| if i == 0 { 1e8 } else { 1.0 });
        let exact = (1e8 + 999_999.0) / 1e6;
        assert!((f64::from(compensated(samples())) / exact - 1.0).abs() < 1e-6);
        assert!((f64::from(naive::mean(samples())) / exact - 1.0).abs() > 5e-3);
    }
}
