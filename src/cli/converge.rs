//! `halfdisk converge`.

use super::answer::{List, answer, to_json};
use super::shares::{self, Share};
use super::{Stop, check_folder, drawn, save, use_threads, with_ending};
use crate::lab::chapter::{Bar, on_ctrl_c, tell, whole};
use crate::lab::experiment::convergence::{
    Convergence, Design, Estimator, converge_watched, csv, errors, of_errors,
};
use crate::lab::experiment::named;
use crate::lab::experiment::study::in_order;
use crate::lab::figures::convergence_chart;
use crate::numeric::count;
use crate::render::Shard;
use clap::Args;
use serde::{Deserialize, Serialize};
use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;
use std::sync::atomic::Ordering;

/// Measure how fast the error of an estimator falls.
///
/// Each estimator is run many times at every size, each run with random numbers of its own. Error
/// and variance come as a table, a chart and files, with the slope of the error on logarithmic axes.
/// Ctrl-C keeps the runs that are finished.
#[derive(Debug, Args)]
#[command(after_help = AFTER_HELP)]
pub struct Converge {
    /// The estimators, all on one chart (see `halfdisk converge --list`)
    #[arg(value_name = "NAME", required_unless_present_any = ["list", "merge"])]
    names: Vec<String>,
    /// List the estimators
    #[arg(long, conflicts_with = "names")]
    list: bool,
    /// Independent runs at each size: more of them make the slope surer
    #[arg(long, default_value_t = Design::default().replicates,
        allow_negative_numbers = true, value_parser = whole(1_u32..=1 << 20))]
    replicates: u32,
    /// Sizes, each twice the one before: 16, 32, 64 ... samples
    #[arg(long, default_value_t = Design::default().doublings,
        allow_negative_numbers = true, value_parser = whole(1_u32..=24))]
    doublings: u32,
    /// Seed of all random numbers: the same seed gives the same bytes
    #[arg(long, default_value_t = Design::default().seed, allow_negative_numbers = true, value_parser = whole(0..=u64::MAX))]
    seed: u64,
    /// Run only share I of N of the replicates, to DIR/NAME-I-of-N.json: of a long measurement on N machines
    #[arg(long, value_name = "I/N", conflicts_with = "json")]
    shard: Option<Shard>,
    /// Put the files of all shares together: the same bytes as from one run
    #[arg(long, value_name = "FILE", num_args = 1.., conflicts_with_all = ["names", "list", "replicates", "doublings", "seed", "shard"])]
    merge: Vec<PathBuf>,
    /// Threads to run on; changes no result [default: one for each core]
    #[arg(long, allow_negative_numbers = true, value_parser = whole(1_u16..=1024))]
    threads: Option<u16>,
    /// Folder for the chart (.svg, .png) and the numbers (.csv, .json)
    #[arg(long, value_name = "DIR", default_value = "out/converge")]
    out: PathBuf,
    /// Print JSON in place of the table
    #[arg(long)]
    json: bool,
}

const AFTER_HELP: &str = "\
Examples:
  halfdisk converge --list
      the estimators, one line each
  halfdisk converge half-disk
      chance alone: four times the samples halve the error, a slope of -1/2
  halfdisk converge half-disk half-disk-stratified
      the same directions, one in each part: the error falls with slope -3/2
  halfdisk converge half-disk half-disk-literal
      a formula that is wrong levels out; no number of samples helps it
  halfdisk converge darts --replicates 8 --doublings 4
      too few runs, and the fit says so
  halfdisk converge product-8 --replicates 4096 --shard 3/8      (1/8, 2/8 ... elsewhere)
  halfdisk converge --merge out/converge/product-8-*-of-8.json
      a long measurement on eight machines";

/// A longer file name is cut here.
const LONGEST_STEM: usize = 80;

impl Converge {
    pub(super) fn run(self) -> Result<(), Stop> {
        if self.list {
            return answer(&List(named::all()), self.json);
        }
        if !self.merge.is_empty() {
            let (design, shares) = Shares::read_all(&self.merge)?;
            check_folder(&self.out)?;
            return self.answer(&design.measured(shares)?);
        }
        let estimators = chosen(&self.names)?;
        check_folder(&self.out)?;
        use_threads(self.threads)?;
        let shared = Shared {
            seed: self.seed,
            replicates: self.replicates,
            doublings: self.doublings,
            estimators: estimators.iter().map(|e| e.name.to_owned()).collect(),
        };
        let design = shared.design();
        let stop = on_ctrl_c();
        if let Some(shard) = self.shard {
            let runs: Vec<_> = estimators
                .iter()
                .map(|e| errors(e, &design, shard, &Bar::new(e.name, stop)))
                .collect();
            if stop.load(Ordering::Relaxed) {
                tell("interrupted: a share is whole or not there, so nothing is written");
                return Err(Stop::Interrupted);
            }
            let names: Vec<&str> = estimators.iter().map(|e| e.name).collect();
            let path = shares::file(&self.out.join(stem(&names)), shard);
            Shares::write(&path, shard, shared, runs)?;
            tell(format_args!("wrote {}", path.display()));
            return Ok(());
        }
        let mut runs = Vec::new();
        for estimator in &estimators {
            let bar = Bar::new(estimator.name, stop);
            runs.extend(converge_watched(estimator, &design, &bar));
            if stop.load(Ordering::Relaxed) {
                break;
            }
        }
        let whole = runs.iter().filter(|r| r.replicates == self.replicates);
        let done = whole.count();
        // What was finished before a Ctrl-C is kept.
        let measured = shared.of(runs);
        if !measured.estimators.is_empty() {
            self.answer(&measured)?;
        }
        let runs = &measured.estimators;
        if done < estimators.len() {
            let all = estimators.len();
            let mut text = format!("interrupted: {done} of {all} estimators were finished");
            if let Some(cut) = runs.iter().find(|r| r.replicates < self.replicates) {
                let (kept, all) = (cut.replicates, self.replicates);
                text += &format!(", and {kept} of {all} runs of {} are kept", cut.name);
            }
            tell(text);
            return Err(Stop::Interrupted);
        }
        Ok(())
    }

