//! Judges a picture by what it is, an estimate: it is accepted where it differs from the stored one by no
//! more than the noise of both.
//!
//! A stored picture is a PNG file that also holds, as text, the means and standard errors of its blocks.

use halfdisk::render::Picture;
use halfdisk::render::compare::z_scores;
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::{FOUR, critical, sidak};
use insta::internals::SnapshotContents;
use insta::{Comparator, Snapshot};
use std::fmt;
use std::path::{Path, PathBuf};

/// Blocks along the longer side of a picture, at most.
const BLOCKS: u32 = 24;
/// A picture of the same thing is refused for its worst block once in so many times.
const LEVEL: f64 = 1e-4;
/// What is added to the line of the worst block: errors are known from few samples, and have tails.
const TAILS: f64 = 1.5;
/// With 90 % probability a normal variable lies below this.
const NINETY_PERCENT: f64 = 1.282;
/// The relative rounding of a stored mean.
const ROUNDING: f64 = 1e-4;
/// The key of the text in a stored picture.
const KEY: &str = "means and errors";

/// What two pictures have between them.
#[derive(Clone, Copy, Debug)]
pub struct Verdict {
    /// The smallest bias of all the light that is refused with 90 % power, relative to that of a typical
    /// block; infinite of a black picture.
    pub notices: f64,
    /// The bias of each channel in standard errors.
    pub biases: [f64; 3],
    /// The largest |z| of a channel in a block, at any scale, and where the line is.
    pub worst: [f64; 2],
    /// The mean of z² over the blocks, and where the line is.
    pub squares: [f64; 2],
}

impl Verdict {
    /// The verdict on a picture beside the stored one, both in blocks.
    pub fn of(stored: &Picture, picture: &Picture) -> Verdict {
        let mut scales = vec![[stored.clone(), picture.clone()]];
        for _ in 0..2 {
            let coarser = scales[scales.len() - 1].each_ref().map(|p| blocks(p, 2));
            scales.push(coarser);
        }
        let scores: Vec<_> = scales.iter().filter_map(|[a, b]| z_scores(a, b)).collect();
        let count: usize = scales.iter().map(|[a, _]| 3 * a.values.len()).sum();
        let worst = scores.iter().map(|z| z.largest).fold(0.0, f64::max);
        // The square of a normal variable has a variance of 2; channels may be copies of each other.
        let scatter = (2.0 / stored.values.len() as f64).sqrt();
        let biases = [0, 1, 2].map(|channel| bias(stored, picture, channel));
        Verdict {
            notices: biases
                .iter()
                .flatten()
                .map(|b| b[1])
                .fold(f64::INFINITY, f64::min),
            biases: biases.map(|b| b.map_or(0.0, |b| b[0])),
            worst: [worst, critical(sidak(LEVEL, count as u32)) + TAILS],
            squares: [scores[0].squares.mean(), 1.0 + FOUR * scatter],
        }
    }

    /// True where the picture is of the same thing.
    pub fn accepts(&self) -> bool {
        self.biases.iter().all(|z| z.abs() <= FOUR)
            && self.worst[0] <= self.worst[1]
            && self.squares[0] <= self.squares[1]
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let [r, g, b] = self.biases;
        let ([worst, line], [squares, most]) = (self.worst, self.squares);
        write!(
            f,
            "biases z {r:+.2} {g:+.2} {b:+.2} of {FOUR}, worst block {worst:.2} of {line:.2}, z² \
             {squares:.2} of {most:.2}; would notice a bias of {:.2} %",
            100.0 * self.notices
        )
    }
}

