//! Scenes that nobody thought of: what a path finds by choosing one lamp must be what a walk finds by
//! chance, or, where lamps have no extent, what asking all of them finds.
//!
//! Shapes and lamps of all kinds lie anywhere, in scenes of 1e-3 to 1e4 units; in a third of them
//! lamps lie in the planes of other surfaces or in each other's place. Image means are compared over
//! sixteen seeds. A difference counts if it stands with sixteen times the samples and other seeds.

use halfdisk::integrators::{Combine, Integrator, Kajiya, Path};
use halfdisk::render::{Options, render};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::{Numbers, Purpose, Sampler, Stream};
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, read::SceneError};
use halfdisk::stats::Estimate;
use rayon::prelude::*;
use std::fmt::Write;

const SEEDS: u64 = 16;
/// The level of a first comparison: of Student's distribution with about 15 to 30 degrees of freedom
/// two in a thousand lie beyond, and are looked at again.
const SUSPICIOUS: f64 = 3.5;
const MAX_DEPTH: u32 = 6;

/// Draws what a scene is made of.
struct Draw {
    numbers: Numbers,
    scale: f32,
}

impl Draw {
    fn one(&mut self) -> f32 {
        self.numbers.one()
    }

    fn up_to(&mut self, n: usize) -> usize {
        ((self.one() * n as f32) as usize).min(n - 1)
    }

    fn chance(&mut self, p: f32) -> bool {
        self.one() < p
    }

    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.one()
    }

    /// A place in the room.
    fn place(&mut self) -> [f32; 3] {
        [(); 3].map(|()| self.between(-1.0, 1.0) * self.scale)
    }

    /// An edge or a radius, most of them a share of the room, some tiny.
    fn size(&mut self) -> f32 {
        let tiny = if self.chance(0.1) { 1e-3 } else { 1.0 };
        self.between(0.2, 0.9) * self.scale * tiny
    }

    fn direction(&mut self) -> [f32; 3] {
        let v = [(); 3].map(|()| self.between(-1.0, 1.0));
        let length = v.iter().map(|x| x * x).sum::<f32>().sqrt().max(0.1);
        v.map(|x| x / length)
    }

    fn edge(&mut self) -> [f32; 3] {
        let (size, direction) = (self.size(), self.direction());
        direction.map(|x| x * size)
    }

    /// A quad: its corner and edges.
    fn quad(&mut self) -> [[f32; 3]; 3] {
        let (corner, u) = (self.place(), self.edge());
        // Half of all along the axes, where rounding makes planes coincide exactly.
        if self.chance(0.5) {
            let (a, b) = (self.size(), self.size());
            return match self.up_to(3) {
                0 => [corner, [a, 0.0, 0.0], [0.0, b, 0.0]],
                1 => [corner, [0.0, a, 0.0], [0.0, 0.0, b]],
                _ => [corner, [0.0, 0.0, a], [b, 0.0, 0.0]],
            };
        }
        [corner, u, self.edge()]
    }

    fn material(&mut self) -> &'static str {
        [
            "white", "grey", "red", "white", "grey", "shiny", "mirror", "glass", "both",
        ][self.up_to(9)]
    }
}

fn object(text: &mut String, what: &str, shape: &str) {
    let _ = writeln!(text, "[[objects]]\n{what}\n{shape}");
}

fn quad([corner, u, v]: [[f32; 3]; 3]) -> String {
    format!("quad = {{ corner = {corner:?}, u = {u:?}, v = {v:?} }}")
}

fn plus<const N: usize>(a: [f32; N], b: [f32; N], share: f32) -> [f32; N] {
    std::array::from_fn(|i| a[i] + share * b[i])
}

