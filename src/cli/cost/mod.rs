//! `halfdisk cost`.

mod page;
mod share;
mod text;

use self::share::Shared;
use super::answer::{answer, to_json};
use super::choices::size;
use super::{Bytes, Stop, check_folder, drawn, folder, note_slow_build, reduced, save};
use crate::lab::chapter::{Bar, on_ctrl_c, tell, whole};
use crate::lab::experiment::cost::strip::{Shown, affordable, needed, show};
use crate::lab::experiment::cost::{
    ALL, BASE, Budget, Design, Measured, Method, Nothing, PriceList, Priced, Verdict, measure_share,
};
use crate::lab::figures::{Against, cost_chart};
use crate::output::{self, Display as Shades, Provenance, png_bytes};
use crate::render::{Progress, Shard};
use crate::scene::{Scene, gallery};
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

/// Measure what accuracy costs: error against seconds and rays for every method.
///
/// Every method renders the scene many times at several sizes, in turns, each picture with random
/// numbers of its own. Slopes, ratios and times come with 95 % intervals, or with the word that what was
/// measured does not suffice. Ctrl-C keeps what is complete.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Cost {
    /// A scene of the gallery (see `halfdisk scenes`), or a path to a .toml file
    scene: String,
    /// Only these methods, such as kajiya,combine,path [default: all that can render the scene]
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    methods: Vec<String>,
    /// Independent pictures of each method at each size
    #[arg(long, default_value_t = Design::default().replicates,
        allow_negative_numbers = true, value_parser = whole(1_u32..=1000))]
    replicates: u32,
    /// Seconds for all of it, about
    #[arg(long, default_value_t = 120.0, value_name = "SECONDS", allow_negative_numbers = true, value_parser = budget)]
    budget: f64,
    /// In place of --budget: rays of each method's largest picture. The same samples on every machine
    #[arg(long, value_name = "RAYS", conflicts_with = "budget", value_parser = whole(1_u64..=1 << 40))]
    rays: Option<u64>,
    /// Measure only share I of N of the replicates, to DIR/cost-I-of-N.json: on N machines of one kind
    #[arg(long, value_name = "I/N", requires = "rays", conflicts_with = "json")]
    shard: Option<Shard>,
    /// Put the files of all shares together, and draw their page
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["methods", "replicates", "budget", "rays", "size", "seed", "shard"])]
    merge: Vec<PathBuf>,
    /// Image size in pixels for the measurement, such as 96x64 [default: the scene's shape, 64 pixels
    /// at its longer side]
    #[arg(long, value_name = "WxH", value_parser = size)]
    size: Option<[u32; 2]>,
    /// Seed of all random numbers
    #[arg(long, default_value_t = Design::default().seed, allow_negative_numbers = true, value_parser = whole(0..=u64::MAX))]
    seed: u64,
    /// Threads for the pictures that are timed
    #[arg(long, default_value_t = 1, allow_negative_numbers = true, value_parser = whole(1_u16..=1024))]
    threads: u16,
    /// Folder for the page, the charts and the numbers [default: out/cost/FILE, after the
    /// scene's file]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print JSON in place of the table
    #[arg(long)]
    json: bool,
}

const AFTER_HELP: &str = "\
Examples:
  halfdisk cost cornell
      every method in two minutes, then open out/cost/cornell/index.html
  halfdisk cost veach --methods kajiya,next-event,combine
      chance, aim, and both
  halfdisk cost mine.toml --budget 600 --size 128x128
      a scene of your own, in ten minutes
  halfdisk cost mine.toml --rays 20000000 --replicates 40 --shard 3/8     (1/8, 2/8 ... elsewhere)
  halfdisk cost mine.toml --merge out/cost/mine/cost-*-of-8.json
      on eight machines of one kind; each makes the reference for itself";

/// The longer side of the pictures that are measured, where nobody says otherwise.
const SIDE: u32 = 64;

fn method(name: &str) -> Result<Method, Stop> {
    Method::find(name.trim()).ok_or_else(|| {
        let names: Vec<_> = ALL.iter().map(|m| m.name).collect();
        let names = names.join(", ");
        Stop::Input(format!("there is no method \"{name}\"; there are {names}"))
    })
}

fn budget(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(seconds) if (1.0..=1e6).contains(&seconds) => Ok(seconds),
        _ => Err("a time is a number of seconds from 1 to a million".to_owned()),
    }
}

/// A size for the measurement, where nobody says otherwise.
fn small(full: [u32; 2]) -> [u32; 2] {
    reduced(full, full[0].max(full[1]), SIDE)
}

/// Names of methods that cannot render a scene, and why.
type LeftOut = Vec<(&'static str, &'static str)>;

