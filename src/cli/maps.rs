//! `halfdisk render --maps`: where in a picture samples are needed.

use super::{Stop, save};
use crate::chart::{Axis, ChartError, HeatMap, required_chart};
use crate::render::Film;
use crate::render::accuracy::{Accuracy, Measure};
use crate::render::target::{Goal, percent};
use clap::Args;
use std::path::{Path, PathBuf};

/// The relative error for which samples are counted, where no other is asked for.
const ERROR: f64 = 0.02;

#[derive(Debug, Args)]
pub(super) struct Maps {
    /// Draw, beside the picture, each pixel's variance (FILE.variance.svg), the samples it needs for the
    /// target error or else for 2 % (FILE.required.svg), and their histogram (FILE.histogram.svg)
    #[arg(long)]
    maps: bool,
}

impl Maps {
    /// Writes the maps where they are wanted; returns their names, and why others are missing.
    pub(super) fn write(
        &self,
        picture: &Path,
        film: &Film,
        goal: &Goal,
    ) -> Result<(Vec<String>, Option<String>), Stop> {
        let accuracy = Accuracy::of(film);
        let known = |square: &f64| square.is_finite();
        if !self.maps {
            return Ok((Vec::new(), None));
        }
        if !accuracy.variances().iter().any(known) {
            let why = "no maps: one sample has no spread, so there is no variance to draw";
            return Ok((Vec::new(), Some(why.to_owned())));
        }
        if accuracy.error(Measure::RootMeanSquare) == 0.0 {
            let why =
                "no maps: all samples of each pixel are alike, so there is no variance to draw";
            return Ok((Vec::new(), Some(why.to_owned())));
        }
        let target = goal.error.unwrap_or(ERROR);
        let error = percent(target);
        let required = accuracy.required(target);
        let map = |title: String, label: &str, values: &[f64]| HeatMap {
            title,
            label: label.to_owned(),
            width: film.width(),
            values: values.to_vec(),
            axis: Axis::Log,
        };
        let variance = map(
            "Variance of one sample".into(),
            "variance",
            &accuracy.variances(),
        );
        let need = map(
            format!("Samples that a pixel needs for an error of {error}"),
            "samples",
            &required,
        );
        let name = picture.file_stem().unwrap_or_default().to_string_lossy();
        let title = format!("Samples needed for an error of {error}");
        let histogram = required_chart(title, target, &[(&name, required)]);
        let charts = [
            ("variance", variance.to_svg()),
            ("required", need.to_svg()),
            ("histogram", histogram.to_svg()),
        ];
        let (mut written, mut missing) = (Vec::new(), Vec::new());
        for (kind, svg) in charts {
            let file = PathBuf::from(picture).with_extension(format!("{kind}.svg"));
            match svg {
                Ok(svg) => {
                    save(&file, svg)?;
                    written.push(file.display().to_string());
                }
                Err(ChartError::Empty(_)) => missing.push(kind),
                Err(error) => return Err(Stop::Failure(error.to_string())),
            }
        }
        let why = (!missing.is_empty())
            .then(|| format!("nothing to draw in the maps of {}", missing.join(" and ")));
        Ok((written, why))
    }
}
