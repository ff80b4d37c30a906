//! How fast errors fall, with and without strata.

use crate::figures;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::estimators::directions::Recipe;
use halfdisk::lab::estimators::gather::Gather;
use halfdisk::lab::estimators::worlds;
use halfdisk::lab::experiment::convergence::{Convergence, Design, Estimator, converge};
use halfdisk::lab::experiment::named;
use halfdisk::sampling::stream::Stream;
use halfdisk::space::Solid;

/// Estimators under a strip of light, and their names in the chart.
const LAMP: [(&str, &str); 4] = [
    ("hemisphere-lamp", "uniform"),
    ("hemisphere-lamp-cosine", "cosine"),
    ("hemisphere-lamp-stratified", "stratified"),
    (STRATIFIED_COSINE, "stratified cosine"),
];

/// Estimators under a white sky, and their names in the chart.
const WHITE: [(&str, &str); 3] = [
    ("half-disk", "independent"),
    ("half-disk-stratified", "stratified, half disk"),
    ("hemisphere-stratified", "stratified, hemisphere"),
];

const STRATIFIED_COSINE: &str = "hemisphere-lamp-stratified-cosine";

/// Runs all of them, records their slopes, draws them; the rays it took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let all = |desk: &Desk, names: &[(&str, &str)]| -> Vec<Convergence> {
        let runs = names
            .iter()
            .filter_map(|(name, short)| run(desk, name, short));
        runs.collect()
    };
    let (lamp, sky) = (all(desk, &LAMP), all(desk, &WHITE));
    record(desk, "slope_uniform", &sky[0], Some(-0.5));
    record(desk, "slope_stratified", &sky[1], Some(-1.5));
    record(desk, "slope_grid", &sky[2], Some(-1.0));
    // Where an edge lies along the strata, it does so better at one size than at the next: -3/4 is
    // the law for many samples, not for these.
    record(desk, "slope_edge", &lamp[2], None);
    record(desk, "slope_edge_cosine", &lamp[3], None);
    figures::slopes(desk, &lamp, &sky)?;
    let spent = lamp.iter().chain(&sky).map(|run| {
        let rays: u64 = run.sizes.iter().map(|size| size.rays).sum();
        rays * u64::from(run.replicates)
    });
    Ok(spent.sum())
}

/// An estimator by name.
fn estimator(name: &str) -> Option<Estimator> {
    if name != STRATIFIED_COSINE {
        return named::find(name);
    }
    // The same lamp for the one recipe that has no name.
    named::find("hemisphere-lamp-stratified").map(|stratified| Estimator::<fn(u32, u64) -> f64> {
        name: STRATIFIED_COSINE,
        run: |samples, seed| {
            let gather = Gather {
                samples,
                depth: 1,
                recipe: Recipe::StratifiedCosine,
            };
            let mut lamp = worlds::strip::<Solid>(0.2, 1.0);
            let floor = worlds::floor::<Solid>(1.0);
            f64::from(
                gather
                    .reflected(&mut lamp, &floor, &Stream::new(seed, 0, 0))
                    .r,
            )
        },
        ..stratified
    })
}

/// Runs a named estimator at many sizes, under a short name.
fn run(desk: &Desk, name: &str, short: &str) -> Option<Convergence> {
    let (replicates, doublings) = desk.choose((128, 9), (64, 8));
    let design = Design {
        replicates,
        doublings,
        seed: desk.options.seed,
        ..Design::default()
    };
    let found = converge(&estimator(name)?, &design);
    Some(Convergence {
        name: short.to_owned(),
        ..found
    })
}

/// Records the slope of one of the runs.
fn record(desk: &mut Desk, name: &str, run: &Convergence, exact: Option<f64>) {
    if let Some(fit) = run.line() {
        let says = format!("slope of the error: {}", run.name);
        let slope = Number::new(&says, fit.line.slope);
        let error = Some(fit.std_error);
        desk.number(
            name,
            Number {
                error,
                exact,
                ..slope
            },
        );
    }
}
