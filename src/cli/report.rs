//! What happened in a render: in words, and for programs.

use super::left_out::LeftOut;
use super::stop::Ended;
use crate::integrators::{ENOUGH, RarelyAsked};
use crate::numeric::count;
use crate::output::Provenance;
use crate::render::target::fewest;
use crate::render::{BadSample, Faults, Rendered};
use crate::scene::{Coarse, RayCounts, Scene};
use crate::stats::Measurement;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use std::path::Path;

/// What happened in a render, and what was found out about its picture.
#[derive(Serialize)]
pub(super) struct Report<'a> {
    #[serde(flatten)]
    pub made: Made<'a>,
    pub accuracy: Ended,
    pub too_bright_pixels: usize,
    pub maps: Vec<String>,
    /// Why there are no maps, or not all of them.
    #[serde(skip)]
    pub no_maps: Option<String>,
    pub black: Option<String>,
    pub rarely_asked: Option<RarelyAsked>,
    pub lamps_unmet: usize,
    /// What no sample has met, in words.
    #[serde(skip)]
    pub unmet: String,
    pub left_out: Option<&'a LeftOut>,
    /// True where a bias was to be measured, and was not.
    #[serde(skip)]
    pub unmeasured: bool,
}

/// What was made of a scene.
#[derive(Serialize)]
pub(super) struct Made<'a> {
    facts: &'a Provenance,
    size: [u32; 2],
    shapes: usize,
    degenerate_triangles: usize,
    build_seconds: f64,
    seconds: f64,
    rays: RayCounts,
    rays_per_second: f64,
    mean: Measurement,
    notes: &'a [String],
    hidden_lamps: usize,
    coarse_shapes: usize,
    #[serde(skip)]
    coarse: Option<Coarse>,
    non_finite: u64,
    faults: Faults,
    largest_sample: f32,
    first_non_finite: Option<BadSample>,
    interrupted: bool,
    /// The fewest and the most samples of a pixel.
    #[serde(skip)]
    samples: [u64; 2],
    out: String,
}

impl<'a> Made<'a> {
    pub fn new(scene: &'a Scene, facts: &'a Provenance, rendered: &Rendered, path: &Path) -> Self {
        let built = &scene.report;
        let seconds = rendered.time.as_secs_f64();
        let counts = || rendered.film.pixels().iter().map(|p| p.count());
        Made {
            facts,
            size: scene.size,
            shapes: built.shapes,
            degenerate_triangles: built.degenerate_triangles,
            build_seconds: built.time.as_secs_f64(),
            seconds,
            rays: rendered.rays,
            rays_per_second: rendered.rays.total() as f64 / seconds,
            mean: rendered.mean().into(),
            notes: &built.notes,
            hidden_lamps: built.hidden_lamps,
            coarse_shapes: built.coarse.map_or(0, |c| c.shapes),
            coarse: built.coarse,
            non_finite: rendered.non_finite,
            faults: rendered.faults,
            largest_sample: rendered.largest,
            first_non_finite: rendered.first_bad,
            interrupted: rendered.interrupted,
            samples: [counts().min(), counts().max()].map(Option::unwrap_or_default),
            out: path.display().to_string(),
        }
    }

    /// What is odd about the scene.
    fn scene(&self, f: &mut Formatter) -> fmt::Result {
        if self.degenerate_triangles > 0 {
            let (one, many) = ("triangle without area was", "triangles without area were");
            let what = count(self.degenerate_triangles, one, many);
            writeln!(f, "note: {what} left out")?;
        }
        for note in self.notes {
            writeln!(f, "note: {note}")?;
        }
        if self.hidden_lamps > 0 {
            let were = if self.hidden_lamps == 1 {
                "was"
            } else {
                "were"
            };
            let lamps = count(self.hidden_lamps, "lamp", "lamps");
            writeln!(
                f,
                "note: {lamps} in the very place of an earlier one {were} left out"
            )?;
        }
        if let Some(Coarse { shapes, step }) = self.coarse {
            let what = count(shapes, "shape is", "shapes are");
            writeln!(
                f,
                "warning: {what} so small for where they stand that rounding changes their form: \
                 numbers there are up to {step} apart, counted from the camera"
            )?;
        }
        Ok(())
    }

