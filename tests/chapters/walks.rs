//! The chapters in which light walks.

use super::{check, near, number};

#[test]
fn ch07_one_ray() {
    let data = check(env!("CARGO_BIN_EXE_ch07-one-ray"), "ch07");
    for name in ["room", "noise", "edge_pixel"] {
        near(&data, name);
    }
    let value = |name: &str| number(&data, name, "value");
    assert!(value("apart") <= 4.0, "trees and paths");
    assert!(value("edge_worst") <= 4.0);
    // Trees and paths were given the same rays, and the paths are less noisy.
    assert!((value("tree_all") / value("paths_all") - 1.0).abs() < 0.02);
    assert!(value("price_ratio") > 2.0);
    for bounces in [2, 4] {
        let rays = value(&format!("path_rays_{bounces}"));
        assert_eq!(rays, f64::from(bounces + 1));
    }
    assert_eq!(value("tree_rays_4"), 69_905.0);
    // At one point a shared ray is a ray saved.
    assert!(value("split_point_16") < value("split_point_1"));
    let forty = number(&data, "noise", "error");
    assert!(
        forty < 0.03 * value("noise"),
        "known to three percent: {forty}"
    );
}

#[test]
fn ch09_aim_at_the_light() {
    let data = check(env!("CARGO_BIN_EXE_ch09-aim-at-the-light"), "ch09");
    for way in ["uniform", "cosine", "aim"] {
        for angle in ["14", "1", "03", "01", "003", "001", "0003"] {
            near(&data, &format!("{way}_{angle}"));
        }
        near(&data, &format!("solid_{way}_03"));
        near(&data, &format!("solid_{way}_01"));
    }
    let value = |name: &str| number(&data, name, "value");
    for name in ["slope_uniform", "slope_cosine"] {
        near(&data, name);
        assert!((value(name) + 1.0).abs() <= 0.03, "{name}: {}", value(name));
    }
    for name in [
        "lamps_all",
        "lamps_uniform",
        "lamps_power",
        "lamps_given",
        "mirror_sphere",
        "mirror_chance",
        "floor_twice",
    ] {
        near(&data, name);
    }
    // The mistake is out of the right one's reach.
    let off = value("floor_twice") - 1.0;
    assert!(off > 8.0 * number(&data, "floor_twice", "error"), "{off}");
    // The image of a point lamp is missing, and nothing else is.
    let direct = value("mirror_point") / value("mirror_direct");
    assert!((direct - 1.0).abs() < 1e-5, "{direct}");
    assert!(value("mirror_image") > 0.1 * value("mirror_direct"));
    assert_eq!(value("lamps_all_rays"), 10.0);
    assert_eq!(value("lamps_power_rays"), 3.0);
    assert!(value("gain") > 1e6);
}

#[test]
fn ch11_combine() {
    let data = check(env!("CARGO_BIN_EXE_ch11-combine"), "ch11");
    let value = |name: &str| number(&data, name, "value");
    for size in [1, 2, 5, 10, 20, 30, 50, 70, 90, 110, 130, 150] {
        let [chance, aiming, balance, power] =
            ["chance", "aiming", "balance", "power"].map(|way| {
                let name = format!("variance_{way}_{size}");
                let [value, exact, error] =
                    ["value", "exact", "error"].map(|p| number(&data, &name, p));
                let z = (value - exact) / error;
                assert!(z.abs() <= 4.0, "{name}: {value} for {exact}, z = {z}");
                value
            });
        let bound = value(&format!("bound_{size}"));
        assert!(balance <= bound && power <= bound, "{size}");
        assert!(balance.max(power) <= chance.max(aiming), "{size}");
    }
    assert!(value("largest_z") <= 4.0);
    for way in ["chance", "aiming", "balance"] {
        for size in [3, 100, 150] {
            near(&data, &format!("length_{way}_{size}"));
        }
    }
    for (way, albedo) in [("chance", 50), ("aiming", 50), ("both", 50), ("both", 75)] {
        let name = format!("furnace_{way}_{albedo}");
        let [value, exact, error] = ["value", "exact", "error"].map(|p| number(&data, &name, p));
        assert!(
            (value - exact).abs() <= 4.0 * error + 1e-5,
            "{name}: {value}"
        );
    }
    for slip in ["twice", "density", "one", "both", "selection"] {
        near(&data, &format!("slip_{slip}"));
        let z = value(&format!("slip_z_{slip}")).abs();
        assert_eq!(z > 4.4, slip != "both", "{slip}: {z}");
    }
    // Combined walks beat both techniques where there is something of everything.
    let price = |way: &str| value(&format!("plates_variance_{way}"));
    assert!(price("power") < price("chance") && price("power") < price("aiming"));
}

