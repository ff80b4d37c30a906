//! The price list as text: for people, and as CSV.

use super::Report;
use crate::lab::experiment::cost::{PriceList, Priced, Reach, TARGETS};
use crate::numeric::{count, three_digits};
use crate::stats::price::Ratio;
use std::fmt::{self, Display, Formatter, Write as _};

/// Everything in lines.
impl Display for Report {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let list = &self.list;
        let [w, h] = list.size;
        let replicates = count(list.replicates as usize, "replicate", "replicates");
        let off = 100.0 * list.reference_error;
        writeln!(
            f,
            "{}, {w} x {h}, {replicates}; the reference is {off:.3} % off\n",
            list.scene
        )?;
        writeln!(
            f,
            "{:<13}{:>6}{:>10}{:>18}   {:>18}   {:>6}",
            "method", "spp", "seconds", "error, %", "rays of a sample", "worst"
        )?;
        list.methods
            .iter()
            .try_for_each(|method| sizes(method, f))?;
        let worst = "the share of the squared error in the worst thousandth of the pixels";
        writeln!(f, "(worst: {worst})\n")?;
        for method in &list.methods {
            writeln!(f, "{:<13}{}", method.name, method.says())?;
        }
        writeln!(f)?;
        for method in &list.methods {
            if let Some([seconds, rays]) = list.against_base(method) {
                writeln!(f, "{}", sentence(method.name, &seconds, &rays))?;
            }
        }
        let [w, h] = self.full;
        let row = |cells: [String; TARGETS.len()]| cells.map(|cell| format!("{cell:>32}")).join("");
        let targets = row(TARGETS.map(|t| format!("{} %", 100.0 * t)));
        writeln!(
            f,
            "\ntime to a relative error, at {w} x {h}:\n{:<13}{targets}",
            ""
        )?;
        for method in &list.methods {
            let times = row(std::array::from_fn(|i| {
                time(&method.times[i], self.scale())
            }));
            writeln!(f, "{:<13}{times}", method.name)?;
        }
        for (name, why) in &self.left_out {
            writeln!(f, "left out: {name}, for {why}")?;
        }
        for method in list.methods.iter().filter(|m| m.non_finite > 0) {
            let samples = count(method.non_finite as usize, "sample is", "samples are");
            writeln!(f, "warning: {}: {samples} not finite", method.name)?;
        }
        Ok(())
    }
}

/// A line for each size of a method.
fn sizes(method: &Priced, f: &mut Formatter) -> fmt::Result {
    let rays = method.rays_per_sample;
    let all = format!("{:.2}", rays.camera + rays.secondary + rays.shadow);
    let [mut name, mut each] = [method.name, &all];
    for s in &method.sizes {
        let own = match s.error_error {
            own if own.is_finite() => format!("{:.3}", 100.0 * own),
            _ => "unknown".to_owned(),
        };
        let error = format!("{:.3} ± {own}", 100.0 * s.error);
        let (spp, seconds, worst) = (s.spp, s.seconds, 100.0 * s.top_share);
        writeln!(
            f,
            "{name:<13}{spp:>6}{seconds:>10.4}{error:>18}   {each:>18}   {worst:>4.1} %"
        )?;
        [name, each] = ["", ""];
    }
    Ok(())
}

/// `kajiya needs 4.10x [3.90, 4.30] the time of path for the same error, and 4.00x [...] the rays`.
pub(super) fn sentence(name: &str, seconds: &Ratio, rays: &Ratio) -> String {
    let [seconds, rays] = [times(seconds), times(rays)];
    format!("{name} needs {seconds} the time of path for the same error, and {rays} the rays")
}

/// `4.1x [3.9, 4.3]`.
pub(super) fn times(ratio: &Ratio) -> String {
    let [a, b, c] = [ratio.ratio, ratio.low, ratio.high].map(three_digits);
    format!("{a}x [{b}, {c}]")
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
        s if s < 100.0 => format!("{} s", three_digits(s)),
        s if s < 6000.0 => format!("{} min", three_digits(s / 60.0)),
        s => format!("{} h", three_digits(s / 3600.0)),
    }
}

/// One line for each method and size.
pub(super) fn csv(list: &PriceList) -> String {
    let mut csv = String::from(
        "method,spp,rays,seconds,seconds_spread,error,error_error,top_share,verdict\n",
    );
    for method in &list.methods {
        let verdict = format!("{:?}", method.verdict).to_lowercase();
        for s in &method.sizes {
            let _ = writeln!(
                csv,
                "{},{},{},{:e},{:e},{:e},{:e},{:e},{verdict}",
                method.name,
                s.spp,
                s.rays,
                s.seconds,
                s.spread,
                s.error,
                s.error_error,
                s.top_share,
            );
        }
    }
    csv
}

impl Report {
    /// Pixels of the scene's own size over those that were measured.
    pub(super) fn scale(&self) -> f64 {
        let pixels = |[w, h]: [u32; 2]| f64::from(w) * f64::from(h);
        pixels(self.full) / pixels(self.list.size)
    }
}
