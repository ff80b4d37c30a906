//! `halfdisk render --maps`: where in a picture samples are needed.

use super::{Stop, drawn, save};
use crate::lab::drawing::{Axis, HeatMap};
use crate::lab::figures::required_chart;
use crate::render::Film;
use crate::render::accuracy::{Accuracy, Measure};
use crate::render::stopping::{Goal, percent};
use clap::Args;
use std::path::{Path, PathBuf};

/// The relative error for which samples are counted, where no other is asked for.
const ERROR: f64 = 0.02;

#[derive(Debug, Args)]
pub(super) struct Maps {
    /// Draw, beside the picture, each pixel's variance (FILE.variance.svg and .png), the samples it needs
    /// for the target error or else for 2 % (FILE.required), and their histogram (FILE.histogram)
    #[arg(long)]
    maps: bool,
}

/// What is drawn, by the middle of its files' names.
const KINDS: [&str; 3] = ["variance", "required", "histogram"];

impl Maps {
    /// The files in the format of pictures, which a scene might need.
    pub(super) fn pictures(&self, picture: &Path) -> Vec<PathBuf> {
        let kinds = KINDS.iter().filter(|_| self.maps);
        kinds
            .map(|kind| picture.with_extension(format!("{kind}.png")))
            .collect()
    }

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
            "variance, (W/(m² sr))²",
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
            (variance.to_svg(), variance.to_png()),
            (need.to_svg(), need.to_png()),
            (histogram.to_svg(), histogram.to_png()),
        ];
        let (mut files, mut written, mut missing) = (Vec::new(), Vec::new(), Vec::new());
        for (kind, (svg, png)) in KINDS.into_iter().zip(charts) {
            match drawn(&picture.with_extension(kind), svg, png)? {
                Some(both) => files.extend(both),
                None => missing.push(kind),
            }
        }
        for (file, bytes) in files {
            save(&file, bytes)?;
            written.push(file.display().to_string());
        }
        let why = (!missing.is_empty())
            .then(|| format!("nothing to draw in the maps of {}", missing.join(" and ")));
        Ok((written, why))
    }
}
