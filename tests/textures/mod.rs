//! Textures of albedo and emission: where they are on each shape, and that light follows them.

mod bad;

use crate::checks::{accept, alike, reject};
use halfdisk::color::Rgb;
use halfdisk::integrators::{Combine, Integrator, Kajiya, NextEvent, Path};
use halfdisk::render::{Options, render};
use halfdisk::sampling::mis::Heuristic;
use halfdisk::sampling::stream::Stream;
use halfdisk::scene::read::Source;
use halfdisk::scene::{Scene, SceneError, Tracer, gallery};
use halfdisk::stats::Estimate;
use std::path::Path as File;
use tempfile::TempDir;

const HEAD: &str = "name = 't'\n[film]\nsize = [8, 8]\n";

fn parse(text: &str, folder: Option<&File>) -> Result<Scene, SceneError> {
    let text = format!("{HEAD}{text}");
    let source = Source {
        file: "t.toml",
        text: &text,
    };
    gallery::from_text(source, folder, |_| {})
}

/// A scene whose eye, at `from`, looks at the origin.
fn scene(from: [f64; 3], text: &str, folder: Option<&File>) -> Scene {
    let camera = format!("[camera]\nfrom = {from:?}\nto = [0, 0, 0]\nfov = 40\n");
    parse(&format!("{camera}{text}"), folder).expect("a right scene")
}

/// A picture of two columns and two rows, each pixel of another colour: red, green above blue, white.
fn four_colors() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let pixels = [255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255];
    let image = image::RgbImage::from_raw(2, 2, pixels.to_vec()).unwrap();
    image.save(folder.path().join("four.png")).unwrap();
    folder
}

/// The albedo in the middle of the four quarters of a square of side 2 around the origin that faces the
/// eye: upper left, upper right, lower left, lower right.
fn quarters(scene: &Scene) -> [Rgb; 4] {
    [(0.36, 0.36), (0.64, 0.36), (0.36, 0.64), (0.64, 0.64)].map(|(s, t)| {
        let hit = Tracer::new(scene).camera_ray(&scene.camera.ray(s, t));
        hit.and_then(|hit| hit.bsdf).unwrap().albedo()
    })
}

const RED: Rgb = Rgb::new(1.0, 0.0, 0.0);
const GREEN: Rgb = Rgb::new(0.0, 1.0, 0.0);
const BLUE: Rgb = Rgb::new(0.0, 0.0, 1.0);
const UPRIGHT: [Rgb; 4] = [RED, GREEN, BLUE, Rgb::WHITE];

/// The colour of the four that is nearest: what is seen lies between the middles of pixels.
fn nearest(colors: [Rgb; 4]) -> [Rgb; 4] {
    let off = |a: Rgb, b: Rgb| (a - b).channels().map(f32::abs).iter().sum::<f32>();
    colors.map(|color| {
        let all = UPRIGHT.into_iter();
        all.min_by(|a, b| off(*a, color).total_cmp(&off(*b, color)))
            .unwrap()
    })
}

const IMAGE: &str = "[materials.m]\nlambert = { albedo = { image = { file = 'four.png' } } }\n[[objects]]\nmaterial = 'm'\n";

#[test]
fn an_image_is_upright_on_every_side_of_a_box_and_on_quads_and_meshes() {
    let folder = four_colors();
    let obj = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    std::fs::write(folder.path().join("square.obj"), obj).unwrap();
    let see = |from, shape: &str| {
        let scene = scene(from, &format!("{IMAGE}{shape}\n"), Some(folder.path()));
        nearest(quarters(&scene))
    };
    let cube = "box = { min = [-1, -1, -1], max = [1, 1, 1] }";
    for from in [
        [0.0, 0.0, 4.0],
        [0.0, 0.0, -4.0],
        [4.0, 0.0, 0.0],
        [-4.0, 0.0, 0.0],
    ] {
        assert_eq!(see(from, cube), UPRIGHT, "the side seen from {from:?}");
    }
    let front = [0.0, 0.0, 4.0];
    let quad = "quad = { corner = [-1, -1, 0], u = [2, 0, 0], v = [0, 2, 0] }";
    assert_eq!(see(front, quad), UPRIGHT);
    assert_eq!(see(front, "mesh = { file = 'square.obj' }"), UPRIGHT);
    // Mirrored, left and right change places; turned by a quarter, the left is below.
    let mirrored = [GREEN, RED, Rgb::WHITE, BLUE];
    let turned = [GREEN, Rgb::WHITE, RED, BLUE];
    for shape in [quad, "mesh = { file = 'square.obj' }", cube] {
        let mirror = format!("transform = {{ scale = [-1, 1, 1] }}\n{shape}");
        assert_eq!(see(front, &mirror), mirrored, "{shape}");
        let turn =
            format!("transform = {{ rotate = {{ axis = [0, 0, 1], degrees = 90 }} }}\n{shape}");
        assert_eq!(see(front, &turn), turned, "{shape}");
    }
}

