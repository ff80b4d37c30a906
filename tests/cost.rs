//! What accuracy costs, measured small: in rays, so that every machine finds the same.

use crate::of_chapters::noise;
use halfdisk::lab::experiment::cost::{
    ALL, Budget, Design, Measured, Method, PriceList, Reach, Verdict, measure, measure_share,
};
use halfdisk::lab::experiment::named;
use halfdisk::render::{Progress, Shard};
use halfdisk::scene::{Scene, gallery};
use std::sync::atomic::{AtomicU64, Ordering};

const DESIGN: Design = Design {
    replicates: 16,
    sizes: 3,
    budget: Budget::Rays(130_000),
    reference: 16,
    threads: None,
    seed: 3,
};

fn small(name: &str) -> Scene {
    gallery::load(name).unwrap().sized([32, 32])
}

fn run(scene: &Scene, methods: &[Method], design: &Design) -> (Measured, PriceList) {
    let measured = measure(scene, methods, design, &()).unwrap();
    let list = PriceList::new(scene, &measured);
    (measured, list)
}

#[test]
fn every_unbiased_error_falls_as_one_over_the_root_of_its_rays() {
    let scene = small("cornell");
    let (measured, list) = run(&scene, &ALL, &DESIGN);
    assert_eq!((measured.replicates, measured.interrupted), (16, false));
    let mut sufficient = 0;
    for method in &list.methods {
        let fit = method.against_rays.as_ref();
        let bias = method.bias.unwrap();
        match method.name {
            "whitted" | "clamped" => {
                assert_eq!(method.verdict, Verdict::Biased, "{}", method.says());
                assert!(bias.floor() > 0.05 && bias.mean < -0.02, "{bias:?}");
                // It loses light, and far more than chance would.
                assert!(bias.mean < -8.0 * bias.mean_error, "{bias:?}");
                assert!(method.says().contains("levels out"), "{}", method.says());
                // What it says agrees with what was measured: pictures are as far off and noise more.
                let floor = method.levels_out.unwrap();
                let last = method.sizes.last().unwrap();
                let most = last.error + 2.0 * last.error_error;
                assert!(0.0 < floor.low && floor.low <= floor.error, "{floor:?}");
                assert!(floor.error <= floor.high && floor.high <= most, "{floor:?}");
                assert!(floor.high > 0.5 * last.error, "{floor:?} {last:?}");
                assert_eq!(method.times[2], Reach::Never);
                assert!(method.ratios.iter().all(Option::is_none), "no price");
            }
            "path-sobol" => assert_eq!(method.verdict, Verdict::Faster, "{}", method.says()),
            name => {
                let fit = fit.unwrap_or_else(|why| panic!("{name}: {why}"));
                // The interval misses in one of twenty, three times as wide in one of ten thousand.
                let off = (fit.line.slope + 0.5).abs();
                assert!(off < 3.0 * fit.half_width, "{name}: {fit}");
                assert!(!bias.is_certain(), "{name}: {bias:?}");
                let priced = matches!(method.times[0], Reach::Priced { .. });
                assert_eq!(priced, method.verdict == Verdict::Sufficient, "{name}");
                sufficient += u32::from(priced);
            }
        }
        assert_eq!(method.non_finite, 0);
        // What is paid is about the same: within a factor of two below the budget.
        let paid = method.sizes.last().unwrap().rays;
        assert!(
            (50_000.0..140_000.0).contains(&paid),
            "{}: {paid}",
            method.name
        );
    }
    assert!(sufficient >= 4, "of 6");
    // In rays chance pays far more than aiming.
    let square_times_rays = |name: &str| {
        let last = list.find(name).unwrap().sizes.last().copied().unwrap();
        last.error * last.error * last.rays
    };
    let ratio = square_times_rays("kajiya") / square_times_rays("next-event");
    assert!(ratio > 10.0, "{ratio}");
    let even = square_times_rays("path") / square_times_rays("path-sobol");
    assert!(even > 1.1, "{even}");
}

#[test]
fn what_does_not_suffice_says_so() {
    let scene = small("cornell");
    let methods = [Method::find("kajiya").unwrap()];
    for (design, words) in [
        (
            Design {
                replicates: 1,
                ..DESIGN
            },
            "fewer than two replicates",
        ),
        (Design { sizes: 1, ..DESIGN }, "fewer than two sizes"),
        (
            Design {
                replicates: 3,
                budget: Budget::Rays(20_000),
                ..DESIGN
            },
            "too wide",
        ),
    ] {
        let (_, list) = run(&scene, &methods, &design);
        let [method] = list.methods.as_slice() else {
            panic!()
        };
        assert_eq!(method.verdict, Verdict::Insufficient);
        assert!(method.says().contains(words), "{}", method.says());
        assert!(
            !matches!(method.times[2], Reach::Priced { .. }),
            "no law, no price"
        );
    }
}

#[test]
fn a_method_that_happens_to_be_right_is_not_called_biased() {
    // Mirrors and glass alone: there is nothing that whitted leaves out.
    let scene = small("tunnel");
    let methods = ["whitted", "path"].map(|name| Method::find(name).unwrap());
    let (_, list) = run(&scene, &methods, &DESIGN);
    let whitted = list.find("whitted").unwrap();
    assert_ne!(whitted.verdict, Verdict::Biased, "{}", whitted.says());
}