    /// What is odd about the samples.
    fn samples(&self, f: &mut Formatter) -> fmt::Result {
        if let Some(BadSample { sample, x, y }) = self.first_non_finite {
            let Faults {
                nan,
                infinite,
                negative,
            } = self.faults;
            writeln!(
                f,
                "warning: samples that no light brings: {nan} not a number and {infinite} infinite, \
                 which are in no mean, {negative} negative; the first is sample {sample} of pixel {x},{y}"
            )?;
        }
        Ok(())
    }
}

impl Report<'_> {
    /// What is odd about the picture.
    fn picture(&self, f: &mut Formatter) -> fmt::Result {
        self.made.samples(f)?;
        if self.too_bright_pixels > 0 {
            let what = count(self.too_bright_pixels, "pixel is", "pixels are");
            writeln!(
                f,
                "warning: {what} brighter than the scene's lights and albedos allow"
            )?;
        }
        if self.made.interrupted {
            let [least, most] = self.made.samples;
            writeln!(
                f,
                "interrupted: the picture has {least} to {most} samples per pixel"
            )?;
        }
        if let Some(RarelyAsked { lights, times, .. }) = self.rarely_asked {
            let which = match lights {
                1 => format!("one light is asked only about {times:.1} times in the whole picture"),
                n => format!(
                    "{n} lights are asked fewer than {ENOUGH} times each in the whole picture, the \
                     least about {times:.1} times"
                ),
            };
            writeln!(
                f,
                "warning: {which}; light may be missing, and the error cannot tell: take more samples"
            )?;
        }
        f.write_str(&self.unmet)
    }
}

impl Display for Report<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let made = &self.made;
        let ([w, h], name) = (made.size, &made.facts.scene);
        let shapes = count(made.shapes, "shape", "shapes");
        let (built, seconds) = (made.build_seconds, made.seconds);
        writeln!(
            f,
            "{name}: {w} x {h}, {shapes}, built in {built:.3} s, rendered in {seconds:.3} s"
        )?;
        let RayCounts {
            camera,
            secondary,
            shadow,
        } = made.rays;
        let speed = made.rays_per_second / 1e6;
        writeln!(
            f,
            "rays: {camera} camera, {secondary} secondary, {shadow} shadow; {speed:.2} million per second"
        )?;
        let Measurement { value, error } = made.mean;
        write!(f, "mean of the picture: {value:.6}")?;
        let reached = &self.accuracy.reached;
        if !error.is_finite() {
            writeln!(f, " (error not known)")?;
        } else if reached.error.is_infinite() {
            writeln!(f, " ± {error:.1e} of rounding; no noise was seen")?;
        } else if reached.spp < fewest(made.facts.sampler) {
            let why = "since few samples that lie evenly only bound their error";
            writeln!(f, " ± at most {error:.1e}, {why}")?;
        } else {
            writeln!(f, " ± {error:.1e}")?;
        }
        made.scene(f)?;
        self.picture(f)?;
        self.accuracy.fmt(f)?;
        if let Some(why) = &self.black {
            writeln!(f, "the picture is black: {why}")?;
        }
        if let Some(bias) = self.left_out.and_then(|left_out| left_out.bias) {
            writeln!(f, "{bias}")?;
        } else if self.unmeasured {
            let what = "the picture is complete, but what it lacks was not measured";
            writeln!(f, "interrupted: {what}")?;
        }
        write!(f, "wrote {}", made.out)?;
        let mut maps = self.maps.iter();
        maps.try_for_each(|map| write!(f, "\nwrote {map}"))?;
        let mut no_maps = self.no_maps.iter();
        no_maps.try_for_each(|why| write!(f, "\nnote: {why}"))
    }
}
