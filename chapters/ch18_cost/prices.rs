//! The price list: every integrator so far, Sobol' points, and a mistake.

use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::experiment::cost::strip::{affordable, show};
use halfdisk::lab::experiment::cost::{
    ALL, BASE, Budget, Design, FROM_THE_EYE, Measured, Nothing, PriceList, Priced, Reach, TARGETS,
    Verdict, measure,
};
use halfdisk::lab::figures::{Against, cost_chart, price_chart};
use halfdisk::render::{Film, Pixel};
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::slope::{Fit, Insufficient};
use halfdisk::stats::z_test::Largest;

/// What the price list leaves for the rest of the chapter.
pub struct Prices {
    /// The box that was measured.
    pub scene: Scene,
    /// All of it.
    pub measured: Measured,
    /// Rays of all pictures.
    pub rays: u64,
    /// Variance of one relative sample of `path`.
    pub variance: f64,
    /// Rays of a sample of `path`.
    pub rays_per_sample: f64,
    /// The biases of methods that should have none, by their standard errors.
    pub biases: Largest,
}

/// Measures and records all prices.
pub fn work(desk: &mut Desk) -> Result<Prices, DeskError> {
    // In smaller pictures the edge of the lamp, in few large pixels, would decide all.
    let side = desk.choose(40, 28);
    let scene = gallery::load("cornell")?.sized([side; 2]);
    // ANCHOR: measure
    let design = Design {
        replicates: 6,
        sizes: 3,
        budget: Budget::Rays(desk.choose(100_000, 90_000)),
        reference: 16,
        threads: None,
        seed: desk.options.seed,
    };
    let measured = measure(&scene, &ALL[..FROM_THE_EYE], &design, &desk.bar("prices"));
    // ANCHOR_END: measure
    let measured = measured.map_err(|nothing| match nothing {
        Nothing::Stopped => DeskError::Interrupted,
        Nothing::Threads(error) => DeskError::Threads(error),
    })?;
    if measured.interrupted {
        return Err(DeskError::Interrupted);
    }
    let list = PriceList::new(&scene, &measured);
    let mut biases = Largest::default();
    for method in &list.methods {
        numbers(desk, &list, method);
        if let Some(bias) = method.bias.filter(|_| method.may_be_biased.is_none()) {
            biases.add(bias.square / bias.error);
            biases.add(bias.mean / bias.mean_error);
        }
    }
    let few = of_few(&list);
    let title = "What accuracy costs in the Cornell box";
    let caption = "Relative error against rays: dots are measured, dashed lines fitted, and their slopes stand in the \
                   legend. Look how far the lines of independent samples lie apart, and that they are parallel. Of nine \
                   methods five are shown; the chart below has all. Bars: one standard error.";
    let chart = cost_chart(title, &few, Against::Rays);
    desk.figure("rays.svg", caption, chart.to_svg()?)?;
    let caption = "Squared error times rays, relative to path: how many times the rays of path a method needs for the same \
                   error. A level line is the law. The line that falls is that of Sobol' points, the two that rise are \
                   biased. Bars: one standard error.";
    let chart = price_chart("The price of the same error", &list);
    desk.figure("price.svg", caption, chart.to_svg()?)?;
    let caption = format!(
        "The same five against the seconds of a picture of {side} x {side} pixels, on the machine that ran this. Bars: one \
         standard error."
    );
    let chart = cost_chart(title, &few, Against::Seconds);
    desk.figure("time_seconds.svg", &caption, chart.to_svg()?)?;
    desk.value("side", "side of the box's pictures, pixels", side.into());
    equal_time(desk, &scene, &measured, &list)?;
    let runs = measured
        .methods
        .iter()
        .flat_map(|m| m.study.runs.iter().flatten());
    let base = list.find(BASE).and_then(|m| Some((m, *m.sizes.last()?)));
    let (variance, rays_per_sample) = base.map_or((0.0, 1.0), |(m, last)| {
        let rays = m.rays_per_sample;
        let all = rays.camera + rays.secondary + rays.shadow;
        (last.error * last.error * f64::from(last.spp), all)
    });
    Ok(Prices {
        // Without those of the last figure, which took as many as the clock allowed.
        rays: runs.map(|run| run.rays.total()).sum::<u64>(),
        scene,
        measured,
        variance,
        rays_per_sample,
        biases,
    })
}

/// The methods whose lines lie apart; the others lie on that of `path` or of `kajiya`.
fn of_few(list: &PriceList) -> PriceList {
    let mut few = list.clone();
    let apart = ["whitted", "kajiya", BASE, "path-sobol", "clamped"];
    few.methods.retain(|method| apart.contains(&method.name));
    few
}

