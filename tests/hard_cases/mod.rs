//! Inputs on which plain code goes wrong, each with a plain twin that does (`halfdisk::lab::naive`).
//!
//! Names without a folder are those of modules here; others, such as `lights::`, of `tests/`. Each test
//! prints its worst case and that of the plain twin, and the seed where it draws.
//!
//! | Case | Test | The plain twin |
//! |---|---|---|
//! | A1 far, tiny spheres | `geometry::a01_*` | misses, and false hits |
//! | A2 huge sphere | `geometry::a02_*` | distances wrong in the first digit |
//! | A3 leaving spheres | `leaving::a03_*` | half of the rays come back |
//! | A4 offset, any proportions | `leaving::a04_*_of_triangles_*` | |
//! | A4 offset, far away | `leaving::a04_*_far_from_*` | a quarter and more come back |
//! | A4 offset, 64 ulp gap | `leaving::a04_*_gap_*` | a fixed 1e-3: half jump over |
//! | A4 offset, scaled | `leaving::a04_*_scales_*` | |
//! | A4 pictures, scaled by 2ᵏ | `structure::a04_*` | scaled by 3: other bits |
//! | A4 offset, shadow rays | `leaving::a04_*_shadow_*` | a quarter end behind their lamp |
//! | A5 closed meshes | `watertight::a05_*_meshes_*` | rays escape at vertices and edges |
//! | A5 rooms of quads | `watertight::a05_*_rooms_*` | |
//! | A6 degenerate triangles | `geometry::a06_*` | some are hit |
//! | A7 degenerate lamps | `lights::sphere::a07_*` | |
//! | A8 boxes | `watertight::a08_*` | rays in faces and at corners are lost |
//! | A9 hierarchies | `hierarchy::a09_*`, `properties::trees_*` | |
//! | A4, A9 shapes in motion | `moving::*` | |
//! | A4, A15 instances | `instances::*` | points that claim to be exact come back |
//! | A10 frames near -z | `sampling::a10_*` | not orthonormal |
//! | A11 poles, no upright | `viewing::a11_*`, `lights::environment::poles_*` | arc cosines are NaN |
//! | A12 ties | `hierarchy::a12_*` | |
//! | A12 two lamps in one place | `structure::objects_doubled_*` | |
//! | A13 far from the origin | `viewing::a13_a_scene_*` | a few places on a unit sphere |
//! | A13 thin walls | `viewing::a13_a_wall_*` | |
//! | A13 too small for its place | `viewing::a13_what_*` | |
//! | A14 checkers on a plane | `textures::an_image_*`: where they are is told by `u` and `v` | |
//! | A15 transforms | `viewing::a15_*`, `cli::bad_scenes::coordinates_*` | normals that are none |
//! | A16 invalid rays | `geometry::a16_*` | |
//! | A17 motion | `viewing::a17_*`, `moving::*`, `motion::a_closed_shutter_*` | mixed matrices shrink |
//! | A18 thin lens | `viewing::a18_*`, `six_integrals::s0_14_*` | the zero vector at focus 1e30 |
//! | A19 inside lamps and glass | `viewing::a19_*`, `ladder::weights::inside_*` | |
//! | A20 ends of uniforms | `warps::a20_*` | words that make 1 (`ch17`) |
//! | A20 ends of uniforms | `twins::a20_*` | |
//! | A21 rim of the hemisphere | `sampling::a21_*` | 0 / 0 on the rim |
//! | A22 rim of the half disk | `twins::a22_*` | a negative sine at the rim |
//! | A23 cone of a sphere lamp | `lights::sphere::a23_*` | off by more than 1 % where it is small |
//! | A24 rectangular lamps | `lights::rectangle::a24_*` | by area: variance without bound nearby |
//! | A25 point light at the point | `lights::sphere::a25_*` | |
//! | A26 weights | `sampling::a26_*`, `ladder::weights::s0_23_*` | sums that are not 1 |
//! | A26 lights without extent | `sampling::a26_lights_*` | a placeholder density loses light |
//! | A27 one of many lights | `lights::choice::a27_*` | sums in `f32` lose the faint |
//! | A28 survival | `sampling::a28_*`, `ladder::survival::*` | 1.5 becomes 1 |
//! | A29 points that lie evenly | `sampling::a29_*`, `stream::even_points_*` | bases 59 and 61 correlate |
//! | A30 jitter far to the right | `sampling::a30_*` | the steps of the grid show |
//! | A31 interfaces | `scattering::a31_*`, `fresnel::*` | NaN |
//! | A32 Schlick's form | `scattering::a32_*` | wrong inside glass |
//! | A33 refraction | `scattering::a33_*`, `ladder::a_slab_*` | NaN |
//! | A34 touching interfaces | `scattering::a34_*` | by way of air, less |
//! | A34 nested media | none: media have no priorities | |
//! | A35 almost smooth, grazing | `materials::limits::a35_*` | a wrong peak (`ch17`) |
//! | A36 rough white furnace | `materials::furnace::a36_*` | one that reads 1 |
//! | A36 every material | `scattering::a36_*` | |
//! | A37 shading normals | `scattering::a37_*` | |
//! | A38 shares of a mixture | `scattering::a38_*`, `materials::mixture::*` | 0 / 0, negative absorption |
//! | A39 samples at fault | `film_and_input::a39_*`, `film::bad_samples_*` | a NaN pixel looks black |
//! | A40 sums | `film_and_input::a40_*` | stops growing |
//! | A41 variances | `film_and_input::a41_*` | negative around large means |
//! | A42 rare bright samples | `film_and_input::a42_*` | clamped, the light is lost |
//! | A43 levels | `film_and_input::a43_*`, `film::png_*` | cut off, too dark by half a level |
//! | A44 sizes | `film_and_input::a44_*`, `cli::bad_scenes::*` | the product overflows |
//! | A45 numbers in files | `film_and_input::a45_*`, `mutations::*` | parsed as infinite |
//! | A46 nothing | `film_and_input::a46_*`, `cli::bad_meshes::*` | |
//! | A47 order | `structure::a47_*`, `determinism::*` | sums of parts differ |
//! | A48 faint paths | `structure::a48_*` | a hundred times the rays |
//! | A49 photons: any size, far away | `photons::input::a49_scenes_*` | a radius that is not scaled along |
//! | A49 photons: radii, edges, counts | `photons::input::a49_radii_*`, `photons::map::*`, `photons::density::*` | 0 / 0; half at an edge; `k / (k - 1)` |
//! | A49 photons: no lamp, only a sky | `photons::input::a49_no_lamp_*` | |
//! | A49 photons: lamp or camera in glass | `photons::pictures::s0_01_*`, `photons::input::a49_a_camera_*` | exactly black by paths |
//! | A50 patches of any size | `patches::a50_rooms_of_*` | a fixed offset: half the pairs are hidden and more |
//! | A50 patches far away | `patches::a50_*_far_*` | a fixed offset of 1e-4 sees nothing |
//! | A50 slivers | `patches::a50_slivers_*` | centre to centre: nothing in place of a half |
//! | A50 patches that touch | `patches::a50_patches_*`, `radiosity::forms::*` | centre to centre: off by its own size |
//! | A51 absent effects | `effects::bits::*` | a kernel without gloss |
//! | A52 effects overlooked | `effects::bits::*` | |
//! | any numbers | `properties::*`, `materials::limits::any_*`, `mutations::*` | a wrong tree is noticed |

