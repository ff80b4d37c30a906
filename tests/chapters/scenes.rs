//! The pictures of the pages on scene files and recipes.

use super::{near, number, run};

#[test]
fn each_picture_of_the_reference_pages_is_of_a_file_and_has_little_noise() {
    let (folder, data) = run(env!("CARGO_BIN_EXE_book-pictures"), "scenes", &[]);
    let figures = data["figures"].as_array().unwrap();
    assert_eq!(figures.len() as f64, number(&data, "pictures", "value"));
    for figure in figures {
        let file = figure["file"].as_str().unwrap();
        let stem = file.strip_suffix(".png").unwrap();
        let error = number(&data, &format!("error_{stem}"), "value");
        // Pictures are a sixth as wide here, so that more of them is edges: in full size 6 % are not passed.
        assert!(error > 0.0 && error <= 7.5, "{file}: {error} %");
        let picture = folder
            .path()
            .join("scenes")
            .join(file)
            .with_extension("exr");
        let mut shades: Vec<f64> = (halfdisk::output::read(&picture).unwrap().values)
            .iter()
            .map(|pixel| pixel.iter().sum::<f64>() / 3.0)
            .collect();
        shades.sort_by(f64::total_cmp);
        let middle = shades[shades.len() / 2];
        assert!((0.01..1.0).contains(&middle), "{file}: exposed to {middle}");
    }
    // The two ways to light a room by its window, and the power of a bulb.
    assert!(number(&data, "window_gain", "value") > 2.0);
    near(&data, "bulb");
    let exact = number(&data, "bulb", "exact");
    let missed = |factor: f64| (factor - 1.0) * exact > 20.0 * number(&data, "bulb", "error");
    assert!(missed(2.0), "two sides for one would be noticed");
}

#[test]
fn the_pages_show_every_picture_of_scene_files_and_recipes() {
    let page = |name: &str| {
        let path = format!("{}/book/src/{name}.md", env!("CARGO_MANIFEST_DIR"));
        std::fs::read_to_string(path).unwrap()
    };
    let pages = page("scenes") + &page("recipes");
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/recipes");
    let mut files = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if let Some(stem) = name.strip_suffix(".toml") {
            files += 1;
            let shown = stem == "stage" || pages.contains(&format!("scenes/{stem}.png"));
            assert!(shown && pages.contains(&name), "{name} is on no page");
        }
    }
    assert_eq!(files, 9);
}
