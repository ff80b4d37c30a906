//! Inputs on which plain code goes wrong, each with a plain twin that does.
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
//! | A4 offset, shadow rays | `leaving::a04_*_shadow_*` | 0 of 598 003 end behind their lamp | 23 % |
//! | A5 closed meshes | `watertight::a05_*_meshes_*` | 0 of 240 000 rays escape | 8 to 11 % at vertices and edges |
//! | A5 rooms of quads | `watertight::a05_*_rooms_*` | 0 of 600 000 rays escape | |
//! | A6 degenerate triangles | `geometry::a06_*` | 0 of 10⁵ hit, normals unit to 4.2e-8 | 10 829 hit |
//! | A7 degenerate lamps | `lights::sphere::a07_*` | refused, or the picture without them | |
//! | A8 boxes | `watertight::a08_*` | 0 lost, entry / t at most 1 | 192 of 216 in faces, 16 % at corners |
//! | A9 hierarchies | `hierarchy::a09_*` | all bits as the plain loop | |
//! | A4, A9 shapes in motion | `moving::*` | all bits as the loop, 0 rays come back | |
//! | A12 ties | `hierarchy::a12_*` | always the lowest id | |
//! | A16 invalid rays | `geometry::a16_*` | 0 of 10⁴ hit | |
//! | A20 ends of uniforms | `warps::a20_*` | lowest cosine 2.4e-4, unit to 7.8e-8 | |
//! | A20 ends of uniforms | `twins::a20_*` | unit to 1.2e-7, inverse to 1.8e-7 | |
//! | A22 rim of the half disk | `twins::a22_*` | sine off by 8.9e-8 of itself, never negative | -4.4e-8 at the rim |
//! | A23 cone of a sphere lamp | `lights::sphere::a23_*` | pdf · Ω off by 1.1e-7, for r / d to 1e-15 | off by over 1 % in 13 of 16 |
//! | A24 rectangular lamps | `lights::rectangle::a24_*` | relative variance at most 0.33 at any height | by area 5.7e4 at h = 1e-3 |
//! | A25 point light at the point | `lights::sphere::a25_*` | no light, nothing infinite | |
//! | A27 one of many lights | `lights::choice::a27_*` | dark ones never, 10⁵ of them | sums in `f32` lose 10⁵ lights |
//! | A35 almost smooth, grazing | `limits::a35_*` | all finite, down to a cosine of 1e-20 | |
//! | A36 rough white furnace | `furnace::a36_*` | 40 readings within 4.4 errors | one that reads 1 |

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
