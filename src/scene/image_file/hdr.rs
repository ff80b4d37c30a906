//! Radiance pictures (Ward, *Real Pixels*, Graphics Gems II, 1991).

use super::{Pixels, check_size, complain};
use crate::color::Rgb;
use std::fs::File;
use std::io::{BufReader, Cursor, Read};

/// Reads a picture as the radiance it stands for: its values over all `EXPOSURE` and `COLORCORR`.
pub(super) fn read(mut file: BufReader<File>, max_pixels: usize) -> Result<Pixels, String> {
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)
        .map_err(|e| format!("cannot be read: {e}"))?;
    let header = Header::read(&bytes)?;
    let [lines, line] = header.axes;
    check_size(lines.count, line.count, max_pixels)?;
    // The crate knows one kind of header; its decoder sees lines from the top.
    let plain = format!(
        "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n",
        lines.count, line.count
    );
    let whole = Cursor::new(plain.into_bytes()).chain(header.rest);
    let decoder = image::codecs::hdr::HdrDecoder::new(whole).map_err(|e| complain(&e))?;
    let image = image::DynamicImage::from_decoder(decoder).map_err(|e| complain(&e))?;
    let image = image.into_rgb32f();
    let (width, height) = if lines.is_y {
        (line.count, lines.count)
    } else {
        (lines.count, line.count)
    };
    let mut pixels = vec![Rgb::BLACK; width * height];
    for (i, pixel) in image.pixels().enumerate() {
        let (a, b) = (lines.at(i / line.count), line.at(i % line.count));
        let (row, column) = if lines.is_y { (a, b) } else { (b, a) };
        let light = |c: usize| (f64::from(pixel.0[c]) / header.scale[c]) as f32;
        pixels[row * width + column] = Rgb::new(light(0), light(1), light(2));
    }
    Ok((width, pixels))
}

/// What stands before the pixels.
struct Header<'a> {
    /// What radiances were multiplied by, in each channel.
    scale: [f64; 3],
    /// From line to line, and along a line.
    axes: [Axis; 2],
    rest: &'a [u8],
}

/// One of the two directions in which pixels follow each other.
#[derive(Clone, Copy)]
struct Axis {
    is_y: bool,
    /// True from the top down, and from left to right.
    is_usual: bool,
    count: usize,
}

impl Axis {
    fn at(self, i: usize) -> usize {
        if self.is_usual { i } else { self.count - 1 - i }
    }

    fn read(sign_and_name: &str, count: &str) -> Option<Axis> {
        let (is_y, is_usual) = match sign_and_name {
            "-Y" => (true, true),
            "+Y" => (true, false),
            "+X" => (false, true),
            "-X" => (false, false),
            _ => return None,
        };
        let count = count.parse().ok()?;
        Some(Axis {
            is_y,
            is_usual,
            count,
        })
    }
}

impl<'a> Header<'a> {
    fn read(bytes: &'a [u8]) -> Result<Self, String> {
        let mut rest = bytes;
        let mut next = || {
            let end = rest.iter().position(|b| *b == b'\n');
            let end = end.ok_or_else(|| complain(&"its header has no end"))?;
            let line = String::from_utf8_lossy(&rest[..end]);
            rest = &rest[end + 1..];
            Ok::<String, String>(line.trim_end_matches('\r').to_owned())
        };
        if !bytes.starts_with(b"#?") {
            return Err(complain(&"a Radiance picture begins with `#?`"));
        }
        next()?;
        let mut scale = [1.0; 3];
        loop {
            let line = next()?;
            if line.is_empty() {
                break;
            }
            // Only lines that begin so: those of pictures this one was made from are indented.
            match line.split_once('=') {
                Some(("FORMAT", format)) if format.trim() != "32-bit_rle_rgbe" => {
                    return Err(format!(
                        "holds {:?}; allowed is FORMAT=32-bit_rle_rgbe",
                        format.trim().chars().take(20).collect::<String>()
                    ));
                }
                Some((name @ "EXPOSURE", factor)) => {
                    let [by] = factors(name, factor)?;
                    scale = scale.map(|s| s * by);
                }
                Some((name @ "COLORCORR", three)) => {
                    let by: [f64; 3] = factors(name, three)?;
                    scale = [0, 1, 2].map(|i| scale[i] * by[i]);
                }
                _ => {}
            }
        }
        let size = next()?;
        let words: Vec<&str> = size.split_whitespace().collect();
        let axes = match words.as_slice() {
            [a, m, b, n] => Axis::read(a, m).zip(Axis::read(b, n)),
            _ => None,
        };
        let axes = axes.filter(|(a, b)| a.is_y != b.is_y);
        let (a, b) = axes.ok_or_else(|| {
            let size: String = size.chars().take(40).collect();
            complain(&format!(
                "its size must be like `-Y 512 +X 1024`, not {size:?}"
            ))
        })?;
        let axes = [a, b];
        Ok(Header { scale, axes, rest })
    }
}

/// The numbers of a line of a header, all above 0.
fn factors<const N: usize>(name: &str, text: &str) -> Result<[f64; N], String> {
    let numbers = text.split_whitespace().map(|word| word.parse::<f64>().ok());
    let numbers = numbers.map(|x| x.filter(|x| x.is_finite() && *x > 0.0));
    let all = numbers
        .collect::<Option<Vec<f64>>>()
        .and_then(|all| all.try_into().ok());
    all.ok_or_else(|| {
        let text: String = text.chars().take(40).collect();
        complain(&format!("{name} must be {N} numbers above 0, not {text:?}"))
    })
}
