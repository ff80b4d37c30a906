//! How far two pictures are apart: error figures, z scores where errors are known, and a picture of
//! the signed difference.
//!
//! `cargo run --release --example compare -- ours.exr reference.exr --out difference.png`
//!
//! EXR, HDR and PNG files; EXR files of this program know the error of each pixel. With
//! `--features flip` (and a C++ compiler) the perceptual difference FLIP is there, too.

use clap::Parser;
use halfdisk::lab::chapter::{answer, tell};
use halfdisk::output::save;
use halfdisk::render::accuracy::Scale;
use halfdisk::render::{Picture, compare};
use std::error::Error;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// How far is a picture from a reference?
#[derive(Debug, Parser)]
struct Arguments {
    /// The picture: .exr, .hdr or .png
    picture: PathBuf,
    /// The reference, of the same size
    reference: PathBuf,
    /// Compares means over squares of so many pixels
    #[arg(long, default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    squares: u32,
    /// Where the signed difference goes as a PNG: red is too bright, blue too dark, full colour at
    /// twenty percent of the brightness around in the reference
    #[arg(long, value_name = "FILE.png")]
    out: Option<PathBuf>,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(e) => {
            tell(format_args!("error: {e}"));
            ExitCode::from(2)
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let read = |path: &Path| halfdisk::output::read(path);
    let (a, b) = (read(&arguments.picture)?, read(&arguments.reference)?);
    if a.size != b.size {
        let sizes = [a.size, b.size].map(|[w, h]| format!("{w} x {h}"));
        let [ours, theirs] = sizes;
        return Err(format!("the pictures differ in size: {ours} and {theirs}").into());
    }
    if a.size.iter().any(|&n| n < arguments.squares) {
        return Err("--squares: larger than the picture".into());
    }
    let (a, b) = (
        a.in_squares(arguments.squares),
        b.in_squares(arguments.squares),
    );
    if let Some(path) = &arguments.out {
        let mut bytes = Cursor::new(Vec::new());
        let (width, height) = a.size.into();
        image::write_buffer_with_format(
            &mut bytes,
            &signed(&a, &b),
            width,
            height,
            image::ColorType::Rgb8,
            image::ImageFormat::Png,
        )?;
        save(path, &bytes.into_inner()).map_err(|e| format!("{}: {e}", path.display()))?;
        tell(format_args!("wrote {}", path.display()));
    }
    answer(&format!("{}FLIP      {}\n", report(&a, &b), flip(&a, &b)))?;
    Ok(())
}

/// The figures, one on a line.
fn report(a: &Picture, b: &Picture) -> String {
    let mse = compare::mse(a, b);
    let mut text = format!(
        "MSE       {mse:.4e}\nRMSE      {:.4e}\nrelMSE    {:.4e}, of which the worst 0.1 % of the pixels \
         carry {:.1} %\n",
        mse.sqrt(),
        compare::rel_mse(a, b),
        100.0 * compare::top_share(a, b),
    );
    let mean = |p: &Picture| match p.mean() {
        (mean, Some(error)) => format!("{mean:.6} ± {error:.1e}"),
        (mean, None) => format!("{mean:.6}"),
    };
    text += &format!("means     {} and {}\n", mean(a), mean(b));
    text += &match compare::z_scores(a, b) {
        Some(z) => format!(
            "z         means {:+.2} errors apart; mean z² {:.3} ± {:.3} (1 where they agree), largest \
             |z| {:.2}, {:.3} % beyond the line\n",
            z.of_means,
            z.squares.mean(),
            z.squares.std_error(),
            z.largest,
            100.0 * z.rejected
        ),
        None => "z         unknown: not both files hold errors (EXR files of this program do)\n"
            .to_owned(),
    };
    text
}

/// The difference relative to the brightness around in the reference: red where the picture is brighter, blue where it is
/// darker, white where they agree.
fn signed(a: &Picture, b: &Picture) -> Vec<u8> {
    let grey = |p: &[f64; 3]| p.iter().sum::<f64>() / 3.0;
    let scale = Scale::of(b);
    let pairs = a.values.iter().zip(&b.values).enumerate();
    pairs
        .flat_map(|(i, (x, y))| {
            let off = scale.signed(i, grey(x) - grey(y)) / 0.2;
            let fade = |x: f64| (255.0 * (1.0 - x.clamp(0.0, 1.0))).round() as u8;
            [fade(-off), fade(off.abs()), fade(off)]
        })
        .collect()
}

/// Mean FLIP of the tone-mapped pictures: 0 where nobody sees a difference, 1 at most.
#[cfg(feature = "flip")]
fn flip(a: &Picture, b: &Picture) -> String {
    use halfdisk::color::{quantise, srgb_encode};
    let [width, height] = a.size;
    let shades = |p: &Picture| -> Vec<u8> {
        let shade = |x: &f64| quantise(srgb_encode(x.clamp(0.0, 1.0)));
        p.values.iter().flatten().map(shade).collect()
    };
    let image = |p: &Picture| nv_flip::FlipImageRgb8::with_data(width, height, &shades(p));
    let per_degree = nv_flip::DEFAULT_PIXELS_PER_DEGREE;
    let difference = nv_flip::flip(image(b), image(a), per_degree);
    let mean = nv_flip::FlipPool::from_image(&difference).mean();
    format!("{mean:.4} (0: no visible difference, 1: the most there is)")
}

#[cfg(not(feature = "flip"))]
fn flip(_: &Picture, _: &Picture) -> &'static str {
    "unknown: build with --features flip"
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(grey: [f64; 2], error: f64) -> Picture {
        Picture {
            size: [2, 1],
            values: grey.map(|x| [x; 3]).to_vec(),
            errors: Some(vec![[error; 3]; 2]),
        }
    }

    #[test]
    fn figures_of_two_pixels() {
        let text = report(&picture([1.1, 2.0], 0.03), &picture([1.0, 2.0], 0.04));
        assert!(text.contains("MSE       5.0000e-3"), "{text}");
        // (0.1 / 1.5)² over two pixels; (0.1 / 0.05)² = 4 over two.
        assert!(text.contains("relMSE    2.2222e-3"), "{text}");
        assert!(text.contains("mean z² 2.000"), "{text}");
    }

    #[test]
    fn red_is_brighter_and_blue_darker() {
        let shades = signed(&picture([2.0, 1.0], 0.0), &picture([1.0, 2.0], 0.0));
        assert_eq!(shades, [255, 0, 0, 0, 0, 255]);
        let same = picture([0.3, 0.0], 0.0);
        assert_eq!(signed(&same, &same), [255; 6]);
    }
}
