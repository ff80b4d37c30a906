//! What chapter 16 found in its quick run.

use super::{check, near, number};

#[test]
fn ch16_photons() {
    let data = check(env!("CARGO_BIN_EXE_ch16-photons"), "ch16");
    let value = |name: &str| number(&data, name, "value");
    for name in ["plate_middle", "plate_edge", "plate_corner", "lens", "slab"] {
        near(&data, name);
    }
    for window in ["wide", "middle", "narrow"] {
        near(&data, &format!("window_mean_{window}"));
        near(&data, &format!("window_variance_{window}"));
    }
    // Variances are those of their windows, and of no other.
    let [wide, narrow] =
        ["wide", "narrow"].map(|window| value(&format!("window_variance_{window}")));
    assert!(narrow > 8.0 * wide, "{narrow} {wide}");
    for k in [5, 20, 50] {
        near(&data, &format!("nearest_{k}"));
        near(&data, &format!("nearest_all_{k}"));
    }
    for name in ["squared_small", "squared_large"] {
        near(&data, name);
    }
    // The curve is flat at its lowest place: the next radius is as good.
    let off = value("best_radius") / number(&data, "best_radius", "exact");
    assert!((0.7..1.5).contains(&off), "{off}");
    for world in ["flat", "solid"] {
        near(&data, &format!("slope_fastest_{world}"));
        let [fastest, fixed] = ["fastest", "fixed"].map(|k| value(&format!("slope_{k}_{world}")));
        assert!(fastest < fixed - 0.1, "{world}: {fastest} {fixed}");
    }
    assert_eq!([value("ellipse"), value("aplanatic")], [1.0; 2]);
    for dark in ["unseen_path", "unseen_mirror_light_tracer"] {
        assert_eq!(value(dark), 0.0, "{dark}");
    }
    assert!(value("unseen_mirror_photons") > 0.5 * value("unseen_photons"));
    // Photons win where light is focused, and by much less where it is not.
    assert!(value("ratio_caustic") > 2.0 && value("ratio_box") < 1.5);
    assert!(value("crossing_caustic") > 10.0 * value("crossing_box"));
}