/// The bias of a channel in standard errors, and the smallest that would be noticed; `None` where there is
/// no light.
///
/// The mean of the blocks' relative differences. Noisy blocks count less, but those without noise not more
/// than twice the typical one, so that a lamp which is seen as it is says nothing about the room.
fn bias(a: &Picture, b: &Picture, channel: usize) -> Option<[f64; 2]> {
    let of = |p: &Picture, i: usize| {
        let error = p.errors.as_ref().map_or(0.0, |e| e[i][channel]);
        (p.values[i][channel], error)
    };
    let relative: Vec<[f64; 2]> = (0..a.values.len())
        .filter_map(|i| {
            let ((x, s), (y, t)) = (of(a, i), of(b, i));
            let mean = 0.5 * (x + y);
            (mean > 0.0).then(|| [(y - x) / mean, s.hypot(t) / mean])
        })
        .collect();
    let mut errors: Vec<f64> = relative.iter().map(|r| r[1]).collect();
    errors.sort_by(f64::total_cmp);
    let typical = *errors.get(errors.len() / 2)?;
    let (mut sum, mut square, mut weights) = (0.0, 0.0, 0.0);
    for [difference, error] in relative {
        let weight = 1.0 / (error * error + typical * typical);
        sum += weight * difference;
        square += (weight * error).powi(2);
        weights += weight;
    }
    let error = square.sqrt();
    Some([sum / error, (FOUR + NINETY_PERCENT) * error / weights])
}

/// The means of blocks of `side` pixels, with their errors.
fn blocks(picture: &Picture, side: u32) -> Picture {
    let [width, height] = picture.size;
    let size = [width.div_ceil(side), height.div_ceil(side)];
    let mut sums = vec![[[0.0; 3]; 2]; (size[0] * size[1]) as usize];
    let mut counts = vec![0.0; sums.len()];
    let errors = picture.errors.iter().flatten();
    for ((i, value), error) in picture.values.iter().enumerate().zip(errors) {
        let (x, y) = (i as u32 % width / side, i as u32 / width / side);
        let block = (y * size[0] + x) as usize;
        counts[block] += 1.0;
        for c in 0..3 {
            sums[block][0][c] += value[c];
            sums[block][1][c] += error[c] * error[c];
        }
    }
    let of = |f: fn([f64; 3], f64) -> [f64; 3], part: usize| {
        sums.iter()
            .zip(&counts)
            .map(|(s, n)| f(s[part], *n))
            .collect()
    };
    Picture {
        size,
        values: of(|sum, n| sum.map(|x| x / n), 0),
        errors: Some(of(|sum, n| sum.map(|x| x.sqrt() / n), 1)),
    }
}

/// A picture in blocks. Where pixels do not know their errors, for there is one sample of each, the scatter
/// of neighbours stands in, in larger blocks.
pub fn in_blocks(picture: &Picture) -> Picture {
    let errors = picture.errors.iter().flatten().flatten();
    let known = errors.clone().count() > 0 && errors.clone().all(|e| e.is_finite());
    let longer = picture.size[0].max(picture.size[1]);
    let mut blocks = if known {
        blocks(picture, longer.div_ceil(BLOCKS))
    } else {
        blocks(&with_scatter(picture), longer.div_ceil(BLOCKS).max(8))
    };
    for (error, value) in blocks.errors.iter_mut().flatten().zip(&blocks.values) {
        (0..3).for_each(|c| error[c] = error[c].hypot(ROUNDING * value[c]));
    }
    blocks
}

/// A picture whose errors are what is left of two by two pixels without their gradients, as root mean square
/// of those that overlap. It is a third more than that, for a block has few of them.
fn with_scatter(picture: &Picture) -> Picture {
    let [width, height] = picture.size.map(|n| n as usize);
    let square = |x: usize, y: usize, c: usize| {
        let at = |u: usize, v: usize| picture.values[(y + v) * width + x + u][c];
        (0.5 * (at(0, 0) - at(1, 0) - at(0, 1) + at(1, 1))).powi(2)
    };
    let error = |i: usize| {
        let around = |at: usize, end: usize| at.saturating_sub(1)..=at.min(end - 2);
        let columns = || around(i % width, width);
        let squares = |c| {
            let rows = around(i / width, height);
            rows.flat_map(move |y| columns().map(move |x| square(x, y, c)))
        };
        [0, 1, 2].map(|c| 4.0 / 3.0 * squares(c).collect::<Estimate>().mean().sqrt())
    };
    Picture {
        errors: Some((0..width * height).map(error).collect()),
        ..picture.clone()
    }
}

/// The numbers of a picture in blocks: its width, then the means and errors of each block.
fn to_text(blocks: &Picture) -> String {
    let mut text = format!("{}\n", blocks.size[0]);
    for (value, error) in blocks.values.iter().zip(blocks.errors.iter().flatten()) {
        value.iter().for_each(|x| text += &format!("{x:.4e} "));
        error.iter().for_each(|x| text += &format!("{x:.1e} "));
        text += "\n";
    }
    text
}

