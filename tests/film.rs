//! What becomes of samples: in the film, and in each kind of file.

use halfdisk::color::{Rgb, srgb_decode};
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Albedo, Depth, Integrator, Normals, Whitted};
use halfdisk::output::{self, Display, Provenance};
use halfdisk::render::{BadSample, Film, Options, Picture, Pixel, compare, render};
use halfdisk::sampling::stream::{Purpose, Sampler, Stream};
use halfdisk::scene::gallery::{self, GALLERY, load};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, Tracer};
use halfdisk::stats::quantile;
use std::collections::BTreeMap;
use std::path::Path;

const OPTIONS: Options = Options {
    spp: 7,
    seed: 3,
    sampler: Sampler::Independent,
    fixed: &[],
    tile: 4,
    shard: None,
};

/// Whitted's integrator, but certain samples come out as something else.
struct Spoilt(BTreeMap<[u32; 2], Rgb>);

impl Spoilt {
    fn new(scene: &Scene, wrong: impl Fn(BadSample) -> Option<Rgb>) -> Self {
        let [width, height] = scene.size;
        let mut spoilt = Spoilt(BTreeMap::new());
        for (y, x) in (0..height).flat_map(|y| (0..width).map(move |x| (y, x))) {
            for sample in 0..OPTIONS.spp {
                if let Some(value) = wrong(BadSample { x, y, sample }) {
                    let stream = Stream::new(OPTIONS.seed, y * width + x, sample);
                    let before = spoilt.0.insert(Spoilt::key(&stream), value);
                    assert!(before.is_none(), "two samples with the same numbers");
                }
            }
        }
        spoilt
    }

    /// Random numbers nobody else draws tell which sample this is.
    fn key(stream: &Stream) -> [u32; 2] {
        stream.at(u64::MAX, Purpose::Lens).two().map(f32::to_bits)
    }
}

impl Integrator for Spoilt {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let li = Whitted { max_depth: 4 }.li(tracer, ray, stream);
        self.0.get(&Spoilt::key(stream)).copied().unwrap_or(li)
    }
}

fn small(name: &str) -> Scene {
    load(name).expect("a scene of the gallery").sized([13, 9])
}

#[test]
fn bad_samples_are_counted_named_and_in_no_mean() {
    let scene = small("lamp");
    let bad = [
        Rgb::grey(f32::NAN),
        Rgb::new(0.0, f32::INFINITY, 0.0),
        Rgb::new(0.0, 0.0, f32::NEG_INFINITY),
    ];
    let is_bad = |b: BadSample| match (b.x, b.y, b.sample) {
        (7, 3, s) => Some(bad[s as usize % 3]),
        (12, 2, 4) | (0, 3, 0) => Some(bad[0]),
        (5, 8, 1..=3) => Some(bad[1]),
        _ => None,
    };
    let spoilt = render(&scene, &Spoilt::new(&scene, is_bad), &OPTIONS, &());
    assert_eq!(spoilt.non_finite, 7 + 2 + 3);
    assert_eq!(
        spoilt.first_bad,
        Some(BadSample {
            x: 12,
            y: 2,
            sample: 4
        })
    );

    // The others are as if the bad ones had never been.
    let sound = render(&scene, &Spoilt::new(&scene, |_| None), &OPTIONS, &());
    assert_eq!((sound.non_finite, sound.first_bad), (0, None));
    for (y, x) in (0..9).flat_map(|y| (0..13).map(move |x| (y, x))) {
        let (pixel, whole) = (spoilt.film.pixel(x, y), sound.film.pixel(x, y));
        match (x, y) {
            (7, 3) => assert_eq!((pixel.count(), pixel.mean()), (0, None)),
            (12, 2) | (0, 3) => assert_eq!(pixel.count(), 6),
            (5, 8) => assert_eq!(pixel.count(), 4),
            _ => assert_eq!(pixel, whole, "{x} {y}"),
        }
        assert!(pixel.mean().is_none_or(|m| m.iter().all(|c| c.is_finite())));
    }
    let (mean, error) = spoilt.film.mean();
    assert!(mean.is_finite() && error.is_finite() && spoilt.film.max().is_finite());
}

