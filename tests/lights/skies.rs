//! Skies from files of all kinds: windows, layers and channels of EXR, headers of HDR.

use exr::prelude::*;
use glam::Vec3;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, SceneError, gallery};
use std::path::Path as FilePath;

/// A scene with such a sky beside its file, and a lamp.
fn load(folder: &FilePath, file: &str) -> std::result::Result<Scene, SceneError> {
    let text = format!(
        "name = 'test'\ncamera = {{ from = [0, 0, 0], to = [0, 0, 1], fov = 40 }}\n\
         environment.image = '{file}'\n[[lights]]\npoint = {{ position = [1, 1, 1], intensity = 1 }}\n"
    );
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, Some(folder), |_| {})
}

/// The values of a sky of 4 x 2 pixels, from its first row's first.
fn values(scene: &Scene) -> Vec<[f32; 3]> {
    let mut found = Vec::new();
    for y in [1.0, -1.0] {
        for [x, z] in [[-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]] {
            let towards = Vec3::new(x, y, z).normalize();
            found.push(scene.background(towards).channels());
        }
    }
    found
}

/// An image file of one part: the place of its data, their size and that of the display window, and
/// channels whose pixel `i` has the value `i + 1` times a factor.
fn write(path: &FilePath, data: [i32; 4], window: [i32; 4], channels: &[(&str, f32)]) {
    let size = (data[2] as usize, data[3] as usize);
    let channel = |(name, factor): &(&str, f32)| {
        let values = (1..=size.0 * size.1).map(|i| i as f32 * factor).collect();
        AnyChannel::new(*name, FlatSamples::F32(values))
    };
    let mut attributes = LayerAttributes::named("part");
    attributes.layer_position = Vec2(data[0], data[1]);
    let layer = Layer::new(
        size,
        attributes,
        Encoding::FAST_LOSSLESS,
        AnyChannels::sort(channels.iter().map(channel).collect()),
    );
    let window = IntegerBounds::new(
        (window[0], window[1]),
        (window[2] as usize, window[3] as usize),
    );
    let image = Image::empty(ImageAttributes::new(window)).with_layer(layer);
    image.write().non_parallel().to_file(path).unwrap();
}

const RGB: [(&str, f32); 3] = [("R", 1.0), ("G", 0.5), ("B", 0.25)];
const WHOLE: [i32; 4] = [0, 0, 4, 2];

fn colour(i: f32) -> [f32; 3] {
    [i, 0.5 * i, 0.25 * i]
}

#[test]
fn data_of_an_exr_file_stand_where_its_display_window_has_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sky.exr");
    let all: Vec<f32> = (1..=8).map(|i| i as f32).collect();
    let cases = [
        (WHOLE, WHOLE, all.clone()),
        // Both windows elsewhere, in the same place.
        ([-7, 100, 4, 2], [-7, 100, 4, 2], all),
        // A crop: black beside it.
        (
            [1, 0, 2, 1],
            WHOLE,
            vec![0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0],
        ),
        (
            [11, 21, 2, 1],
            [10, 20, 4, 2],
            vec![0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 0.0],
        ),
        // More than the window shows.
        (
            [-1, -1, 6, 4],
            WHOLE,
            vec![8.0, 9.0, 10.0, 11.0, 14.0, 15.0, 16.0, 17.0],
        ),
        // Over two of its edges.
        (
            [2, 1, 4, 2],
            WHOLE,
            vec![0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 2.0],
        ),
    ];
    for (data, window, expected) in cases {
        write(&path, data, window, &RGB);
        let scene = load(folder.path(), "sky.exr").unwrap();
        let expected: Vec<[f32; 3]> = expected.into_iter().map(colour).collect();
        assert_eq!(values(&scene), expected, "{data:?} in {window:?}");
    }
    // Nothing of it in the window: black, and said so.
    write(&path, [50, 0, 4, 2], WHOLE, &RGB);
    let scene = load(folder.path(), "sky.exr").unwrap();
    assert!(scene.environment_light.is_none());
    assert_eq!(
        scene.report.notes,
        ["sky.exr: every pixel is black, so it gives no light"]
    );
    write(&path, WHOLE, [0, 0, 100_000, 100_000], &RGB);
    let error = load(folder.path(), "sky.exr").unwrap_err().to_string();
    assert!(error.contains("not 100000 x 100000"), "{error}");
}

