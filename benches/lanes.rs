//! What lanes gain: samples and rays a second of one thread, path by path and sixteen at a time, by each set of
//! instructions that the processor has. All renders of a scene have the same bytes, which is checked. Where `valgrind` is
//! installed it counts the instructions of a sample, by the widest set that it knows, AVX2. `benches/peers.py` compares with another renderer.

#![allow(clippy::print_stdout)]
#![allow(missing_docs, clippy::expect_used)]

use fearless_simd::Level;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Passes, Path, PathInLanes};
use halfdisk::numeric::lanes::{level_name, levels};
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::scene::{Scene, Tracer, gallery};
use std::process::Command;

/// Renders of each kind, in turns.
const TURNS: usize = 5;

const SCENES: [&str; 4] = ["cornell", "spheres", "caustic", "mesh"];
const SIZE: [u32; 2] = [96, 96];
/// What a run is told that renders one picture for `valgrind`.
const RENDER_ONE: &str = "--render-one";

/// `path`, one by one or in lanes by some instructions.
struct By {
    path: Path,
    level: Option<Level>,
}

impl Integrator for By {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        self.path.li(tracer, ray, stream)
    }

    fn in_lanes<'s>(&self, scene: &'s Scene) -> Option<PathInLanes<'s>> {
        let level = self.level?;
        PathInLanes::new(&self.path, scene).map(|lanes| lanes.by(level))
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        self.path.passes(scene)
    }
}

fn main() {
    let mut arguments = std::env::args().skip_while(|argument| argument != RENDER_ONE);
    if let (Some(_), Some(name), Some(spp)) = (arguments.next(), arguments.next(), arguments.next())
    {
        render_one(&name, spp.parse().expect("a number of samples"));
        return;
    }
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("a thread").install(|| {
        println!("| scene | by | samples/s | rays/s | times one by one |");
        println!("|---|---|---|---|---|");
        for name in SCENES {
            compare(name);
        }
    });
    println!("instructions a sample:");
    for name in SCENES {
        match instructions(name) {
            Some(count) => println!("{name}: {count:.0}"),
            None => println!("{name}: not counted, for valgrind could not be run"),
        }
    }
}

fn render_one(name: &str, spp: u32) {
    let scene = gallery::load(name).expect("a scene of the gallery");
    let path = Path::new(scene.suggested.max_depth);
    let level = Some(Level::new());
    let sampler = Sampler::Sobol;
    let options = Options {
        spp,
        sampler,
        ..Options::default()
    };
    render(&scene.sized(SIZE), &By { path, level }, &options, &());
}

/// The instructions of a sample, from those of two renders, so that what both do once does not count.
fn instructions(name: &str) -> Option<f64> {
    let counted = |spp: u32| {
        let program = std::env::current_exe().ok()?;
        let mut valgrind = Command::new("valgrind");
        valgrind
            .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
            .arg(program);
        let run = valgrind
            .args([RENDER_ONE, name, &spp.to_string()])
            .output()
            .ok()?;
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        let line = said.lines().find(|line| line.contains("Collected"))?;
        line.rsplit(' ').next()?.parse::<f64>().ok()
    };
    let samples = f64::from(4 * SIZE[0] * SIZE[1]);
    Some((counted(8)? - counted(4)?) / samples)
}

fn compare(name: &str) {
    let scene = gallery::load(name).expect("a scene of the gallery");
    let scene = scene.sized(SIZE);
    let path = Path::new(scene.suggested.max_depth);
    let ways: Vec<Option<Level>> = std::iter::once(None)
        .chain(levels().into_iter().map(Some))
        .collect();
    let options = Options {
        spp: 64,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let take = |level: &Option<Level>| {
        let level = *level;
        render(&scene, &By { path, level }, &options, &())
    };
    let turns: Vec<Vec<Rendered>> = (0..TURNS)
        .map(|_| ways.iter().map(take).collect())
        .collect();
    let same = turns.iter().flatten().all(|r| r.film == turns[0][0].film);
    assert!(same, "{name}: another picture");
    let samples = f64::from(64 * SIZE[0] * SIZE[1]);
    for (i, way) in ways.iter().enumerate() {
        let seconds = |turn: &Vec<Rendered>| turn[i].time.as_secs_f64();
        let time = median(turns.iter().map(seconds));
        let gain = median(
            turns
                .iter()
                .map(|turn| turn[0].time.as_secs_f64() / seconds(turn)),
        );
        let rays = turns[0][i].rays.total() as f64;
        let by = way.map_or("one by one", level_name);
        let million = |n: f64| n / time / 1e6;
        println!(
            "| {name} | {by} | {:.2} M | {:.1} M | {gain:.2} |",
            million(samples),
            million(rays)
        );
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut sorted: Vec<f64> = values.collect();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}