#[test]
fn the_first_samples_of_many_are_the_samples_of_few() {
    let scene = small("spheres");
    for spp in 1..OPTIONS.spp {
        let only_first = |b: BadSample| (b.sample >= spp).then_some(Rgb::grey(f32::NAN));
        let many = render(&scene, &Spoilt::new(&scene, only_first), &OPTIONS, &());
        let few = render(
            &scene,
            &Spoilt(BTreeMap::new()),
            &Options { spp, ..OPTIONS },
            &(),
        );
        // Samples that are left out were taken, too.
        let of = |film: &Film| -> Vec<_> {
            film.pixels().iter().map(|p| (p.channels, p.runs)).collect()
        };
        assert_eq!(of(&many.film), of(&few.film), "{spp}");
        assert!(many.film.pixels().iter().all(|p| p.taken == OPTIONS.spp));
        assert!(
            few.film
                .pixels()
                .iter()
                .all(|p| p.count() == u64::from(spp))
        );
    }
}

#[test]
fn the_gallery_has_only_finite_samples() {
    for (name, _) in GALLERY {
        let scene = load(name).unwrap().sized([40, 30]);
        let check = |integrator: &str, rendered: halfdisk::render::Rendered| {
            assert_eq!(rendered.non_finite, 0, "{name}, {integrator}");
            assert!(rendered.film.pixels().iter().all(|p| p.count() == 7));
        };
        check(
            "whitted",
            render(&scene, &Whitted { max_depth: 8 }, &OPTIONS, &()),
        );
        check("normals", render(&scene, &Normals, &OPTIONS, &()));
        check("albedo", render(&scene, &Albedo, &OPTIONS, &()));
        check("depth", render(&scene, &Depth, &OPTIONS, &()));
    }
}

#[test]
fn nothing_is_exactly_background() {
    let text = "name = \"nothing\"\nbackground = [0.1, 0.2, 30]\n\
                [camera]\nfrom = [0, 0, 5]\nto = [0, 0, 0]\nfov = 40\n[film]\nsize = [5, 3]\n";
    let source = Source {
        file: "nothing",
        text,
    };
    let scene = gallery::from_text(source, None, |_| {}).unwrap();
    let film = render(&scene, &Whitted { max_depth: 4 }, &OPTIONS, &()).film;
    for pixel in film.pixels() {
        assert_eq!(pixel.mean(), Some([0.1_f32, 0.2, 30.0].map(f64::from)));
        assert!(pixel.channels.iter().all(|c| c.std_error() == 0.0));
    }
    for view in [
        render(&scene, &Normals, &OPTIONS, &()),
        render(&scene, &Depth, &OPTIONS, &()),
    ] {
        assert_eq!(view.film.max(), 0.0);
    }
}

/// A film with all there may be: many sizes, zero, one sample, none at all.
fn sample_film() -> Film {
    let mut pixels = vec![Pixel::default(); 6 * 4];
    for (i, pixel) in pixels.iter_mut().enumerate().skip(1) {
        for sample in 0..i as u32 % 5 + 1 {
            let x = libm::expf(i as f32 - 12.0) * (1.0 + sample as f32);
            pixel.add(Rgb::new(
                x,
                0.5 * x,
                if i % 2 == 0 { 0.0 } else { 0.25 * x },
            ));
        }
    }
    Film::new(6, pixels)
}

/// The film as a file.
fn written(ending: &str, display: Display) -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = crate::cli::folder();
    let path = folder.path().join("deep/er").join("p.".to_owned() + ending);
    let facts = Provenance::new(&small("lamp"), "whitted", 4, 5, u64::MAX);
    output::write(&path, &sample_film(), display, &facts).unwrap();
    (folder, path)
}

fn check_facts(text: &str) {
    let facts: serde_json::Value = serde_json::from_str(text).expect("JSON");
    assert_eq!(
        facts["software"],
        format!("halfdisk {}", env!("CARGO_PKG_VERSION"))
    );
    assert_eq!(facts["scene"], "lamp");
    assert_eq!(facts["integrator"], "whitted");
    assert_eq!((&facts["max_depth"], &facts["spp"]), (&4.into(), &5.into()));
    assert_eq!(facts["seed"], u64::MAX);
}

