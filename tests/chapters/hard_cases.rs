//! The chapter of hard cases.

use super::{check, number};

#[test]
fn ch17_hard_cases() {
    let data = check(env!("CARGO_BIN_EXE_ch17-hard-cases"), "ch17");
    let off = |name: &str| {
        let [value, exact] = ["value", "exact"].map(|part| number(&data, name, part));
        (value - exact).abs()
    };
    for (case, ours, plain) in [
        ("sphere", 0.0, 0.2),
        ("vertex", 0.0, 0.001),
        ("slab", 0.0, 0.5),
        ("cone", 1e-6, 0.05),
        ("frame", 1e-6, 0.1),
        ("rim", 0.0, 1e-8),
        ("words", 0.0, 127.0),
        ("fresnel", 0.0, 0.7),
        ("schlick", 0.0, 0.9),
        ("ggx", 1e-6, 0.01),
        ("survival", 1e-6, 0.3),
        ("mean", 1e-9, 1e-5),
        ("variance", 0.01, 10.0),
    ] {
        let [a, b] = ["ours", "plain"].map(|whose| off(&format!("{case}_{whose}")));
        assert!(a <= ours && b > plain, "{case}: ours {a}, plain {b}");
    }
    // The plain weights are no number; ours are one.
    assert!(off("weights_ours") <= 1e-6 && data["numbers"].get("weights_plain").is_none());
    // Points below their own surface are dark; a step of a fixed length moves the shadows.
    let wrong = |start: &str| number(&data, &format!("acne_{start}"), "value");
    assert!(wrong("end") > 10.0 && wrong("fixed") > 1.0);
    assert_eq!(number(&data, "leaving_bounded", "value"), 0.0);
    for rule in ["fixed", "scaled"] {
        assert!(number(&data, &format!("leaving_{rule}"), "value") > 0.1);
    }
}
