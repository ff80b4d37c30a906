//! Light that walks from the lights bring to the eye is that which walks from the eye find.

use crate::checks::{alike, unlike};
use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::integrators::{
    Arrival, FilteredPath, Integrator, LightTracer, Pass, Passes, Path, Prepared,
};
use halfdisk::notation::Expression;
use halfdisk::render::{Options, Rendered, compare, render};
use halfdisk::sampling::stream::{Purpose, Sampler, Stream};
use halfdisk::scene::gallery::{self, GALLERY};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, Tracer};
use halfdisk::stats::Estimate;

/// What [`LightTracer`] finds of a lamp with extent.
const FOUND: &str = "L((D|S|G)*(D|G))?E";

fn rendered(scene: &Scene, integrator: &dyn Integrator, spp: u32, seed: u64) -> Rendered {
    // Evenly, so that the edges of lamps that are seen make little noise.
    let options = Options {
        spp,
        seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let rendered = render(scene, integrator, &options, &());
    assert_eq!(rendered.faults, Default::default(), "{}", scene.name);
    rendered
}

fn by_path(scene: &Scene, max_depth: u32, spp: u32) -> Rendered {
    let paths: Expression = FOUND.parse().unwrap();
    let paths = paths.eye_first();
    let path = Path::new(max_depth);
    rendered(scene, &FilteredPath { path, paths }, spp, 2)
}

#[test]
fn on_every_scene_whose_light_both_find() {
    let mut noticed = Vec::new();
    for (name, _) in GALLERY {
        let scene = gallery::load(name).unwrap().sized([16; 2]);
        // Of a point no walk from the eye finds light that was focused; of a dark scene nobody does.
        if scene.inventory.point_lights > 0 || scene.is_dark() {
            continue;
        }
        let max_depth = scene.suggested.max_depth.min(8);
        let ours = rendered(&scene, &LightTracer { max_depth }, 3072, 1);
        let theirs = by_path(&scene, max_depth, 1024);
        if theirs.film.mean().0 == 0.0 {
            assert!(ours.is_black(), "{name}");
            continue;
        }
        alike(name, ours.mean(), theirs.mean(), 0.4);
        noticed.push(crate::checks::between(ours.mean(), theirs.mean()).1);
        let [a, b] = [&ours, &theirs].map(|r| r.film.picture().in_squares(4));
        let z = compare::z_scores(&a, &b).unwrap();
        assert!(z.largest < 6.0, "{name}: {}", z.largest);
    }
    assert!(noticed.len() > 10, "{}", noticed.len());
    noticed.sort_by(f64::total_cmp);
    let median = noticed[noticed.len() / 2];
    assert!(median < 0.03, "half of the scenes notice {median}");
}

/// A light tracer with a mistake in what the film receives.
struct Wrong(fn([f32; 2]) -> f32);

impl Integrator for Wrong {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        LightTracer { max_depth: 6 }.li(tracer, ray, stream)
    }

    fn passes(&self, _: &Scene) -> Option<&dyn Passes> {
        Some(self)
    }
}

impl Passes for Wrong {
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        pass.splat(pass.pixels(), |tracer, stream, splat| {
            LightTracer { max_depth: 6 }.trace(tracer, stream, &mut |film, light| {
                splat(film, light * (self.0)(film), Arrival::Counts);
            });
        })
    }
}

#[test]
fn mistakes_of_the_film_are_noticed() {
    let scene = gallery::load("cornell").unwrap().sized([16; 2]);
    let right = by_path(&scene, 6, 2048);
    let wrong = |factor| rendered(&scene, &Wrong(factor), 2048, 1);
    let squares = |a: &Rendered| {
        let z = compare::z_scores(&a.film.picture(), &right.film.picture()).unwrap();
        z.squares.mean()
    };
    // Of 32 runs the errors are known to an eighth: 1 + 2 / 31 is what the squares expect.
    let none = squares(&wrong(|_| 1.0));
    assert!((0.9..1.3).contains(&none), "{none}");
    // 3 % too much, and the cosine of the film forgotten.
    unlike("too much", wrong(|_| 1.03).mean(), right.mean());
    let cosine = |[s, t]: [f32; 2]| {
        let (x, y) = (0.36 * (2.0 * s - 1.0), 0.36 * (2.0 * t - 1.0));
        1.0 / (1.0 + x * x + y * y).sqrt()
    };
    let without = squares(&wrong(cosine));
    assert!(without > 1.6, "{without}");
}

/// Light that is all alike in a pass, as if every photon were seen everywhere.
struct Flicker;