#[test]
fn png_shows_the_film_and_says_what_made_it() {
    let (_folder, path) = written("png", Display::Radiance);
    let file = std::io::BufReader::new(std::fs::File::open(&path).unwrap());
    let reader = png::Decoder::new(file).read_info().unwrap();
    let texts = &reader.info().utf8_text;
    let text = |key: &str| {
        let chunk = texts.iter().find(|c| c.keyword == key).expect(key);
        chunk.get_text().unwrap()
    };
    check_facts(&text("halfdisk"));
    assert_eq!(text("Title"), "lamp");
    assert_eq!(
        reader.info().srgb,
        Some(png::SrgbRenderingIntent::RelativeColorimetric)
    );

    let image = image::open(&path).unwrap().to_rgb8();
    assert_eq!(image.dimensions(), (6, 4));
    assert_eq!(
        image.get_pixel(0, 0).0,
        [255, 0, 255],
        "no sample is magenta"
    );
    let reds: Vec<u8> = image.pixels().skip(1).map(|p| p.0[0]).collect();
    assert!(reds[0] == 0 && reds[22] == 255, "{reds:?}");
    assert_eq!(image.get_pixel(2, 0).0[2], 0);

    let (_folder, path) = written(
        "png",
        Display::Data {
            white: sample_film().max(),
        },
    );
    let image = image::open(&path).unwrap().to_rgb8();
    assert_eq!(image.get_pixel(0, 0).0, [255, 0, 255]);
    assert_eq!(image.get_pixel(5, 3).0, [255, 128, 64]);
    for white in [0.0, f64::NAN, f64::INFINITY] {
        written("png", Display::Data { white });
    }
}

#[test]
fn png_levels_are_equally_wide() {
    // Of 256 000 even values a thousand have each level, and of linear ones those between the decoded
    // ends of a level.
    let ramp = |i: u32| (f64::from(i) + 0.5) / 256_000.0;
    let counts = |display: Display| {
        let pixel = |i| {
            let mut pixel = Pixel::default();
            pixel.add(Rgb::grey(ramp(i) as f32));
            pixel
        };
        let film = Film::new(512, (0..256_000).map(pixel).collect());
        let facts = Provenance::new(&small("lamp"), "whitted", 4, 1, 0);
        let bytes = output::png_bytes(&film, display, &facts).unwrap();
        let image = image::load_from_memory(&bytes).unwrap().to_rgb8();
        let mut counts = [0_u32; 256];
        for pixel in image.pixels() {
            assert_eq!(pixel.0, [pixel.0[0]; 3]);
            counts[usize::from(pixel.0[0])] += 1;
        }
        counts
    };
    assert_eq!(counts(Display::Data { white: 1.0 }), [1000; 256]);
    let linear = counts(Display::Radiance);
    for (level, count) in linear.into_iter().enumerate() {
        let end = |k: usize| 256_000.0 * srgb_decode(k as f64 / 256.0);
        let expected = end(level + 1) - end(level);
        assert!(
            (f64::from(count) - expected).abs() <= 1.5,
            "{level}: {count} for {expected}"
        );
    }
}

/// A channel of an EXR file.
pub fn channel(path: &Path, name: &str) -> Vec<f32> {
    let image = exr::prelude::read_first_flat_layer_from_file(path).expect("an EXR file");
    let channels = &image.layer_data.channel_data.list;
    let found = channels.iter().find(|c| c.name == *name);
    found.expect(name).sample_data.values_as_f32().collect()
}

#[test]
fn exr_holds_the_film_in_f32() {
    let (_folder, path) = written("exr", Display::Radiance);
    let film = sample_film();
    let check = |name: &str, value: &dyn Fn(&Pixel) -> f64| {
        let expected: Vec<u32> = film
            .pixels()
            .iter()
            .map(|p| (value(p) as f32).to_bits())
            .collect();
        let found: Vec<u32> = channel(&path, name).into_iter().map(f32::to_bits).collect();
        assert_eq!(found, expected, "{name}");
    };
    for (i, name) in ["R", "G", "B"].into_iter().enumerate() {
        check(name, &|p| p.mean().map_or(f64::NAN, |m| m[i]));
        check(&format!("error.{name}"), &|p| p.channels[i].std_error());
    }
    check("samples.Y", &|p| p.count() as f64);
    assert!(channel(&path, "R")[0].is_nan() && channel(&path, "samples.Y")[0] == 0.0);

    let image = exr::prelude::read_first_flat_layer_from_file(&path).unwrap();
    assert_eq!((image.layer_data.size.0, image.layer_data.size.1), (6, 4));
    let facts = &image.layer_data.attributes.other[&exr::prelude::Text::from("halfdisk")];
    let exr::meta::attribute::AttributeValue::Text(facts) = facts else {
        panic!("the provenance is text");
    };
    check_facts(&facts.to_string());
}

