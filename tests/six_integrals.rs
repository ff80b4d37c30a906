//! The integrals of a picture one at a time: each profile against its closed form, and against wrong
//! lenses, shutters, lamps, edges, walls and facets.

use crate::checks::{alike, unlike};
use crate::of_chapters::profiles::{Profile, Reading, lobe_energy};
use halfdisk::integrators::{Distributed, Integral, Integrator, Kajiya, NextEvent};
use halfdisk::lab::estimators::furnace::irradiance;
use halfdisk::lab::estimators::worlds::ball;
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Purpose;
use halfdisk::scene::description::{Description, Material, Shape};
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;
use halfdisk::scene::value::{Positive, Triple};
use halfdisk::space::{Flat, Solid};
use std::f64::consts::{LN_2, PI};

const SPP: u32 = 16_384;

fn profile(integral: Integral) -> Profile {
    let all = Profile::all();
    all.into_iter().find(|p| p.integral == integral).unwrap()
}

fn worst(row: &[Reading]) -> f64 {
    row.iter().map(|r| r.z().abs()).fold(0.0, f64::max)
}

#[test]
fn s0_14_each_of_six_integrals_has_its_closed_form_everywhere() {
    for profile in Profile::all() {
        let (row, rays) = profile.read(SPP, 3, |_| {}).unwrap();
        let z = worst(&row);
        println!(
            "{:?}: largest |z| {z:.2} of {}",
            profile.integral,
            row.len()
        );
        assert!(z <= 4.0, "{:?}: {z}", profile.integral);
        if let Some((width, error)) = profile.width_of(&row) {
            let exact = profile.width.unwrap();
            println!("  width {width:.5} ± {error:.5}, exact {exact}");
            assert!((width - exact).abs() <= 4.4 * error && error < 0.01 * exact);
        }
        // A camera ray, one to the lamp, one onwards: as many as there are, whatever is drawn.
        let per_sample = match profile.integral {
            Integral::Pixel | Integral::Lens | Integral::Time => 1,
            Integral::Hemisphere => 2,
            Integral::Light => 3,
            // Where a facet sends light into the surface, there is no ray.
            Integral::Gloss => continue,
        };
        assert_eq!(
            rays.total(),
            per_sample * rays.camera,
            "{:?}",
            profile.integral
        );
    }
}

/// Corner and edges of a quad.
fn quad(said: &mut Description, object: usize) -> [&mut Triple; 3] {
    match &mut said.objects[object].shape {
        Shape::Quad { corner, u, v } => [corner, u, v],
        other => panic!("{other:?}"),
    }
}

#[test]
fn s0_14_wrong_lenses_shutters_lamps_edges_walls_and_facets_are_rejected() {
    type Change = fn(&mut Description);
    let wrong: [(&str, Integral, Change); 8] = [
        ("radius doubled", Integral::Lens, |s| {
            s.camera.lens_radius.0 *= 2.0
        }),
        ("focus nearer", Integral::Lens, |s| {
            s.camera.focus = Some(Positive(3.8))
        }),
        ("shutter halved", Integral::Time, |s| {
            s.camera.shutter.0[1] = 1.0
        }),
        ("speed up by a tenth", Integral::Time, |s| {
            s.objects[0].motion.0[0] *= 1.1;
        }),
        ("lamp half as wide", Integral::Light, |s| {
            quad(s, 2)[1].0[0] *= 0.5;
        }),
        ("edge half a pixel off", Integral::Pixel, |s| {
            quad(s, 0)[0].0[0] += 0.5;
        }),
        ("wall a tenth lower", Integral::Hemisphere, |s| {
            quad(s, 1)[2].0[1] *= 0.9;
        }),
        ("facets rougher by a twentieth", Integral::Gloss, |s| {
            for material in s.materials.values_mut() {
                if let Material::Glossy { roughness, .. } = material {
                    roughness.0 = (1.05 * roughness.0).min(1.0);
                }
            }
        }),
    ];
    for (name, integral, change) in wrong {
        let (row, _) = profile(integral).read(SPP, 3, change).unwrap();
        println!("{name}: largest |z| {:.1}", worst(&row));
        assert!(worst(&row) > 6.0, "{name}");
    }
}

#[test]
fn s1_05_the_sky_in_a_groove_and_in_a_cone() {
    for sin in [0.1_f64, 0.5, 0.9] {
        let sky = ball::<Flat>(sin as f32, 0.0);
        let groove = irradiance::<Flat, _>(sky, 200_000, 8);
        let cone = irradiance::<Solid, _>(ball::<Solid>(sin as f32, 0.0), 200_000, 8);
        let (flat, solid) = (2.0 * sin, PI * sin * sin);
        println!("sin {sin}: z {:.2}, {:.2}", groove.z(flat), cone.z(solid));
        assert!(groove.z(flat).abs() <= 4.4 && cone.z(solid).abs() <= 4.4);
        // The law of the other world is another.
        assert!(groove.z(2.0 * sin * sin).abs() > 10.0 && cone.z(PI * sin).abs() > 10.0);
    }
}