#[test]
fn the_picture_of_an_exr_file_is_its_root_layer_or_its_only_one() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("sky.exr");
    let read = |channels: &[(&str, f32)]| {
        write(&path, WHOLE, WHOLE, channels);
        load(folder.path(), "sky.exr").map(|scene| values(&scene)[2])
    };
    for (channels, expected) in [
        (&RGB[..], [3.0, 1.5, 0.75]),
        (
            &[("A", 9.0), ("B", 0.25), ("G", 0.5), ("R", 1.0), ("Z", 7.0)],
            [3.0, 1.5, 0.75],
        ),
        (&[("Y", 2.0)], [6.0; 3]),
        (&[("A", 9.0), ("Y", 2.0)], [6.0; 3]),
        (
            &[("sky.B", 1.0), ("sky.G", 2.0), ("sky.R", 3.0)],
            [9.0, 6.0, 3.0],
        ),
        (
            &[
                ("a.b.B", 1.0),
                ("a.b.G", 2.0),
                ("a.b.R", 3.0),
                ("depth.Z", 4.0),
            ],
            [9.0, 6.0, 3.0],
        ),
        (&[("sky.Y", 3.0), ("Z", 4.0)], [9.0; 3]),
        // The root before others, colour before grey.
        (
            &[
                ("B", 1.0),
                ("G", 1.0),
                ("R", 1.0),
                ("left.B", 8.0),
                ("left.G", 8.0),
                ("left.R", 8.0),
            ],
            [3.0; 3],
        ),
        (&[("B", 1.0), ("G", 1.0), ("R", 1.0), ("Y", 8.0)], [3.0; 3]),
        (
            &[("Y", 1.0), ("sky.B", 8.0), ("sky.G", 8.0), ("sky.R", 8.0)],
            [3.0; 3],
        ),
    ] {
        assert_eq!(read(channels).unwrap(), expected, "{channels:?}");
    }
    for (channels, found) in [
        (
            &[
                ("left.B", 1.0),
                ("left.G", 1.0),
                ("left.R", 1.0),
                ("right.Y", 1.0),
            ][..],
            "its channels are left.B, left.G, left.R, right.Y",
        ),
        (&[("Z", 1.0)], "its channels are Z"),
        (&[("R", 1.0), ("G", 1.0)], "its channels are G, R"),
        // Luminance and chroma: the colour is in the other two.
        (
            &[("BY", 1.0), ("RY", 1.0), ("Y", 1.0)],
            "its channels are BY, RY, Y",
        ),
    ] {
        let error = read(channels).unwrap_err().to_string();
        assert!(error.contains(found), "{error}");
        assert!(
            error.starts_with("test.toml:3: `environment.image` names "),
            "{error}"
        );
    }
}

/// A Radiance picture of 4 x 2 pixels of which pixel `i` has the value `(i + 1)` times `colour(1)`.
fn hdr(header: &str, size: &str) -> Vec<u8> {
    let mut bytes = format!("{header}{size}").into_bytes();
    for i in 1..=8 {
        // Mantissas over 256 times 2 to the exponent less 128.
        bytes.extend([16 * i, 8 * i, 4 * i, 132]);
    }
    bytes
}