#[test]
fn a_sphere_wears_an_image_as_a_globe_does() {
    let folder = four_colors();
    // The image twice round: each half of the sphere shows all of it, upright.
    let text = "[materials.m]\nlambert = { albedo = { image = { file = 'four.png', repeat = [2, 1] } } }\n\
                [[objects]]\nmaterial = 'm'\n";
    let see = |from, more: &str| {
        let ball = format!("{text}{more}\nsphere = {{ center = [0, 0, 0], radius = 1 }}\n");
        nearest(quarters(&scene(from, &ball, Some(folder.path()))))
    };
    assert_eq!(see([0.0, 0.0, 4.0], ""), UPRIGHT);
    assert_eq!(see([0.0, 0.0, -4.0], ""), UPRIGHT);
    let turn = "transform = { rotate = { axis = [0, 0, 1], degrees = 180 } }";
    let [a, b, c, d] = UPRIGHT;
    assert_eq!(see([0.0, 0.0, 4.0], turn), [d, c, b, a]);
    let mirror = "transform = { scale = -1 }";
    assert_eq!(see([0.0, 0.0, 4.0], mirror), [c, d, a, b], "upside down");
}

#[test]
fn a_texture_of_one_color_is_that_color_bit_for_bit() {
    let film = |albedo: &str, emits: &str| {
        let text = format!(
            "[materials.m]\nlambert = {{ albedo = {albedo} }}\n\
             [[objects]]\nmaterial = 'm'\nbox = {{ min = [-2, -1, -2], max = [2, -0.5, 2] }}\n\
             [[objects]]\nemits = {emits}\nquad = {{ corner = [-1, 2, -1], u = [2, 0, 0], v = [0, 0, 2] }}\n\
             [[objects]]\nemits = {emits}\nsphere = {{ center = [1, 1, 0], radius = 0.2 }}\n"
        );
        let scene = scene([0.0, 1.0, 6.0], &text, None);
        [
            &Path::new(4) as &dyn Integrator,
            &NextEvent { max_depth: 4 },
        ]
        .map(|integrator| render(&scene, integrator, &Options::default(), &()).film)
    };
    let same =
        |color: &str| format!("{{ checker = {{ even = {color}, odd = {color}, fields = 5 }} }}");
    let plain = film("0.5", "[3, 2, 1]");
    assert!(plain == film(&same("0.5"), &same("[3, 2, 1]")));
    assert!(plain != film(&same("0.6"), &same("[3, 2, 1]")));
    assert!(plain != film(&same("0.5"), &same("[3, 2, 0.5]")));
}

/// The radiance of the middle of a picture, by a number of samples.
fn middle(scene: &Scene, integrator: &impl Integrator, samples: u32) -> Estimate {
    let mut tracer = Tracer::new(scene);
    let ray = scene.camera.ray(0.5, 0.5);
    let one = |i| f64::from(integrator.li(&mut tracer, &ray, &Stream::new(3, i, 0)).r);
    (0..samples).map(one).collect()
}

#[test]
fn a_lamp_of_many_colors_lights_as_its_fields_do() {
    // A lamp of four by four fields above a floor, as a texture and as sixteen lamps; and others whose
    // texture is found only by their own coordinates.
    let floor = "[materials.m]\nlambert = { albedo = 0.8 }\n[[objects]]\nmaterial = 'm'\n\
                 quad = { corner = [-5, 0, 5], u = [10, 0, 0], v = [0, 0, -10] }\n";
    let from = [0.0, 0.5, 2.0];
    let checker = "{ checker = { even = 8, odd = 0.5, fields = 4 } }";
    let whole = "quad = { corner = [-1, 1, -1], u = [2, 0, 0], v = [0, 0, 2] }";
    let one = scene(
        from,
        &format!("{floor}[[objects]]\nemits = {checker}\n{whole}\n"),
        None,
    );
    let fields = (0..16).map(|i| {
        let (s, t) = (i % 4, i / 4);
        let emits = if (s + t) % 2 == 0 { 8.0 } else { 0.5 };
        let corner = [f64::from(s) * 0.5 - 1.0, f64::from(t) * 0.5 - 1.0];
        format!(
            "[[objects]]\nemits = {emits}\nquad = {{ corner = [{}, 1, {}], u = [0.5, 0, 0], v = [0, 0, 0.5] }}\n",
            corner[0], corner[1]
        )
    });
    let many = scene(
        from,
        &format!("{floor}{}", fields.collect::<String>()),
        None,
    );
    let max_depth = 2;
    let truth = middle(&many, &NextEvent { max_depth }, 20_000);
    let mean = (truth.mean(), truth.std_error());
    let check = |name: &str, estimate: Estimate| {
        alike(name, (estimate.mean(), estimate.std_error()), mean, 0.03);
    };
    check("kajiya", middle(&one, &Kajiya { max_depth }, 400_000));
    check(
        "next-event",
        middle(&one, &NextEvent { max_depth }, 100_000),
    );
    check("path", middle(&one, &Path::new(max_depth), 100_000));
    // With the brightest radiance everywhere, or the mean, it would be another light.
    let bright = scene(
        from,
        &format!("{floor}[[objects]]\nemits = 8\n{whole}\n"),
        None,
    );
    reject(
        "as bright everywhere",
        &middle(&bright, &NextEvent { max_depth }, 20_000),
        mean.0,
    );
}

