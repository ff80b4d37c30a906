//! Chapter 13: Six integrals.
//!
//! Question: which integrals are in a picture, and what does each of them cost?
//! New here: `integrators::Distributed`, cameras with a lens, scenes in motion. Simulates
//! `L(S|G|D)*E` with a lens, a shutter and pixels that have an area.
//! Builds on: chapters 2 and 6 (trees of rays; directions over a surface).

mod figures;
mod finale;
mod profiles;
mod rate;

use halfdisk::integrators::{Distributed, Integral};
use halfdisk::lab::chapter::{Chapter, Desk, DeskError, Number};
use halfdisk::lab::estimators::furnace::irradiance;
use halfdisk::lab::estimators::worlds::ball;
use halfdisk::lab::ledger::Ledger;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Purpose;
use halfdisk::scene::{Scene, gallery};
use halfdisk::space::{Flat, Solid};
use halfdisk::stats::z_test::Largest;
use profiles::{Profile, lobe_energy};
use std::f64::consts::{LN_2, PI};
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch13",
    title: "Six integrals",
    question: "Which integrals are in a picture, and what does each of them cost?",
};

fn main() -> ExitCode {
    Desk::run(&CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    let (seed, mut drawn) = (desk.options.seed, 0);

    // Each integral in a row of pixels of its own, against its closed form.
    let mut rows = Vec::new();
    let mut compared = Largest::default();
    for profile in Profile::all() {
        let (row, rays) = profile.read(desk.choose(8_192, 4096), seed, |_| {})?;
        let z = row.iter().map(|r| r.z().abs()).fold(0.0, f64::max);
        let off = row.iter().map(|r| (r.read.mean() - r.exact).abs());
        let name = figures::name(profile.integral);
        let says = format!("{name}: largest distance from the closed form in standard errors");
        desk.value(&format!("z_{name}"), &says, (100.0 * z).round() / 100.0);
        let says = format!("{name}: largest distance from the closed form");
        desk.value(&format!("off_{name}"), &says, off.fold(0.0, f64::max));
        if let (Some((width, error)), Some(exact)) = (profile.width_of(&row), profile.width) {
            let says = format!("{name}: width of the blur");
            let number = Number::new(&says, width).exact(exact);
            let error = Some(error);
            desk.number(&format!("width_{name}"), Number { error, ..number });
        }
        row.iter().for_each(|r| compared.add(r.z()));
        drawn += rays.total();
        rows.push((profile, row));
    }
    figures::profiles(desk, &rows)?;
    rate::chart(desk, &Profile::all())?;
    let smooth = lobe_energy(1.0);
    desk.known("lobe", "energy of the roughest lobe", smooth, 1.0 - LN_2);

    // The sky in a groove and in a cone whose walls stand 30 degrees from the middle, as shares.
    let samples = desk.choose(400_000, 200_000);
    let groove = irradiance::<Flat, _>(ball::<Flat>(0.5, 0.0), samples, seed);
    let cone = irradiance::<Solid, _>(ball::<Solid>(0.5, 0.0), samples, seed);
    desk.estimate("groove", "irradiance in a groove", &groove, Some(1.0));
    desk.estimate("cone", "irradiance in a cone", &cone, Some(PI / 4.0));
    compared.add(groove.z(1.0));
    compared.add(cone.z(PI / 4.0));

    // The same scene without any integral, with each alone, and with all.
    let scene = gallery::load("six")?.sized(desk.choose([240, 180], [160, 120]));
    let none = picture(desk, &scene, Integral::NONE, 1)?;
    let text = "No integral: jagged edges, hard shadows, all in focus.";
    desk.picture("none.png", text, &none.film, &scene)?;
    let mut sum = 0.0;
    for integral in Integral::ALL {
        let only = picture(desk, &scene, integral.others(), desk.spp(5, 2))?;
        let name = figures::name(integral);
        let caption = figures::look(integral);
        desk.picture(&format!("{name}.png"), caption, &only.film, &scene)?;
        sum += cost(desk, name, &only);
        drawn += only.rays.total();
    }
    let once = picture(desk, &scene, &[], 1)?;
    let text = "All six with one sample: noise, and right in the mean.";
    desk.picture("once.png", text, &once.film, &scene)?;
    let all_six = format!("All six with {} samples.", desk.spp(12, 2));
    let all = picture(desk, &scene, &[], desk.spp(12, 2))?;
    desk.picture("all.png", &all_six, &all.film, &scene)?;
    cost(desk, "none", &none);
    let variance = cost(desk, "all", &all);
    desk.value("variance_sum", "variances one by one, added up", sum);
    let pictures = none.rays.total() + once.rays.total() + all.rays.total();
    drawn += pictures + figures::first_hits(desk)? + figures::occlusion(desk)?;
    drawn += finale::work(desk)?;

    let per_sample = all.rays.total() as f64 / all.rays.camera.max(1) as f64;
    Ok(Ledger {
        rays: drawn + 2 * u64::from(samples),
        variance: Some(variance),
        compared: Some(compared.into()),
        efficiency: Some(1.0 / (variance * per_sample)),
        ..Ledger::of(
            "Soft edges, shadows, focus, motion, gloss and indirect light for the rays of one \
             sharp picture: each integral costs variance, and none costs rays.",
        )
    })
}

/// The variance of a sample and the rays it takes.
fn cost(desk: &mut Desk, name: &str, rendered: &Rendered) -> f64 {
    let rays = rendered.rays.total() as f64 / rendered.rays.camera.max(1) as f64;
    let says = format!("{name}: rays a sample");
    desk.value(&format!("rays_{name}"), &says, rays);
    let variance = rendered.film.sample_variance();
    // One sample of a picture has no scatter to tell, but nothing was drawn for this one.
    let variance = if name == "none" { 0.0 } else { variance };
    let says = format!("{name}: variance of a sample");
    desk.value(&format!("variance_{name}"), &says, variance);
    variance
}

/// The scene with some integrals left out.
fn picture(
    desk: &Desk,
    scene: &Scene,
    fixed: &'static [Purpose],
    spp: u32,
) -> Result<Rendered, DeskError> {
    let options = Options {
        spp,
        seed: desk.options.seed,
        fixed,
        ..Options::default()
    };
    let max_depth = scene.suggested.max_depth;
    let integrator = Distributed { max_depth };
    let rendered = render(scene, &integrator, &options, &desk.bar("six"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
