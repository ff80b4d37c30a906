//! Absent, compiled out, and forced on at no strength: the same bytes.

use super::{FLOOR, LAMP, POINT, ball, effects, path, scene, small, with};
use halfdisk::effects::plan::plan;
use halfdisk::integrators::{Kajiya, NextEvent, Whitted};
use halfdisk::output::{Display, Provenance, png_bytes};
use halfdisk::render::Film;
use halfdisk::scene::description::Description;
use halfdisk::scene::gallery::{self, GALLERY};
use halfdisk::scene::read::Source;
use halfdisk::scene::{Effect, Scene};

/// The bytes of the PNG and the film itself, of which an EXR holds means, errors and counts.
fn bytes(scene: &Scene, film: &Film) -> (Vec<u8>, Film) {
    let facts = Provenance::new(scene, "path", 1, 4, 0);
    let png = png_bytes(film, Display::Radiance, &facts).unwrap();
    (png, film.clone())
}

fn same_picture(a: &Scene, b: &Scene, why: &str) {
    let (first, second) = (path(a), path(b));
    assert_eq!(bytes(a, &first.film), bytes(b, &second.film), "{why}");
    assert_eq!(first.rays, second.rays, "{why}");
}

#[test]
fn every_effect_at_work_changes_no_bit_of_any_gallery_scene() {
    for (name, _) in GALLERY {
        let scene = small(name);
        let all_on = scene.clone().with_all_effects();
        same_picture(&scene, &all_on, name);
        // The other integrators see the same lens and the same motion.
        let depth = scene.suggested.max_depth.min(6);
        let integrators = [
            (
                with(&scene, &Kajiya { max_depth: depth }),
                with(&all_on, &Kajiya { max_depth: depth }),
            ),
            (
                with(&scene, &NextEvent { max_depth: depth }),
                with(&all_on, &NextEvent { max_depth: depth }),
            ),
            (
                with(&scene, &Whitted { max_depth: depth }),
                with(&all_on, &Whitted { max_depth: depth }),
            ),
        ];
        for (automatic, forced) in integrators {
            assert_eq!(automatic.film, forced.film, "{name}");
            assert_eq!(automatic.rays, forced.rays, "{name}");
        }
    }
}

#[test]
fn an_effect_without_strength_is_an_effect_that_is_absent() {
    let room = FLOOR.to_owned() + LAMP + &ball("half", "");
    let plain = scene("", &room);
    let variants = [
        (
            "a lens of radius 0",
            scene("lens_radius = 0\nfocus = 3", &room),
        ),
        (
            "a shutter that never opens",
            scene(
                "shutter = [0, 0]",
                &(FLOOR.to_owned() + LAMP + &ball("half", "motion = [3, 0, 0]")),
            ),
        ),
        (
            "a motion of nothing",
            scene(
                "shutter = [0, 1]",
                &(FLOOR.to_owned() + LAMP + &ball("half", "motion = [0, 0, 0]")),
            ),
        ),
        ("a black sky", {
            let black = "background = 0\n".to_owned();
            let text = format!(
                "{black}name = 'test'\nfilm.size = [24, 18]\n[materials]\nhalf.lambert.albedo = 0.5\n\
                 [camera]\nfrom = [0, 1, 5]\nto = [0, 0.5, 0]\nfov = 45\n{room}"
            );
            gallery::from_text(
                Source {
                    file: "t.toml",
                    text: &text,
                },
                None,
                |_| {},
            )
            .unwrap()
        }),
        ("a mixture of one part", {
            let text = format!(
                "name = 'test'\nfilm.size = [24, 18]\n[materials]\n\
                 half.mixture = {{ kd = 0.5, ks = 0, kt = 0 }}\n\
                 [camera]\nfrom = [0, 1, 5]\nto = [0, 0.5, 0]\nfov = 45\n{room}"
            );
            gallery::from_text(
                Source {
                    file: "t.toml",
                    text: &text,
                },
                None,
                |_| {},
            )
            .unwrap()
        }),
    ];
    for (why, variant) in variants {
        assert_eq!(effects(&variant), effects(&plain), "{why}");
        same_picture(&plain, &variant, why);
    }
    // With strength each of them shows.
    let lens = scene("lens_radius = 0.3\nfocus = 3", &room);
    let moving = scene(
        "shutter = [0, 1]",
        &(FLOOR.to_owned() + LAMP + &ball("half", "motion = [3, 0, 0]")),
    );
    for other in [lens, moving] {
        assert_ne!(path(&plain).film, path(&other).film);
    }
}

