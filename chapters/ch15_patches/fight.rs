//! Patches against paths: when does the solution pay?

use super::shown;
use halfdisk::integrators::{Integrator, Path, Radiosity};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::drawing::{Axis, Curve, CurveChart, Style};
use halfdisk::lab::experiment::cost::Reference;
use halfdisk::radiosity::PatchSize;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::scene::{Scene, gallery};
use halfdisk::stats::{Estimate, jackknife};
use halfdisk::time::Moment;

/// Relative errors at which both are compared, in per cent.
const ERRORS: [u32; 3] = [5, 2, 1];
/// Samples per pixel of a small picture and of a large one.
const SIZES: [u32; 2] = [4, 64];

/// What was measured of a method in one replicate.
#[derive(Clone, Copy, Default)]
struct Run {
    /// Seconds before the first sample.
    before: f64,
    /// Seconds of a sample of a pixel.
    sample: f64,
    /// Mean squared relative error by size.
    squares: [f64; 2],
}

impl Run {
    /// The variance of a sample and the square that stays, from two sizes.
    fn parts(&self) -> [f64; 2] {
        let [small, large] = self.squares;
        let [n, m] = SIZES.map(f64::from);
        let variance = (small - large) / (1.0 / n - 1.0 / m);
        [variance, (large - variance / m).max(0.0)]
    }
}

/// The mean of some runs.
fn mean(runs: &[Run]) -> Run {
    let n = runs.len() as f64;
    let of = |f: fn(&Run) -> f64| runs.iter().map(f).sum::<f64>() / n;
    Run {
        before: of(|r| r.before),
        sample: of(|r| r.sample),
        squares: [of(|r| r.squares[0]), of(|r| r.squares[1])],
    }
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
    let side = desk.choose(64, 24);
    let cornell = gallery::load("cornell")?.sized([side; 2]);
    let empty = cornell.changed(|said| said.objects.truncate(6))?;
    let gloss = cornell.changed(shown::with_metal)?;
    Ok([("empty", empty), ("blocks", cornell), ("metal", gloss)])
}

fn room(desk: &mut Desk, name: &str, scene: &Scene) -> Result<u64, DeskError> {
    let depth = 40;
    let number = PatchSize::Number(desk.choose(1000, 250));
    let spp = desk.choose(2048, 64);
    let film =
        |desk: &Desk, by: &dyn Integrator, spp: u32, seed: u64| -> Result<Rendered, DeskError> {
            let options = Options {
                spp,
                seed: 1000 * desk.options.seed + seed,
                ..Options::default()
            };
            let rendered = render(scene, &By(by), &options, &desk.bar(name));
            match rendered.interrupted {
                true => Err(DeskError::Interrupted),
                false => Ok(rendered),
            }
        };
    let path = Path::new(depth);
    let halves = [film(desk, &path, spp, 1)?, film(desk, &path, spp, 2)?];
    let mut rays = halves.iter().map(|half| half.rays.total()).sum();
    let truth = Reference::new(&halves[0].film, &halves[1].film, spp);
    let pixels = f64::from(scene.size[0] * scene.size[1]);
    let replicates: u32 = desk.choose(8, 3);
    let mut runs = [Vec::new(), Vec::new()];
    let mut mesh = None;
    for replicate in 0..replicates {
        // In turns, each first once in two.
        for turn in 0..2 {
            let which = (turn + replicate as usize) % 2;
            let start = Moment::now();
            let patches = match which {
                0 => None,
                _ => Some(Radiosity::new(scene, depth, number, &())?),
            };
            let mut run = Run {
                before: start.elapsed().unwrap_or_default().as_secs_f64(),
                ..Run::default()
            };
            let by: &dyn Integrator = match &patches {
                None => &path,
                Some(patches) => patches,
            };
            mesh = mesh.or(by.solved().and_then(|report| report.mesh_error));
            for (k, spp) in SIZES.into_iter().enumerate() {
                // The same random numbers for both: of their noise, less is in the difference.
                let seed = 10 + 2 * u64::from(replicate) + k as u64;
                let rendered = film(desk, by, spp, seed)?;
                let squares: Estimate = truth.squares(&rendered.film).into_iter().collect();
                run.squares[k] = squares.mean();
                run.sample = rendered.time.as_secs_f64() / (f64::from(spp) * pixels);
                rays += rendered.rays.total();
            }
            runs[which].push(run);
        }
    }
    say(desk, name, &runs, mesh);
    chart(desk, name, &runs)?;
    Ok(rays)
}