#[test]
fn the_roughest_lobe_keeps_one_minus_the_logarithm_of_two() {
    assert!((lobe_energy(1.0) - (1.0 - LN_2)).abs() < 1e-7);
    assert!((lobe_energy(1e-4) - 1.0).abs() < 1e-6);
    let falls =
        (1..20).all(|i| lobe_energy(0.05 * f64::from(i)) > lobe_energy(0.05 * f64::from(i + 1)));
    assert!(falls);
}

fn six(integrator: &impl Integrator, fixed: &'static [Purpose], spp: u32, seed: u64) -> Rendered {
    let scene = gallery::load("six").unwrap().sized([24, 18]);
    let options = Options {
        spp,
        seed,
        fixed,
        ..Options::default()
    };
    let rendered = render(&scene, integrator, &options, &());
    assert_eq!(rendered.non_finite, 0);
    rendered
}

#[test]
fn up_to_the_first_surface_every_integral_costs_the_same_rays() {
    let first = |fixed| six(&Distributed { max_depth: 2 }, fixed, 16, 1).rays;
    let none = first(Integral::NONE);
    assert_eq!((none.shadow, none.secondary), (none.camera, none.camera));
    for integral in Integral::ALL {
        let rays = first(integral.others());
        assert_eq!(
            (rays.camera, rays.shadow),
            (none.camera, none.shadow),
            "{integral:?}"
        );
        // A facet may send light into the surface: no other ray is lost.
        let lost = none.secondary - rays.secondary;
        println!(
            "{integral:?}: {lost} of {} secondary rays lost",
            none.secondary
        );
        assert!(integral == Integral::Gloss || lost == 0, "{integral:?}");
        assert!(lost * 50 < none.secondary);
    }
    let all = first(&[]);
    assert_eq!((all.camera, all.shadow), (none.camera, none.shadow));
    assert!((none.secondary - all.secondary) * 50 < none.secondary);
}

#[test]
fn what_is_left_out_draws_nothing() {
    // Without any integral every sample is the same; with one the picture has variance.
    let shot = |fixed| {
        six(&Distributed { max_depth: 3 }, fixed, 4, 1)
            .film
            .sample_variance()
    };
    assert!(shot(Integral::NONE) < 1e-12);
    for integral in Integral::ALL {
        assert!(shot(integral.others()) > 1e-6, "{integral:?}");
        assert_eq!(integral.others().len(), 5);
        assert!(!integral.others().contains(&integral.purpose()));
    }
}

#[test]
fn all_six_together_are_what_the_walks_see() {
    let max_depth = 4;
    let all = six(&Distributed { max_depth }, &[], 512, 1).film;
    let asking = six(&NextEvent { max_depth }, &[], 512, 2).film;
    let walk = six(&Kajiya { max_depth }, &[], 6144, 3).film;
    alike("next-event", all.mean(), asking.mean(), 0.01);
    alike("kajiya", all.mean(), walk.mean(), 0.013);
    let shorter = six(&Distributed { max_depth: 3 }, &[], 512, 1).film;
    unlike("shorter paths", shorter.mean(), walk.mean());
    let sharp = six(&Distributed { max_depth }, Integral::NONE, 1, 1).film;
    assert!((sharp.mean().0 - walk.mean().0).abs() > 0.005);
}

#[test]
fn s0_08_all_but_the_light_of_a_point_through_glass() {
    let under_glass = |lamp: &str| {
        let text = format!(
            "name = 'pane'\nfilm.size = [4, 4]\nmaterials.half.lambert.albedo = 0.5\n\
             materials.pane.glass.ior = 1.5\n\
             camera = {{ from = [0, 0.5, 0], to = [0, 0, 0], up = [0, 0, -1], fov = 30 }}\n\
             [[objects]]\nmaterial = 'half'\n\
             quad = {{ corner = [-9, 0, 9], u = [18, 0, 0], v = [0, 0, -18] }}\n\
             [[objects]]\nmaterial = 'pane'\n\
             box = {{ min = [-9, 1, -9], max = [9, 1.1, 9] }}\n{lamp}\n"
        );
        let source = Source {
            file: "pane",
            text: &text,
        };
        let scene = gallery::from_text(source, None, |_| {}).unwrap();
        let options = Options {
            spp: 1024,
            ..Options::default()
        };
        render(&scene, &Distributed { max_depth: 5 }, &options, &()).film
    };
    let ball = under_glass("[[objects]]\nemits = 9\nsphere = { center = [0, 3, 0], radius = 0.5 }");
    let point = under_glass("[[lights]]\npoint = { position = [0, 3, 0], intensity = 7 }");
    let (mean, error) = ball.mean();
    println!(
        "a ball's light {mean:.4} ± {error:.4}, a point's {}",
        point.mean().0
    );
    assert!(mean > 4.4 * error && point.max() == 0.0);
}
