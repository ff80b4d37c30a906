//! From the eye, from the lamp, and by photons: a caustic and a box, error against samples and seconds.

use super::scene;
use halfdisk::integrators::{self, Integrator, Settings};
use halfdisk::lab::chapter::{Desk, DeskError};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::experiment::cost::Reference;
use halfdisk::render::{Film, Options, Session, render};
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::Estimate;
use halfdisk::stats::slope::Line;

/// Path tracing as the slides have it, with shadow rays; walks from the lights; and photons.
const METHODS: [&str; 3] = ["combine", "light-tracer", "photons"];

/// What a method reached after 1, 2, 4 … samples per pixel: seconds, and squared relative errors of replicates.
struct Course {
    name: &'static str,
    seconds: Vec<f64>,
    squares: Vec<Estimate>,
}

pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let side = desk.choose(40, 24);
    let caustic = scene("ball.toml", include_str!("ball.toml"))?.sized([side; 2]);
    let cornell = gallery::load("cornell")?.sized([side; 2]);
    let mut rays = 0;
    for (name, scene, truth) in [
        ("caustic", &caustic, "light-tracer"),
        ("box", &cornell, "path"),
    ] {
        desk.say(&format!(
            "\nfrom the eye, from the lamp, by photons: {name}"
        ));
        rays += one(desk, name, scene, truth)?;
    }
    strip(desk, &caustic)?;
    Ok(rays)
}

fn made(name: &str, scene: &Scene) -> Result<Box<dyn Integrator>, DeskError> {
    let entry = integrators::find(name).ok_or(DeskError::Missing(name.to_owned()))?;
    let depth = scene.suggested.max_depth.min(8);
    Ok(entry.prepare(scene, &Settings::new(depth))?)
}

fn one(desk: &mut Desk, scene_name: &str, scene: &Scene, truth: &str) -> Result<u64, DeskError> {
    let mut rays = 0;
    let spp = desk.choose(2048, 512);
    let by = made(truth, scene)?;
    let mut half = |seed: u64| {
        let options = Options {
            spp,
            seed: 1000 + seed,
            ..Options::default()
        };
        let made = render(scene, &by, &options, &desk.bar("the truth"));
        rays += made.rays.total();
        match made.interrupted {
            true => Err(DeskError::Interrupted),
            false => Ok(made.film),
        }
    };
    let truth = Reference::new(&half(1)?, &half(2)?, spp);
    let (doublings, replicates) = (desk.choose(8, 6), 3_u64);
    let mut courses = Vec::new();
    for name in METHODS {
        let by = made(name, scene)?;
        let mut course = Course {
            name,
            seconds: vec![0.0; doublings + 1],
            squares: vec![Estimate::new(); doublings + 1],
        };
        for replicate in 0..replicates {
            let options = Options {
                seed: desk.options.seed.wrapping_add(77 * replicate),
                ..Options::default()
            };
            let mut session = Session::new(scene, &by as &dyn Integrator, &options);
            for k in 0..=doublings {
                session.advance(1 << k, &desk.bar(name));
                if session.interrupted() {
                    return Err(DeskError::Interrupted);
                }
                let squares: Estimate = truth.squares(&session.film()).into_iter().collect();
                course.squares[k].add(squares.mean());
                course.seconds[k] += session.time().as_secs_f64() / replicates as f64;
            }
            rays += session.finish().rays.total();
        }
        courses.push(course);
    }
    say(desk, scene_name, &courses);
    chart(desk, scene_name, &courses)?;
    Ok(rays)
}

impl Course {
    /// The relative error after `2^k` samples.
    fn error(&self, k: usize) -> f64 {
        self.squares[k].mean().max(0.0).sqrt()
    }

    /// A line of the law's slope through the last point: error against samples or seconds.
    fn law(&self, slope: f64, last: f64) -> Line {
        let error = self.error(self.squares.len() - 1);
        Line {
            slope,
            intercept: libm::log(error) - slope * libm::log(last),
        }
    }
}

/// Where two laws meet.
fn crossing(a: Line, b: Line) -> f64 {
    libm::exp((b.intercept - a.intercept) / (a.slope - b.slope))
}

