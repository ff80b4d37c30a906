//! What happened in a render: in words, and for programs.

use crate::integrators::{ENOUGH, RarelyAsked};
use crate::numeric::count;
use crate::output::Provenance;
use crate::render::Faults;
use crate::render::target::{Outcome, fewest};
use crate::sampling::stream::Sampler;
use crate::scene::Scene;
use serde_json::json;
use std::path::Path;

/// What happened, for people.
pub(super) fn report(
    scene: &Scene,
    outcome: &Outcome,
    sampler: Sampler,
    too_bright: usize,
) -> String {
    let rendered = &outcome.rendered;
    let mut text = String::new();
    let mut line = |l: String| {
        text += &l;
        text.push('\n');
    };
    let seconds = rendered.time.as_secs_f64();
    let rays = rendered.rays;
    let [w, h] = scene.size;
    line(format!(
        "{}: {w} x {h}, {}, built in {:.3} s, rendered in {seconds:.3} s",
        scene.name,
        count(scene.report.shapes, "shape", "shapes"),
        scene.report.time.as_secs_f64(),
    ));
    line(format!(
        "rays: {} camera, {} secondary, {} shadow; {:.2} million per second",
        rays.camera,
        rays.secondary,
        rays.shadow,
        rays.total() as f64 / seconds / 1e6
    ));
    let (mean, error) = rendered.mean();
    let error = if !error.is_finite() {
        " (error not known)".to_owned()
    } else if outcome.reached.error.is_infinite() {
        format!(" ± {error:.1e} of rounding; no noise was seen")
    } else if outcome.reached.spp < fewest(sampler) {
        format!(" ± at most {error:.1e}, since few samples that lie evenly only bound their error")
    } else {
        format!(" ± {error:.1e}")
    };
    line(format!("mean of the picture: {mean:.6}{error}"));
    if scene.report.degenerate_triangles > 0 {
        line(format!(
            "note: {} left out",
            count(
                scene.report.degenerate_triangles,
                "triangle without area was",
                "triangles without area were"
            )
        ));
    }
    for note in &scene.report.notes {
        line(format!("note: {note}"));
    }
    if scene.report.hidden_lamps > 0 {
        line(format!(
            "note: {} in the very place of an earlier one {} left out",
            count(scene.report.hidden_lamps, "lamp", "lamps"),
            if scene.report.hidden_lamps == 1 {
                "was"
            } else {
                "were"
            }
        ));
    }
    if let Some(coarse) = scene.report.coarse {
        line(format!(
            "warning: {} so small for where they stand that rounding changes their form: \
             numbers there are up to {} apart, counted from the camera",
            count(coarse.shapes, "shape is", "shapes are"),
            coarse.step
        ));
    }
    if let Some(bad) = rendered.first_bad {
        let Faults {
            nan,
            infinite,
            negative,
        } = rendered.faults;
        line(format!(
            "warning: samples that no light brings: {nan} not a number and {infinite} infinite, \
             which are in no mean, {negative} negative; the first is sample {} of pixel {},{}",
            bad.sample, bad.x, bad.y
        ));
    }
    if too_bright > 0 {
        line(format!(
            "warning: {} brighter than the scene's lights and albedos allow",
            count(too_bright, "pixel is", "pixels are")
        ));
    }
    if rendered.interrupted {
        let counts = rendered.film.pixels().iter().map(|p| p.count());
        line(format!(
            "interrupted: the picture has {} to {} samples per pixel",
            counts.clone().min().unwrap_or(0),
            counts.max().unwrap_or(0)
        ));
    }
    text
}

/// Lights whose absence the error of the picture could not tell, for people.
pub(super) fn rarely_asked_line(rare: RarelyAsked) -> String {
    let RarelyAsked { lights, times, .. } = rare;
    let which = match lights {
        1 => format!("one light is asked only about {times:.1} times in the whole picture"),
        n => format!(
            "{n} lights are asked fewer than {ENOUGH} times each in the whole picture, the least \
             about {times:.1} times"
        ),
    };
    format!(
        "warning: {which}; light may be missing, and the error cannot tell: take more samples\n"
    )
}

/// What happened, for machines.
pub(super) fn as_json(
    scene: &Scene,
    facts: &Provenance,
    outcome: &Outcome,
    too_bright: usize,
    path: &Path,
) -> serde_json::Value {
    let rendered = &outcome.rendered;
    let seconds = rendered.time.as_secs_f64();
    let (mean, error) = rendered.mean();
    json!({
        "facts": facts,
        "size": scene.size,
        "shapes": scene.report.shapes,
        "degenerate_triangles": scene.report.degenerate_triangles,
        "build_seconds": scene.report.time.as_secs_f64(),
        "seconds": seconds,
        "rays": rendered.rays,
        "rays_per_second": rendered.rays.total() as f64 / seconds,
        "mean": { "value": mean, "error": error },
        "notes": scene.report.notes,
        "hidden_lamps": scene.report.hidden_lamps,
        "coarse_shapes": scene.report.coarse.map_or(0, |c| c.shapes),
        "non_finite": rendered.non_finite,
        "faults": rendered.faults,
        "largest_sample": rendered.largest,
        "too_bright_pixels": too_bright,
        "first_non_finite": rendered.first_bad,
        "interrupted": rendered.interrupted,
        "out": path.display().to_string(),
    })
}
