//! Patches against paths: when does the solution pay?

use super::shown;
use super::stays::{Off, squared_bias};
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Path, Radiosity};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::experiment::cost::Reference;
use halfdisk::radiosity::PatchSize;
use halfdisk::render::accuracy::Scale;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::{Scene, Tracer, gallery};
use halfdisk::stats::{Estimate, Measurement, jackknife};
use halfdisk::time::Moment;

/// Relative errors at which both are compared, in per cent.
const ERRORS: [u32; 3] = [5, 2, 1];
/// Samples per pixel of the pictures whose noise is measured.
const SAMPLES: u32 = 64;

/// What was measured of a method in one replicate.
#[derive(Clone, Copy, Default)]
struct Run {
    /// Seconds before the first sample.
    before: f64,
    /// Seconds of a sample of a pixel.
    sample: f64,
    /// Relative variance of a sample of a pixel.
    variance: f64,
}

/// The mean of some runs.
fn mean(runs: &[Run]) -> Run {
    let of = |f: fn(&Run) -> f64| runs.iter().map(f).sum::<f64>() / runs.len() as f64;
    Run {
        before: of(|r| r.before),
        sample: of(|r| r.sample),
        variance: of(|r| r.variance),
    }
}

/// The path tracer, one path at a time as patches are read: what vector instructions gain is no merit of the method.
struct OneByOne(Path);

impl Integrator for OneByOne {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        self.0.li(tracer, ray, stream)
    }
}

/// What both methods cost in a room, and the mean squared relative error that stays with patches.
struct Fought {
    path: Vec<Run>,
    patches: Vec<Run>,
    stays: Measurement,
    mesh: Option<f64>,
}

/// Lets both render three rooms; the rays that took.
pub fn work(desk: &mut Desk) -> Result<u64, DeskError> {
    let mut rays = 0;
    for (name, scene) in rooms(desk)? {
        desk.say(&format!("\npatches against paths: {name}"));
        rays += room(desk, name, &scene)?;
    }
    Ok(rays)
}

