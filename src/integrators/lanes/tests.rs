//! The walk in lanes against the plain one.

use super::*;
use crate::geometry::Ray;
use crate::integrators::{Integrator, Passes};
use crate::numeric::lanes::levels;
use crate::render::{Options, Rendered, render};
use crate::scene::gallery;
use crate::scene::read::Source;

/// The path tracer by some of the processor's instructions; one path at a time without any.
struct By(Path, Option<Level>);

impl Integrator for By {
    fn li(&self, tracer: &mut Tracer, ray: &Ray, stream: &Stream) -> Rgb {
        self.0.li(tracer, ray, stream)
    }

    fn in_lanes<'s>(&self, scene: &'s Scene) -> Option<PathInLanes<'s>> {
        let level = self.1?;
        PathInLanes::new(&self.0, scene).map(|lanes| lanes.by(level))
    }

    fn passes(&self, scene: &Scene) -> Option<&dyn Passes> {
        self.0.passes(scene)
    }
}

fn assert_same(a: &Rendered, b: &Rendered, what: &str) {
    assert!(a.film == b.film, "{what}: another picture");
    assert_eq!(a.rays, b.rays, "{what}");
    assert_eq!(a.lights_met, b.lights_met, "{what}");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "only optimised programs have lanes")]
fn every_scene_is_the_same_picture_in_lanes_by_all_instructions() {
    let mut in_lanes = 0;
    for (name, _) in gallery::GALLERY {
        let scene = gallery::load(name).expect("a scene").sized([18, 14]);
        let path = Path::new(scene.suggested.max_depth.min(12));
        for sampler in [Sampler::Independent, Sampler::Sobol] {
            let options = Options {
                spp: 9,
                sampler,
                ..Options::default()
            };
            let plain = render(&scene, &By(path, None), &options, &());
            in_lanes += usize::from(PathInLanes::new(&path, &scene).is_some());
            for (level, tile) in levels().into_iter().zip([32, 5, 16, 7]) {
                let options = Options { tile, ..options };
                let lanes = render(&scene, &By(path, Some(level)), &options, &());
                assert_same(&lanes, &plain, &format!("{name} {sampler:?} {level:?}"));
            }
        }
    }
    assert!(in_lanes > 8, "scenes in lanes: {in_lanes} of two samplers");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "only optimised programs have lanes")]
fn lights_that_lie_in_a_wall_are_met_as_by_one_path() {
    let room = |x: f32, lamps: &str| {
        let wall = "material = 'white'\nquad =";
        let text = format!(
            "name = 'contact'\ncamera = {{ from = [{x}, 1, 2.9], to = [{x}, 1.2, 0], fov = 70 }}\nfilm.size = [18, 14]\n\
             materials.white.lambert.albedo = 0.7\n\
             [[objects]]\n{wall} {{ corner = [{x}, 2, -3], u = [4, 0.03, 0], v = [0.1, 0, 6] }}\n\
             [[objects]]\n{wall} {{ corner = [{x}, 0, -3], u = [0, 0, 6], v = [4, 0, 0] }}\n{lamps}"
        );
        let source = Source {
            file: "contact.toml",
            text: &text,
        };
        gallery::from_text(source, None, |_| {}).expect("a scene")
    };
    // A tilted ceiling, and lamps that cover parts of it, and of each other.
    let lamp = |x: f32, emits: u32, v: &str| {
        format!(
            "[[objects]]\nemits = {emits}\nquad = {{ corner = [{x}, 2, -3], u = [4, 0.03, 0], v = {v} }}\n"
        )
    };
    let path = Path::new(5);
    let options = Options {
        spp: 32,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    for x in [0.0, 0.7, 1234.5] {
        let one = lamp(x, 3, "[0.05, 0, 3]");
        for lamps in [one.clone(), one + &lamp(x, 5, "[0.07, 0, 4.2]")] {
            let scene = room(x, &lamps);
            let lanes = PathInLanes::new(&path, &scene).expect("lanes");
            assert!(lanes.scene.has_contacts());
            let plain = render(&scene, &By(path, None), &options, &());
            for level in levels() {
                let lanes = render(&scene, &By(path, Some(level)), &options, &());
                assert_same(&lanes, &plain, &format!("{x} {level:?}"));
            }
        }
    }
}

#[test]
#[cfg_attr(debug_assertions, ignore = "only optimised programs have lanes")]
fn whoever_asks_for_path_by_name_gets_lanes() {
    let scene = gallery::load("cornell").expect("a scene");
    let settings = crate::integrators::Settings::new(8);
    let entry = crate::integrators::find("path").expect("path");
    let path = entry.prepare(&scene, &settings).expect("path");
    assert!(path.in_lanes(&scene).is_some());
    let options = Options::default();
    let by = |scene: Scene| render(&scene.sized([4, 4]), path.as_ref(), &options, &()).lanes;
    assert_eq!(by(scene.clone()), Some(level_name(Level::new())));
    let spheres = gallery::load("spheres").expect("a scene");
    assert!(PathInLanes::new(&Path::new(8), &spheres).is_some());
    let from_eye = PathInLanes::new(&Path::from_eye(8), &spheres);
    assert!(from_eye.is_none(), "most of its vertices are guided");
    let moving = gallery::load("motion").expect("a scene");
    assert_eq!(by(moving), None, "what moves is traced one by one");
}

#[test]
#[cfg_attr(debug_assertions, ignore = "only optimised programs have lanes")]
fn effects_at_no_strength_change_no_bit_and_keep_the_lanes() {
    for name in ["cornell", "mesh"] {
        let scene = gallery::load(name).expect("a scene").sized([18, 14]);
        let path = Path::new(8);
        let options = Options {
            spp: 9,
            ..Options::default()
        };
        let plain = render(&scene, &By(path, None), &options, &());
        let all = render(&scene.with_all_effects(), &path, &options, &());
        assert_same(&all, &plain, name);
        assert!(all.lanes.is_some(), "{name}");
    }
}

#[test]
fn few_samples_depths_and_threads_change_no_bit() {
    let scene = gallery::load("spheres").expect("a scene").sized([33, 5]);
    for (max_depth, spp) in [(0, 3), (1, 1), (2, 70), (40, 3)] {
        let path = Path::new(max_depth);
        let options = Options {
            spp,
            sampler: Sampler::Sobol,
            ..Options::default()
        };
        let plain = render(&scene, &By(path, None), &options, &());
        for threads in [1, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            let lanes = pool
                .expect("threads")
                .install(|| render(&scene, &path, &options, &()));
            assert_same(&lanes, &plain, &format!("{max_depth} {spp} {threads}"));
        }
    }
}
