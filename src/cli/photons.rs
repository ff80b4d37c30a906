//! How many photons `halfdisk render --integrator photons` has, on how large discs, and how much they blur.

use super::Stop;
use crate::integrators::{Entry, Photons};
use crate::lab::chapter::whole;
use crate::output::PhotonFacts;
use crate::photons::radius;
use crate::render::Blur;
use crate::render::stopping::percent;
use crate::scene::Scene;
use crate::space::Solid;
use crate::stats::Measurement;
use clap::Args;
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

/// How many photons there are, and how large their discs.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct PhotonArgs {
    /// Walks from the lights in each pass; each sample per pixel is one pass. More walks mean less noise in each
    /// pass, and more memory [default: one for each pixel, at most 262144]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole(1..=Photons::MOST_WALKS), help_heading = HEADING)]
    photons: Option<u32>,
    /// Radius of the discs of the first pass, in scene units: a larger one has less noise and more blur; later
    /// ones shrink [default: two pixels where the eye looks]
    #[arg(long, value_name = "LENGTH", allow_negative_numbers = true, value_parser = length,
        help_heading = HEADING)]
    radius: Option<f32>,
}

const HEADING: &str = "Photons";

fn length(text: &str) -> Result<f32, String> {
    match text.parse::<f32>() {
        Ok(length) if length > 0.0 && length.is_finite() => Ok(length),
        _ => Err("a radius is a number above 0, in scene units".to_owned()),
    }
}

impl PhotonArgs {
    /// Walks in each pass; `None` for the usual number.
    pub fn walks(&self) -> Option<u32> {
        self.photons
    }

    /// The first radius; `None` for the usual one.
    pub fn radius(&self) -> Option<f32> {
        self.radius
    }

    /// Refuses what makes no sense together.
    pub fn check(&self, integrator: Entry) -> Result<(), Stop> {
        let said = match (self.photons, self.radius) {
            (Some(_), _) => "--photons",
            (_, Some(_)) => "--radius",
            _ => return Ok(()),
        };
        match integrator == Photons::ENTRY {
            true => Ok(()),
            false => Err(Stop::Input(format!(
                "{said}: `{}` has no photon map, only `--integrator {}` has",
                integrator.name,
                Photons::ENTRY.name
            ))),
        }
    }
}

/// The photons of a picture.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Landed {
    #[serde(flatten)]
    pub facts: PhotonFacts,
    /// Radius of the discs of the last pass, in scene units.
    pub last_radius: f32,
    /// What they blur; `None` where it was not measured.
    pub blur: Option<Blur>,
}

impl Landed {
    /// What photons do for a picture of so many samples per pixel.
    pub fn new(photons: &Photons, scene: &Scene, spp: u32) -> Self {
        let (walks, first_radius, _) = photons.first(scene);
        let shrunk = radius::shrunk::<Solid>(photons.alpha, spp.saturating_sub(1));
        Landed {
            facts: PhotonFacts {
                walks,
                first_radius,
            },
            last_radius: (f64::from(first_radius) * shrunk) as f32,
            blur: None,
        }
    }
}

impl Display for Landed {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let Landed {
            facts,
            last_radius,
            blur,
        } = self;
        let PhotonFacts {
            walks,
            first_radius,
        } = facts;
        write!(
            f,
            "photons: {walks} walks from the lights in each pass; discs of radius {first_radius:.3e} in the \
             first, {last_radius:.3e} in the last"
        )?;
        let Some(blur) = blur else {
            return Ok(());
        };
        let pixels = match blur.relative() {
            Some(Measurement { value, error }) => {
                let [value, error] = [value, error].map(percent);
                format!("about {value} ± {error} of the light around each pixel")
            }
            None => format!(
                "not told from noise, at most {} of the light around each pixel",
                percent(blur.at_most())
            ),
        };
        let Measurement { value, error } = blur.mean;
        write!(
            f,
            "\nblur: {pixels}, {value:+.1e} ± {error:.1e} of the mean of the picture; by what half of each \
             disc reads, less than there is at edges. It falls as the power -1/3 of the samples"
        )
    }
}
