//! All mistakes and their readings.

use super::exam_json;
use crate::cli::{Stop, answer};
use crate::estimators::doctor::{Reading, diagnose, question};
use crate::estimators::mistakes::{Exam, Variant, all, right};
use crate::numeric::fixed;
use crate::space::Dimension;
use serde_json::{Value, json};
use std::fmt::Write as _;

/// Gathers behind each measured reading.
const GATHERS: u32 = 20_000;
/// The same list every time.
const SEED: u64 = 1;

/// A variant at an exam that tells it from the right one.
struct Row {
    variant: Variant,
    exact: f64,
    reading: Reading,
    z: f64,
}

pub(super) fn list(worlds: &[Dimension], json: bool) -> Result<(), Stop> {
    let worlds = worlds.iter().map(|&world| (world, rows(world)));
    if json {
        let entries: Vec<Value> = worlds
            .flat_map(|(world, rows)| rows.into_iter().map(move |row| row.json(world)))
            .collect();
        return answer(&(serde_json::to_string_pretty(&entries)? + "\n"));
    }
    let texts: Vec<String> = worlds.map(|(world, rows)| table(world, &rows)).collect();
    answer(&super::for_terminal(&texts.join("\n")))
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
            variant,
            exact: variant.reading(&exam),
            reading,
            z: own.map_or(f64::INFINITY, |f| f.z),
        }
    };
    [vec![right], all(world)]
        .concat()
        .into_iter()
        .map(row)
        .collect()
}

fn table(world: Dimension, rows: &[Row]) -> String {
    let name = match world {
        Dimension::Flat => "The flat world: the half disk",
        Dimension::Solid => "Space: the hemisphere",
    };
    let mut text = format!(
        "{name}\nWhite sky, albedo 1, 16 directions, upright, one bounce, shadow rays that see; what a \
         mistake has\nto be asked otherwise to show is under `asked with`. z is the distance of measured \
         from exact, in standard\nerrors.\n\n{:<33} {:>8}   {:<20} {:>5}  asked with\n",
        "variant", "exact", "measured ± error", "z"
    );
    for Row {
        variant,
        exact,
        reading,
        z,
    } in rows
    {
        let measured = format!("{} ± {:.5}", fixed(reading.value, 5), reading.error);
        let line = format!(
            "{:<33} {:>8}   {measured:<20} {z:>5.2}  {}",
            variant.name,
            fixed(*exact, 5),
            asked(&reading.exam)
        );
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text += "\nForgotten, or mixed up:\n";
    for Row { variant, .. } in rows {
        let _ = writeln!(text, "  {}: {}", variant.name, variant.forgot);
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

impl Row {
    fn json(&self, world: Dimension) -> Value {
        json!({
            "space": world,
            "variant": self.variant.name,
            "forgot": self.variant.forgot,
            "exam": exam_json(&self.reading.exam),
            "exact": self.exact,
            "measured": self.reading.value,
            "error": self.reading.error,
            "z": self.z,
        })
    }
}
