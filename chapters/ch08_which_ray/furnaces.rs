//! The choice alone: frequencies, readings, variances, and two ways to lose light.

use crate::RULES;
use crate::figures::{self, KINDS, kind, z};
use crate::mixed_furnace::MixedFurnace;
use crate::rate;
use halfdisk::color::Rgb;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::materials::{Choice, Mixture};
use halfdisk::sampling::stream::Stream;
use halfdisk::stats::Estimate;
use halfdisk::stats::chi_square::chi_square;
use halfdisk::stats::z_test::Largest;
use rayon::prelude::*;

/// A grey mixture.
fn grey([kd, ks, kt]: [f32; 3]) -> Mixture {
    let [kd, ks, kt] = [kd, ks, kt].map(Rgb::grey);
    let ior = 1.5;
    Mixture { kd, ks, kt, ior }
}

fn room(material: Mixture, choice: Choice, segments: u32) -> MixedFurnace {
    MixedFurnace {
        material,
        choice,
        segments,
    }
}

/// A million choices at (0.5, 0.3, 0.2), counted.
pub fn frequencies(desk: &mut Desk) -> Largest {
    let (shares, draws) = ([0.5, 0.3, 0.2], 1_000_000);
    let room = room(grey(shares), Choice::ByMean, 1);
    let seed = desk.options.seed;
    let one = |i| {
        room.next(1, &Stream::new(seed, i, 0))
            .map(|next| kind(&next))
    };
    let chosen: Vec<Option<usize>> = (0..draws).into_par_iter().map(one).collect();
    let count = |k| chosen.iter().filter(|c| **c == Some(k)).count() as u64;
    let counts = [0, 1, 2].map(count);
    let mut compared = Largest::default();
    for (k, name) in KINDS.iter().enumerate() {
        let read = Estimate::from_hits(counts[k], u64::from(draws));
        // The uniforms are multiples of 2^-24: finer than that no share is met.
        let exact = f64::from(shares[k]);
        desk.estimate(name, &format!("share of {name} rays"), &read, Some(exact));
        compared.add(z(&read, exact));
    }
    for (name, says, shares) in [
        ("p_shares", "the shares", shares),
        ("p_thirds", "thirds", [1.0 / 3.0; 3]),
    ] {
        let expected = shares.map(|k| f64::from(k) * f64::from(draws));
        let p = chi_square(&counts, &expected).p;
        let says = format!("p of the counts as {says}");
        desk.value(name, &says, (p * 1e4).round() / 1e4);
    }
    compared
}

/// What a sheet under a white sky reads, by each rule, and without any weight.
pub fn readings(desk: &mut Desk) -> Largest {
    let (seed, draws) = (desk.options.seed, desk.choose(400_000, 100_000));
    let mut compared = Largest::default();
    for (choice, name, called) in RULES {
        let room = room(grey([0.5, 0.3, 0.1]), choice, 1);
        let read: Estimate = weights(&room, draws, seed).map(|w| w[0]).collect();
        let exact = f64::from(room.material.k_tot().r);
        let says = format!("furnace: k_tot, chosen {called}");
        desk.estimate(&format!("furnace_{name}"), &says, &read, Some(exact));
        compared.add(z(&read, exact));
        if choice == Choice::ByMean {
            let lives = |i| f64::from(u8::from(room.next(1, &Stream::new(seed, i, 0)).is_some()));
            let read: Estimate = (0..draws).map(lives).collect();
            let says = "furnace: the same without a weight";
            desk.value("furnace_forgotten", says, read.mean());
        }
    }
    compared
}

/// The weights of so many choices, channel by channel.
fn weights(room: &MixedFurnace, draws: u32, seed: u64) -> impl Iterator<Item = [f64; 3]> {
    let weight = move |i| {
        let next = room.next(1, &Stream::new(seed, i, 0));
        let weight = next.map_or(Rgb::BLACK, |next| next.weight);
        weight.channels().map(f64::from)
    };
    (0..draws).map(weight)
}