/// A scene file and whether all its lamps have extent.
fn random_scene(seed: u64) -> (String, bool) {
    let mut draw = Draw {
        numbers: Stream::new(seed, 0, 0).at(0, Purpose::Integrand),
        scale: 1.0,
    };
    draw.scale = libm::pow(10.0, f64::from(draw.between(-3.0, 4.0))) as f32;
    let scale = draw.scale;
    let mut text = format!(
        "name = 'random'\ncamera = {{ from = [0, {}, {}], to = [0, 0, 0], fov = 50, shutter = [0, 1] }}\n\
         film.size = [8, 8]\n\
         [materials]\nwhite.lambert.albedo = 0.8\ngrey.lambert.albedo = 0.4\nred.lambert.albedo = [0.7, 0.2, 0.1]\n\
         shiny.glossy = {{ reflectance = 0.8, roughness = 0.4 }}\nmirror.mirror.reflectance = 0.8\n\
         glass.glass.ior = 1.5\nboth.mixture = {{ kd = 0.4, ks = 0.3, kt = 0.1, ior = 1.3 }}\n",
        0.3 * scale,
        -2.2 * scale
    );
    let extent = draw.chance(0.7);
    if draw.chance(0.4) {
        let _ = writeln!(
            text,
            "\n[environment]\nradiance = {}",
            draw.between(0.05, 0.6)
        );
    }
    // A floor, so that something is lit.
    let floor = [
        [-1.5 * scale, -scale, -1.5 * scale],
        [0.0, 0.0, 3.0 * scale],
        [3.0 * scale, 0.0, 0.0],
    ];
    object(&mut text, "material = 'white'", &quad(floor));
    let mut quads = vec![floor];
    for _ in 0..1 + draw.up_to(4) {
        let material = format!("material = '{}'", draw.material());
        let shape = match draw.up_to(4) {
            0 => format!(
                "sphere = {{ center = {:?}, radius = {} }}",
                draw.place(),
                0.6 * draw.size()
            ),
            1 => {
                let place = draw.place();
                let (b, c) = (plus(place, draw.edge(), 1.0), plus(place, draw.edge(), 1.0));
                format!("triangle = {{ a = {place:?}, b = {b:?}, c = {c:?} }}")
            }
            2 => format!(
                "bumpy_sphere = {{ center = {:?}, radius = {}, columns = 8, rows = 5 }}",
                draw.place(),
                0.5 * draw.size()
            ),
            _ => {
                quads.push(draw.quad());
                quad(quads[quads.len() - 1])
            }
        };
        object(&mut text, &material, &shape);
    }
    for _ in 0..1 + draw.up_to(3) {
        lamp(&mut text, &mut draw);
    }
    if draw.chance(1.0 / 3.0) {
        for _ in 0..1 + draw.up_to(2) {
            touching(&mut text, &mut draw, &quads);
        }
    }
    if !extent {
        for _ in 0..1 + draw.up_to(2) {
            let strength = draw.between(0.5, 3.0);
            let _ = if draw.chance(0.6) {
                let intensity = strength * scale * scale;
                writeln!(
                    text,
                    "[[lights]]\npoint = {{ position = {:?}, intensity = {intensity} }}",
                    draw.place()
                )
            } else {
                let mut direction = draw.direction();
                direction[1] = -direction[1].abs() - 0.2;
                writeln!(
                    text,
                    "[[lights]]\ndirectional = {{ direction = {direction:?}, irradiance = {strength} }}"
                )
            };
        }
    }
    (text, extent)
}

/// A lamp somewhere.
fn lamp(text: &mut String, draw: &mut Draw) {
    let mut what = format!("emits = {}", draw.between(0.5, 6.0));
    if draw.chance(0.3) {
        let _ = write!(what, "\nmaterial = '{}'", draw.material());
    }
    if draw.chance(0.15) {
        let _ = write!(what, "\nmotion = {:?}", draw.edge());
    }
    let shape = match draw.up_to(5) {
        0 | 1 => format!(
            "sphere = {{ center = {:?}, radius = {} }}",
            draw.place(),
            0.6 * draw.size()
        ),
        2 => {
            let place = draw.place();
            let (b, c) = (plus(place, draw.edge(), 1.5), plus(place, draw.edge(), 1.5));
            format!("two_sided = true\ntriangle = {{ a = {place:?}, b = {b:?}, c = {c:?} }}")
        }
        _ => {
            let two_sided = if draw.chance(0.7) {
                "two_sided = true\n"
            } else {
                ""
            };
            format!("{two_sided}{}", quad(draw.quad()))
        }
    };
    object(text, &what, &shape);
}

/// A lamp in the plane or the place of another surface, or as near to it as a rounding.
fn touching(text: &mut String, draw: &mut Draw, quads: &[[[f32; 3]; 3]]) {
    let [corner, u, v] = quads[draw.up_to(quads.len())];
    let what = format!("emits = {}", draw.between(0.5, 6.0));
    let two_sided = if draw.chance(0.5) {
        "two_sided = true\n"
    } else {
        ""
    };
    let lamp = match draw.up_to(4) {
        // The very place, from another corner, or turned over.
        0 => [
            plus(plus(corner, u, 1.0), v, 1.0),
            u.map(|x| -x),
            v.map(|x| -x),
        ],
        1 => [corner, v, u],
        // A part of it.
        2 => [
            plus(
                plus(corner, u, draw.between(0.0, 0.5)),
                v,
                draw.between(0.0, 0.5),
            ),
            u.map(|x| 0.5 * x),
            v.map(|x| 0.5 * x),
        ],
        // A little beside it.
        _ => {
            let exponent = f64::from(draw.between(-9.0, -3.0));
            let beside = libm::pow(10.0, exponent) as f32 * draw.scale;
            let direction = draw.direction();
            [plus(corner, direction, beside), u, v]
        }
    };
    object(text, &what, &format!("{two_sided}{}", quad(lamp)));
    if draw.chance(0.3) {
        // Two lamps in one place.
        let [corner, u, v] = lamp;
        object(
            text,
            "emits = 2",
            &quad([plus(corner, v, 1.0), u, v.map(|x| -x)]),
        );
    }
}