/// An integrator behind a reference.
struct By<'a>(&'a dyn Integrator);

impl Integrator for By<'_> {
    fn li(
        &self,
        tracer: &mut halfdisk::scene::Tracer,
        ray: &halfdisk::geometry::Ray,
        stream: &halfdisk::sampling::stream::Stream,
    ) -> halfdisk::color::Rgb {
        self.0.li(tracer, ray, stream)
    }
}

// ANCHOR: break_even
/// The points at which patches and paths have cost the same at a relative error: the time before the first
/// point, over what each point saves. Without end where patches do not reach it, or save nothing.
fn break_even(path: &Run, patches: &Run, error: f64) -> f64 {
    let time = |run: &Run, stays: f64| {
        let noise = (error * error - stays).max(0.0);
        run.sample * run.parts()[0] / noise
    };
    // Of paths nothing stays.
    let saved = time(path, 0.0) - time(patches, patches.parts()[1]);
    if saved > 0.0 {
        patches.before / saved
    } else {
        f64::INFINITY
    }
}
// ANCHOR_END: break_even

fn say(desk: &mut Desk, name: &str, runs: &[Vec<Run>; 2], mesh: Option<f64>) {
    let [path, patches] = [mean(&runs[0]), mean(&runs[1])];
    let percent = |square: f64| 100.0 * square.sqrt();
    desk.value(
        &format!("stays_{name}"),
        "error that stays with patches, %",
        percent(patches.parts()[1]),
    );
    if let Some(mesh) = mesh {
        let says = "error of the mesh by two meshes, of the indirect light, %";
        desk.value(&format!("mesh_{name}"), says, 100.0 * mesh);
    }
    desk.value(
        &format!("noise_path_{name}"),
        "noise of a path, %",
        percent(path.parts()[0]),
    );
    desk.value(
        &format!("noise_patches_{name}"),
        "noise of a sample of patches, %",
        percent(patches.parts()[0]),
    );
    desk.value(
        &format!("time_before_{name}"),
        "seconds before the first sample",
        patches.before,
    );
    for (run, who) in [(&path, "path"), (&patches, "patches")] {
        let says = format!("microseconds of a sample, {who}");
        desk.value(
            &format!("time_sample_{who}_{name}"),
            &says,
            1e6 * run.sample,
        );
    }
    for error in ERRORS {
        let at = |path: &Run, patches: &Run| break_even(path, patches, f64::from(error) / 100.0);
        let points = at(&path, &patches);
        let without = |r: usize| {
            let others = |runs: &Vec<Run>| {
                let mut others = runs.clone();
                others.remove(r);
                mean(&others)
            };
            at(&others(&runs[0]), &others(&runs[1]))
        };
        let left_out: Vec<f64> = (0..runs[0].len()).map(without).collect();
        let says = format!("points from which patches pay, at {error} %");
        let spread = jackknife(&left_out);
        desk.number(
            &format!("time_points_{name}_{error}"),
            Number {
                error: spread.is_finite().then_some(spread),
                ..Number::new(&says, if points.is_finite() { points } else { -1.0 })
            },
        );
        let says = format!("views of 256 x 256 points from which patches pay, at {error} %");
        let views = if points.is_finite() {
            points / 65_536.0
        } else {
            -1.0
        };
        desk.value(&format!("time_views_{name}_{error}"), &says, views);
    }
}

/// The error after so many seconds for a view.
fn chart(desk: &mut Desk, name: &str, runs: &[Vec<Run>; 2]) -> Result<(), DeskError> {
    let curve = |who: &str, run: Run| {
        // Of paths nothing stays.
        let [variance, stays] = match run.before > 1e-4 {
            true => run.parts(),
            false => [run.parts()[0], 0.0],
        };
        let samples = (0..14).map(|k| f64::from(1 << k));
        let points = samples.map(|n| {
            let seconds = run.before + 65_536.0 * n * run.sample;
            (seconds, (variance / n + stays).sqrt())
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
            curve("path", mean(&runs[0])),
            curve("radiosity", mean(&runs[1])),
        ],
    };
    let caption = "Error against seconds, from the noise and the bias measured in small pictures. Patches begin late, and \
                   level out at the error of their mesh.";
    desk.figure(&format!("time_{name}.svg"), caption, chart.to_svg()?)?;
    Ok(())
}
