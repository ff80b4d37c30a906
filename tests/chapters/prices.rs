//! The chapter of prices.

use super::{check, near, number};

#[test]
fn ch18_cost() {
    let data = check(env!("CARGO_BIN_EXE_ch18-cost"), "ch18");
    for name in [
        "early", "late", "ratio", "forty", "reached", "held_out", "paused",
    ] {
        near_or_equal(&data, name);
    }
    assert!(number(&data, "early", "error") < 0.6 && number(&data, "late", "error") < 0.3);
    assert!(number(&data, "forty", "error") < 0.01);
    assert!(number(&data, "merged", "value") <= 1.0);
    for name in [
        "kajiya",
        "roulette",
        "next_event",
        "which_ray",
        "combine",
        "path",
    ] {
        let key = format!("slope_{name}");
        let [slope, error] = ["value", "error"].map(|part| number(&data, &key, part));
        assert!(
            (slope + 0.5).abs() <= 4.4 * error,
            "{name}: {slope} ± {error}"
        );
        assert!(error < 0.08, "{name}: {error}");
    }
    // What is biased levels out: named, with its floor, and without a price.
    for name in ["whitted", "clamped"] {
        assert!(number(&data, &format!("floor_{name}"), "value") > 5.0);
        assert!(data["numbers"].get(format!("price_{name}")).is_none());
    }
    let price = |name: &str| number(&data, &format!("price_{name}"), "value");
    assert!(price("kajiya") > 10.0 && price("path_sobol") < 1.0);
    // The shares of the pixels of a scene are all of them.
    for scene in ["cornell", "spheres", "gloss", "caustic"] {
        let share = |part: &str| number(&data, &format!("{part}_{scene}"), "value");
        let all = share("less") + share("within") + share("more");
        assert!((all - 100.0).abs() < 0.2, "{scene}: {all}");
    }
}

/// As [`near`]; what has no error is equal.
fn near_or_equal(data: &serde_json::Value, name: &str) {
    match data["numbers"][name].get("error") {
        Some(_) => near(data, name),
        None => assert_eq!(number(data, name, "value"), number(data, name, "exact")),
    }
}
