//! Chapter 1: From the eye.
//!
//! Question: light goes from the lamp to the eye; why do ray tracers go the other way?
//! New here: `estimators::aperture` and `estimators::two_ways`. Simulates `LE` and `LDE`.

mod drawing;

use halfdisk::chart::{Axis, Curve, CurveChart, Style};
use halfdisk::desk::{Chapter, Desk, DeskError, Number};
use halfdisk::estimators::aperture::{
    count_through_disc, count_through_slit, disc_chance, slit_chance,
};
use halfdisk::estimators::two_ways::{Traced, TwoWays};
use halfdisk::ledger::Ledger;
use halfdisk::lights::Light;
use halfdisk::output::{Display, Provenance, png_bytes};
use halfdisk::render::compare;
use halfdisk::scene::gallery;
use halfdisk::stats::Estimate;
use std::process::ExitCode;

const CHAPTER: Chapter = Chapter {
    id: "ch01",
    title: "From the eye",
    question: "Light goes from the lamp to the eye. Why do ray tracers go the other way?",
};

fn main() -> ExitCode {
    Desk::run(CHAPTER, work)
}

fn work(desk: &mut Desk) -> Result<Ledger, DeskError> {
    let seed = desk.options.seed;

    // ANCHOR: counts
    // How many of a million rays from a lamp enter an eye three units away?
    let (rays, distance) = (1_000_000, 3.0);
    let mut worst = 0.0_f64;
    for (name, width) in [("slit", 0.4), ("slit_doubled", 0.8), ("slit_pinhole", 0.0)] {
        let hits = count_through_slit(width, distance, rays, seed);
        let chance = slit_chance(f64::from(width), f64::from(distance));
        let says = format!("flat world: rays through a slit of width {width}");
        worst = worst.max(count(desk, name, &says, &hits, chance).abs());
    }
    for (name, radius) in [("disc", 0.2), ("disc_doubled", 0.4), ("disc_pinhole", 0.0)] {
        let hits = count_through_disc(radius, distance, rays, seed);
        let chance = disc_chance(f64::from(radius), f64::from(distance));
        let says = format!("space: rays through a disc of radius {radius}");
        worst = worst.max(count(desk, name, &says, &hits, chance).abs());
    }
    // ANCHOR_END: counts
    desk.figure(
        "from_light.svg",
        drawing::FROM_LIGHT,
        drawing::from_light(seed)?,
    )?;
    desk.figure("from_eye.svg", drawing::FROM_EYE, drawing::from_eye()?)?;

    // The same view both ways, with the same number of rays.
    let scene = gallery::load("lamp")?;
    let Some(lamp) = scene.lights.iter().find_map(|light| match light {
        Light::Sphere(lamp) => Some(*lamp),
        _ => None,
    }) else {
        return Err(DeskError::Scene(gallery::unknown("lamp with a round lamp")));
    };
    let view = TwoWays {
        scene: &scene,
        lamp,
        pupil: 0.5,
    };
    let light = view.from_light(desk.choose(16_000_000, 2_000_000), seed);
    let pixels = u64::from(scene.size[0] * scene.size[1]);
    let eye = view.from_eye((light.rays / (2 * pixels)) as u32, seed);
    let wasted = (light.rays - light.useful) as f64 / light.useful as f64;
    desk.number(
        "useful",
        Number::new(
            "rays from the light that entered the eye",
            light.useful as f64,
        ),
    );
    desk.number(
        "wasted",
        Number::new("rays wasted for each of them", wasted),
    );

    let (mean_light, error_light) = light.film.mean();
    let (mean_eye, error_eye) = eye.film.mean();
    let error = (error_light.powi(2) + error_eye.powi(2)).sqrt();
    let says = "mean of the picture from the light, and from the eye";
    let mean = Number {
        error: Some(error),
        ..Number::new(says, mean_light).exact(mean_eye)
    };
    desk.number("mean", mean);
    let z = compare::z_scores(&light.film, &eye.film);
    let says = "mean of z² over pixels and channels: 1 where they agree";
    desk.estimate("agreement", says, &z.squares, Some(1.0));
    desk.number(
        "largest_z",
        Number::new("largest |z| of any pixel and channel", z.largest),
    );
    // Few rays show the difference.
    let light_few = view.from_light(150_000, seed);
    let eye_few = view.from_eye((light_few.rays / (2 * pixels)) as u32, seed);
    for (file, picture, caption) in [
        (
            "light.png",
            &light_few,
            "From the light: few of its rays find the eye, so the picture is noise.",
        ),
        (
            "image.png",
            &eye_few,
            "From the eye, with as many rays: every one of them counts.",
        ),
    ] {
        let facts = Provenance::new(
            &scene,
            CHAPTER.id,
            2,
            picture.film.pixel(0, 0).count(),
            seed,
        );
        let png = png_bytes(&picture.film, Display::Radiance, &facts)?;
        desk.figure(file, caption, png)?;
    }
    let says = "rays traced for each of the two pictures";
    desk.number("picture_rays", Number::new(says, light_few.rays as f64));

    // The error against the number of rays.
    let reference = view.from_eye(desk.choose(32_768, 4_096), seed + 1);
    let doublings = desk.choose(6, 3);
    let mut price_ratio = Estimate::new();
    let mut curves = [Vec::new(), Vec::new()];
    for k in 0..doublings {
        let mut errors = [Estimate::new(), Estimate::new()];
        let mut spent = [0, 0];
        for replicate in 0..desk.choose(8, 4) {
            let seed = seed + 2 + replicate;
            let runs = [
                view.from_light(20_000 << k, seed),
                view.from_eye(1 << k, seed),
            ];
            let price = |run: &Traced| compare::mse(&run.film, &reference.film) * run.rays as f64;
            price_ratio.add(libm::log(price(&runs[0]) / price(&runs[1])));
            for (i, run) in runs.iter().enumerate() {
                errors[i].add(compare::mse(&run.film, &reference.film).sqrt());
                spent[i] = run.rays;
            }
        }
        for (i, curve) in curves.iter_mut().enumerate() {
            curve.push((spent[i] as f64, errors[i].mean(), errors[i].std_error()));
        }
    }
    let ratio = libm::exp(price_ratio.mean());
    let ratio_error = ratio * price_ratio.std_error();
    let says = "rays from the light for the error of one ray from the eye";
    desk.number(
        "price",
        Number {
            error: Some(ratio_error),
            ..Number::new(says, ratio)
        },
    );
    let [from_light, from_eye] = curves;
    let chart = CurveChart {
        title: "The same picture both ways".to_owned(),
        x_label: "rays traced".to_owned(),
        y_label: "root mean square error of a pixel".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: vec![
            Curve::measured("from the light", Style::MarksAndLine, from_light),
            Curve::measured("from the eye", Style::MarksAndLine, from_eye),
        ],
    };
    let caption = "Both ways end at the same picture; from the light it takes many more rays.";
    desk.figure("chart.svg", caption, chart.to_svg()?)?;

    let variance = eye.film.sample_variance();
    Ok(Ledger {
        rays: 6 * u64::from(rays) + light.rays + eye.rays + reference.rays,
        seconds: 0.0,
        variance: Some(variance),
        bias_in_errors: Some(worst),
        efficiency: Some(1.0 / (2.0 * variance)),
        gain: format!(
            "From the eye no ray is lost; from the light {wasted:.0} are, for each that arrives."
        ),
    })
}

/// Records a count beside its prediction; its distance from it in standard errors.
fn count(desk: &mut Desk, name: &str, says: &str, hits: &Estimate, chance: f64) -> f64 {
    let rays = hits.count() as f64;
    let number = Number::new(says, hits.mean() * rays).exact(chance * rays);
    // The error that theory gives a count, so that a count of zero has one too.
    let error = (chance * (1.0 - chance) * rays).sqrt();
    let z = if error > 0.0 {
        (number.value - chance * rays) / error
    } else {
        0.0
    };
    desk.number(
        name,
        Number {
            error: Some(error),
            unit: Some("rays".to_owned()),
            ..number
        },
    );
    z
}
