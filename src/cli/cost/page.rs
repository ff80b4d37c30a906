//! The page of a price list: charts, tables, pictures side by side.

use super::text::{sentence, time, times};
use super::{Report, STRIPS, Shown, Stop, files_of};
use crate::cli::page::filled;
use crate::lab::experiment::cost::{Priced, TARGETS};
use minijinja::{Value, context};

/// The page as HTML; charts and pictures lie beside it.
pub(super) fn html(report: &Report, charts: &[String]) -> Result<String, Stop> {
    let list = &report.list;
    let [width, height] = list.size;
    let [full_width, full_height] = report.full;
    let methods: Vec<Value> = list.methods.iter().map(|m| method(report, m)).collect();
    let names: Vec<&str> = list.methods.iter().map(|m| m.name).collect();
    let sentences: Vec<String> = list
        .methods
        .iter()
        .filter_map(|m| list.against_base(m).map(|[s, r]| sentence(m.name, &s, &r)))
        .collect();
    let strip = |k: usize| -> Vec<Value> {
        let pictures = report.strips[k].iter();
        pictures.map(|shown| picture(STRIPS[k], shown)).collect()
    };
    let page = context! {
        scene => list.scene.clone(),
        width, height, full_width, full_height,
        replicates => list.replicates,
        interrupted => list.interrupted,
        reference_spp => list.reference_spp,
        reference_error => format!("{:.3}", 100.0 * list.reference_error),
        targets => TARGETS.map(|t| format!("{} %", 100.0 * t)),
        charts => charts.to_vec(),
        methods, names, sentences,
        equal_time => strip(0),
        equal_error => strip(1),
        error => format!("{:.1}", 100.0 * report.error),
        left_out => report.left_out.iter().map(|(name, why)| format!("{name}: {why}")).collect::<Vec<_>>(),
    };
    filled("the page of prices", include_str!("page.html"), page)
}

fn method(report: &Report, m: &Priced) -> Value {
    let rays = m.rays_per_sample;
    let times_to: Vec<String> = m.times.iter().map(|t| time(t, report.scale())).collect();
    let last = m.sizes.last();
    let ratios: Vec<String> = m
        .ratios
        .iter()
        .map(|r| r.as_ref().map_or_else(|| "–".to_owned(), times))
        .collect();
    context! {
        name => m.name,
        about => m.about,
        says => m.says(),
        seconds => match &m.against_seconds {
            Ok(fit) => fit.to_string(),
            Err(why) => why.to_string(),
        },
        camera => format!("{:.0}", rays.camera),
        secondary => format!("{:.2}", rays.secondary),
        shadow => format!("{:.2}", rays.shadow),
        speed => format!("{:.2}", last.map_or(0.0, |s| s.rays / s.seconds / 1e6)),
        spp => last.map_or(0, |s| s.spp),
        error => last.map_or_else(String::new, |s| format!("{:.2}", 100.0 * s.error)),
        worst => last.map_or_else(String::new, |s| format!("{:.1}", 100.0 * s.top_share)),
        non_finite => m.non_finite,
        times => times_to,
        ratios,
    }
}

fn picture(kind: &str, shown: &Shown) -> Value {
    let [file, off] = files_of(kind, shown.name);
    context! {
        file, off,
        name => shown.name,
        spp => shown.spp,
        seconds => format!("{:.2}", shown.seconds),
        error => format!("{:.1}", 100.0 * shown.error),
    }
}
