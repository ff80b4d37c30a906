//! Sums, and what is shown of them.

/// The mean of samples by a sum in `f32`: a sum of 0.1 stops at 2097152.
pub fn mean(samples: impl IntoIterator<Item = f32>) -> f32 {
    let (mut sum, mut count) = (0.0_f32, 0_u64);
    for x in samples {
        sum += x;
        count += 1;
    }
    sum / count as f32
}

/// The mean of samples as a mean that each moves by its share: worse than the sum.
pub fn running_mean(samples: impl IntoIterator<Item = f32>) -> f32 {
    let (mut mean, mut count) = (0.0_f32, 0_u64);
    for x in samples {
        count += 1;
        let share = 1.0 / count as f32;
        mean = mean * (1.0 - share) + x * share;
    }
    mean
}

/// The variance of samples as `E[x²] - E[x]²` in `f32`: below zero where the mean is large.
pub fn variance(samples: impl IntoIterator<Item = f32>) -> f32 {
    let (mut sum, mut squares, mut count) = (0.0_f32, 0.0_f32, 0_u64);
    for x in samples {
        sum += x;
        squares += x * x;
        count += 1;
    }
    let n = count as f32;
    squares / n - (sum / n) * (sum / n)
}

/// A level of 256 from a value in `[0, 1]`, cut off: white only at exactly 1, and NaN is black.
pub fn level(value: f32) -> u8 {
    (value * 255.0) as u8
}

/// The number of pixels in 32 bits, as a release build counts: 65536 x 65536 are none.
pub fn pixels([width, height]: [u32; 2]) -> u32 {
    width.wrapping_mul(height)
}
