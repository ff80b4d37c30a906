//! Chapter 17: Hard cases.
//!
//! Question: formulas that are right on paper go wrong in 24 bits; where, what holds there, and what
//! does it cost? New here: `numeric::naive`, the plain forms; beside each the one that is used.
//! Simulates no paths. Builds on: all chapters before.

mod cases;
mod leaving;
mod patches;

use halfdisk::lab::chapter::{Chapter, Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::experiment::robustness::pairs;
use halfdisk::lab::experiment::stopwatch::in_turns;
use halfdisk::lab::ledger::Ledger;
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
    // Where the plain form fails, and ours does not.
    let n = desk.choose(1_000_000, 20_000);
    let seed = desk.options.seed;
    for case in cases::all(n, seed)? {
        let whose = |whose: &str, value: f64| {
            Number::new(&format!("{}: {whose}", case.says), value).exact(case.truth)
        };
        desk.number(&format!("{}_plain", case.name), whose("plain", case.plain));
        desk.number(&format!("{}_ours", case.name), whose("ours", case.ours));
    }

    // Rays that leave a surface, in small worlds and large ones.
    let each = desk.choose(100_000, 4_000);
    let rates = leaving::rates(each, seed);
    desk.figure("leaving.svg", CAPTION, chart(&rates).to_svg()?)?;
    let worst = |rule: usize| rates.iter().map(|r| r.failed[rule]).fold(0.0, f64::max);
    for (rule, (name, says)) in leaving::RULES.iter().enumerate() {
        let says = format!("rays that start wrongly, at the worst scale: {says}");
        desk.value(&format!("leaving_{name}"), &says, worst(rule));
    }

    // What the care costs.
    let rounds = desk.choose(2_000, 4);
    for pair in pairs(4096) {
        let ratio = in_turns(rounds, &pair.plain, &pair.robust).mean();
        let says = format!("time of ours over the plain form: {}", pair.name);
        // To a hundredth: the rounds of one run agree better than runs do.
        let rounded = (100.0 * ratio).round() / 100.0;
        desk.value(&format!("price_time_{}", pair.key), &says, rounded);
    }
    Ok(Ledger {
        rays: 3 * leaving::SCALES as u64 * u64::from(each),
        ..Ledger::of(
            "No ray is lost, none meets its own surface, and no sum forgets its samples; most \
             single routines take longer for it.",
        )
    })
}

const CAPTION: &str = "Rays that leave a triangle and meet it again, or start beyond a neighbour at a \
                       hundredth of its size, against the size of the world.";

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
