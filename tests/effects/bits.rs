//! Absent, compiled out, and forced on at no strength: the same bytes.

use super::{FLOOR, LAMP, POINT, ball, effects, path, scene, small, with};
use halfdisk::integrators::{FilteredPath, Kajiya, NextEvent, Path, Whitted};
use halfdisk::lab::effects::plan::plan;
use halfdisk::lab::effects::without::Without;
use halfdisk::notation::Expression;
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

/// A floor and a ball of one material under a lamp and a sky.
fn of_one_material(material: &str) -> Scene {
    let text = format!(
        "name = 'test'\nfilm.size = [24, 18]\nbackground = 0.25\nmaterials.it.{material}\n\
         [camera]\nfrom = [0, 1, 5]\nto = [0, 0.5, 0]\nfov = 45\n{}{LAMP}{}",
        FLOOR.replace("half", "it"),
        ball("it", "")
    );
    let source = Source {
        file: "t.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).unwrap()
}

#[test]
fn each_material_alone_has_a_kernel_that_knows_it() {
    let black = path(&of_one_material("lambert.albedo = 0"));
    for material in [
        "lambert.albedo = 0.5",
        "mirror.reflectance = 0.9",
        "glass.ior = 1.5",
        "glossy = { reflectance = 0.8, roughness = 0.2 }",
        "rough_glass = { ior = 1.5, roughness = 0.2 }",
        "mixture = { kd = 0.5, ks = 0, kt = 0 }",
        "mixture = { kd = 0, ks = 0.5, kt = 0 }",
        "mixture = { kd = 0.2, ks = 0.3, kt = 0.4, ior = 1.5 }",
    ] {
        let scene = of_one_material(material);
        same_picture(&scene, &scene.clone().with_all_effects(), material);
        // A kernel that does not know it would paint it black.
        assert_ne!(path(&scene).film, black.film, "{material}");
    }
}

/// The share of a picture's light on paths of an expression.
fn share(scene: &Scene, paths: &str) -> f64 {
    let expression = Expression::parse(paths).unwrap();
    let paths = expression.eye_first();
    let path = Path::new(scene.suggested.max_depth);
    let part = with(scene, &FilteredPath { path, paths }).film.mean().0;
    part / with(scene, &path).film.mean().0
}

#[test]
fn a_closed_surface_that_shines_lights_itself() {
    let glow = |shape: &str| {
        scene(
            "",
            &format!("[[objects]]\nmaterial = 'half'\nemits = 1\n{shape}\n"),
        )
    };
    let bleeds = |scene: &Scene| effects(scene).contains(&Effect::Bleeding);
    let room = glow("sphere = { center = [0, 1, 5], radius = 3, inward = true }");
    assert!(bleeds(&room) && share(&room, "LD.*D.*E") > 0.1);
    let bumpy = "bumpy_sphere = { center = [0, 0.5, 0], radius = 1, columns = 8, rows = 6 }";
    for shape in ["box = { min = [-1, 0, -1], max = [1, 1, 1] }", bumpy] {
        assert!(bleeds(&glow(shape)), "{shape}");
    }
    // One flat surface does not, whether it shines or is shone at.
    let flat = "quad = { corner = [-1, 0, 0], u = [2, 0, 0], v = [0, 2, 0] }";
    let flat = glow(flat);
    assert!(!bleeds(&flat) && share(&flat, "L.*D.*E") == 0.0);
    let planned = |scene: &Scene| {
        let line = plan(scene).lines.into_iter();
        let mut of_bleeding = line.filter(|line| line.effect == Effect::Bleeding);
        of_bleeding.next().unwrap()
    };
    assert!(planned(&room).simulated && !planned(&flat).simulated);
    assert_ne!(planned(&room).reason, planned(&flat).reason);
}

#[test]
fn every_light_that_can_be_met_makes_caustics() {
    let glass = FLOOR.to_owned() + &ball("clear", "");
    let folder = crate::cli::folder();
    let sky = image::RgbImage::from_pixel(8, 4, image::Rgb([128; 3]));
    sky.save(folder.path().join("sky.png")).unwrap();
    let under = |sky: &str| {
        let text = format!(
            "name = 'test'\nfilm.size = [24, 18]\n{sky}\nmaterials.half.lambert.albedo = 0.5\n\
             materials.clear.glass.ior = 1.5\n\
             [camera]\nfrom = [0, 1, 5]\nto = [0, 0.5, 0]\nfov = 45\n{glass}"
        );
        let source = Source {
            file: "t.toml",
            text: &text,
        };
        gallery::from_text(source, Some(folder.path()), |_| {}).unwrap()
    };
    for sky in [
        "background = 1",
        "environment.radiance = [0, 0, 1]",
        "environment.image = 'sky.png'",
    ] {
        let scene = under(sky);
        assert!(effects(&scene).contains(&Effect::Caustics), "{sky}");
        assert!(share(&scene, "LS+D.*E") > 1e-3, "{sky}");
        let line = plan(&scene).lines.into_iter();
        let caustics = line
            .filter(|line| line.effect == Effect::Caustics)
            .collect::<Vec<_>>();
        assert!(caustics[0].simulated, "{sky}: {}", caustics[0].reason);
    }
    // Without any light there is nothing to focus, and a point's light is not met.
    assert!(!effects(&under("background = 0")).contains(&Effect::Caustics));
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
        said.background = Some(halfdisk::scene::value::Radiance([1.0; 3]));
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
    assert_eq!(
        by_a_point,
        [PointLights, Diffuse, Specular, Bleeding, Caustics]
    );
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

#[test]
fn each_part_of_a_mixture_is_counted_alone() {
    use Effect::*;
    for (parts, called_for) in [
        ("kd = 0.5, ks = 0, kt = 0", [true, false]),
        ("kd = 0, ks = 0.5, kt = 0", [false, true]),
        ("kd = 0, ks = 0, kt = 0.5", [false, true]),
        ("kd = 0.2, ks = 0, kt = 0.5", [true, true]),
    ] {
        let scene = of_one_material(&format!("mixture = {{ {parts} }}"));
        let found = effects(&scene);
        let has = [Diffuse, Specular].map(|effect| found.contains(&effect));
        assert_eq!(has, called_for, "{parts}: {found:?}");
    }
}

#[test]
fn without_the_sky_every_kind_of_it_is_gone() {
    let folder = crate::cli::folder();
    let image = image::RgbImage::from_pixel(8, 4, image::Rgb([128; 3]));
    image.save(folder.path().join("sky.png")).unwrap();
    let without = Without::from_iter([Effect::Sky]);
    for sky in [
        "background = 1",
        "environment.radiance = 1",
        "environment.image = 'sky.png'",
    ] {
        let text = format!(
            "name = 'test'\nfilm.size = [8, 6]\n{sky}\nmaterials.half.lambert.albedo = 0.5\n\
             [camera]\nfrom = [0, 1, 5]\nto = [0, 0.5, 0]\nfov = 45\n{FLOOR}"
        );
        let load = |change: &dyn Fn(&mut Description)| {
            let source = Source {
                file: "t.toml",
                text: &text,
            };
            gallery::from_text(source, Some(folder.path()), |said| change(said)).unwrap()
        };
        let (lit, dark) = (load(&|_| {}), load(&|said| without.change(said)));
        assert!(effects(&lit).contains(&Effect::Sky), "{sky}");
        assert_eq!(effects(&dark), [], "{sky}");
        assert!(path(&lit).film.max() > 0.0 && path(&dark).film.max() == 0.0);
    }
}