#[test]
fn ch10_roulette() {
    let data = check(env!("CARGO_BIN_EXE_ch10-roulette"), "ch10");
    let value = |name: &str| number(&data, name, "value");
    for cut in ["50_2", "50_5", "80_5", "80_20", "90_8", "90_43"] {
        let name = format!("lost_{cut}");
        assert!(
            (value(&name) - number(&data, &name, "exact")).abs() < 1e-3,
            "{name}"
        );
    }
    for survival in [80, 90, 95] {
        near(&data, &format!("mean_{survival}"));
        near(&data, &format!("variance_{survival}"));
        let name = format!("variance_{survival}");
        let ratio = value(&name) / number(&data, &name, "exact");
        assert!((ratio - 1.0).abs() < 0.1, "{name}: {ratio}");
    }
    // Where no variance can be trusted, the common walks can.
    for survival in [50, 65, 80, 90, 95] {
        near(&data, &format!("common_{survival}"));
    }
    for name in [
        "clamp_10",
        "clamp_30",
        "clamp_100",
        "reached",
        "white_segments",
    ] {
        near(&data, name);
    }
    assert!(value("clamp_lost_10") > value("clamp_lost_100"));
    assert!(value("clamp_lost_100") > 1.0, "percent");
    near(&data, "dark_roulette");
    assert!(value("dark_variance_cut") < 1e-12);
    let hurt = value("dark_variance_roulette") / number(&data, "dark_variance_roulette", "exact");
    assert!((hurt - 1.0).abs() < 0.1, "{hurt}");
    assert!(value("box_gain") > 1.0);
}

#[test]
fn ch12_the_path_tracer() {
    let data = check(env!("CARGO_BIN_EXE_ch12-the-path-tracer"), "ch12");
    let value = |name: &str| number(&data, name, "value");
    for name in ["plates", "room", "square", "sunk", "many"] {
        near(&data, name);
    }
    assert_eq!(value("many_rays"), 3.0, "one lamp of sixty-four");
    for percent in [60, 90] {
        for way in ["chance", "path"] {
            near(&data, &format!("furnace_{way}_{percent}"));
        }
        near(&data, &format!("furnace_chance_variance_{percent}"));
        let name = format!("furnace_chance_rays_{percent}");
        let ratio = value(&name) / number(&data, &name, "exact");
        assert!((ratio - 1.0).abs() < 0.02, "{name}: {ratio}");
    }
    // Whatever is left out, the mean stays.
    for scene in ["box", "plates", "ceiling"] {
        for left_out in ["aiming", "weights", "roulette", "choice"] {
            let z = value(&format!("{scene}_{left_out}_z"));
            assert!(z.abs() <= 4.0, "{scene} without {left_out}: {z}");
        }
        // One lamp is asked instead of all, so a path takes no more rays.
        let rays = |left_out: &str| value(&format!("{scene}_{left_out}_rays"));
        assert!(rays("path") <= 1.05 * rays("choice") && rays("path") <= rays("roulette"));
        assert!(rays("aiming") < rays("path"));
    }
    assert!(value("box_aiming_price") > 3.0, "a small lamp");
    assert!(
        value("plates_weights_price") > 2.0,
        "large lamps in smooth plates"
    );
    assert!(value("ceiling_choice_price") > 2.0, "many lamps");
    for walk in ["kajiya", "which_ray", "roulette", "next_event", "combine"] {
        let z = value(&format!("spheres_{walk}_z"));
        assert!(z.abs() <= 4.0, "{walk}: {z}");
    }
    assert!(value("floor_variance_chance") > 50.0 * value("floor_variance_path"));
}

