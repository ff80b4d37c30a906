//! Chapter 8, exercise 2: a golden mirror on red paint, chosen by luminance.
//!
//! The luminance gives one probability for all three channels; the weight `k/p` is then a colour.
//! Each channel of each part must come out as its own share in the mean. One weight for all
//! channels, the luminance's, would paint the mirror grey.

#![allow(clippy::print_stdout)]

use glam::Vec3;
use halfdisk::color::Rgb;
use halfdisk::materials::{Choice, Event, Mixture};
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::stats::Estimate;

const GOLD_ON_RED: Mixture = Mixture {
    kd: Rgb::new(0.4, 0.05, 0.05),
    ks: Rgb::new(0.55, 0.4, 0.15),
    kt: Rgb::BLACK,
    ior: 1.5,
};

/// The mean of each channel: first of what is scattered, then of what is mirrored.
fn means(draws: u32, weight: impl Fn(Rgb) -> Rgb) -> [[Estimate; 3]; 2] {
    let mut means = [[Estimate::new(); 3]; 2];
    for i in 0..draws {
        let stream = Stream::new(10, i, 0);
        let choice = stream.at(0, Purpose::Branch).one();
        let u = stream.at(0, Purpose::Direction).two();
        let next = GOLD_ON_RED.scatter_by(Choice::ByLuminance, Vec3::Z, choice, u);
        for (part, means) in means.iter_mut().enumerate() {
            let of = next.filter(|next| (next.event == Event::Specular) == (part == 1));
            let counted = of.map_or(Rgb::BLACK, |next| weight(next.weight));
            for (mean, x) in means.iter_mut().zip(counted.channels()) {
                mean.add(f64::from(x));
            }
        }
    }
    means
}

/// The wrong weight: that of the luminance for every channel.
fn grey(weight: Rgb) -> Rgb {
    Rgb::grey(weight.luminance())
}

fn main() {
    let shares = [GOLD_ON_RED.kd, GOLD_ON_RED.ks].map(Rgb::channels);
    let right = means(1_000_000, |weight| weight);
    let wrong = means(1_000_000, grey);
    for (part, name) in ["kd", "ks"].iter().enumerate() {
        for (channel, colour) in ["red", "green", "blue"].iter().enumerate() {
            let (right, wrong) = (right[part][channel], wrong[part][channel]);
            println!(
                "{name}, {colour}: {:.4} ± {:.4}, exactly {:.4}; with one weight for all {:.4}",
                right.mean(),
                right.std_error(),
                shares[part][channel],
                wrong.mean()
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_channel_of_every_part_is_its_share() {
        let shares = [GOLD_ON_RED.kd, GOLD_ON_RED.ks].map(Rgb::channels);
        let (right, wrong) = (means(200_000, |weight| weight), means(200_000, grey));
        for part in 0..2 {
            for channel in 0..3 {
                let truth = f64::from(shares[part][channel]);
                let (right, wrong) = (right[part][channel], wrong[part][channel]);
                assert!(right.z(truth).abs() <= 4.4, "{part} {channel}: {right:?}");
                assert!(wrong.z(truth).abs() > 4.4, "{part} {channel}: {wrong:?}");
            }
        }
    }

    #[test]
    fn the_luminance_itself_has_no_variance() {
        let weights = (0..10_000).map(|i| {
            let choice = Stream::new(10, i, 0).at(0, Purpose::Branch).one();
            let next = GOLD_ON_RED.scatter_by(Choice::ByLuminance, Vec3::Z, choice, [0.5; 2]);
            next.map_or(0.0, |next| f64::from(next.weight.luminance()))
        });
        let read: Estimate = weights.collect();
        let exact = f64::from(GOLD_ON_RED.k_tot().luminance());
        assert!(read.variance() < 1e-12 && (read.mean() - exact).abs() < 1e-6);
    }
}