/// The variance of one choice, by mixture and rule, beside its closed form.
pub fn variances(desk: &mut Desk) -> Result<Largest, DeskError> {
    let colours = |kd: [f32; 3], ks: [f32; 3], kt: [f32; 3]| Mixture {
        kd: kd.into(),
        ks: ks.into(),
        kt: kt.into(),
        ior: 1.5,
    };
    let mixtures = [
        ("grey", "grey", grey([0.5, 0.3, 0.1])),
        ("faint", "faint mirror", grey([0.7, 0.05, 0.05])),
        (
            "plastic",
            "red, white mirror",
            colours([0.6, 0.1, 0.1], [0.3; 3], [0.0; 3]),
        ),
        (
            "prism",
            "red, green, blue",
            colours([0.6, 0.1, 0.1], [0.1, 0.6, 0.1], [0.1, 0.1, 0.6]),
        ),
    ];
    let (seed, draws) = (desk.options.seed, desk.choose(2_500, 500));
    let mut groups = Vec::new();
    let mut compared = Largest::default();
    for &(id, title, mixture) in &mixtures {
        let mut bars = Vec::new();
        for (choice, name, called) in RULES {
            let room = room(mixture, choice, 1);
            let batch = |b: u64| {
                let own = seed.wrapping_mul(1 << 20).wrapping_add(b);
                let mut channels = [Estimate::new(); 3];
                for weight in weights(&room, draws, own) {
                    (0..3).for_each(|c| channels[c].add(weight[c]));
                }
                channels.iter().map(Estimate::variance).sum::<f64>() / 3.0
            };
            let read: Estimate = (0..256).map(batch).collect();
            let exact = room.weight_variance().iter().sum::<f64>() / 3.0;
            let says = format!("variance of one choice, {title}, {called}");
            // What is left by rounding alone is none.
            let number = Number {
                error: Some(read.std_error()),
                ..Number::new(&says, read.mean()).exact(exact.max(0.0))
            };
            desk.number(&format!("variance_{id}_{name}"), number);
            let rounding = (read.mean() - exact).abs() < 1e-9;
            if !rounding {
                compared.add(z(&read, exact));
            }
            bars.push((called, read.mean(), read.std_error()));
        }
        groups.push(figures::group(title, &bars));
    }
    figures::bars(desk, groups)?;
    rate::chart(desk, mixtures[1].2)?;
    Ok(compared)
}

/// All light goes on with less weight, or less of it goes on with all its weight.
pub fn two_ways_to_lose(desk: &mut Desk) -> Largest {
    let (seed, walks) = (desk.options.seed, desk.choose(80_000, 45_000));
    let mut compared = Largest::default();
    for (choice, name, called) in [
        (Choice::ByMean, "weight", "lose weight"),
        (Choice::Analog, "absorb", "are absorbed"),
    ] {
        let room = room(grey([0.5, 0.3, 0.1]), choice, 40);
        let one = |i| room.walk(&Stream::new(seed, i, 0));
        let walked: Vec<_> = (0..walks).into_par_iter().map(one).collect();
        let read: Estimate = walked.iter().map(|(li, _)| f64::from(li.r)).collect();
        let rays: Estimate = walked.iter().map(|(_, rays)| f64::from(*rays)).collect();
        let exact = room.radiance()[0];
        let says = format!("glowing room, 40 segments, where paths {called}");
        desk.estimate(&format!("room_{name}"), &says, &read, Some(exact));
        // A path of weight one reads its length, which is j or more with probability k^(j - 1).
        let k = f64::from(room.material.k_tot().r);
        let longer = |j: i32| f64::from(2 * j - 1) * k.powi(j - 1);
        let law = match choice {
            Choice::Analog => (1..=40).map(longer).sum::<f64>() - exact * exact,
            _ => 0.0,
        };
        // Below this it is rounding.
        let variance = Some(read.variance()).filter(|v| *v > 1e-9).unwrap_or(0.0);
        let says = "  variance of a path";
        desk.known(&format!("room_variance_{name}"), says, variance, law);
        desk.estimate(
            &format!("room_rays_{name}"),
            "  rays of a path",
            &rays,
            None,
        );
        compared.add(z(&read, exact));
    }
    compared
}

/// What is left after ten bounces: with the right weight, with none, and of shares that add up to
/// 1.2, which no scene file may say.
pub fn growth(desk: &mut Desk) -> Result<(), DeskError> {
    let mut rows = Vec::new();
    for (name, called, shares, weighs) in [
        ("right", "k/p, k_tot = 0.9", [0.5, 0.3, 0.1], true),
        ("none", "no weight", [0.5, 0.3, 0.1], false),
        ("more", "k/p, k_tot = 1.2", [0.6, 0.4, 0.2], true),
    ] {
        let room = room(grey(shares), Choice::ByMean, 1);
        let stream = Stream::new(desk.options.seed, 0, 0);
        let mut left = vec![1.0_f64];
        for place in 0..10 {
            let weight = room.next(place, &stream).map_or(0.0, |next| next.weight.r);
            let before = left.last().copied().unwrap_or(1.0);
            left.push(before * if weighs { f64::from(weight) } else { 1.0 });
        }
        let share: f32 = if weighs { shares.iter().sum() } else { 1.0 };
        let says = format!("left after ten bounces: {called}");
        let exact = (f64::from(share) * 10.0).round() / 10.0;
        let value = left.last().copied().unwrap_or(0.0);
        desk.known(&format!("left_{name}"), &says, value, exact.powi(10));
        rows.push((called, exact, left));
    }
    figures::energy(desk, rows)
}
