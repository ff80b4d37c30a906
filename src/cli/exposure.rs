//! How bright a picture is shown.

use super::{Stop, picture};
use crate::integrators::{Entry, Shows};
use crate::output::{Display, Format};
use crate::render::Film;
use clap::Args;
use std::path::Path;

/// The most that a picture is brightened or darkened, in stops.
const MOST: f64 = 24.0;

#[derive(Debug, Args)]
pub(super) struct Exposure {
    /// Brighten a .png picture by so many stops: each doubles the light, a negative one halves it
    /// [default: 0, where radiance 1 is white]
    #[arg(long, value_name = "EV", allow_negative_numbers = true, value_parser = stops)]
    exposure: Option<f64>,
}

fn stops(text: &str) -> Result<f64, String> {
    let stops = text.parse::<f64>().ok();
    stops
        .filter(|stops| stops.abs() <= MOST)
        .ok_or_else(|| format!("a number from -{MOST} to {MOST} is needed"))
}

impl Exposure {
    /// Refuses what has no exposure.
    pub(super) fn check(&self, path: &Path, integrator: Entry) -> Result<(), Stop> {
        if self.exposure.is_none() {
            return Ok(());
        }
        let why = match (integrator.shows, Format::of(path)) {
            (Shows::Geometry { .. }, _) => "this picture shows geometry, and no light",
            (_, Some(Format::Png)) => return Ok(()),
            _ => "it is for .png pictures; other formats keep the radiance as it is",
        };
        Err(Stop::Input(format!("--exposure: {why}")))
    }

    /// How the picture is shown.
    pub(super) fn display(&self, integrator: Entry, film: &Film) -> Display {
        match (self.exposure, integrator.shows) {
            (Some(stops), Shows::Light(_)) => Display::Exposed { stops },
            _ => picture::display(integrator, film),
        }
    }

    /// The option as it was given, for the command that makes the picture again.
    pub(super) fn again(&self) -> Option<String> {
        self.exposure.map(|stops| stops.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrators::{Path as PathTracer, find};

    #[test]
    fn only_light_in_a_png_file_has_an_exposure() {
        let asked = Exposure {
            exposure: Some(-1.5),
        };
        let refused = |file: &str, name: &str| {
            let entry = find(name).unwrap();
            match asked.check(Path::new(file), entry) {
                Err(Stop::Input(why)) => Some(why),
                _ => None,
            }
        };
        assert_eq!(refused("a.png", PathTracer::ENTRY.name), None);
        assert!(
            refused("a.exr", "path")
                .unwrap()
                .contains("for .png pictures")
        );
        assert!(refused("a.png", "normals").unwrap().contains("geometry"));
        assert_eq!(asked.again().as_deref(), Some("-1.5"));
        assert!(stops("25").is_err() && stops("nan").is_err());
        assert_eq!(stops("-2"), Ok(-2.0));
    }
}