/// An empty room, the box with its blocks, and the box with a tall block of rough metal.
fn rooms(desk: &Desk) -> Result<[(&'static str, Scene); 3], DeskError> {
    let side = desk.choose(24, 16);
    let cornell = gallery::load("cornell")?.sized([side; 2]);
    let empty = cornell.changed(|said| said.objects.truncate(6))?;
    let gloss = cornell.changed(shown::with_metal)?;
    Ok([("empty", empty), ("blocks", cornell), ("metal", gloss)])
}

fn room(desk: &mut Desk, name: &str, scene: &Scene) -> Result<u64, DeskError> {
    let depth = 40;
    let number = PatchSize::Number(desk.choose(500, 200));
    let mut rays = 0;
    let mut film = |by: &dyn Integrator, spp: u32, seed: u64| -> Result<Rendered, DeskError> {
        let options = Options {
            spp,
            seed: 1000 * desk.options.seed + seed,
            ..Options::default()
        };
        let rendered = render(scene, by, &options, &desk.bar(name));
        rays += rendered.rays.total();
        match rendered.interrupted {
            true => Err(DeskError::Interrupted),
            false => Ok(rendered),
        }
    };
    let path = Path::new(depth);
    let spp = desk.choose(64, 40);
    let halves = [film(&path, spp, 1)?, film(&path, spp, 2)?];
    let truth = Reference::new(&halves[0].film, &halves[1].film, spp);
    let pixels = f64::from(scene.size[0] * scene.size[1]);
    let mut measure = |by: &dyn Integrator, before: f64, seed: u64| -> Result<Run, DeskError> {
        let rendered = film(by, SAMPLES, seed)?;
        let variances: Estimate = truth.required(&rendered.film, 1.0).into_iter().collect();
        Ok(Run {
            before,
            sample: rendered.time.as_secs_f64() / (f64::from(SAMPLES) * pixels),
            variance: variances.mean(),
        })
    };
    let (mut of_path, mut of_patches) = (Vec::new(), Vec::new());
    let mut solved = None;
    for replicate in 0..desk.choose(3_u64, 3) {
        let start = Moment::now();
        let patches = Radiosity::new(scene, depth, number, &())?;
        let before = start.elapsed().unwrap_or_default().as_secs_f64();
        // In turns, each first once in two.
        if replicate % 2 == 0 {
            of_path.push(measure(&OneByOne(path), 0.0, 10 + replicate)?);
        }
        of_patches.push(measure(&patches, before, 20 + replicate)?);
        if replicate % 2 == 1 {
            of_path.push(measure(&OneByOne(path), 0.0, 10 + replicate)?);
        }
        solved = Some(patches);
    }
    let Some(patches) = solved else {
        return Ok(rays);
    };
    let off = film(
        &Off {
            patches: &patches,
            path,
        },
        desk.choose(96, 64),
        3,
    )?;
    let fought = Fought {
        path: of_path,
        patches: of_patches,
        stays: squared_bias(&off.film, &Scale::of(&truth.picture)),
        mesh: patches.solved().and_then(|report| report.mesh_error),
    };
    say(desk, name, &fought);
    chart(desk, name, &fought)?;
    Ok(rays)
}

// ANCHOR: break_even
/// The points at which patches and paths have cost the same at a relative error: the time before
/// the first point, over what each point saves. Infinite where patches do not reach the error, or
/// save nothing.
///
/// * `stays`: the squared relative error that no sample takes from patches.
fn break_even(path: &Run, patches: &Run, stays: f64, error: f64) -> f64 {
    let time = |run: &Run, stays: f64| {
        let noise = (error * error - stays).max(0.0);
        run.sample * run.variance / noise
    };
    let saved = time(path, 0.0) - time(patches, stays);
    if saved > 0.0 {
        patches.before / saved
    } else {
        f64::INFINITY
    }
}
// ANCHOR_END: break_even

impl Fought {
    /// The break-even in points at a relative error, with its standard error: by leaving out replicates, and
    /// by what stays being not known better. None of it where either end has no break-even.
    fn points(&self, error: f64) -> (f64, Option<f64>) {
        let stays = self.stays.value.max(0.0);
        let at = |path: &[Run], patches: &[Run], stays| {
            break_even(&mean(path), &mean(patches), stays, error)
        };
        let points = at(&self.path, &self.patches, stays);
        let without = |r: usize| {
            let others = |runs: &[Run]| [&runs[..r], &runs[r + 1..]].concat();
            at(&others(&self.path), &others(&self.patches), stays)
        };
        let left_out: Vec<f64> = (0..self.path.len()).map(without).collect();
        let more = at(&self.path, &self.patches, stays + self.stays.error);
        let spread = jackknife(&left_out).hypot(more - points);
        (points, spread.is_finite().then_some(spread))
    }
}

fn say(desk: &mut Desk, name: &str, fought: &Fought) {
    let (path, patches) = (mean(&fought.path), mean(&fought.patches));
    // The error of a root, where the square is known well enough to have one.
    let (square, its_error) = (fought.stays.value, fought.stays.error);
    let stays = square.max(0.0).sqrt();
    let error = (square + its_error).max(0.0).sqrt() - stays;
    let number = Number {
        error: Some(100.0 * error),
        ..Number::new("error that stays with patches, %", 100.0 * stays)
    };
    desk.number(&format!("stays_{name}"), number);
    if let Some(mesh) = fought.mesh {
        let says = "error of the mesh by two meshes, of the indirect light, %";
        desk.value(&format!("mesh_{name}"), says, 100.0 * mesh);
    }
    let says = "seconds before the first sample";
    desk.value(&format!("time_before_{name}"), says, patches.before);
    for (run, who, words) in [
        (&path, "path", "of a path"),
        (&patches, "patches", "of a sample of patches"),
    ] {
        let says = format!("noise {words}, %");
        desk.value(
            &format!("noise_{who}_{name}"),
            &says,
            100.0 * run.variance.sqrt(),
        );
        let says = format!("microseconds {words}");
        desk.value(
            &format!("time_sample_{who}_{name}"),
            &says,
            1e6 * run.sample,
        );
    }
    for error in ERRORS {
        let (points, spread) = fought.points(f64::from(error) / 100.0);
        let never = !points.is_finite();
        let says = format!("points from which patches pay, at {error} %");
        let number = Number {
            error: spread,
            ..Number::new(&says, if never { -1.0 } else { points })
        };
        desk.number(&format!("time_points_{name}_{error}"), number);
        let says = format!("views of 256 x 256 points from which patches pay, at {error} %");
        let views = if never { -1.0 } else { points / 65_536.0 };
        desk.value(&format!("time_views_{name}_{error}"), &says, views);
    }
}

/// The error after so many seconds for a view.
fn chart(desk: &mut Desk, name: &str, fought: &Fought) -> Result<(), DeskError> {
    let curve = |who: &str, runs: &[Run], stays: f64| {
        let run = mean(runs);
        let samples = (0..14).map(|k| f64::from(1 << k));
        let points = samples.map(|n| {
            let seconds = run.before + 65_536.0 * n * run.sample;
            (seconds, (run.variance / n + stays).sqrt())
        });
        Curve::new(who, Style::MarksAndLine, points)
    };
    let chart = CurveChart {
        title: format!("A view of 256 x 256 points: {name}"),
        x_label: "seconds, the patches included".to_owned(),
        y_label: "relative error".to_owned(),
        x_axis: Axis::Log,
        y_axis: Axis::Log,
        curves: vec![
            curve("path", &fought.path, 0.0),
            curve("radiosity", &fought.patches, fought.stays.value.max(0.0)),
        ],
    };
    let caption = "Error against seconds, from the noise and the bias measured in small pictures. Patches begin late, and \
                   level out at the error of their mesh.";
    desk.figure(&format!("time_{name}.svg"), caption, chart.to_svg()?)?;
    Ok(())
}
