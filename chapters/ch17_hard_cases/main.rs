//! Chapter 17: Hard cases.
//!
//! Question: formulas that are right on paper go wrong in 24 bits; where, what holds there, and what
//! does it cost? New here: `numeric::naive`, the plain forms; beside each the one that is used.
//! Simulates no paths. Builds on: all chapters before.

mod acne;
mod cases;
mod finale;
mod leaving;
mod patches;
mod spacing;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::experiment::robustness::pairs;
use halfdisk::lab::experiment::stopwatch::in_turns;
use halfdisk::lab::ledger::Ledger;
use halfdisk::stats::Estimate;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch17",
    title: "Hard cases",
    question: "The formulas are right on paper. Where do 24 bits lose them, and what does it cost to \
               keep them?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    spacing::chart(desk)?;

    // Where the plain form fails, and ours does not.
    let n = desk.choose(200_000, 20_000);
    let seed = desk.options.seed;
    for case in cases::all(n, seed)? {
        let whose = |whose: &str, value: f64| {
            Number::new(&format!("{}: {whose}", case.says), value).exact(case.truth)
        };
        // JSON has no word for what is no number.
        match case.plain.is_nan() {
            true => desk.say(&format!("{:<58} NaN", format!("{}: plain", case.says))),
            false => desk.number(&format!("{}_plain", case.name), whose("plain", case.plain)),
        }
        desk.number(&format!("{}_ours", case.name), whose("ours", case.ours));
    }

    // Rays that leave a surface, in small worlds and large ones.
    let each = desk.choose(50_000, 4_000);
    let rates = leaving::rates(each, seed);
    desk.figure("leaving.svg", CAPTION, chart(&rates).to_svg()?)?;
    let worst = |rule: usize| rates.iter().map(|r| r.failed[rule]).fold(0.0, f64::max);
    for (rule, (name, says)) in leaving::RULES.iter().enumerate() {
        let says = format!("rays that start wrongly, at the worst scale: {says}");
        desk.value(&format!("leaving_{name}"), &says, worst(rule));
    }

    // The same in a picture.
    let pictured = acne::pictures(desk)? + finale::work(desk)?;

    // What the care costs: rounds in several sittings, for what slows a machine lasts longer than a round.
    let (sittings, rounds) = desk.choose((12, 40), (3, 2));
    let pairs = pairs(4096);
    let mut ratios = vec![Estimate::new(); pairs.len()];
    for _ in 0..sittings {
        for (pair, ratios) in pairs.iter().zip(&mut ratios) {
            ratios.add(in_turns(rounds, &pair.plain, &pair.robust).mean());
        }
    }
    for (pair, ratios) in pairs.iter().zip(&ratios) {
        let says = format!("time of ours over the plain form: {}", pair.name);
        desk.estimate(&format!("price_time_{}", pair.key), &says, ratios, None);
    }
    Ok(Ledger {
        rays: 3 * leaving::SCALES as u64 * u64::from(each) + pictured,
        ..Ledger::of(
            "No ray is lost, none meets its own surface, and no sum forgets its samples; most \
             single routines take longer for it.",
        )
    })
}

const CAPTION: &str = "The share of rays that leave a triangle wrongly, against the size of the world: they meet it \
                       again, or start beyond a neighbour at a hundredth of its size. A fixed length is right in worlds \
                       of one size only; the bound is right in all. Each point is a count of so many rays that its \
                       standard error is smaller than its dot.";

fn chart(rates: &[leaving::Rate]) -> CurveChart {
    let curve = |rule: usize| {
        let points = rates.iter().map(|rate| (rate.scale, rate.failed[rule]));
        Curve::new(leaving::RULES[rule].1, Style::MarksAndLine, points)
    };
    CurveChart {
        title: "Three ways to leave a surface".to_owned(),
        x_label: "size of the triangle, scene units".to_owned(),
        y_label: "share of rays that start wrongly".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Linear,
        curves: (0..3).map(curve).collect(),
    }
}
