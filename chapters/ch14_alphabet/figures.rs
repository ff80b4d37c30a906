//! The figures of this chapter: shares of the light as bars, and a picture for each class.

use crate::share_of;
use halfdisk::integrators::{FilteredPath, Integrator, Path, Whitted};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Bar, BarChart, BarGroup};
use halfdisk::lab::effects::language::{Class, Finds, finds};
use halfdisk::lab::effects::words::Words;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::{Scene, gallery};

/// How a class is called in numbers, files and the chart.
pub fn short(class: Class) -> &'static str {
    match class {
        Class::Seen => "seen",
        Class::SeenSpecular => "seen_specular",
        Class::Direct => "direct",
        Class::DirectSpecular => "direct_specular",
        Class::Bleeding => "bleeding",
        Class::Caustic => "caustic",
    }
}

/// What to look at in its picture.
fn look_at(class: Class) -> &'static str {
    match class {
        Class::Seen => "the lamp, and nothing else",
        Class::SeenSpecular => "the lamp again, in the mirror and in the glass",
        Class::Direct => "walls lit by the lamp; all shadows are black",
        Class::DirectSpecular => "lit walls, seen in the mirror and through the glass",
        Class::Bleeding => "walls lit by walls, with the colours of those",
        Class::Caustic => "what the mirror and the glass throw onto the walls",
    }
}

/// How it is called in the legend.
fn label(class: Class) -> &'static str {
    match class {
        Class::Bleeding => "bleeding",
        Class::Caustic => "caustics",
        _ => class.text(),
    }
}

/// The share of each class in a scene's light, as a group of bars.
pub fn shares(desk: &mut Desk, scene: &str, words: &Words) -> BarGroup {
    let mut bars = Vec::new();
    for class in Class::ALL {
        let [share, error] = share_of(class, words).map(|x| 100.0 * x);
        let says = format!("{scene}: {}", class.name());
        let number = Number {
            error: Some(error),
            ..Number::new(&says, share).unit("%")
        };
        desk.number(&format!("{scene}_{}", short(class)), number);
        bars.push(Bar {
            label: label(class).to_owned(),
            value: share,
            error: (error > 0.0).then_some(error),
        });
    }
    BarGroup {
        name: scene.to_owned(),
        bars,
    }
}

/// The bars of all scenes.
pub fn chart(desk: &mut Desk, groups: Vec<BarGroup>) -> Result<(), DeskError> {
    let chart = BarChart {
        title: "Which way the light came".to_owned(),
        x_label: "scene".to_owned(),
        y_label: "share of the light, percent".to_owned(),
        groups,
        ..BarChart::default()
    };
    let caption = "The light of four scenes by classes of paths, in percent. Whitted's tree finds the first four classes; how much it \
         misses depends on the scene.";
    desk.figure("chart.svg", caption, chart.to_svg()?)
}

/// What the pictures cost, and what they show.
pub struct Drawn {
    /// Rays traced.
    pub rays: u64,
    /// Variance of one sample of the whole picture.
    pub variance: f64,
    /// Rays of one of its samples.
    pub per_sample: f64,
    /// The share of the light that Whitted's tree finds.
    pub found: f64,
}

/// A picture for each class, which add up to the whole one.
pub fn strip(desk: &mut Desk) -> Result<Drawn, DeskError> {
    let side = desk.choose(112, 32);
    let scene = gallery::load("spheres")?.sized([side; 2]);
    let path = Path::new(scene.suggested.max_depth);
    let whole = paint(desk, &scene, &path)?;
    let mut sum = vec![[0.0; 3]; whole.film.pixels().len()];
    let mut rays = whole.rays.total();
    let mut found = 0.0;
    for class in Class::ALL {
        // ANCHOR: class
        let expression = class.expression();
        let paths = expression.eye_first();
        let rendered = paint(desk, &scene, &FilteredPath { path, paths })?;
        // ANCHOR_END: class
        let caption = format!("{}: {}.", class.text(), look_at(class));
        let name = format!("{}.png", short(class));
        desk.picture(&name, &caption, &rendered.film, &scene)?;
        for (pixel, part) in sum.iter_mut().zip(rendered.film.picture().values) {
            (0..3).for_each(|c| pixel[c] += part[c]);
        }
        let used = 100.0 * rendered.rays.total() as f64 / whole.rays.total() as f64;
        let says = format!("rays for {} alone, of those for all", class.text());
        let number = Number::new(&says, used.round()).unit("%");
        desk.number(&format!("rays_{}", short(class)), number);
        rays += rendered.rays.total();
        if finds(&Whitted::ENTRY, class, &scene.inventory) == Finds::All {
            found += rendered.film.mean().0 / whole.film.mean().0;
        }
    }
    let caption = "All of them together: the picture itself.";
    desk.picture("whole.png", caption, &whole.film, &scene)?;
    let parts = sum.iter().flatten();
    let all = whole.film.picture().values.into_flattened();
    let off = parts.zip(&all).map(|(a, b)| (a - b).abs());
    let off = off.fold(0.0, f64::max) / whole.film.mean().0;
    let says = "the six pictures' sum misses the whole by, of its mean, at most";
    desk.known("sum_is_off_by", says, off, 0.0);
    Ok(Drawn {
        rays,
        variance: whole.film.sample_variance(),
        per_sample: whole.rays.total() as f64 / whole.rays.camera as f64,
        found,
    })
}

fn paint(desk: &Desk, scene: &Scene, by: &impl Integrator) -> Result<Rendered, DeskError> {
    let options = Options {
        spp: desk.spp(16, 4),
        seed: desk.options.seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let rendered = render(scene, by, &options, &desk.bar("classes"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