/// What the list says of a method.
fn numbers(desk: &mut Desk, list: &PriceList, method: &Priced) {
    let name = method.name;
    let key = name.replace('-', "_");
    desk.say(&format!("{name}: {}", method.says()));
    if let Ok(Fit {
        line, std_error, ..
    })
    | Err(Insufficient::Wide(Fit {
        line, std_error, ..
    })) = method.against_rays
    {
        let says = format!("{name}: slope of error against rays");
        let number = Number {
            error: Some(std_error),
            exact: (method.verdict == Verdict::Sufficient).then_some(-0.5),
            ..Number::new(&says, line.slope)
        };
        desk.number(&format!("slope_{key}"), number);
    }
    if let Some(floor) = method.levels_out {
        let says = format!("{name}: levels out at an error of, %");
        let number = |end: &str| format!("floor_{end}{key}");
        desk.value(&number(""), &says, digits(100.0 * floor.error));
        desk.value(&number("low_"), "  at least", digits(100.0 * floor.low));
        desk.value(&number("high_"), "  at most", digits(100.0 * floor.high));
    }
    let rays = method.rays_per_sample;
    let says = format!("{name}: rays of a sample");
    desk.value(
        &format!("rays_{key}"),
        &says,
        digits(rays.camera + rays.secondary + rays.shadow),
    );
    if let Some(last) = method.sizes.last() {
        let says = format!("{name}: error of its largest pictures, %");
        let number = Number {
            error: Some(100.0 * last.error_error),
            ..Number::new(&says, 100.0 * last.error)
        };
        desk.number(&format!("error_{key}"), number);
        desk.value(
            &format!("spp_{key}"),
            &format!("{name}: their samples"),
            last.spp.into(),
        );
        let says = format!("{name}: share of the worst thousandth of the pixels, %");
        desk.value(
            &format!("worst_{key}"),
            &says,
            digits(100.0 * last.top_share),
        );
    }
    if let Some([seconds, rays]) = list.against_base(method) {
        for (unit, ratio) in [("rays", rays), ("seconds", seconds)] {
            let says = format!("{name}: times the {unit} of path for the same error");
            let time = if unit == "rays" { "" } else { "time_" };
            let number = |end: &str| format!("{time}price_{end}{key}");
            desk.value(&number(""), &says, digits(ratio.ratio));
            desk.value(&number("low_"), "  at least", digits(ratio.low));
            desk.value(&number("high_"), "  at most", digits(ratio.high));
        }
    }
    // For a picture of 256 x 256 pixels.
    let scale = 256.0 * 256.0 / f64::from(list.size[0] * list.size[1]);
    for (target, reach) in TARGETS.iter().zip(&method.times) {
        let seconds = match (*reach, method.sizes.last()) {
            (Reach::Priced { seconds, .. } | Reach::Between { seconds }, _) => seconds,
            // Its slope is not known well enough to tell; that of an unbiased method is the law's.
            (Reach::MoreThan { seconds }, Some(last))
                if method.verdict == Verdict::Insufficient =>
            {
                seconds * (last.error / target).powi(2)
            }
            _ => continue,
        };
        let percent = 100.0 * target;
        let says = format!("{name}: seconds to {percent} % at 256 x 256");
        desk.value(
            &format!("time_{percent}_{key}"),
            &says,
            digits(scale * seconds),
        );
    }
}

/// A picture of each method in equal time, side by side.
fn equal_time(
    desk: &mut Desk,
    scene: &Scene,
    measured: &Measured,
    list: &PriceList,
) -> Result<(), DeskError> {
    let seconds = desk.choose(0.08, 0.004);
    let (mut pictures, mut errors) = (Vec::new(), Vec::new());
    for (priced, runs) in list.methods.iter().zip(&measured.methods) {
        let (spp, seed) = (affordable(priced, seconds), !desk.options.seed);
        let shown = show(scene, measured, &runs.method, spp, seed, &desk.bar("strip"));
        let shown = shown.ok_or(DeskError::Interrupted)?;
        pictures.extend([shown.film, shown.off]);
        errors.push(format!("{} {:.0}\u{a0}%", shown.name, 100.0 * shown.error));
    }
    let errors = errors.join(", ");
    let caption = format!(
        "Equal time, {seconds} s for each column, and below each picture its signed error (red is too bright, blue too \
         dark). From left to right: {errors}. Look for the noise of kajiya and roulette, which find the lamp by chance, \
         and for even patches of one colour: those are bias."
    );
    let strip = side_by_side(&pictures);
    desk.picture("time_strip.png", &caption, &strip, scene)
}

/// Columns of two pictures each, with a white line between them.
fn side_by_side(films: &[Film]) -> Film {
    let (width, height) = films.first().map_or((1, 1), |f| (f.width(), f.height()));
    let white = Pixel {
        channels: [std::iter::once(1.0).collect(); 3],
        ..Pixel::default()
    };
    let columns = (films.len() as u32).div_ceil(2);
    let size = [columns * (width + 2), 2 * (height + 2)];
    let at = |x: u32, y: u32| {
        let film = films.get((2 * (x / (width + 2)) + y / (height + 2)) as usize)?;
        let (x, y) = (x % (width + 2), y % (height + 2));
        (x < width && y < height).then(|| *film.pixel(x, y))
    };
    let places = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
    Film::new(
        size[0],
        places.map(|(x, y)| at(x, y).unwrap_or(white)).collect(),
    )
}

/// Three significant digits: more would say nothing.
pub fn digits(x: f64) -> f64 {
    format!("{x:.2e}").parse().unwrap_or(x)
}
