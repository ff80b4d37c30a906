//! `halfdisk doctor`.

mod list;
mod typed;

use super::Stop;
use super::answer::{answer, for_terminal};
use crate::lab::chapter::whole;
use crate::lab::doctor::{Diagnosis, Reading, diagnose};
use crate::lab::mistakes::{Exam, Variant};
use crate::space::Dimension;
use clap::{Args, ValueEnum};
use serde::Serialize;
use std::fmt::{self, Display, Formatter};
use typed::{Typed, albedo, error, tilt};

/// Name the mistake behind a wrong reading, or list the mistakes.
///
/// Under a white sky a surface reflects its albedo. Each of the usual mistakes reads another
/// number, exactly known: so a reading names its mistake.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Doctor {
    /// What your estimator reads under a white sky; may be given several times
    #[arg(
        long,
        value_name = "NUMBER",
        requires = "space",
        allow_negative_numbers = true
    )]
    reading: Vec<Typed>,
    /// The world it works in; without a reading, the world whose mistakes are listed
    #[arg(long, value_enum)]
    space: Option<World>,
    /// Standard error of the reading [default: half a unit of its last digit]
    #[arg(long, requires = "reading", allow_negative_numbers = true, value_parser = error)]
    error: Vec<f64>,
    /// Albedo of the surface [default: 1]
    #[arg(long, requires = "reading", allow_negative_numbers = true, value_parser = albedo)]
    albedo: Vec<f32>,
    /// Directions of each gather [default: 16]
    #[arg(long, requires = "reading", allow_negative_numbers = true, value_parser = whole(1_u32..=u32::MAX))]
    samples: Vec<u32>,
    /// Tilt of the surface, from 0 to 90 degrees [default: 0]
    #[arg(long, requires = "reading", value_name = "DEGREES", allow_negative_numbers = true, value_parser = tilt)]
    tilt: Vec<f32>,
    /// How often the light was reflected [default: 1]
    #[arg(long, requires = "reading", allow_negative_numbers = true, value_parser = whole(1_u32..=1000))]
    bounces: Vec<u32>,
    /// Whether shadow rays find the sky [default: seeing]
    #[arg(long, requires = "reading", value_enum)]
    shadow_rays: Vec<ShadowRays>,
    /// Print JSON
    #[arg(long)]
    json: bool,
}

const AFTER_HELP: &str = "\
Set up a white sky (radiance 1 from everywhere) over a surface, and read what your estimator says
it reflects. Then:
  halfdisk doctor
      what each mistake reads, and what was forgotten
  halfdisk doctor --space flat --reading 0.6366
      a number with all its digits: the more, the fewer mistakes fit
  halfdisk doctor --space solid --reading 0.667 --error 0.002
      the mean of many gathers, and its standard error
  halfdisk doctor --space flat --reading 1.000 --reading 0.750 --tilt 0 --tilt 30
      two readings: an option given once is for all, otherwise once for each

A mistake may hide: a matrix that is transposed reads 1 until the surface is tilted, and a forgotten
weight until its albedo is not 1. Where several mistakes fit, the answer says what to ask next.";

/// The worlds by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum World {
    /// Two dimensions: the half disk
    Flat,
    /// Three dimensions: the hemisphere
    Solid,
}

/// Whether shadow rays find the sky.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ShadowRays {
    /// They find it
    Seeing,
    /// Only rays that meet the sky by chance do
    Blind,
}

impl From<World> for Dimension {
    fn from(world: World) -> Self {
        match world {
            World::Flat => Dimension::Flat,
            World::Solid => Dimension::Solid,
        }
    }
}

impl Doctor {
    pub(super) fn run(self) -> Result<(), Stop> {
        match (self.space, self.reading.is_empty()) {
            (Some(world), false) => {
                let diagnosis = diagnose(world.into(), &self.readings()?);
                answer(&Diagnosed::of(diagnosis), self.json)
            }
            (Some(world), true) => list::list(&[world.into()], self.json),
            (None, _) => list::list(&[Dimension::Flat, Dimension::Solid], self.json),
        }
    }

    fn readings(&self) -> Result<Vec<Reading>, Stop> {
        let count = self.reading.len();
        let usual = Exam::default();
        let reading = |(i, typed): (usize, &Typed)| {
            let shadows = each("--shadow-rays", &self.shadow_rays, i, count)?;
            let tilt = each("--tilt", &self.tilt, i, count)?;
            Ok(Reading {
                value: typed.value,
                error: each("--error", &self.error, i, count)?.unwrap_or(typed.half_unit),
                exam: Exam {
                    albedo: each("--albedo", &self.albedo, i, count)?.unwrap_or(usual.albedo),
                    samples: each("--samples", &self.samples, i, count)?.unwrap_or(usual.samples),
                    tilt: tilt.map_or(usual.tilt, f32::to_radians),
                    bounces: each("--bounces", &self.bounces, i, count)?.unwrap_or(usual.bounces),
                    aimed: shadows != Some(ShadowRays::Blind),
                },
            })
        };
        self.reading.iter().enumerate().map(reading).collect()
    }
}

/// The value of an option for the reading at place `i`: its own, or the one given for all.
fn each<T: Copy>(option: &str, given: &[T], i: usize, count: usize) -> Result<Option<T>, Stop> {
    match given {
        [] => Ok(None),
        [one] => Ok(Some(*one)),
        _ if given.len() == count => Ok(Some(given[i])),
        _ => Err(Stop::Input(format!(
            "{option} is given {} times for {count} reading{}: give it once for all, or once for \
             each",
            given.len(),
            if count == 1 { "" } else { "s" }
        ))),
    }
}

/// What the readings say.
#[derive(Serialize)]
struct Diagnosed {
    space: Dimension,
    healthy: bool,
    matches: Vec<Match>,
    explanation: String,
    readings: Vec<Reading>,
}

/// A variant that fits, with its exact readings.
#[derive(Serialize)]
struct Match {
    variant: &'static str,
    forgot: &'static str,
    exact: Vec<f64>,
    z: f64,
}

impl Diagnosed {
    fn of(diagnosis: Diagnosis) -> Self {
        let exact = |variant: &Variant| {
            let readings = diagnosis.readings.iter();
            readings.map(|r| variant.reading(&r.exam)).collect()
        };
        let matches = diagnosis.matches().iter().map(|found| Match {
            variant: found.variant.name,
            forgot: found.variant.forgot,
            exact: exact(&found.variant),
            z: found.z,
        });
        Diagnosed {
            space: diagnosis.dimension,
            healthy: diagnosis.healthy(),
            matches: matches.collect(),
            explanation: diagnosis.explain(),
            readings: diagnosis.readings,
        }
    }
}

impl Display for Diagnosed {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&for_terminal(&self.explanation))
    }
}
