//! What happened in a render: in words, and for programs.

use super::left_out::LeftOut;
use super::patching::Patched;
use super::photons::Landed;
use super::stop::Ended;
use crate::integrators::{ENOUGH, RarelyAsked};
use crate::numeric::count;
use crate::output::Provenance;
use crate::render::stopping::fewest;
use crate::render::{BadSample, Faults, Rendered};
use crate::scene::{BuildReport, Coarse, RayCounts};
use crate::stats::Measurement;
use serde::{Serialize, Serializer};
use std::fmt::{self, Display, Formatter};
use std::time::Duration;

/// What happened in a render, and what was found out about its picture.
#[derive(Serialize)]
pub(super) struct Report<'a> {
    pub facts: &'a Provenance,
    pub size: [u32; 2],
    #[serde(flatten, with = "Built")]
    pub built: &'a BuildReport,
    #[serde(flatten, with = "Made")]
    pub made: &'a Rendered,
    pub out: String,
    pub accuracy: Ended<'a>,
    pub too_bright_pixels: usize,
    /// Pixels that are brighter than the file can show; `None` where it can hold any radiance.
    pub clipped_pixels: Option<usize>,
    pub maps: Vec<String>,
    pub views: Vec<String>,
    /// Why there are no maps, or not all of them.
    #[serde(skip)]
    pub no_maps: Option<String>,
    pub black: Option<String>,
    pub patches: Option<Patched>,
    pub photons: Option<Landed>,
    /// Why the scatter of samples is not all of its error.
    pub biased: Option<&'static str>,
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

/// What programs are told of how a scene was built.
#[derive(Serialize)]
#[serde(remote = "BuildReport")]
struct Built {
    shapes: usize,
    instances: usize,
    degenerate_triangles: usize,
    notes: Vec<String>,
    #[serde(rename = "hidden_lamps")]
    hidden_lights: usize,
    #[serde(rename = "coarse_shapes", serialize_with = "coarse_shapes")]
    coarse: Option<Coarse>,
    #[serde(rename = "build_seconds", serialize_with = "seconds")]
    time: Duration,
}

/// What programs are told of how a picture was made.
#[derive(Serialize)]
#[serde(remote = "Rendered")]
struct Made {
    rays: RayCounts,
    #[serde(rename = "seconds", serialize_with = "seconds")]
    time: Duration,
    #[serde(getter = "rays_per_second")]
    rays_per_second: f64,
    lanes: Option<&'static str>,
    #[serde(getter = "mean")]
    mean: Measurement,
    non_finite: u64,
    faults: Faults,
    #[serde(rename = "largest_sample")]
    largest: f32,
    #[serde(rename = "first_non_finite")]
    first_bad: Option<BadSample>,
    interrupted: bool,
}

fn seconds<S: Serializer>(time: &Duration, serializer: S) -> Result<S::Ok, S::Error> {
    time.as_secs_f64().serialize(serializer)
}

fn coarse_shapes<S: Serializer>(coarse: &Option<Coarse>, serializer: S) -> Result<S::Ok, S::Error> {
    coarse.map_or(0, |c| c.shapes).serialize(serializer)
}

fn rays_per_second(made: &Rendered) -> f64 {
    let traced = made.rays - made.rays_before;
    traced.total() as f64 / made.time.as_secs_f64()
}

fn mean(made: &Rendered) -> Measurement {
    made.mean().into()
}

