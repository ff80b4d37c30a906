//! From the eye, from the lamp, and by photons: a caustic and a box, error against samples and seconds.

use super::scene;
use halfdisk::integrators::{self, Integrator, Settings};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, HALF, Style};
use halfdisk::lab::experiment::cost::Reference;
use halfdisk::render::{Options, Session, render};
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::slope::Line;
use halfdisk::stats::{Estimate, Measurement};

/// Path tracing as the slides have it, with shadow rays; walks from the lights; and photons.
const METHODS: [&str; 3] = ["combine", "light-tracer", "photons"];

/// What a method reached after 1, 2, 4 … samples per pixel: seconds, and squared relative errors of replicates.
struct Course {
    name: &'static str,
    seconds: Vec<f64>,
    squares: Vec<Estimate>,
}

pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let side = desk.choose(24, 16);
    desk.value(
        "side",
        "pixels along each side of the pictures",
        f64::from(side),
    );
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
    let spp = desk.choose(192, 128);
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
    let (doublings, replicates) = (desk.choose(6, 5), 3);
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
            rays += session.rendered().rays.total();
        }
        courses.push(course);
    }
    say(desk, scene_name, &courses);
    chart(desk, scene_name, &courses)?;
    Ok(rays)
}

impl Course {
    /// The relative error after `2^k` samples.
    fn error(&self, k: usize) -> Measurement {
        self.squares[k].root()
    }

    /// The slope of its law: photons pay for their blur.
    fn slope(&self) -> f64 {
        if self.name == "photons" {
            -1.0 / 3.0
        } else {
            -0.5
        }
    }

    /// The law of its error, drawn through the last point, which took `last` samples or seconds.
    fn law(&self, last: f64) -> Line {
        let error = self.error(self.squares.len() - 1).value;
        Line {
            slope: self.slope(),
            intercept: libm::log(error) - self.slope() * libm::log(last),
        }
    }

    /// Samples per pixel, or seconds, of the point `k`.
    fn cost(&self, k: usize, timed: bool) -> f64 {
        if timed {
            self.seconds[k]
        } else {
            f64::from(1_u32 << k)
        }
    }
}

/// Where two laws meet.
fn crossing(a: Line, b: Line) -> f64 {
    libm::exp((b.intercept - a.intercept) / (a.slope - b.slope))
}

/// Samples per pixel, or seconds, from which on one method has a smaller error than another whose law is slower.
fn ahead_from([one, other]: [&Course; 2], timed: bool) -> f64 {
    let last = one.squares.len() - 1;
    let law = |course: &Course| course.law(course.cost(last, timed));
    crossing(law(one), law(other))
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
            let Measurement { value, error } = course.error(k).percent();
            let number = Number {
                error: Some(error),
                ..Number::new(&says, value)
            };
            desk.number(&format!("error_{name}_{scene}_{}", 1 << k), number);
        }
        let says = format!(
            "seconds for {samples} samples per pixel by {}, {scene}",
            course.name
        );
        desk.value(&format!("time_{name}_{scene}"), &says, course.seconds[last]);
    }
    let [path, light, photons] = courses else {
        return;
    };
    let [one, other] = [path, photons].map(|course| course.error(4));
    let ratio = one.value / other.value;
    let says =
        format!("error of path tracing over that of photons at 16 samples per pixel, {scene}");
    let number = Number {
        error: Some(ratio * (one.error / one.value).hypot(other.error / other.value)),
        ..Number::new(&says, ratio)
    };
    desk.number(&format!("ratio_{scene}"), number);
    // From where the slower law of photons is above those of path tracing and of light tracing.
    for (key, unit, course, timed) in [
        ("crossing", "samples per pixel", path, false),
        ("time_crossing", "seconds", path, true),
        ("time_crossing_light", "seconds", light, true),
    ] {
        let says = format!(
            "{unit} from which {} has a smaller error than photons, {scene}, by the laws",
            course.name
        );
        let from = ahead_from([course, photons], timed);
        desk.value(&format!("{key}_{scene}"), &says, from);
    }
}

fn chart(desk: &mut Desk, scene: &str, courses: &[Course]) -> Result<(), DeskError> {
    let what = match scene {
        "caustic" => "A caustic",
        _ => "The box with two blocks",
    };
    for (file, x_label, timed) in [
        (format!("samples_{scene}.svg"), "samples per pixel", false),
        (format!("time_{scene}.svg"), "seconds", true),
    ] {
        let mut curves = Vec::new();
        for (place, course) in courses.iter().enumerate() {
            let points = (0..course.squares.len())
                .map(|k| (course.cost(k, timed), course.error(k)))
                .filter(|(_, error)| error.value > 0.0)
                .map(|(x, error)| (x, error.value, error.error));
            let marks = Curve::measured(course.name, Style::Marks, points);
            curves.push(marks.coloured(place));
            let last = course.cost(course.squares.len() - 1, timed);
            let law = course.law(last);
            let ends = [course.cost(0, timed), 4.0 * last].map(|x| (x, law.at(x)));
            curves.push(Curve::new("", Style::Dashed, ends).coloured(place));
        }
        let chart = CurveChart {
            title: what.to_owned(),
            x_label: x_label.to_owned(),
            y_label: "relative error".to_owned(),
            x_axis: Axis::Log,
            y_axis: Axis::Log,
            curves,
        };
        let caption = format!(
            "{what}: relative error against {x_label}. Dashed: the laws through the last points, with slope -1/2 for walks from \
             the eye and from the light, and -1/3 for photons. Where two of them cross, the unbiased method gets ahead. \
             Bars: one standard error."
        );
        desk.figure(&file, &caption, chart.to_svg_at(HALF)?)?;
    }
    Ok(())
}

/// The caustic by all three, in the same time.
fn strip(desk: &mut Desk, scene: &Scene) -> Result<(), DeskError> {
    let scene = scene.clone().sized(desk.choose([120; 2], [40; 2]));
    let seconds = desk.choose(0.25, 0.05);
    desk.value(
        "time_of_strip",
        "seconds of each of the three pictures",
        seconds,
    );
    for (name, look) in METHODS.into_iter().zip([
        "Look at the single bright specks: each is a walk that found the lamp through the glass by chance.",
        "Fine grain, and a sharp rim.",
        "Look at the grain: it is as coarse as a disc, for each photon counts for all pixels near it. That is the blur.",
    ]) {
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
        let caption = format!("{name}, {seconds} s. {look}");
        let file = format!("time_{}.png", name.replace('-', "_"));
        desk.picture(&file, &caption, &session.film(), &scene)?;
    }
    Ok(())
}