#[test]
fn walks_that_meet_lamps_by_chance_are_left_out_where_lamps_have_no_extent() {
    let scene = small("whitted");
    let cannot: Vec<&str> = ALL
        .iter()
        .filter(|m| m.cannot(&scene).is_some())
        .map(|m| m.name)
        .collect();
    // Light solved beforehand has no price by samples, in whatever scene.
    assert_eq!(cannot, ["kajiya", "roulette", "radiosity"]);
    let cannot = ALL.iter().filter(|m| m.cannot(&small("cornell")).is_some());
    assert!(cannot.map(|m| m.name).eq(["radiosity"]));
}

/// Stops after it was told so often that something is done.
struct Impatient {
    told: AtomicU64,
    patience: u64,
}

impl Progress for Impatient {
    fn tell(&self, done: u64, total: u64) {
        assert!(done <= total + total / 100, "{done} of {total}");
        self.told.fetch_add(1, Ordering::Relaxed);
    }
    fn stop(&self) -> bool {
        self.told.load(Ordering::Relaxed) >= self.patience
    }
}

#[test]
fn stopped_it_keeps_the_replicates_that_are_complete() {
    let scene = small("cornell");
    let methods = ["kajiya", "path"].map(|name| Method::find(name).unwrap());
    let stopped = |patience| {
        let told = AtomicU64::new(0);
        measure(&scene, &methods, &DESIGN, &Impatient { told, patience })
    };
    // Two halves of the reference, then two methods at three sizes for each replicate.
    let some = stopped(2 + 3 * 6 + 2).unwrap();
    assert_eq!((some.replicates, some.interrupted), (3, true));
    let list = PriceList::new(&scene, &some);
    assert!(list.interrupted && list.methods.iter().all(|m| m.sizes.len() == 3));
    let (whole, _) = run(&scene, &methods, &DESIGN);
    for (few, all) in some.methods.iter().zip(&whole.methods) {
        let [few, all] = [few, all].map(|runs| runs.study.runs.iter().flatten());
        for (a, b) in few.zip(all) {
            assert_eq!((a.square, a.rays), (b.square, b.rays), "the same pictures");
        }
    }
    assert!(
        stopped(0).is_err() && stopped(4).is_err(),
        "nothing complete"
    );
}

#[test]
fn s1_06_the_second_thousand_is_worth_fifty_times_the_twenty_first() {
    let lamp = named::find("half-disk-lamp").unwrap();
    let found = noise::falls(80, lamp.truth, |block| {
        (lamp.run)(1000, 1 << 40 | u64::from(block))
    });
    for (name, fall, exact, widest) in [
        ("early", found.one_to_two, 1.0 - 0.5_f64.sqrt(), 0.006),
        (
            "late",
            found.twenty_to_more,
            1.0 - (20.0 / 21.0_f64).sqrt(),
            0.003,
        ),
        ("ratio", found.ratio, 54.351, 8.0),
    ] {
        let off = (fall.value - exact).abs();
        assert!(
            off <= 4.0 * fall.error && off < widest,
            "{name}: {fall:?} for {exact}"
        );
        // Equal steps would be noticed: the test tells the one from the other.
        assert!(fall.error < 0.3 * widest, "{name}: {fall:?}");
    }
}

#[test]
fn shares_of_the_replicates_give_what_one_run_gives() {
    let scene = gallery::load("cornell").unwrap().sized([12, 12]);
    let methods = ["path", "path-sobol", "clamped", "kajiya"].map(|n| Method::find(n).unwrap());
    let design = Design {
        replicates: 7,
        budget: Budget::Rays(20_000),
        ..DESIGN
    };
    let (whole, list) = run(&scene, &methods, &design);
    let share = |index| {
        let share = Shard { index, count: 3 };
        let measured = measure_share(&scene, &methods, &design, share, &()).unwrap();
        // By way of a file.
        let text = serde_json::to_string(&measured).unwrap();
        serde_json::from_str::<Measured>(&text).unwrap()
    };
    let shares = vec![share(1), share(2), share(3)];
    let joined = Measured::joined(shares.clone()).unwrap();
    assert_eq!(joined.replicates, 7);
    for (a, b) in whole.methods.iter().zip(&joined.methods) {
        let known = |runs: &[Vec<halfdisk::lab::experiment::cost::Run>]| -> Vec<_> {
            let runs = runs.iter().flatten();
            runs.map(|r| (r.square, r.top_share, r.rays, r.non_finite))
                .collect()
        };
        assert_eq!(
            known(&a.study.runs),
            known(&b.study.runs),
            "{}",
            a.method.name
        );
    }
    let of_shares = PriceList::new(&scene, &joined);
    for (a, b) in list.methods.iter().zip(&of_shares.methods) {
        let [x, y] = [a, b].map(|method| method.bias.unwrap());
        for (x, y) in [
            (x.square, y.square),
            (x.mean, y.mean),
            (x.mean_error, y.mean_error),
        ] {
            assert!(
                (x - y).abs() < 1e-9 * (1.0 + x.abs()),
                "{}: {x} {y}",
                a.name
            );
        }
    }
    // Another order is another study, and another seed another reference.
    let mut turned = shares.clone();
    turned.swap(0, 2);
    let turned = Measured::joined(turned).unwrap();
    assert_ne!(
        turned.methods[0].study.runs[0][0].square,
        joined.methods[0].study.runs[0][0].square
    );
    let other = Design { seed: 4, ..design };
    let first = Shard { index: 1, count: 3 };
    let other = measure_share(&scene, &methods, &other, first, &()).unwrap();
    assert!(Measured::joined(vec![other, shares[1].clone()]).is_none());
}