mod draw;
mod film_and_input;
mod geometry;
mod hierarchy;
mod instances;
mod leaving;
mod moving;
mod naive;
mod patches;
mod properties;
mod sampling;
mod scattering;
mod structure;
mod viewing;
mod watertight;

use halfdisk::integrators::{Entry, Integrator, Settings};
use halfdisk::scene::Scene;
use halfdisk::scene::description::Description;
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;

/// The integrator for a scene, as usual.
fn made(entry: &Entry, scene: &Scene, max_depth: u32) -> Box<dyn Integrator> {
    let settings = Settings::new(max_depth);
    entry.prepare(scene, &settings).expect("an integrator")
}

/// A scene of these objects and lights, seen from the origin along `z`.
fn scene(text: &str) -> Scene {
    let start = "camera = { from = [0, 0, 0], to = [0, 0, 1], fov = 40 }\nname = 'test'\n\
                 materials.half.lambert.albedo = 0.5\n";
    let text = start.to_owned() + text;
    let source = Source {
        file: "test.toml",
        text: &text,
    };
    gallery::from_text(source, None, |_| {}).expect("a proper scene")
}

/// A closed room with a ball that scatters, one of glass, and a lamp below the ceiling.
const ROOM: &str = "name = 'room'
[camera]
from = [0.2, 1, 3.7]
to = [0, 0.9, 0]
fov = 60
[materials]
white.lambert.albedo = 0.7
red.lambert.albedo = [0.6, 0.1, 0.1]
glass.glass.ior = 1.5
[[objects]]
material = 'white'
quad = { corner = [-2, 0, 4], u = [4, 0, 0], v = [0, 0, -6] }
[[objects]]
material = 'white'
quad = { corner = [-2, 3, -2], u = [4, 0, 0], v = [0, 0, 6] }
[[objects]]
material = 'white'
quad = { corner = [-2, 0, -2], u = [4, 0, 0], v = [0, 3, 0] }
[[objects]]
material = 'white'
quad = { corner = [2, 0, 4], u = [-4, 0, 0], v = [0, 3, 0] }
[[objects]]
material = 'red'
quad = { corner = [-2, 0, 4], u = [0, 0, -6], v = [0, 3, 0] }
[[objects]]
material = 'white'
quad = { corner = [2, 0, -2], u = [0, 0, 6], v = [0, 3, 0] }
[[objects]]
material = 'red'
sphere = { center = [-0.8, 0.6, 0.1], radius = 0.55 }
[[objects]]
material = 'glass'
sphere = { center = [0.9, 0.55, 0.8], radius = 0.5 }
[[objects]]
emits = 6
quad = { corner = [-0.6, 2.9, -0.4], u = [1.2, 0, 0], v = [0, 0, 0.9] }
";

/// The room, changed before it is built.
fn room_with(size: [i64; 2], change: impl FnOnce(&mut Description)) -> Scene {
    let source = Source {
        file: "room.toml",
        text: ROOM,
    };
    let sized = |said: &mut Description| {
        said.film.size = size;
        change(said);
    };
    gallery::from_text(source, None, sized).expect("a proper scene")
}

fn room(size: [i64; 2]) -> Scene {
    room_with(size, |_| {})
}
