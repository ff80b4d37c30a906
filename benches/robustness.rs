//! What robustness costs: the plain form of each computation, and ours, on the same input. The end is a
//! table of all that was timed, in nanoseconds for each call and in percent.

#![allow(clippy::print_stdout)]
#![allow(missing_docs)]

use criterion::{Criterion, Throughput};
use halfdisk::lab::experiment::robustness::{Pair, pairs};
use serde_json::Value;
use std::path::Path;
use std::time::SystemTime;

/// How often each form is computed in one go.
const CALLS: usize = 4096;

fn main() {
    // Where criterion puts its results anyway.
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("../criterion");
    let mut criterion = Criterion::default()
        .output_directory(&folder)
        .configure_from_args();
    let (start, pairs) = (SystemTime::now(), pairs(CALLS));
    forms(&mut criterion, &pairs);
    criterion.final_summary();
    print_table(&folder, start, &pairs);
}

fn forms(c: &mut Criterion, pairs: &[Pair]) {
    for pair in pairs {
        let mut group = c.benchmark_group(pair.name);
        group.throughput(Throughput::Elements(CALLS as u64));
        group.bench_function(PLAIN, |b| b.iter(&pair.plain));
        group.bench_function(OURS, |b| b.iter(&pair.robust));
        group.finish();
    }
}

const PLAIN: &str = "plain";
const OURS: &str = "ours";

/// Nanoseconds of a call, and half of their interval of 95 %.
struct Price {
    ns: f64,
    half: f64,
}

impl Price {
    /// The median that criterion found for this form since `start`; `None` where it timed something else.
    fn read(folder: &Path, pair: &Pair, form: &str, start: SystemTime) -> Option<Price> {
        let file = folder.join(pair.name).join(form).join("new/estimates.json");
        if file.metadata().ok()?.modified().ok()? < start {
            return None;
        }
        let all: Value = serde_json::from_slice(&std::fs::read(file).ok()?).ok()?;
        let median = &all["median"];
        let bound = |name: &str| median["confidence_interval"][name].as_f64();
        let calls = CALLS as f64;
        Some(Price {
            ns: median["point_estimate"].as_f64()? / calls,
            half: 0.5 * (bound("upper_bound")? - bound("lower_bound")?) / calls,
        })
    }

    fn relative(&self) -> f64 {
        self.half / self.ns
    }
}

/// What each pair costs, of those that were timed since `start`.
fn print_table(folder: &Path, start: SystemTime, pairs: &[Pair]) {
    let read = |pair, form| Price::read(folder, pair, form, start);
    let timed: Vec<(&Pair, Price, Price)> = pairs
        .iter()
        .filter_map(|pair| Some((pair, read(pair, PLAIN)?, read(pair, OURS)?)))
        .collect();
    if timed.is_empty() {
        return;
    }
    println!(
        "{:20} {:>16} {:>16} {:>10}",
        "", "plain, ns", "ours, ns", "more, %"
    );
    for (pair, plain, ours) in timed {
        let ratio = ours.ns / plain.ns;
        println!(
            "{:20} {:8.3} ± {:.3} {:8.3} ± {:.3} {:+6.0} ± {:.0}   {}; {}",
            pair.name,
            plain.ns,
            plain.half,
            ours.ns,
            ours.half,
            100.0 * (ratio - 1.0),
            100.0 * ratio * plain.relative().hypot(ours.relative()),
            pair.plain_form,
            pair.robust_form
        );
    }
}
