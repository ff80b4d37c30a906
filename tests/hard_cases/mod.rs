//! Inputs on which plain code goes wrong, each with a plain twin that does (`halfdisk::numeric::naive`).
//!
//! Names without a folder are those of modules here; others, such as `lights::`, of `tests/`. Each test
//! prints its worst case, and the seed where it draws.
//!
//! | Case | Test | Worst figure seen | The plain twin |
//! |---|---|---|---|
//! | A1 far, tiny spheres | `geometry::a01_*` | 0 misses, 0 false hits, \|Δt\| 0.41 ulp(D + r) | 29 199 misses, 64 930 false hits |
//! | A2 huge sphere | `geometry::a02_*` | \|Δt\| 6.0e-8 | 0.40 |
//! | A3 leaving spheres | `leaving::a03_*` | 0 of 2·10⁶ rays come back | 48 % do |
//! | A4 offset, any proportions | `leaving::a04_*_of_triangles_*` | 0 of 10⁶ again, error 0.44 of its bound | |
//! | A4 offset, far away | `leaving::a04_*_far_from_*` | 0 of 24·10⁶ again | at least 26 % |
//! | A4 offset, 64 ulp gap | `leaving::a04_*_gap_*` | 0 of 1.2·10⁶ jump over | fixed 1e-3: half |
//! | A4 offset, scaled | `leaving::a04_*_scales_*` | 74 308 crossings, all bits equal | |
//! | A4 pictures, scaled by 2ᵏ | `structure::a04_*` | 41 scales, all bits equal | times 3: other bits |
//! | A4 offset, shadow rays | `leaving::a04_*_shadow_*` | 0 of 598 003 end behind their lamp | 23 % |
//! | A5 closed meshes | `watertight::a05_*_meshes_*` | 0 of 240 000 rays escape | 8 to 11 % at vertices and edges |
//! | A5 rooms of quads | `watertight::a05_*_rooms_*` | 0 of 600 000 rays escape | |
//! | A6 degenerate triangles | `geometry::a06_*` | 0 of 10⁵ hit, normals unit to 4.2e-8 | 10 829 hit |
//! | A7 degenerate lamps | `lights::sphere::a07_*` | refused, or the picture without them | |
//! | A8 boxes | `watertight::a08_*` | 0 lost, entry / t at most 1 | 192 of 216 in faces, 16 % at corners |
//! | A9 hierarchies | `hierarchy::a09_*`, `properties::trees_*` | all bits as the plain loop | |
//! | A4, A9 shapes in motion | `moving::*` | all bits as the loop, 0 rays come back | |
//! | A10 frames near -z | `sampling::a10_*` | rms 3.8e-8 | 2.35 |
//! | A11 poles, no upright | `viewing::a11_*`, `lights::environment::poles_*` | refused; all finite | arc cosines of 23 % are NaN |
//! | A12 ties | `hierarchy::a12_*` | always the lowest id | |
//! | A12 two lamps in one place | `structure::objects_doubled_*` | all bits as with one | |
//! | A13 far from the origin | `viewing::a13_a_scene_*` | relMSE 0 of that of two seeds | 33 places on a unit sphere |
//! | A13 thin walls | `viewing::a13_a_wall_*` | 3·10⁴ points in full shadow | |
//! | A13 too small for its place | `viewing::a13_what_*` | reported | |
//! | A14 checkers on a plane | none: there are no textures | | |
//! | A15 transforms | `viewing::a15_*`, `cli::bad_scenes::coordinates_*` | normals off by 4.4e-7 | off by 0.9 |
//! | A16 invalid rays | `geometry::a16_*` | 0 of 10⁴ hit | |
//! | A17 motion | `viewing::a17_*`, `moving::*`, `motion::a_closed_shutter_*` | shut: all bits equal | mixed matrices shrink to 0 |
//! | A18 thin lens | `viewing::a18_*`, `six_integrals::s0_14_*` | radius 0: all bits equal | the zero vector at focus 1e30 |
//! | A19 inside lamps and glass | `viewing::a19_*`, `ladder::weights::inside_*` | within 4.4 errors; glass exactly 1 | |
//! | A20 ends of uniforms | `warps::a20_*` | lowest cosine 2.4e-4, unit to 7.8e-8 | 128 words make 1 (`ch17`) |
//! | A20 ends of uniforms | `twins::a20_*` | unit to 1.2e-7, inverse to 1.8e-7 | |
//! | A21 rim of the hemisphere | `sampling::a21_*` | lowest cosine 2.4e-4 | 0 / 0 on the rim |
//! | A22 rim of the half disk | `twins::a22_*` | sine off by 8.9e-8 of itself, never negative | -4.4e-8 at the rim |
//! | A23 cone of a sphere lamp | `lights::sphere::a23_*` | pdf · Ω off by 1.1e-7, for r / d to 1e-15 | off by over 1 % in 13 of 16 |
//! | A24 rectangular lamps | `lights::rectangle::a24_*` | relative variance at most 0.33 at any height | by area 5.7e4 at h = 1e-3 |
//! | A25 point light at the point | `lights::sphere::a25_*` | no light, nothing infinite | |
//! | A26 weights | `sampling::a26_*`, `ladder::weights::s0_23_*` | sums off 1 by 0 | 2891 of 6083 sums |
//! | A26 lights without extent | `sampling::a26_lights_*` | within 4.4 errors | a placeholder density loses 9 % |
//! | A27 one of many lights | `lights::choice::a27_*` | dark ones never, 10⁵ of them | sums in `f32` lose 10⁵ lights |
//! | A28 survival | `sampling::a28_*`, `ladder::survival::*` | means within 4.4 errors | 1.5 becomes 1 |
//! | A29 points that lie evenly | `sampling::a29_*`, `stream::even_points_*` | correlations at most 0.034, below 1 | 1.0 (bases 59, 61); reaches 1 |
//! | A30 jitter far to the right | `sampling::a30_*` | p 0.38 | p 0 |
//! | A31 interfaces | `scattering::a31_*`, `fresnel::*` | off by 4.6e-14 | 23 140 of 70 007 NaN |
//! | A32 Schlick's form | `scattering::a32_*` | exact | off by 0.96 inside glass |
//! | A33 refraction | `scattering::a33_*`, `ladder::a_slab_*` | T off by 1e-8, glass in white light 1 | 7454 NaN |
//! | A34 touching interfaces | `scattering::a34_*` | glass to water 0.99639 | 0.94150 by way of air |
//! | A34 nested media | none: media have no priorities | | |
//! | A35 almost smooth, grazing | `materials::limits::a35_*` | all finite, down to a cosine of 1e-20 | peak off by 2.6 % at 1e-3 (`ch17`) |
//! | A36 rough white furnace | `materials::furnace::a36_*` | 40 readings within 4.4 errors | one that reads 1 |
//! | A36 every material | `scattering::a36_*` | at most 1, smooth ones exactly | |
//! | A37 shading normals | `scattering::a37_*` | there are none; no light gets in | |
//! | A38 shares of a mixture | `scattering::a38_*`, `materials::mixture::*` | weights exceed by 0 | 0 / 0, and absorption of -0.4 |
//! | A39 samples at fault | `film_and_input::a39_*`, `film::bad_samples_*` | counted exactly, others unchanged | a NaN pixel looks black |
//! | A40 sums | `film_and_input::a40_*` | 10⁸ samples, off by 1.3e-13 | off by 0.66 |
//! | A41 variances | `film_and_input::a41_*` | 0.3336 at any mean | -2.1e6 around 10⁴ |
//! | A42 rare bright samples | `film_and_input::a42_*` | nothing is clamped: 0.96 ± 0.03 of 1 | clamped 0.001 |
//! | A43 levels | `film_and_input::a43_*`, `film::png_*` | mean off by 1.3e-7 | by -0.002 |
//! | A44 sizes | `film_and_input::a44_*`, `cli::bad_scenes::*` | painted or refused | 65536² has no pixel |
//! | A45 numbers in files | `film_and_input::a45_*`, `mutations::*` | refused with line and field | parsed as infinite |
//! | A46 nothing | `film_and_input::a46_*`, `cli::bad_meshes::*` | the background to the last bit | |
//! | A47 order | `structure::a47_*`, `determinism::*` | 1, 2, 7 threads: all bits equal | sums of parts differ |
//! | A48 faint paths | `structure::a48_*` | 10 rays, the light exact | 1000 rays |
//! | A51 absent effects | `effects::bits::*` | absent, compiled out, at no strength: the same bytes | a kernel without gloss |
//! | A52 effects overlooked | `effects::bits::*` | all forced on: the same bytes, on the whole gallery | |
//! | any numbers | `properties::*`, `materials::limits::any_*`, `mutations::*` | sound | a wrong tree is noticed |

mod draw;
mod film_and_input;
mod geometry;
mod hierarchy;
mod leaving;
mod moving;
mod naive;
mod properties;
mod sampling;
mod scattering;
mod structure;
mod viewing;
mod watertight;

use halfdisk::scene::Scene;
use halfdisk::scene::description::Description;
use halfdisk::scene::gallery;
use halfdisk::scene::read::Source;

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