#[test]
fn chance_and_sampling_agree_on_textured_lamps_of_every_shape() {
    let folder = four_colors();
    let obj = "v -1 2 -1\nv 1 2 -1\nv 1 2 1\nv -1 2 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";
    std::fs::write(folder.path().join("lamp.obj"), obj).unwrap();
    let image = "emits = { image = { file = 'four.png', scale = 4 } }";
    for (name, lamp) in [
        ("sphere", "sphere = { center = [0.3, 2, 0], radius = 0.7 }"),
        (
            "turned sphere",
            "transform = { rotate = { axis = [1, 1, 0], degrees = 70 } }\nsphere = { center = [1, 1, 0], radius = 0.7 }",
        ),
        (
            "triangle",
            "two_sided = true\ntriangle = { a = [-1, 2, -1], b = [1, 2, 1], c = [-1, 1.5, 1] }",
        ),
        ("mesh", "two_sided = true\nmesh = { file = 'lamp.obj' }"),
        ("box", "box = { min = [-1, 1.5, -1], max = [0.5, 2, 1] }"),
        (
            "mirrored box",
            "transform = { scale = [-1, 1, 1] }\nbox = { min = [-1, 1.5, -1], max = [0.5, 2, 1] }",
        ),
        (
            "moving quad",
            "motion = [1, 0, 0]\nquad = { corner = [-1, 2, -1], u = [2, 0, 0], v = [0, 0, 2] }",
        ),
    ] {
        let text = format!(
            "shutter = [0, 1]\n[materials.m]\nlambert = {{ albedo = 0.8 }}\n[[objects]]\nmaterial = 'm'\n\
             quad = {{ corner = [-5, 0, 5], u = [10, 0, 0], v = [0, 0, -10] }}\n[[objects]]\n{image}\n{lamp}\n"
        );
        let scene = scene([0.0, 0.5, 2.0], &text, Some(folder.path()));
        let read = |integrator: &dyn Integrator, samples| {
            let mut tracer = Tracer::new(&scene);
            let estimate: Estimate = (0..samples)
                .map(|i| {
                    let stream = Stream::new(3, i, 0);
                    let time = (i as f32 + 0.5) / samples as f32;
                    let ray = scene.camera.ray(0.5, 0.5).at_time(time);
                    f64::from(integrator.li(&mut tracer, &ray, &stream).r)
                })
                .collect();
            (estimate.mean(), estimate.std_error())
        };
        let max_depth = 2;
        let heuristic = Heuristic::Power;
        let combine = Combine {
            max_depth,
            heuristic,
        };
        let chance = read(&Kajiya { max_depth }, 200_000);
        alike(
            &format!("{name}, next-event"),
            read(&NextEvent { max_depth }, 40_000),
            chance,
            0.04,
        );
        alike(
            &format!("{name}, combine"),
            read(&combine, 40_000),
            chance,
            0.04,
        );
        alike(
            &format!("{name}, path"),
            read(&Path::new(max_depth), 40_000),
            chance,
            0.04,
        );
    }
}

#[test]
fn under_a_white_sky_a_surface_reads_its_own_color_at_each_point() {
    let text = "background = 1\n[camera]\nfrom = [0, 0, 4]\nto = [0, 0, 0]\nfov = 40\n\
                [materials.m]\nmixture = { kd = { checker = { even = 0.5, odd = 0.1, fields = [2, 1] } }, ks = 0.3, kt = 0 }\n\
                [[objects]]\nmaterial = 'm'\nquad = { corner = [-1, -1, 0], u = [2, 0, 0], v = [0, 2, 0] }\n";
    let text = format!("name = 't'\n{text}");
    let source = Source {
        file: "t.toml",
        text: &text,
    };
    let scene = gallery::from_text(source, None, |_| {}).expect("a right scene");
    for (s, albedo) in [(0.4, 0.8), (0.6, 0.4)] {
        let ray = scene.camera.ray(s, 0.5);
        let mut tracer = Tracer::new(&scene);
        let path = Path::new(3);
        let one = |i| f64::from(path.li(&mut tracer, &ray, &Stream::new(1, i, 0)).g);
        let read: Estimate = (0..60_000).map(one).collect();
        accept(&format!("at {s}"), &read, albedo, albedo);
    }
}
