//! What chapter 15 found in its quick run.

use super::{check, number};

#[test]
fn ch15_patches() {
    let data = check(env!("CARGO_BIN_EXE_ch15-patches"), "ch15");
    let value = |name: &str| number(&data, name, "value");
    let off = |name: &str| (value(name) - number(&data, name, "exact")).abs();
    for name in ["facing", "touching"] {
        assert!(off(&format!("{name}_lambert_8")) < 1e-10, "{name}");
        assert!(off(&format!("{name}_centres")) > 0.1, "the mistake");
    }
    assert!(off("touching_areas") > 0.05, "points on both are no help");
    assert!(off("centre") < 1e-4 && off("mean") < 4e-4);
    assert!(off("slope_constant") < 0.1);
    assert!((-1.5..-0.85).contains(&value("slope_gathered")));
    assert!(value("jacobi") <= 0.5 + 1e-9);
    assert_eq!(value("rows"), 1.0);
    // Few patches are far from the truth, and that is no noise.
    let off = ["value", "error"].map(|part| number(&data, "point_off", part));
    assert!(off[0].abs() > 4.0 * off[1], "{off:?}");
    // What the metal would send on is missing.
    let stays = |part: &str| number(&data, "stays_metal", part);
    assert!(stays("value") > 4.0 * stays("error"));
}