fn load(text: &str) -> Result<Scene, SceneError> {
    gallery::from_text(
        Source {
            file: "random.toml",
            text,
        },
        None,
        |_| {},
    )
}

/// The mean of the pictures of some seeds.
fn means(scene: &Scene, integrator: &dyn Integrator, first_seed: u64, spp: u32) -> Estimate {
    let one = |seed| {
        let options = Options {
            spp,
            seed: first_seed + seed,
            sampler: Sampler::Sobol,
            ..Options::default()
        };
        render(scene, integrator, &options, &()).film.mean().0
    };
    (0..SEEDS).map(one).collect()
}

/// How two ways compare.
struct Compared {
    z: f64,
    /// The smallest bias that would be rejected for certain, relative to the mean; `None` for black.
    smallest: Option<f64>,
    says: String,
}

fn compare(seed: u64, times: u32) -> Compared {
    let (text, extent) = random_scene(seed);
    let scene = load(&text).unwrap_or_else(|e| panic!("{seed}: {e}\n{text}"));
    let first_seed = seed.wrapping_mul(1000) + u64::from(times);
    // Walks from the eye alone, to which `path` is compared, find no caustics of points.
    let path = match scene.inventory.point_lights {
        0 => Path::new(MAX_DEPTH),
        _ => Path::from_eye(MAX_DEPTH),
    };
    let path = means(&scene, &path, first_seed, 64 * times);
    let (max_depth, heuristic) = (MAX_DEPTH, Heuristic::Power);
    let by_chance = || means(&scene, &Kajiya { max_depth }, first_seed + 500, 192 * times);
    let by_asking_all = || {
        let combine = Combine {
            max_depth,
            heuristic,
        };
        means(&scene, &combine, first_seed + 500, 64 * times)
    };
    // Chance that found nothing at all knows nothing: its scatter is no error.
    let found = extent.then(by_chance).filter(|found| found.mean() > 0.0);
    let plain = found.unwrap_or_else(by_asking_all);
    let error = path.std_error().hypot(plain.std_error());
    let (a, b) = (path.mean(), plain.mean());
    let z = if a == b { 0.0 } else { (a - b) / error };
    Compared {
        z,
        smallest: (b > 0.0).then_some(SUSPICIOUS * error / b),
        says: format!("{seed}: path {a:.6e}, plain {b:.6e} +- {error:.1e}, z {z:.2}"),
    }
}

/// Compares the scenes of these seeds, and fails if any difference stands.
fn all_agree(seeds: std::ops::Range<u64>) {
    let compared: Vec<Compared> = seeds
        .into_par_iter()
        .map(|seed| {
            let first = compare(seed, 1);
            if first.z.abs() <= SUSPICIOUS {
                return first;
            }
            let again = compare(seed, 16);
            Compared {
                says: format!("{}; again {}", first.says, again.says),
                ..again
            }
        })
        .collect();
    let mut smallest: Vec<f64> = compared.iter().filter_map(|c| c.smallest).collect();
    smallest.sort_by(f64::total_cmp);
    let black = compared.len() - smallest.len();
    let median = smallest[smallest.len() / 2];
    println!(
        "{} scenes, {black} of them black; smallest bias seen: median {:.2} %, nine of ten {:.2} %",
        compared.len(),
        100.0 * median,
        100.0 * smallest[smallest.len() * 9 / 10]
    );
    let again = compared.iter().filter(|c| c.says.contains("again"));
    again.for_each(|c| println!("{}", c.says));
    let stands: Vec<&str> = compared
        .iter()
        .filter(|c| c.z.abs() > SUSPICIOUS)
        .map(|c| c.says.as_str())
        .collect();
    assert!(stands.is_empty(), "{stands:#?}");
    assert!(median < 0.02, "the comparisons see nothing: {median}");
}

#[test]
fn a_path_finds_what_a_walk_finds_in_random_scenes() {
    all_agree(0..100);
}

/// As many as the environment variable `SCENES` says, or a thousand.
#[test]
#[ignore = "takes minutes"]
fn long_random_scenes() {
    let count = std::env::var("SCENES").ok().and_then(|n| n.parse().ok());
    all_agree(1000..1000 + count.unwrap_or(1000));
}
