//! How bright the chapters' pictures are shown.

use super::run;
use halfdisk::color::{quantise, srgb_encode};
use halfdisk::output;

/// The pixels of a picture that are shown with `factor` times their light, of all.
fn shown_with(factor: f64, folder: &std::path::Path, file: &str) -> [usize; 2] {
    let path = folder.join(file);
    let shades = image::open(&path).unwrap().to_rgb8();
    let light = output::read(&path.with_extension("exr")).unwrap();
    let pairs = light.values.iter().zip(shades.pixels());
    // An EXR file keeps single precision, which may lie on the other side of a level.
    let near = |x: f64, shade: u8| quantise(srgb_encode(factor * x)).abs_diff(shade) <= 1;
    let same = pairs.filter(|(light, shade)| (0..3).all(|c| near(light[c], shade.0[c])));
    [same.count(), light.values.len()]
}

/// Quick runs show the last picture so many times smaller.
const SMALLER: u32 = 8;

/// Fails where a chapter has no last picture, or one that is small in a full run, or one whose error is not told.
pub fn has_a_last_picture(folder: &std::path::Path, data: &serde_json::Value) {
    let numbers = data["numbers"].as_object().unwrap();
    let told: Vec<&str> = (numbers.keys())
        .filter_map(|name| name.strip_prefix("error_of_"))
        .collect();
    let [name] = told[..] else {
        panic!("one last picture has its error told, not {told:?}");
    };
    let picture = image::open(folder.join(format!("{name}.png"))).unwrap();
    assert!(SMALLER * picture.width() >= 512, "{name} is small");
    let figures = data["figures"].as_array().unwrap();
    let file = |figure: &&serde_json::Value| figure["file"] == format!("{name}.png");
    let caption = figures.iter().find(file).unwrap()["caption"].as_str();
    assert!(
        caption.unwrap().contains("Look"),
        "the caption of {name} does not say where to look"
    );
}

#[test]
fn the_box_is_shown_with_twice_the_light_and_its_numbers_are_as_they_are() {
    let (folder, _) = run(env!("CARGO_BIN_EXE_ch06-gather"), "ch06", &[]);
    let folder = folder.path().join("ch06");
    let [twice, all] = shown_with(2.0, &folder, "all.png");
    assert_eq!(twice, all);
    let [once, _] = shown_with(1.0, &folder, "all.png");
    assert!(once < all / 2, "{once} of {all}");
}

#[test]
fn a_last_picture_has_the_exposure_that_was_chosen_for_it() {
    let (folder, _) = run(env!("CARGO_BIN_EXE_ch01-from-the-eye"), "ch01", &[]);
    let folder = folder.path().join("ch01");
    let [same, all] = shown_with(libm::exp2(0.2), &folder, "courtyard.png");
    assert_eq!(same, all);
    // A picture beside it is shown as it is.
    let [same, all] = shown_with(1.0, &folder, "image.png");
    assert_eq!(same, all);
}
