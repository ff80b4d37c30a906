//! What lanes gain: samples and rays a second of one thread, path by path and sixteen at a time, by each set of
//! instructions that the processor has. All renders of a scene have the same bytes, which is checked.

#![allow(clippy::print_stdout)]
#![allow(missing_docs, clippy::expect_used)]

use fearless_simd::Level;
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{Integrator, Path, PathInLanes};
use halfdisk::numeric::lanes::{level_name, levels};
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::{Sampler, Stream};
use halfdisk::scene::{Scene, Tracer, gallery};

/// Renders of each kind, in turns.
const TURNS: usize = 5;

/// `path` from the eye alone, one by one or in lanes by some instructions.
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
}

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("a thread").install(|| {
        println!("| scene | by | samples/s | rays/s | times one by one |");
        println!("|---|---|---|---|---|");
        for name in ["cornell", "spheres", "caustic", "mesh"] {
            compare(name);
        }
    });
}

fn compare(name: &str) {
    let scene = gallery::load(name).expect("a scene of the gallery");
    let scene = scene.sized([96, 96]);
    let path = Path::from_eye(scene.suggested.max_depth);
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
    let samples = 96.0 * 96.0 * 64.0;
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