#[test]
fn a_glossy_object_that_is_gone_leaves_no_trace() {
    let room = FLOOR.to_owned() + LAMP;
    let gone = scene("", &room);
    let with_gloss = scene("", &(room.clone() + &ball("satin", "")));
    assert!(effects(&with_gloss).contains(&Effect::Gloss));
    assert!(!effects(&gone).contains(&Effect::Gloss));
    // Far behind the camera, where no path of this room finds it: the code for gloss is there, and
    // the picture is the same.
    let far = "[[objects]]\nmaterial = 'satin'\n\
               triangle = { a = [0, -90, 90], b = [1e-3, -90, 90], c = [0, -90, 90.001] }\n";
    let far_away = scene("", &(room + far));
    assert!(effects(&far_away).contains(&Effect::Gloss));
    assert_eq!(path(&gone).film, path(&far_away).film);
    assert_ne!(path(&gone).film, path(&with_gloss).film);
}

#[test]
fn one_effect_more_is_one_flag_more() {
    use Effect::*;
    let quad = |material: &str| FLOOR.replace("half", material);
    let sky = |said: &mut Description| {
        said.background = Some(halfdisk::scene::description::Color([1.0; 3]));
    };
    assert_eq!(effects(&scene("", LAMP)), [AreaLights]);
    assert_eq!(effects(&scene("", POINT)), [PointLights]);
    let text = "name = 'sky'\ncamera = { from = [0, 0, 5], to = [0, 0, 0], fov = 45 }";
    let only_sky = gallery::from_text(
        Source {
            file: "t.toml",
            text,
        },
        None,
        sky,
    )
    .unwrap();
    assert_eq!(effects(&only_sky), [Sky]);
    let lamp_and = |camera: &str, more: &str| effects(&scene(camera, &(LAMP.to_owned() + more)));
    assert_eq!(lamp_and("", &quad("half")), [AreaLights, Diffuse]);
    assert_eq!(lamp_and("", &quad("silver")), [AreaLights, Specular]);
    assert_eq!(lamp_and("", &quad("clear")), [AreaLights, Specular]);
    assert_eq!(lamp_and("", &quad("satin")), [AreaLights, Gloss]);
    assert_eq!(lamp_and("lens_radius = 0.1", ""), [AreaLights, Lens]);
    let moving = LAMP.replace("emits = 9", "emits = 9\nmotion = [1, 0, 0]");
    assert_eq!(
        effects(&scene("shutter = [0, 1]", &moving)),
        [AreaLights, Motion]
    );
    let two = quad("half") + &ball("half", "");
    assert_eq!(lamp_and("", &two), [AreaLights, Diffuse, Bleeding]);
    let caustic = quad("half") + &ball("clear", "");
    assert_eq!(
        lamp_and("", &caustic),
        [AreaLights, Diffuse, Specular, Bleeding, Caustics]
    );
    // What is closed may light itself from within, the lamp too; a sky is light that can be met.
    let glowing = LAMP.replace("emits = 9", "emits = 9\nmaterial = 'half'");
    assert_eq!(
        effects(&scene("", &glowing)),
        [AreaLights, Diffuse, Bleeding]
    );
    let under_the_sky = "[environment]\nradiance = 1\n".to_owned() + &caustic;
    assert_eq!(
        effects(&scene("", &under_the_sky)),
        [Sky, Diffuse, Specular, Bleeding, Caustics]
    );
    let by_a_point = effects(&scene("", &(POINT.to_owned() + &caustic)));
    assert_eq!(by_a_point, [PointLights, Diffuse, Specular, Bleeding]);
    // Without light nothing is called for.
    assert_eq!(effects(&scene("lens_radius = 0.1", &caustic)), []);
}

#[test]
fn in_the_dark_no_ray_is_traced() {
    let dark = scene("", FLOOR);
    let rendered = path(&dark);
    assert_eq!((rendered.rays.total(), rendered.film.max()), (0, 0.0));
    assert_eq!(rendered.film, path(&dark.clone().with_all_effects()).film);
    let plan = plan(&dark);
    assert_eq!(plan.paths, None);
    assert!(
        plan.lines
            .iter()
            .all(|l| !l.simulated && l.reason.contains("nothing shines"))
    );
}
