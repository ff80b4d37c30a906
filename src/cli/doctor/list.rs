//! All mistakes and their readings.

use crate::cli::Stop;
use crate::cli::answer::answer;
use crate::lab::doctor::{Reading, diagnose, question};
use crate::lab::mistakes::{Exam, Variant, all, right};
use crate::numeric::fixed;
use crate::space::Dimension;
use serde::Serialize;
use std::fmt::{self, Display, Formatter, Write as _};

/// Gathers behind each measured reading.
const GATHERS: u32 = 20_000;
/// The same list every time.
const SEED: u64 = 1;

/// A variant at an exam that tells it from the right one.
#[derive(Serialize)]
struct Row {
    space: Dimension,
    variant: &'static str,
    forgot: &'static str,
    exam: Exam,
    exact: f64,
    measured: f64,
    error: f64,
    z: f64,
}

/// The variants of one world after those of another.
#[derive(Serialize)]
struct Rows(Vec<Row>);

pub(super) fn list(worlds: &[Dimension], json: bool) -> Result<(), Stop> {
    let rows = worlds.iter().flat_map(|&world| rows(world));
    answer(&Rows(rows.collect()), json)
}

impl Display for Rows {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let worlds = self.0.chunk_by(|a, b| a.space == b.space);
        let tables: Vec<String> = worlds.map(table).collect();
        f.write_str(&super::for_terminal(&tables.join("\n")))
    }
}

fn rows(world: Dimension) -> Vec<Row> {
    let right = right(world);
    let row = |variant: Variant| {
        let exam = question(&right, &variant).unwrap_or_default();
        let measured = variant.measure(&exam, GATHERS, SEED);
        let reading = Reading {
            value: measured.mean(),
            error: measured.std_error(),
            exam,
        };
        // The doctor's own distance: it knows how far sums in `f32` can be trusted.
        let findings = diagnose(world, &[reading]).findings;
        let own = findings.iter().find(|f| f.variant.name == variant.name);
        Row {
            space: world,
            variant: variant.name,
            forgot: variant.forgot,
            exact: variant.reading(&exam),
            measured: reading.value,
            error: reading.error,
            exam,
            z: own.map_or(f64::INFINITY, |f| f.z),
        }
    };
    [vec![right], all(world)]
        .concat()
        .into_iter()
        .map(row)
        .collect()
}

fn table(rows: &[Row]) -> String {
    let name = match rows.first().map(|row| row.space) {
        Some(Dimension::Solid) => "Space: the hemisphere",
        _ => "The flat world: the half disk",
    };
    let mut text = format!(
        "{name}\nWhite sky, albedo 1, 16 directions, upright, one bounce, shadow rays that see; what a \
         mistake has\nto be asked otherwise to show is under `asked with`. z is the distance of measured \
         from exact, in standard\nerrors.\n\n{:<33} {:>8}   {:<20} {:>5}  asked with\n",
        "variant", "exact", "measured ± error", "z"
    );
    for row in rows {
        let measured = format!("{} ± {:.5}", fixed(row.measured, 5), row.error);
        let line = format!(
            "{:<33} {:>8}   {measured:<20} {:>5.2}  {}",
            row.variant,
            fixed(row.exact, 5),
            row.z,
            asked(&row.exam)
        );
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text += "\nForgotten, or mixed up:\n";
    for row in rows {
        let _ = writeln!(text, "  {}: {}", row.variant, row.forgot);
    }
    text
}

/// What differs from the usual question.
fn asked(exam: &Exam) -> String {
    let usual = Exam::default();
    let mut said = Vec::new();
    if exam.albedo != usual.albedo {
        said.push(format!("albedo {}", exam.albedo));
    }
    if exam.samples != usual.samples {
        said.push(format!("{} directions", exam.samples));
    }
    if exam.tilt != usual.tilt {
        said.push(format!("tilt {:.0} degrees", exam.tilt.to_degrees()));
    }
    if exam.bounces != usual.bounces {
        said.push(format!("{} bounces", exam.bounces));
    }
    if exam.aimed != usual.aimed {
        said.push("blind shadow rays".to_owned());
    }
    said.join(", ")
}