#[test]
fn ch13_six_integrals() {
    let data = check(env!("CARGO_BIN_EXE_ch13-six-integrals"), "ch13");
    for name in ["pixel", "light", "lens", "time", "gloss", "hemisphere"] {
        let z = number(&data, &format!("z_{name}"), "value");
        assert!(z <= 4.0, "{name}: {z}");
        let variance = |name: &str| number(&data, &format!("variance_{name}"), "value");
        assert!(variance(name) > 0.0 && variance(name) < variance("all"));
        let asked = number(&data, &format!("asked_{name}"), "value");
        assert_eq!(asked, 2.0, "{name}: a camera ray and a shadow ray");
        if name != "gloss" {
            assert_eq!(number(&data, &format!("first_{name}"), "value"), 3.0);
        }
    }
    for name in ["first_none", "asked_none", "asked_all"] {
        let rays = if name == "first_none" { 3.0 } else { 2.0 };
        assert_eq!(number(&data, name, "value"), rays, "{name}");
    }
    for name in ["width_light", "width_lens", "width_time", "groove", "cone"] {
        near(&data, name);
    }
    let off = number(&data, "lobe", "value") - number(&data, "lobe", "exact");
    assert!(off.abs() < 1e-7);
}

#[test]
fn ch08_which_ray() {
    let data = check(env!("CARGO_BIN_EXE_ch08-which-ray"), "ch08");
    for name in [
        "diffuse",
        "specular",
        "transmitted",
        "room_absorb",
        "slab_rays",
    ] {
        near(&data, name);
    }
    for rule in ["equal", "mean", "luminance", "analog"] {
        let name = format!("furnace_{rule}");
        let [value, exact, error] = ["value", "exact", "error"].map(|p| number(&data, &name, p));
        assert!((value - exact).abs() <= 4.0 * error + 1e-6, "{name}");
        for mixture in ["grey", "faint", "plastic", "prism"] {
            near(&data, &format!("variance_{mixture}_{rule}"));
        }
    }
    assert!(number(&data, "p_shares", "value") > 1e-3);
    assert!(number(&data, "p_thirds", "value") < 1e-6);
    // Without a weight everything reflects everything, far from the truth.
    assert_eq!(number(&data, "furnace_forgotten", "value"), 1.0);
    for (name, widest) in [("slab_through", 0.005), ("slab_back", 0.05)] {
        near(&data, name);
        let [exact, error] = ["exact", "error"].map(|p| number(&data, name, p));
        assert!(4.0 * error < widest * exact, "{name}: {error}");
    }
    for name in ["left_right", "left_none", "left_more"] {
        let ratio = number(&data, name, "value") / number(&data, name, "exact");
        assert!((ratio - 1.0).abs() < 1e-5, "{name}: {ratio}");
    }
    assert!((number(&data, "left_more", "value") - 6.19).abs() < 0.01);
    // By weight: no variance, all rays. Absorbed: variance, and as many rays as light.
    assert_eq!(number(&data, "room_variance_weight", "value"), 0.0);
    assert_eq!(number(&data, "room_rays_weight", "value"), 40.0);
    let [value, exact] = ["value", "exact"].map(|p| number(&data, "room_variance_absorb", p));
    assert!((value / exact - 1.0).abs() < 0.03, "{value} for {exact}");
    let rays = number(&data, "room_rays_absorb", "value");
    assert!((rays / number(&data, "room_absorb", "value") - 1.0).abs() < 1e-6);
}