#[test]
fn headers_of_hdr_files_say_what_radiance_the_values_stand_for() {
    let folder = tempfile::tempdir().unwrap();
    let read = |bytes: &[u8]| {
        std::fs::write(folder.path().join("sky.hdr"), bytes).unwrap();
        load(folder.path(), "sky.hdr").map(|scene| values(&scene))
    };
    let format = "FORMAT=32-bit_rle_rgbe\n";
    let usual: Vec<[f32; 3]> = (1..=8).map(|i| colour(i as f32)).collect();
    let scaled = |by: [f32; 3]| {
        let scale = |p: &[f32; 3]| [p[0] * by[0], p[1] * by[1], p[2] * by[2]];
        usual.iter().map(scale).collect::<Vec<_>>()
    };
    for (header, by) in [
        ("#?RADIANCE\nFORMAT\n", [1.0; 3]),
        ("#?RGBE\nFORMAT\n", [1.0; 3]),
        (
            "#?RADIANCE\n# made by hand\nGAMMA=1.0\nFORMAT\nPRIMARIES= 0 0 1 0 0 1 .3 .3\n",
            [1.0; 3],
        ),
        ("#?RADIANCE\nFORMAT\nEXPOSURE=0.5\n", [2.0; 3]),
        ("#?RADIANCE\nEXPOSURE= 4\nFORMAT\nEXPOSURE=0.5\n", [0.5; 3]),
        ("#?RADIANCE\nFORMAT\nCOLORCORR= 0.5 1 2\n", [2.0, 1.0, 0.5]),
        (
            "#?RGBE\nCOLORCORR=0.5 1 2\nEXPOSURE=2\nFORMAT\nCOLORCORR=.5 4 1\n",
            [2.0, 0.125, 0.25],
        ),
        // What belongs to a picture it was made from.
        ("#?RADIANCE\n\tEXPOSURE=8\nFORMAT\n", [1.0; 3]),
    ] {
        let header = header.replace("FORMAT\n", format) + "\n";
        assert_eq!(
            read(&hdr(&header, "-Y 2 +X 4\n")).unwrap(),
            scaled(by),
            "{header}"
        );
        let crlf = header.replace('\n', "\r\n");
        assert_eq!(
            read(&hdr(&crlf, "-Y 2 +X 4\r\n")).unwrap(),
            scaled(by),
            "{crlf:?}"
        );
    }
    let start = format!("#?RADIANCE\n{format}");
    for (header, words) in [
        (
            format!("{start}EXPOSURE=0\n\n"),
            "EXPOSURE must be 1 numbers above 0",
        ),
        (
            format!("{start}EXPOSURE=-1\n\n"),
            "EXPOSURE must be 1 numbers above 0",
        ),
        (
            format!("{start}EXPOSURE=nan\n\n"),
            "EXPOSURE must be 1 numbers above 0",
        ),
        (
            format!("{start}COLORCORR=1 1\n\n"),
            "COLORCORR must be 3 numbers above 0",
        ),
        (
            "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n".to_owned(),
            "32-bit_rle_xyze",
        ),
        ("RADIANCE\n\n".to_owned(), "begins with `#?`"),
        (start.clone(), "its header has no end"),
    ] {
        let error = read(&hdr(&header, "-Y 2 +X 4\n")).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    }
}

#[test]
fn hdr_files_may_be_written_in_all_eight_orders() {
    let folder = tempfile::tempdir().unwrap();
    // Of each order, which of the values stands at each place.
    let orders = [
        ("-Y 2 +X 4", [1, 2, 3, 4, 5, 6, 7, 8]),
        ("-Y 2 -X 4", [4, 3, 2, 1, 8, 7, 6, 5]),
        ("+Y 2 +X 4", [5, 6, 7, 8, 1, 2, 3, 4]),
        ("+Y 2 -X 4", [8, 7, 6, 5, 4, 3, 2, 1]),
        ("+X 4 -Y 2", [1, 3, 5, 7, 2, 4, 6, 8]),
        ("-X 4 -Y 2", [7, 5, 3, 1, 8, 6, 4, 2]),
        ("+X 4 +Y 2", [2, 4, 6, 8, 1, 3, 5, 7]),
        ("-X 4 +Y 2", [8, 6, 4, 2, 7, 5, 3, 1]),
    ];
    let header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    for (order, expected) in orders {
        std::fs::write(
            folder.path().join("sky.hdr"),
            hdr(header, &format!("{order}\n")),
        )
        .unwrap();
        let found = values(&load(folder.path(), "sky.hdr").unwrap());
        let expected = expected.map(|i: u8| colour(f32::from(i)));
        assert_eq!(found, expected, "{order}");
    }
    for order in [
        "-Y 2 -Y 4",
        "X 4 Y 2",
        "-Y 2",
        "-Y 2 +X four",
        "-Y 2 +X 4 5",
    ] {
        std::fs::write(
            folder.path().join("sky.hdr"),
            hdr(header, &format!("{order}\n")),
        )
        .unwrap();
        let error = load(folder.path(), "sky.hdr").unwrap_err().to_string();
        assert!(error.contains("like `-Y 512 +X 1024`"), "{error}");
    }
}