    /// Writes and prints what was measured.
    fn answer(&self, measured: &Measured) -> Result<(), Stop> {
        // The table is worth having where the files cannot be written.
        let stem = self.write(measured);
        answer(measured, self.json)?;
        tell(format_args!(
            "wrote {}.svg, .png, .csv and .json",
            stem?.display()
        ));
        Ok(())
    }

    /// Writes chart and numbers; returns their path without its ending.
    fn write(&self, measured: &Measured) -> Result<PathBuf, Stop> {
        let runs = &measured.estimators;
        let names: Vec<&str> = runs.iter().map(|run| run.name.as_str()).collect();
        let path = self.out.join(stem(&names));
        let runs_each = count(measured.replicates as usize, "run", "runs");
        let title = match runs.as_slice() {
            [run] => format!("Error of {}, {runs_each} each", run.name),
            _ => format!("Error against samples, {runs_each} each"),
        };
        let chart = convergence_chart(title, runs);
        let mut files = vec![
            (with_ending(&path, ".csv"), csv(runs).into_bytes()),
            (with_ending(&path, ".json"), to_json(measured)?.into_bytes()),
        ];
        match drawn(&path, chart.to_svg(), chart.to_png())? {
            Some(both) => files.extend(both),
            // Estimators without any error have numbers, but no place on logarithmic axes.
            None => tell("note: no error anywhere, so there is no chart"),
        }
        for (file, bytes) in files {
            save(&file, bytes)?;
        }
        Ok(path)
    }
}

/// What all shares of a measurement have in common.
#[derive(PartialEq, Serialize, Deserialize)]
struct Shared {
    seed: u64,
    replicates: u32,
    doublings: u32,
    estimators: Vec<String>,
}

/// The errors of each estimator, replicate and size.
type Errors = Vec<Vec<Vec<f64>>>;
type Shares = Share<Shared, Errors>;

impl Shared {
    fn design(&self) -> Design {
        Design {
            replicates: self.replicates,
            doublings: self.doublings,
            seed: self.seed,
            ..Design::default()
        }
    }

    fn of(&self, estimators: Vec<Convergence>) -> Measured {
        Measured {
            seed: self.seed,
            replicates: self.replicates,
            doublings: self.doublings,
            estimators,
        }
    }

    /// What all shares amount to.
    fn measured(&self, shares: Vec<Errors>) -> Result<Measured, Stop> {
        let mut shares: Vec<_> = shares.into_iter().map(Vec::into_iter).collect();
        let mut runs = Vec::new();
        for estimator in chosen(&self.estimators)? {
            let rows = in_order(shares.iter_mut().filter_map(Iterator::next).collect());
            let whole = rows.len() == self.replicates as usize;
            let made = of_errors(&estimator, &self.design(), rows).filter(|_| whole);
            runs.push(made.ok_or_else(|| {
                let name = estimator.name;
                Stop::Input(format!("the shares do not have all replicates of {name}"))
            })?);
        }
        Ok(self.of(runs))
    }
}

/// What was measured.
#[derive(Serialize)]
struct Measured {
    seed: u64,
    replicates: u32,
    doublings: u32,
    estimators: Vec<Convergence>,
}

impl Display for Measured {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        self.estimators.iter().try_for_each(|run| run.fmt(f))
    }
}

/// The estimators of these names, each once.
fn chosen(names: &[String]) -> Result<Vec<Estimator>, Stop> {
    let mut found: Vec<Estimator> = Vec::new();
    for name in names {
        let estimator = named::find(name).ok_or_else(|| {
            let all: Vec<_> = named::all().iter().map(|e| e.name).collect();
            Stop::Input(format!(
                "there is no estimator \"{name}\"; there are {}",
                all.join(", ")
            ))
        })?;
        if found.iter().all(|e| e.name != estimator.name) {
            found.push(estimator);
        }
    }
    Ok(found)
}

/// The names joined with `+`, shortened where that makes a long name.
fn stem(names: &[&str]) -> String {
    let joined = names.join("+");
    if joined.len() <= LONGEST_STEM {
        return joined;
    }
    let others = format!("{}+{}-more", names[0], names.len() - 1);
    // The same number of others is not the same others.
    let mark = joined
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    format!("{others}-{:08x}", mark as u32)
}