/// What a run leaves behind.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    list: PriceList,
    /// Size that a picture of the scene has.
    #[serde(skip)]
    full: [u32; 2],
    #[serde(skip)]
    left_out: LeftOut,
    /// Pictures of equal time and of equal error.
    #[serde(skip)]
    strips: [Vec<Shown>; 2],
    /// The error that the pictures of equal error should have.
    #[serde(skip)]
    error: f64,
}

/// What the files of the strips begin with.
const STRIPS: [&str; 2] = ["time", "error"];

/// The files of a picture in a strip, and of its signed error.
fn files_of(kind: &str, method: &str) -> [String; 2] {
    [
        format!("{kind}_{method}.png"),
        format!("{kind}_off_{method}.png"),
    ]
}

impl Cost {
    pub(super) fn run(self) -> Result<(), Stop> {
        note_slow_build();
        let scene = gallery::load(&self.scene)?;
        let full = scene.size;
        let (shared, measured) = match self.merge.as_slice() {
            [] => (None, None),
            files => share::merged(&self.scene, &scene, files).map(|(a, b)| (Some(a), Some(b)))?,
        };
        let size = shared.as_ref().map(|shared| shared.size).or(self.size);
        let scene = scene.sized(size.unwrap_or_else(|| small(full)));
        let (methods, left_out) = match &shared {
            Some(shared) => (shared.methods.clone(), LeftOut::new()),
            None => self.methods(&scene)?,
        };
        let folder = self.folder(&scene, &methods)?;
        let stop = on_ctrl_c();
        let design = Design {
            replicates: shared.as_ref().map_or(self.replicates, |s| s.replicates),
            threads: Some(usize::from(self.threads)),
            seed: shared.as_ref().map_or(self.seed, |s| s.seed),
            ..Design::default()
        };
        let design = match shared.map(|s| s.rays).or(self.rays) {
            Some(rays) => Design {
                budget: Budget::Rays(rays),
                ..design
            },
            None => design.within(self.budget, &methods),
        };
        let all = Shard { index: 1, count: 1 };
        let bar = Bar::new(&scene.name, stop);
        let measure = || {
            let own = self.shard.unwrap_or(all);
            measure_share(&scene, &methods, &design, own, &bar)
        };
        let measured = measured.map_or_else(measure, Ok);
        let measured = measured.map_err(|nothing| match nothing {
            Nothing::Stopped => {
                tell("interrupted before the first replicate was finished: nothing is written");
                Stop::Interrupted
            }
            Nothing::Threads(_) => Stop::Failure(nothing.to_string()),
        })?;
        if let (Some(shard), Some(rays)) = (self.shard, self.rays) {
            let shared = Shared {
                fingerprint: scene.fingerprint().ok(),
                size: scene.size,
                replicates: self.replicates,
                seed: self.seed,
                rays,
                methods,
            };
            return share::write(&folder, shard, shared, measured);
        }
        let mut report = Report {
            list: PriceList::new(&scene, &measured),
            full,
            left_out,
            strips: Default::default(),
            error: 0.0,
        };
        if !measured.interrupted {
            let bar = Bar::new("pictures", stop);
            self.strips(&scene, &measured, &design, &mut report, &bar)?;
        }
        // The table is worth having where the files cannot be written.
        let written = self.write(&scene, &report, &folder);
        answer(&report, self.json)?;
        written?;
        tell(format_args!(
            "open {} to see charts and pictures",
            folder.join("index.html").display()
        ));
        if !stop.load(Ordering::Relaxed) {
            return Ok(());
        }
        let (done, all) = (measured.replicates, self.replicates);
        tell(format_args!(
            "interrupted: {done} of {all} replicates were finished; {} pictures to look at are kept",
            report.strips.iter().flatten().count()
        ));
        Err(Stop::Interrupted)
    }

    /// The folder of the results, if nothing there that the scene needs would be replaced.
    fn folder(&self, scene: &Scene, methods: &[Method]) -> Result<PathBuf, Stop> {
        let folder = folder(&self.out, "cost", &self.scene);
        check_folder(&folder)?;
        let charts = ["seconds.png", "rays.png"].map(str::to_owned);
        let names = || methods.iter().map(|method| method.name);
        let pictures = STRIPS
            .iter()
            .flat_map(|kind| names().flat_map(move |name| files_of(kind, name)));
        for file in charts.into_iter().chain(pictures) {
            output::prepare(&folder.join(file), scene)?;
        }
        Ok(folder)
    }

