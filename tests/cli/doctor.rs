//! `halfdisk doctor`: readings and the mistakes behind them.

use super::{complaint, folder, halfdisk};
use halfdisk::lab::doctor::question;
use halfdisk::lab::mistakes::{Exam, Variant, all, right};
use halfdisk::space::Dimension;
use serde_json::Value;

const WORLDS: [(Dimension, &str); 2] = [(Dimension::Flat, "flat"), (Dimension::Solid, "solid")];

/// Runs `doctor`; returns its stdout.
fn doctor(arguments: &[&str]) -> String {
    let output = halfdisk(folder().path(), &[&["doctor"], arguments].concat());
    assert!(
        output.status.success(),
        "{arguments:?}: {}",
        complaint(&output)
    );
    assert!(output.stderr.is_empty());
    String::from_utf8(output.stdout).unwrap()
}

/// The arguments that say how a reading was taken.
fn as_asked(exam: &Exam) -> Vec<String> {
    let rays = if exam.aimed { "seeing" } else { "blind" };
    [
        ("--albedo", exam.albedo.to_string()),
        ("--samples", exam.samples.to_string()),
        ("--tilt", exam.tilt.to_degrees().to_string()),
        ("--bounces", exam.bounces.to_string()),
        ("--shadow-rays", rays.to_owned()),
    ]
    .into_iter()
    .flat_map(|(option, value)| [option.to_owned(), value])
    .collect()
}

/// Checks that a reading, as typed, is named after `variant`, and after nothing that would have
/// read another number.
fn names(world: (Dimension, &str), variant: &Variant, exam: &Exam, reading: &[&str]) {
    let asked = as_asked(exam);
    let asked: Vec<&str> = asked.iter().map(String::as_str).collect();
    let text = doctor(&[&["--space", world.1, "--json"], reading, &asked[..]].concat());
    let object: Value = serde_json::from_str(&text).unwrap();
    let found: Vec<&str> = object["matches"]
        .as_array()
        .unwrap()
        .iter()
        .map(|m| m["variant"].as_str().unwrap())
        .collect();
    let place = format!("{}, {}: {found:?}", world.1, variant.name);
    assert!(found.contains(&variant.name), "{place}");
    for other in [vec![right(world.0)], all(world.0)].concat() {
        if found.contains(&other.name) {
            let apart = (other.reading(exam) - variant.reading(exam)).abs();
            assert!(apart < 0.03, "{place}: {} is not it", other.name);
        }
    }
    assert_eq!(object["healthy"], found.contains(&"right"));
}

#[test]
fn every_exact_reading_is_named_and_so_is_a_noisy_one() {
    for world in WORLDS {
        for variant in [vec![right(world.0)], all(world.0)].concat() {
            let exam = question(&right(world.0), &variant).unwrap_or_default();
            let exact = format!("{:.4}", variant.reading(&exam));
            names(world, &variant, &exam, &["--reading", &exact]);
            let noisy = variant.measure(&exam, 4000, 3);
            let (value, error) = (
                noisy.mean().to_string(),
                noisy.std_error().max(1e-4).to_string(),
            );
            names(
                world,
                &variant,
                &exam,
                &["--reading", &value, "--error", &error],
            );
        }
    }
}

#[test]
fn the_answer_is_in_sentences() {
    let text = doctor(&["--reading", "0.7854", "--space", "flat"]);
    assert!(
        text.starts_with("cosine twice ") && text.contains("Forgotten: "),
        "{text}"
    );
    let text = doctor(&["--reading", "0.6366", "--space", "flat"]);
    assert!(text.contains("No reading tells them apart"), "{text}");
    let text = doctor(&["--reading", "0.9000", "--space", "solid"]);
    assert!(
        text.starts_with("No mistake on the list reads this"),
        "{text}"
    );
    assert!(doctor(&["--reading", "-0.0000", "--space", "flat"]).starts_with("cosine of the"));
}

