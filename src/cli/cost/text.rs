//! The price list as text: for people, and as CSV.

use super::Report;
use crate::experiment::cost::{PriceList, Priced, Reach, TARGETS, Verdict};
use crate::numeric::count;
use crate::stats::price::Ratio;
use std::fmt::Write as _;

/// Everything in lines.
pub(super) fn table(report: &Report) -> String {
    let list = &report.list;
    let [w, h] = list.size;
    let mut text = format!(
        "{}, {w} x {h}, {}; the reference is {:.3} % off\n\n",
        list.scene,
        count(list.replicates as usize, "replicate", "replicates"),
        100.0 * list.reference_error
    );
    let _ = writeln!(
        text,
        "{:<12}{:>6}{:>10}{:>18}   {:>18}   {:>6}",
        "method", "spp", "seconds", "error, %", "rays of a sample", "worst"
    );
    for method in &list.methods {
        let rays = method.rays_per_sample;
        let all = rays.camera + rays.secondary + rays.shadow;
        for (i, s) in method.sizes.iter().enumerate() {
            let name = if i == 0 { method.name } else { "" };
            let each = if i == 0 {
                format!("{all:.2}")
            } else {
                String::new()
            };
            let own = match s.error_error {
                own if own.is_finite() => format!("{:.3}", 100.0 * own),
                _ => "unknown".to_owned(),
            };
            let _ = writeln!(
                text,
                "{name:<12}{:>6}{:>10.4}{:>18}   {each:>18}   {:>4.1} %",
                s.spp,
                s.seconds,
                format!("{:.3} ± {own}", 100.0 * s.error),
                100.0 * s.top_share,
            );
        }
    }
    text += "(worst: the share of the squared error in the worst thousandth of the pixels)\n\n";
    for method in &list.methods {
        let _ = writeln!(text, "{:<12}{}", method.name, method.says());
    }
    text.push('\n');
    for method in &list.methods {
        if let Some([seconds, rays]) = list.against_base(method) {
            let _ = writeln!(text, "{}", sentence(method.name, &seconds, &rays));
        }
    }
    let [w, h] = report.full;
    let targets = TARGETS.map(|t| format!("{:>32}", format!("{} %", 100.0 * t)));
    let _ = writeln!(
        text,
        "\ntime to a relative error, at {w} x {h}:\n{:<12}{}",
        "",
        targets.join("")
    );
    for method in &list.methods {
        let times: Vec<String> = method
            .times
            .iter()
            .map(|t| format!("{:>32}", time(t, report.scale())))
            .collect();
        let _ = writeln!(text, "{:<12}{}", method.name, times.join(""));
    }
    for (name, why) in &report.left_out {
        let _ = writeln!(text, "left out: {name}, for {why}");
    }
    for method in list.methods.iter().filter(|m| m.non_finite > 0) {
        let _ = writeln!(
            text,
            "warning: {}: {} not finite",
            method.name,
            count(method.non_finite as usize, "sample is", "samples are")
        );
    }
    text
}

/// `kajiya needs 4.10x [3.90, 4.30] the time of path for the same error, and 4.00x [...] the rays`.
pub(super) fn sentence(name: &str, seconds: &Ratio, rays: &Ratio) -> String {
    let [seconds, rays] = [times(seconds), times(rays)];
    format!("{name} needs {seconds} the time of path for the same error, and {rays} the rays")
}

/// `4.1x [3.9, 4.3]`.
pub(super) fn times(ratio: &Ratio) -> String {
    let [a, b, c] = [ratio.ratio, ratio.low, ratio.high].map(digits);
    format!("{a}x [{b}, {c}]")
}

/// Two or three digits.
fn digits(x: f64) -> String {
    match x {
        x if x < 9.995 => format!("{x:.2}"),
        x if x < 99.95 => format!("{x:.1}"),
        x => format!("{x:.0}"),
    }
}

/// A time for people, for so many times the pixels that were measured.
pub(super) fn time(reach: &Reach, scale: f64) -> String {
    match *reach {
        Reach::Priced { seconds, low, high } => {
            let [low, high] = [low, high].map(|t| duration(scale * t));
            format!("{} [{low}, {high}]", duration(scale * seconds))
        }
        Reach::Between { seconds } => format!("about {}", duration(scale * seconds)),
        Reach::AtMost { seconds } => format!("< {}", duration(scale * seconds)),
        Reach::MoreThan { seconds } => format!("> {}", duration(scale * seconds)),
        Reach::Never => "never".to_owned(),
    }
}

fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 100.0 => format!("{} s", digits(s)),
        s if s < 6000.0 => format!("{} min", digits(s / 60.0)),
        s => format!("{} h", digits(s / 3600.0)),
    }
}

/// One line for each method and size.
pub(super) fn csv(list: &PriceList) -> String {
    let mut csv = String::from(
        "method,spp,rays,seconds,seconds_spread,error,error_error,top_share,verdict\n",
    );
    for Priced {
        name,
        sizes,
        verdict,
        ..
    } in &list.methods
    {
        for s in sizes {
            let _ = writeln!(
                csv,
                "{name},{},{},{:e},{:e},{:e},{:e},{:e},{}",
                s.spp,
                s.rays,
                s.seconds,
                s.spread,
                s.error,
                s.error_error,
                s.top_share,
                word(*verdict)
            );
        }
    }
    csv
}

fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Sufficient => "sufficient",
        Verdict::Faster => "faster",
        Verdict::Biased => "biased",
        Verdict::Insufficient => "insufficient",
    }
}

impl Report {
    /// Pixels of the scene's own size over those that were measured.
    pub(super) fn scale(&self) -> f64 {
        let pixels = |[w, h]: [u32; 2]| f64::from(w) * f64::from(h);
        pixels(self.full) / pixels(self.list.size)
    }
}