fn say(desk: &mut Desk, scene: &str, courses: &[Course]) {
    let last = courses[0].squares.len() - 1;
    let samples = f64::from(1_u32 << last);
    for course in courses {
        let name = course.name.replace('-', "_");
        for k in [4, last] {
            let says = format!(
                "error of {} after {} samples per pixel, {scene}, %",
                course.name,
                1 << k
            );
            desk.value(
                &format!("error_{name}_{scene}_{}", 1 << k),
                &says,
                100.0 * course.error(k),
            );
        }
        let says = format!(
            "seconds for {samples} samples per pixel by {}, {scene}",
            course.name
        );
        desk.value(&format!("time_{name}_{scene}"), &says, course.seconds[last]);
    }
    let [path, _, photons] = courses else { return };
    let ratio = path.error(4) / photons.error(4);
    let says =
        format!("error of path tracing over that of photons at 16 samples per pixel, {scene}");
    desk.value(&format!("ratio_{scene}"), &says, ratio);
    // From where the slower law of photons is above that of path tracing.
    let at = |p: f64, q: f64| crossing(path.law(-0.5, p), photons.law(-1.0 / 3.0, q));
    let says = format!(
        "samples per pixel from which path tracing has the smaller error, {scene}, by the laws"
    );
    desk.value(&format!("crossing_{scene}"), &says, at(samples, samples));
    let says =
        format!("seconds from which path tracing has the smaller error, {scene}, by the laws");
    let seconds = at(path.seconds[last], photons.seconds[last]);
    desk.value(&format!("time_crossing_{scene}"), &says, seconds);
}

fn chart(desk: &mut Desk, scene: &str, courses: &[Course]) -> Result<(), DeskError> {
    for (file, x_label, timed) in [
        (format!("samples_{scene}.svg"), "samples per pixel", false),
        (format!("time_{scene}.svg"), "seconds", true),
    ] {
        let curves = courses.iter().map(|course| {
            let points = (0..course.squares.len())
                .filter(|&k| course.error(k) > 0.0)
                .map(|k| {
                    let x = if timed {
                        course.seconds[k]
                    } else {
                        f64::from(1_u32 << k)
                    };
                    let root = course.squares[k].root();
                    (x, root.value, root.error)
                });
            Curve::measured(course.name, Style::MarksAndLine, points)
        });
        let chart = CurveChart {
            title: format!("Error against {x_label}: {scene}"),
            x_label: x_label.to_owned(),
            y_label: "relative error".to_owned(),
            x_axis: Axis::Log,
            y_axis: Axis::Log,
            curves: curves.collect(),
        };
        let caption = "Independent samples fall with slope -1/2. Photons begin lower where light is focused, and fall with -1/3.";
        desk.figure(&file, caption, chart.to_svg()?)?;
    }
    Ok(())
}

/// The caustic by all three, in the same time.
fn strip(desk: &mut Desk, scene: &Scene) -> Result<(), DeskError> {
    let scene = scene.clone().sized(desk.choose([200; 2], [40; 2]));
    let seconds = desk.choose(1.0, 0.2);
    let mut films = Vec::new();
    for name in METHODS {
        let by = made(name, &scene)?;
        let options = Options {
            seed: desk.options.seed,
            ..Options::default()
        };
        let mut session = Session::new(&scene, &by as &dyn Integrator, &options);
        while session.time().as_secs_f64() < seconds {
            let next = session.spp() + 1;
            session.advance(next, &desk.bar(name));
            if session.interrupted() {
                return Err(DeskError::Interrupted);
            }
        }
        let says = format!("samples per pixel by {name} in the pictures of equal time");
        desk.value(
            &format!("time_samples_{}", name.replace('-', "_")),
            &says,
            f64::from(session.spp()),
        );
        films.push(session.film());
    }
    let strip: Vec<&Film> = films.iter().collect();
    let caption =
        format!("The caustic after {seconds} s each: path tracing, light tracing, photons.");
    desk.picture("time_strip.png", &caption, &Film::beside(&strip), &scene)
}