    /// The methods that were asked for and can render the scene, and why others cannot.
    fn methods(&self, scene: &Scene) -> Result<(Vec<Method>, LeftOut), Stop> {
        let named: Vec<Method> = self
            .methods
            .iter()
            .map(|n| method(n))
            .collect::<Result<_, _>>()?;
        let wanted = match named.as_slice() {
            [] => ALL.to_vec(),
            some => ALL.into_iter().filter(|m| some.contains(m)).collect(),
        };
        let cannot = |m: &Method| m.cannot(scene).map(|why| (m.name, why));
        let left_out: Vec<_> = wanted.iter().filter_map(cannot).collect();
        let methods: Vec<Method> = wanted
            .into_iter()
            .filter(|m| m.cannot(scene).is_none())
            .collect();
        match (methods.is_empty(), left_out.first()) {
            (true, Some((name, why))) => {
                Err(Stop::Input(format!("`{name}` cannot render this: {why}")))
            }
            _ => Ok((methods, left_out)),
        }
    }

    /// A picture of each method in equal time, and one of equal error.
    fn strips(
        &self,
        scene: &Scene,
        measured: &Measured,
        design: &Design,
        report: &mut Report,
        bar: &Bar,
    ) -> Result<(), Stop> {
        let seconds = match design.budget {
            Budget::Seconds(seconds) => seconds,
            Budget::Rays(_) => 1.0,
        };
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(usize::from(self.threads))
            .build();
        let pool =
            pool.map_err(|e| Stop::Failure(format!("the threads cannot be started: {e}")))?;
        report.error = common_error(&report.list);
        let count = 2 * measured.methods.len() as u64;
        for (i, runs) in measured.methods.iter().enumerate() {
            let (priced, i) = (&report.list.methods[i], i as u64);
            let seed = !design.seed - 1 - i;
            let picture =
                |spp| pool.install(|| show(scene, measured, &runs.method, spp, seed, bar));
            // A quarter of the time: at more the eye sees no difference.
            report.strips[0].extend(picture(affordable(priced, 0.25 * seconds)));
            bar.tell(2 * i + 1, count);
            report.strips[1].extend(needed(priced, runs, report.error).and_then(picture));
            bar.tell(2 * i + 2, count);
        }
        Ok(())
    }

    /// Writes page, charts, pictures and numbers.
    fn write(&self, scene: &Scene, report: &Report, folder: &Path) -> Result<(), Stop> {
        let mut files: Vec<Bytes> = vec![
            (
                folder.join("cost.csv"),
                text::csv(&report.list).into_bytes(),
            ),
            (folder.join("cost.json"), to_json(report)?.into_bytes()),
        ];
        let mut charts = Vec::new();
        for (name, against) in [("seconds", Against::Seconds), ("rays", Against::Rays)] {
            let title = format!("What accuracy costs: {}, against {name}", scene.name);
            let chart = cost_chart(title, &report.list, against);
            match drawn(&folder.join(name), chart.to_svg(), chart.to_png())? {
                Some(both) => {
                    charts.push(format!("{name}.svg"));
                    files.extend(both);
                }
                // Without any error there is no place on logarithmic axes.
                None => tell("note: no error anywhere, so no chart"),
            }
        }
        let depth = scene.suggested.max_depth;
        for (kind, strip) in STRIPS.into_iter().zip(&report.strips) {
            for shown in strip {
                let facts = Provenance::new(scene, shown.name, depth, shown.spp.into(), self.seed);
                let [picture, off] = files_of(kind, shown.name).map(|file| folder.join(file));
                files.push((picture, png_bytes(&shown.film, Shades::Radiance, &facts)?));
                let white = Shades::Data { white: 1.0 };
                files.push((off, png_bytes(&shown.off, white, &facts)?));
            }
        }
        let page = page::html(report, &charts)?;
        files.push((folder.join("index.html"), page.into_bytes()));
        files
            .into_iter()
            .try_for_each(|(file, bytes)| save(&file, bytes))
    }
}

/// An error that all unbiased methods can show: that of the base's second largest pictures, or, where it
/// would cost another too much, a quarter of that one's smallest.
fn common_error(list: &PriceList) -> f64 {
    let unbiased = || list.methods.iter().filter(|m| m.verdict != Verdict::Biased);
    let smallest = |m: &Priced| m.sizes.last().map_or(0.0, |s| s.error);
    let worst = unbiased().map(smallest).fold(0.0, f64::max);
    let base = list.find(BASE).or(unbiased().next());
    let second = base.and_then(|m| m.sizes.iter().rev().nth(1));
    second.map_or(worst, |size| size.error.max(0.25 * worst))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_pictures_keep_their_shape() {
        assert_eq!(small([256, 192]), [64, 48]);
        assert_eq!(small([16, 12]), [16, 12]);
        assert_eq!(small([10_000, 1]), [64, 1]);
    }
}
