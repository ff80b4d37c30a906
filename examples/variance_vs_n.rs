//! Error against samples: one gather right, one stratified, one as printed in the essay.
//!
//! `cargo run --release --example variance_vs_n`

#![allow(clippy::print_stdout)]

use halfdisk::lab::experiment::convergence::{Convergence, Design, converge};
use halfdisk::lab::experiment::named;
use halfdisk::lab::figures::convergence_chart;
use std::error::Error;

const NAMES: [&str; 3] = ["half-disk", "half-disk-stratified", "half-disk-literal"];

fn runs(design: &Design) -> Vec<Convergence> {
    let estimators = NAMES.into_iter().filter_map(named::find);
    estimators.map(|e| converge(&e, design)).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let runs = runs(&Design::default());
    for run in &runs {
        println!("{}: {}", run.name, run.slope_text());
        for size in &run.sizes {
            println!(
                "{:>8} samples: variance {:.3e}",
                size.samples,
                size.variance.unwrap_or(f64::NAN)
            );
        }
    }
    let svg = convergence_chart("Error of a gather under a white sky", &runs).to_svg()?;
    std::fs::create_dir_all("out")?;
    std::fs::write("out/variance_vs_n.svg", svg)?;
    println!("wrote out/variance_vs_n.svg");
    Ok(())
}

#[test]
fn strata_fall_faster_than_chance_and_the_printed_formula_not_at_all() {
    let slopes: Vec<f64> = runs(&Design::default())
        .iter()
        .filter_map(|run| run.fit.ok())
        .map(|fit| fit.line.slope)
        .collect();
    assert_eq!(slopes.len(), NAMES.len());
    for (slope, expected) in slopes.into_iter().zip([-0.5, -1.5, 0.0]) {
        assert!((slope - expected).abs() < 0.05, "{slope}, not {expected}");
    }
}
