//! What the figures of this chapter show beside light.

use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, WhichRay};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Axis, Bar, BarChart, BarGroup, Curve, CurveChart, Style};
use halfdisk::materials::{Bsdf, BsdfSample, Event};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::Tracer;
use halfdisk::stats::Estimate;
use halfdisk::stats::z_test::{FOUR, z_test};

/// The kinds of ray, as they are counted.
pub const KINDS: [&str; 3] = ["diffuse", "specular", "transmitted"];

/// The place in [`KINDS`] of a ray that was chosen at a surface seen from its front.
pub fn kind(next: &BsdfSample) -> usize {
    match next.event {
        Event::Diffuse | Event::Gloss => 0,
        Event::Specular if next.wi.z > 0.0 => 1,
        Event::Specular => 2,
    }
}

/// A picture of what is chosen at the first mixture a ray from the eye meets; its mean colour tells
/// how often. All else is dim.
pub struct FirstChoice(pub WhichRay);

impl Integrator for FirstChoice {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        let orange = Rgb::new(0.95, 0.3, 0.05);
        let blue = Rgb::new(0.08, 0.3, 0.9);
        let green = Rgb::new(0.15, 0.7, 0.2);
        let dim = Rgb::grey(0.06);
        let Some(hit) = tracer.camera_ray(ray) else {
            return dim;
        };
        if !matches!(hit.bsdf, Some(Bsdf::Mixture(_))) {
            return dim;
        }
        let next = self.0.further(&hit, 1, stream);
        next.map_or(Rgb::BLACK, |next| [orange, blue, green][kind(&next)])
    }
}

/// How many standard errors an estimate is off.
pub fn z(read: &Estimate, exact: f64) -> f64 {
    z_test(read, exact, FOUR).z.abs()
}

/// Variances of the weight of one choice, by mixture and rule.
pub fn bars(desk: &mut Desk, groups: Vec<BarGroup>) -> Result<(), DeskError> {
    let chart = BarChart {
        title: "Variance of one choice under white light".to_owned(),
        x_label: "mixture".to_owned(),
        y_label: "variance, mean of the channels".to_owned(),
        groups,
        ..BarChart::default()
    };
    let caption = "Every rule reads the same mean. Going by the shares leaves grey mixtures no \
                   variance; thirds waste rays on faint parts.";
    desk.figure("chart.svg", caption, chart.to_svg()?)
}

/// One group of bars: name of the rule, variance, error.
pub fn group(name: &str, bars: &[(&str, f64, f64)]) -> BarGroup {
    let bar = |&(rule, value, error): &(&str, f64, f64)| Bar {
        error: Some(error),
        ..Bar::new(rule, value)
    };
    BarGroup {
        name: name.to_owned(),
        bars: bars.iter().map(bar).collect(),
    }
}

/// What is left of light after each bounce: measured, and the powers it should be.
pub fn energy(desk: &mut Desk, rows: Vec<(&str, f64, Vec<f64>)>) -> Result<(), DeskError> {
    let mut curves = Vec::new();
    for (place, (name, share, left)) in rows.into_iter().enumerate() {
        let points = (0..).map(f64::from).zip(left);
        curves.push(Curve::new(name, Style::Marks, points).coloured(place));
        let law = (0..=10).map(|k| (f64::from(k), share.powi(k)));
        curves.push(Curve::new("", Style::Dashed, law).coloured(place));
    }
    let chart = CurveChart {
        title: "What is left of light".to_owned(),
        x_label: "bounces".to_owned(),
        y_label: "mean weight".to_owned(),
        y_axis: Axis::Log,
        curves,
        ..CurveChart::default()
    };
    let caption = "Mean weight of a path: with k/p, without a weight, and where the shares add up to \
                   more than one; dashed the powers.";
    desk.figure("energy.svg", caption, chart.to_svg()?)
}
