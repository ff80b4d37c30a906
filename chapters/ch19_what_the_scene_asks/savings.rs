//! What effects are worth, and what absent ones cost where they are not left out.

use crate::{ROOM, load};
use halfdisk::integrators::Path;
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Bar, BarChart, BarGroup};
use halfdisk::lab::effects::measure::{Difference, Setup, Times, difference};
use halfdisk::lab::effects::without::Without;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::scene::Scene;
use halfdisk::stats::slope::student_95;

/// Scenes that lack something.
const SCENES: [&str; 6] = ["cornell", ROOM, "caustic", "gloss", "veach", "mesh"];

/// Leaves out each effect that the room calls for; the rays it took.
pub fn worth(desk: &mut Desk) -> Result<u64, DeskError> {
    let side = desk.choose(32, 24);
    let scene = load(ROOM, [side; 2])?;
    let (spp, rounds) = desk.choose((8, 10), (8, 6));
    let with = Setup {
        scene: scene.clone(),
        wanted: None,
    };
    let mut rays = 0;
    for effect in scene.inventory.effects().iter() {
        let leave: Without = [effect].into_iter().collect();
        let without = leave.of(scene.clone(), None)?;
        let found = difference(&with, &without, spp, rounds);
        let name = effect.name().replace('-', "_");
        let says = format!("without {}: light that is missing", effect.name());
        let number = Number {
            error: Some(100.0 * found.share.error),
            ..Number::new(&says, 100.0 * found.share.value).unit("%")
        };
        desk.number(&format!("worth_{name}"), number);
        let says = format!("without {}: mean squared relative error", effect.name());
        let number = Number {
            error: Some(found.rel_mse.error),
            ..Number::new(&says, found.rel_mse.value)
        };
        desk.number(&format!("wrong_{name}"), number);
        let says = format!("without {}: rays with, over rays without", effect.name());
        desk.value(&format!("rays_{name}"), &says, two_digits(found.rays));
        time(desk, &name, &found);
        rays += found.traced;
    }
    Ok(rays)
}

/// Leaves every absent effect at work, at no strength; the rays it took.
pub fn absent(desk: &mut Desk) -> Result<u64, DeskError> {
    let (spp, rounds) = desk.choose((2, 12), (1, 4));
    let (mut groups, mut rays) = (Vec::new(), 0);
    for name in SCENES {
        let size = desk.choose([40; 2], [16; 2]);
        // ANCHOR: absent
        let plain = load(name, size)?;
        let all_on = plain.clone().with_all_effects();
        let (differ, traced) = differing_pixels(desk, &plain, &all_on);
        // ANCHOR_END: absent
        let setup = |scene: &Scene| Setup {
            scene: scene.clone(),
            wanted: None,
        };
        let found = difference(&setup(&all_on), &setup(&plain), spp, rounds);
        let says = format!("{name}, every effect at work: pixels that differ");
        desk.known(&format!("differ_{name}"), &says, differ as f64, 0.0);
        let says = format!("{name}, every effect at work: rays, of those of the plan");
        desk.known(&format!("rays_all_{name}"), &says, found.rays, 1.0);
        time(desk, &format!("all_{name}"), &found);
        rays += found.traced + traced;
        let Times { value, low, high } = found.time;
        // The interval is by Student's law on the logarithm of the ratio; charts show one standard error.
        let error = 0.5 * libm::log(high / low) / student_95(rounds as usize - 1);
        groups.push(BarGroup {
            name: name.to_owned(),
            bars: vec![Bar {
                label: String::new(),
                value: 100.0 * (value - 1.0),
                error: Some(100.0 * value * error),
            }],
        });
    }
    let chart = BarChart {
        title: "The price of effects that are not there".to_owned(),
        x_label: "scene".to_owned(),
        y_label: "more time than by the plan, percent".to_owned(),
        groups,
        ..BarChart::default()
    };
    let caption = "How much longer the same picture takes when every effect is at work, at no strength, than by the \
                   plan of its scene. Bars: one standard error.";
    desk.figure("seconds_absent.svg", caption, chart.to_svg()?)?;
    Ok(rays)
}

/// Pixels that are not the same in both, to the last bit, and the rays it took.
fn differing_pixels(desk: &Desk, a: &Scene, b: &Scene) -> (usize, u64) {
    let rendered = |scene: &Scene| -> Rendered {
        let options = Options {
            spp: 4,
            seed: desk.options.seed,
            ..Options::default()
        };
        let path = Path::new(scene.suggested.max_depth);
        render(scene, &path, &options, &())
    };
    let (a, b) = (rendered(a), rendered(b));
    let pairs = a.film.pixels().iter().zip(b.film.pixels());
    let differ = pairs.filter(|(p, q)| p != q).count();
    (differ, a.rays.total() + b.rays.total())
}

/// A ratio of times with its interval; it differs from run to run.
fn time(desk: &mut Desk, name: &str, found: &Difference) {
    let Times { value, low, high } = found.time;
    desk.value(
        &format!("seconds_{name}"),
        "  ratio of the times",
        two_digits(value),
    );
    desk.value(&format!("seconds_{name}_low"), "  from", two_digits(low));
    desk.value(
        &format!("seconds_{name}_high"),
        "  to, with 95 %",
        two_digits(high),
    );
}

/// To two digits after the point.
fn two_digits(x: f64) -> f64 {
    (100.0 * x).round() / 100.0
}