#[test]
fn the_root_layer_of_an_exr_file_is_red_green_and_blue_and_it_is_read_back() {
    let (_folder, path) = written("exr", Display::Radiance);
    let image = exr::prelude::read_first_flat_layer_from_file(&path).unwrap();
    let channels = &image.layer_data.channel_data.list;
    let names: Vec<String> = channels.iter().map(|c| c.name.to_string()).collect();
    let (layers, root): (Vec<_>, Vec<_>) = names.iter().partition(|name| name.contains('.'));
    assert_eq!(root, ["B", "G", "R"]);
    assert_eq!(layers, ["error.B", "error.G", "error.R", "samples.Y"]);

    let film = sample_film();
    let picture = halfdisk::output::read(&path).unwrap();
    let errors = picture.errors.expect("errors");
    for (i, pixel) in film.pixels().iter().enumerate().skip(1) {
        let as_f32 = |values: [f64; 3]| values.map(|x| (x as f32).to_bits());
        assert_eq!(as_f32(picture.values[i]), as_f32(pixel.mean().unwrap()));
        let expected = pixel.channels.each_ref().map(|c| c.std_error());
        assert_eq!(as_f32(errors[i]), as_f32(expected));
    }
}

#[test]
fn hdr_holds_the_film_to_one_percent() {
    let (_folder, path) = written("hdr", Display::Radiance);
    let image = image::open(&path).unwrap().to_rgb32f();
    assert_eq!(image.dimensions(), (6, 4));
    assert_eq!(image.get_pixel(0, 0).0, [0.0; 3], "the format has no NaN");
    for (found, pixel) in image.pixels().zip(sample_film().pixels()).skip(1) {
        let expected = pixel.mean().unwrap();
        // Channels share an exponent, so the largest sets the step of all.
        let step = 0.01 * expected[0];
        for (x, y) in found.0.into_iter().zip(expected) {
            assert!(
                (f64::from(x) - y).abs() <= step,
                "{found:?} for {expected:?}"
            );
        }
    }
}

#[test]
fn z_scores_count_the_errors_of_both_pictures() {
    let picture = |value: f64, error: f64| Picture {
        size: [2, 2],
        values: vec![[value; 3]; 4],
        errors: Some(vec![[error; 3]; 4]),
    };
    // Errors of 3 and 4 make one of 5; the four pixels' mean has half of it.
    for (a, b) in [(3.0, 4.0), (4.0, 3.0)] {
        let z = compare::z_scores(&picture(12.0, a), &picture(2.0, b)).unwrap();
        assert!((z.largest - 2.0).abs() < 1e-12 && (z.squares.mean() - 4.0).abs() < 1e-12);
        assert!((z.of_means - 4.0).abs() < 1e-12, "{z:?}");
        assert_eq!(z.rejected, 0.0);
    }
    let far = compare::z_scores(&picture(42.0, 3.0), &picture(2.0, 4.0)).unwrap();
    assert_eq!(far.rejected, 1.0);
}

#[test]
fn a_quantile_is_the_smallest_value_that_so_many_do_not_exceed() {
    let ten: Vec<f64> = (1..=10).rev().map(f64::from).collect();
    for (share, value) in [
        (0.01, 1.0),
        (0.1, 1.0),
        (0.11, 2.0),
        (0.5, 5.0),
        (0.51, 6.0),
        (0.95, 10.0),
        (1.0, 10.0),
    ] {
        assert_eq!(quantile(ten.clone(), share), value, "{share}");
    }
    assert_eq!(quantile(vec![3.0, 1.0, 2.0], 0.34), 2.0);
}