fn from_text(text: &str) -> Option<Picture> {
    let mut lines = text.lines();
    let width: u32 = lines.next()?.parse().ok()?;
    let (values, errors): (Vec<_>, Vec<_>) = lines
        .filter_map(|line| {
            let numbers = line.split_whitespace().map_while(|n| n.parse::<f64>().ok());
            let n: [f64; 6] = numbers.collect::<Vec<_>>().try_into().ok()?;
            Some(([n[0], n[1], n[2]], [n[3], n[4], n[5]]))
        })
        .unzip();
    Some(Picture {
        size: [width, values.len() as u32 / width],
        values,
        errors: Some(errors),
    })
}

/// A PNG file of these pixels that holds the numbers of its picture in blocks.
pub fn snapshot(png: &Path, blocks: &Picture) -> Vec<u8> {
    let pixels = image::open(png).unwrap().to_rgb8();
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder
        .add_ztxt_chunk(KEY.to_owned(), to_text(blocks))
        .unwrap();
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&pixels).unwrap();
    writer.finish().unwrap();
    bytes
}

/// The numbers in a stored picture.
fn numbers(png: &[u8]) -> Option<Picture> {
    let reader = png::Decoder::new(std::io::Cursor::new(png))
        .read_info()
        .ok()?;
    let texts = &reader.info().compressed_latin1_text;
    let text = texts.iter().find(|text| text.keyword == KEY)?;
    from_text(&text.get_text().ok()?)
}

/// Compares snapshots of a picture, whose name it has.
#[derive(Clone)]
pub struct Judge(pub String);

impl Comparator for Judge {
    fn matches(&self, reference: &Snapshot, test: &Snapshot) -> bool {
        let bytes = |snapshot: &Snapshot| match snapshot.contents() {
            SnapshotContents::Binary(Some(bytes)) => Some(bytes.to_vec()),
            _ => None,
        };
        let (Some(expected), Some(actual)) = (bytes(reference), bytes(test)) else {
            return false;
        };
        let accepted = match (numbers(&expected), numbers(&actual)) {
            (Some(a), Some(b)) if a.size == b.size => {
                let verdict = Verdict::of(&a, &b);
                println!("{}: {verdict}", self.0);
                verdict.accepts()
            }
            _ => false,
        };
        if !accepted {
            let path = left_to_look_at(&self.0, &expected, &actual);
            println!(
                "{}: expected | actual | difference in {}",
                self.0,
                path.display()
            );
        }
        accepted
    }

    fn dyn_clone(&self) -> Box<dyn Comparator> {
        Box::new(self.clone())
    }
}

/// Writes what was expected, what came, and four times their difference on middle grey, side by side.
fn left_to_look_at(name: &str, expected: &[u8], actual: &[u8]) -> PathBuf {
    let [a, b] = [expected, actual].map(|png| image::load_from_memory(png).unwrap().to_rgb8());
    let (width, height) = (a.width().max(b.width()), a.height().max(b.height()));
    let mut sheet = image::RgbImage::new(3 * width + 2, height);
    let at = |p: &image::RgbImage, x: u32, y: u32| p.get_pixel_checked(x, y).copied();
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let (a, b) = (at(&a, x, y), at(&b, x, y));
        let of = |c: usize| a.map_or(0, |p| i32::from(p.0[c])) - b.map_or(0, |p| i32::from(p.0[c]));
        let difference = [0, 1, 2].map(|c| (128 - 4 * of(c)).clamp(0, 255) as u8);
        let panels = [a, b, Some(image::Rgb(difference))];
        for (i, panel) in (0..).zip(panels) {
            panel.inspect(|p| sheet.put_pixel(i * (width + 1) + x, y, *p));
        }
    }
    // Large enough to see pixels.
    let times = (256 / width).max(1);
    let (width, height) = (sheet.width() * times, sheet.height() * times);
    let sheet = image::imageops::resize(&sheet, width, height, image::imageops::Nearest);
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pictures");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(format!("{name}.png"));
    sheet.save(&path).unwrap();
    path
}