impl Integrator for Flicker {
    fn li(&self, _: &mut Tracer, _: &Ray, _: &Stream) -> Rgb {
        Rgb::BLACK
    }

    fn passes(&self, _: &Scene) -> Option<&dyn Passes> {
        Some(self)
    }
}

impl Passes for Flicker {
    fn prepare<'a>(&'a self, pass: &Pass<'a>) -> Option<Prepared<'a>> {
        let (light, _) = pass.trace(0..1, |_, stream, leave| {
            leave(Rgb::grey(stream.at(1, Purpose::Survival).one()));
        })?;
        let light = vec![light[0]; pass.pixels() as usize];
        Some(Prepared {
            light: Some(light),
            ..Prepared::default()
        })
    }
}

/// Pixels that share their light are not independent: the mean's error is not a pixel's by the root of their number.
#[test]
fn the_error_of_the_mean_knows_what_pixels_share() {
    let scene = gallery::load("cornell").unwrap().sized([8; 2]);
    let rendered = |seed| {
        let options = Options {
            spp: 32,
            seed,
            ..Options::default()
        };
        render(&scene, &Flicker, &options, &())
    };
    let of_seeds = (0..60).map(|seed| rendered(seed).mean());
    let means: Estimate = of_seeds.clone().map(|(mean, _)| mean).collect();
    let told: Estimate = of_seeds.map(|(_, error)| error * error).collect();
    // The spread of 60 means is known to a tenth; by the pixels alone the error would be an eighth.
    let ratio = means.variance().sqrt() / told.mean().sqrt();
    assert!((0.75..1.25).contains(&ratio), "{ratio}");
    let (_, by_pixels) = rendered(1).film.mean();
    assert!(by_pixels < 0.2 * told.mean().sqrt(), "{by_pixels}");
}

/// A point light over glass over a floor: the caustic that no walk from the eye can find.
#[test]
fn a_slab_of_glass_lets_the_light_of_a_point_through() {
    let scene = |glass: &str| {
        let text = format!(
            "name = 'test'\ncamera = {{ from = [0, 1, 6], to = [0, 0, 0], fov = 40 }}\nfilm.size = [32, 32]\n\
             materials.half.lambert.albedo = 0.5\nmaterials.clear.glass.ior = 1.5\n\
             [[objects]]\nmaterial = 'half'\nquad = {{ corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n\
             [[lights]]\npoint = {{ position = [0, 6, 0], intensity = 20 }}\n{glass}"
        );
        let file = "test.toml";
        gallery::from_text(Source { file, text: &text }, None, |_| {}).unwrap()
    };
    // So far to the side that no line from the floor to the eye goes through it.
    let slab = "[[objects]]\nmaterial = 'clear'\nquad = { corner = [-20, 4, 20], u = [40, 0, 0], v = [0, 0, -40] }\n\
                [[objects]]\nmaterial = 'clear'\nquad = { corner = [-20, 3.999, -20], u = [40, 0, 0], v = [0, 0, 40] }\n";
    let tracer = LightTracer { max_depth: 12 };
    let bare = rendered(&scene(""), &tracer, 1024, 1);
    let through = rendered(&scene(slab), &tracer, 1024, 2);
    // Of light that falls on a slab nearly straight 2 n / (n² + 1) comes through in the end.
    let share = 12.0 / 13.0;
    let (mean, error) = bare.mean();
    alike("slab", through.mean(), (share * mean, share * error), 0.065);
    let path = rendered(&scene(slab), &Path::from_eye(12), 64, 3);
    assert_eq!(path.mean().0, 0.0, "no walk from the eye meets a point");
    let path = rendered(&scene(slab), &Path::new(12), 1792, 3);
    alike("path", path.mean(), through.mean(), 0.11);
}

#[test]
fn neither_threads_nor_tiles_nor_pauses_change_a_bit() {
    let scene = gallery::load("six").unwrap().sized([24, 17]);
    let tracer = LightTracer { max_depth: 6 };
    let film = |threads: usize, tile: u32| {
        let options = Options {
            spp: 9,
            tile,
            ..Options::default()
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let work = || render(&scene, &tracer, &options, &()).film;
        pool.build().unwrap().install(work)
    };
    let one = film(1, 16);
    assert_eq!(one, film(3, 5));
    let options = Options {
        spp: 9,
        ..Options::default()
    };
    let mut session = halfdisk::render::Session::new(&scene, &tracer as &dyn Integrator, &options);
    session.advance(4, &());
    session.advance(9, &());
    assert_eq!(one, session.rendered().film);
}