impl Report<'_> {
    /// What is odd about the scene.
    fn scene(&self, f: &mut Formatter) -> fmt::Result {
        let built = self.built;
        if built.degenerate_triangles > 0 {
            let (one, many) = ("triangle without area was", "triangles without area were");
            let what = count(built.degenerate_triangles, one, many);
            writeln!(f, "note: {what} left out")?;
        }
        for note in &built.notes {
            writeln!(f, "note: {note}")?;
        }
        if built.hidden_lights > 0 {
            let were = if built.hidden_lights == 1 {
                "was"
            } else {
                "were"
            };
            let lamps = count(built.hidden_lights, "lamp", "lamps");
            writeln!(
                f,
                "note: {lamps} in the very place of an earlier one {were} left out"
            )?;
        }
        if let Some(Coarse { shapes, step }) = built.coarse {
            let what = count(shapes, "shape is", "shapes are");
            writeln!(
                f,
                "warning: {what} so small for where they stand that rounding changes their form: \
                 numbers there are up to {step} apart, counted from the camera"
            )?;
        }
        Ok(())
    }

    /// What is odd about the picture.
    fn picture(&self, f: &mut Formatter) -> fmt::Result {
        let made = self.made;
        if let Some(BadSample { sample, x, y }) = made.first_bad {
            let Faults {
                nan,
                infinite,
                negative,
            } = made.faults;
            writeln!(
                f,
                "warning: samples that no light brings: {nan} not a number and {infinite} infinite, \
                 which are in no mean, {negative} negative; the first is sample {sample} of pixel {x},{y}"
            )?;
        }
        if self.too_bright_pixels > 0 {
            let what = count(self.too_bright_pixels, "pixel is", "pixels are");
            writeln!(
                f,
                "warning: {what} brighter than the scene's lights and albedos allow"
            )?;
        }
        if let Some(pixels) = self.clipped_pixels.filter(|&pixels| pixels > 0) {
            let share = 100.0 * pixels as f64 / made.film.pixels().len() as f64;
            let what = count(pixels, "pixel is", "pixels are");
            writeln!(
                f,
                "{what} brighter than white ({share:.2} %); `--exposure` chooses how bright a picture is shown"
            )?;
        }
        if made.interrupted {
            let counts = || made.film.pixels().iter().map(|p| p.count());
            let [least, most] = [counts().min(), counts().max()].map(Option::unwrap_or_default);
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
        let ([w, h], name) = (self.size, &self.facts.scene);
        let mut shapes = count(self.built.shapes, "shape", "shapes");
        if self.built.instances > 0 {
            shapes += &format!(
                " ({} of shared meshes)",
                count(self.built.instances, "instance", "instances")
            );
        }
        let [built, seconds] = [self.built.time, self.made.time].map(|t| t.as_secs_f64());
        writeln!(
            f,
            "{name}: {w} x {h}, {shapes}, built in {built:.3} s, rendered in {seconds:.3} s"
        )?;
        let RayCounts {
            camera,
            secondary,
            shadow,
        } = self.made.rays;
        let speed = rays_per_second(self.made) / 1e6;
        let lanes = self.made.lanes.map_or_else(String::new, |by| {
            format!(", sixteen paths at a time by {by}")
        });
        writeln!(
            f,
            "rays: {camera} camera, {secondary} secondary, {shadow} shadow; {speed:.2} million per second{lanes}"
        )?;
        if let Some(paths) = self.facts.light_paths {
            let each = count(paths as usize, "path", "paths");
            writeln!(
                f,
                "caustics: {each} from the lights in each sample of all pixels"
            )?;
        }
        let Measurement { value, error } = mean(self.made);
        write!(f, "mean of the picture: {value:.6}")?;
        let reached = &self.accuracy.outcome.reached;
        if !error.is_finite() {
            writeln!(f, " (error not known)")?;
        } else if reached.error.is_infinite() {
            writeln!(f, " ± {error:.1e} of rounding; no noise was seen")?;
        } else if reached.spp < fewest(self.facts.sampler) {
            let why = "since few samples that lie evenly only bound their error";
            writeln!(f, " ± at most {error:.1e}, {why}")?;
        } else {
            let noise = match self.photons {
                Some(_) => " of noise, were pixels to share no photons",
                None => self.biased.map_or("", |_| " of noise"),
            };
            writeln!(f, " ± {error:.1e}{noise}")?;
        }
        self.scene(f)?;
        self.picture(f)?;
        if let Some(patches) = &self.patches {
            writeln!(f, "{patches}")?;
        }
        if let Some(photons) = &self.photons {
            writeln!(f, "{photons}")?;
        }
        self.accuracy.fmt(f)?;
        if let Some(why) = self.biased {
            writeln!(
                f,
                "that error is noise alone, the picture is biased, too: {why}"
            )?;
        }
        if let Some(why) = &self.black {
            writeln!(f, "the picture is black: {why}")?;
        }
        if let Some(bias) = self.left_out.and_then(|left_out| left_out.bias) {
            writeln!(f, "{bias}")?;
        } else if self.unmeasured {
            let what = "the picture is complete, but what it lacks was not measured";
            writeln!(f, "interrupted: {what}")?;
        }
        write!(f, "wrote {}", self.out)?;
        let mut maps = self.views.iter().chain(&self.maps);
        maps.try_for_each(|map| write!(f, "\nwrote {map}"))?;
        let mut no_maps = self.no_maps.iter();
        no_maps.try_for_each(|why| write!(f, "\nnote: {why}"))
    }
}
