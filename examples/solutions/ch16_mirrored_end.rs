//! Chapter 16, exercise 3: photons at the end of a line, and two cures for what is lost there.
//!
//! The floor ends at 0. A window around the end has only half
//! of itself on the floor. To divide by that half is right for light that is constant; to count each photon a second time,
//! mirrored at the end, is the same there. Of light with a slope both look only inwards, and read too little.

#![allow(clippy::print_stdout)]

use halfdisk::photons::edge::share_on_line;
use halfdisk::sampling::stream::{Purpose, Stream};

const PHOTONS: u32 = 1 << 16;

/// A place from 0 to 1, uniform or with a density that falls from 2 to nothing.
fn place(falls: bool, u: f64) -> f64 {
    match falls {
        // The density 2 (1 - x) has the distribution 1 - (1 - x)².
        true => 1.0 - (1.0 - u).sqrt(),
        false => u,
    }
}

/// What a window of this radius around the end reads: as it is, over the part on the floor, and mirrored.
fn reads(falls: bool, radius: f64) -> [f64; 3] {
    let (mut within, mut mirrored) = (0.0, 0.0);
    for photon in 0..PHOTONS {
        let u = Stream::new(1, photon, 0).at(0, Purpose::Integrand).one();
        let x = place(falls, u.into());
        within += f64::from(u8::from(x < radius));
        // Its image is at -x, beyond the end.
        mirrored += f64::from(u8::from(-x > -radius));
    }
    let over = 1.0 / (f64::from(PHOTONS) * 2.0 * radius);
    let plain = within * over;
    let part = share_on_line(0.0, 1.0, radius);
    [plain, plain / part, plain + mirrored * over]
}

fn main() {
    for (what, falls, truth) in [
        ("constant light", false, 1.0),
        ("light that falls off", true, 2.0),
    ] {
        for radius in [0.2, 0.1, 0.05] {
            let [plain, divided, mirrored] = reads(falls, radius);
            println!(
                "{what} {truth}, radius {radius}: {plain:.3} as it is, {divided:.3} by the part, {mirrored:.3} mirrored"
            );
        }
    }
}

#[test]
fn both_cures_are_right_for_constant_light_and_off_by_half_the_slope_otherwise() {
    let error = |radius: f64| 5.0 / (f64::from(PHOTONS) * radius).sqrt();
    for radius in [0.2, 0.1, 0.05] {
        let [plain, divided, mirrored] = reads(false, radius);
        assert!((plain - 0.5).abs() < error(radius), "{plain}");
        assert!((divided - 1.0).abs() < error(radius) && (mirrored - 1.0).abs() < error(radius));
        // Of 2 (1 - x) the mean over the half window is 2 - radius.
        for x in &reads(true, radius)[1..] {
            assert!((x - (2.0 - radius)).abs() < 2.0 * error(radius), "{x}");
        }
    }
}