#[test]
fn a_reading_of_one_digit_is_told_to_be_one_and_one_below_zero_has_the_wrong_sign() {
    let text = doctor(&["--reading", "1", "--space", "solid"]);
    let first = text.lines().next().unwrap();
    assert!(
        first.starts_with("The right estimator reads this, and so do "),
        "{text}"
    );
    assert!(first.contains("measure with more of them"), "{text}");
    let z: Vec<f64> = text
        .split("(z ")
        .skip(1)
        .map(|rest| rest.split(')').next().unwrap().parse().unwrap())
        .collect();
    assert!(z.len() > 4 && z.is_sorted(), "{z:?}");
    assert!(!text.contains("bounce(s)"), "{text}");
    for (value, space) in [("-1", "solid"), ("-0.32", "flat"), ("-0.7854", "solid")] {
        let text = doctor(&["--reading", value, "--space", space]);
        let sign =
            format!("A white sky reads 0 or more, and {value} is below: look for a wrong sign");
        assert!(text.starts_with(&sign), "{text}");
        assert!(!text.contains("printed formula over pi"), "{text}");
    }
    let three = doctor(&["--reading", "1.000", "--space", "solid"]);
    assert!(!three.contains("A white sky reads 0 or more"), "{three}");
}

#[test]
fn two_readings_say_more_than_one() {
    let healthy = |more: &[&str]| {
        let text = doctor(&[&["--space", "flat", "--json", "--reading", "1.0000"], more].concat());
        serde_json::from_str::<Value>(&text).unwrap()["healthy"] == true
    };
    assert!(healthy(&[]));
    let transposed = ["--reading", "0.5000", "--tilt", "0", "--tilt", "30"];
    assert!(!healthy(&transposed));
    assert!(healthy(&[
        "--reading",
        "0.5000",
        "--albedo",
        "1",
        "--albedo",
        "0.5"
    ]));
}

#[test]
fn without_a_reading_it_lists_every_mistake() {
    let text = doctor(&[]);
    let json: Value = serde_json::from_str(&doctor(&["--json"])).unwrap();
    let entries = json.as_array().unwrap();
    let count: usize = WORLDS.iter().map(|(world, _)| 1 + all(*world).len()).sum();
    assert_eq!(entries.len(), count);
    for entry in entries {
        for key in [
            "space", "variant", "forgot", "exam", "exact", "measured", "error", "z",
        ] {
            assert!(entry.get(key).is_some(), "no {key} in {entry}");
        }
        assert!(entry["z"].as_f64().unwrap() <= 4.0, "{entry}");
        let [name, forgot] = ["variant", "forgot"].map(|key| entry[key].as_str().unwrap());
        assert!(text.contains(&format!("  {name}: {forgot}\n")), "{name}");
    }
    assert!(
        text.contains("tilt 30 degrees") && text.contains("albedo 0.5"),
        "{text}"
    );
    assert!(!text.contains("-0.00000 "), "{text}");
    let solid = doctor(&["--space", "solid"]);
    assert!(text.ends_with(&solid) && !solid.contains("flat world:"));
}

#[test]
fn bad_values_end_with_2() {
    let asked = ["doctor", "--space", "flat", "--reading", "0.6"];
    for (more, words) in [
        (&["--reading", "pi"][..], "a finite number is needed"),
        (&["--reading", "NaN"], "a finite number is needed"),
        (&["--error", "0"], "a standard error is above 0"),
        (&["--error", "-1"], "a standard error is above 0"),
        (&["--tilt", "-30"], "a tilt is from 0 to 90 degrees"),
        (&["--albedo", "1.5"], "an albedo is from 0 to 1"),
        (&["--tilt", "91"], "a tilt is from 0 to 90 degrees"),
        (&["--samples", "0"], "--samples"),
        (&["--bounces", "0"], "--bounces"),
        (&["--space", "curved"], "--space"),
        (
            &["--tilt", "1", "--tilt", "2"],
            "--tilt is given 2 times for 1 reading: give it once",
        ),
    ] {
        let output = halfdisk(folder().path(), &[&asked, more].concat());
        let text = complaint(&output);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {text}");
        assert!(text.contains(words) && output.stdout.is_empty(), "{text}");
    }
    for alone in [
        &["doctor", "--reading", "0.6"][..],
        &["doctor", "--tilt", "3"],
    ] {
        assert_eq!(
            halfdisk(folder().path(), alone).status.code(),
            Some(2),
            "{alone:?}"
        );
    }
}
