//! How bright a PNG picture is shown, and what does not fit in it.

use halfdisk::color::{Rgb, quantise, srgb_encode};
use halfdisk::output::{self, Display};
use halfdisk::render::{Film, Pixel};
use std::path::Path;

/// Eight pixels from black to twice white.
fn ramp() -> Film {
    let pixel = |i: u8| {
        let mut pixel = Pixel::default();
        let light = 0.25 * f32::from(i);
        pixel.add(Rgb::new(light, 0.5 * light, 0.1));
        pixel
    };
    Film::new(4, (0..8).map(pixel).collect())
}

#[test]
fn a_stop_doubles_the_light_and_clipped_pixels_are_counted() {
    let film = ramp();
    let mut before = 0;
    for stops in [-2.0, 0.0, 1.0] {
        let display = Display::Exposed { stops };
        let factor = libm::exp2(stops);
        let mut bright = 0;
        for (pixel, shown) in film.pixels().iter().zip(output::shades(&film, display)) {
            let mean = pixel.mean().unwrap();
            let expected = mean.map(|x| quantise(srgb_encode(factor * x)));
            assert_eq!(shown, expected, "{stops} stops");
            bright += usize::from(mean.iter().any(|x| factor * x > 1.0));
        }
        let clipped = output::clipped(&film, display, Path::new("a.png"));
        assert_eq!(clipped, Some(bright), "{stops} stops");
        assert!(bright >= before, "more light clips no fewer");
        before = bright;
    }
    assert_eq!(before, 5, "all that are brighter than half of white");
    let plain = output::shades(&film, Display::Radiance);
    assert_eq!(
        plain,
        output::shades(&film, Display::Exposed { stops: 0.0 })
    );
    // Other formats hold any radiance, and data is no light.
    assert_eq!(
        output::clipped(&film, Display::Radiance, Path::new("a.exr")),
        None
    );
    let data = Display::Data { white: 1.0 };
    assert_eq!(output::clipped(&film, data, Path::new("a.png")), None);
}
