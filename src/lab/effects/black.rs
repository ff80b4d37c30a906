//! Why a picture is black.

use super::missed::misses_everything;
use crate::integrators::{Entry, world::World};
use crate::render::{Options, camera_sample};
use crate::scene::{Interaction, Scene, Sky, Tracer};

/// Camera rays that are looked at, to each side.
const GRID: u32 = 24;
/// Surfaces that one of them may meet.
const LONGEST: u32 = 8;
/// Points of a lamp that are asked for.
const ASKED: [[f32; 2]; 5] = [[0.5, 0.5], [0.1, 0.1], [0.9, 0.1], [0.1, 0.9], [0.9, 0.9]];
/// What refines these points, where a light has many parts.
const MIDDLE: f64 = 0.5;

/// The cosine of light that passes along a surface and does not light it.
const GRAZING: f32 = 1e-6;

/// What walks from the eye see of a scene and its lamps.
#[derive(Default)]
struct Seen {
    /// Camera rays that meet a surface,
    hits: usize,
    /// and those that meet the back of the very object that the first of them met.
    inner: usize,
    /// Backs of lamps met.
    backs: usize,
    /// Points on rough surfaces,
    points: usize,
    /// and of lamps as seen from there: those that shine that way,
    facing: usize,
    /// whose light would fall on the side that is seen,
    beside: usize,
    /// and that no surface stops.
    lit: usize,
    /// Rays that left the scene.
    left: usize,
}

/// Why no sample of a picture has any light, in a sentence, as far as some walks through the scene tell.
///
/// * `max_depth`: the longest path in segments.
pub fn why_black(scene: &Scene, entry: &Entry, max_depth: u32) -> String {
    let has = &scene.inventory;
    if has.is_dark() {
        return "there is no light in the scene: nothing emits, and there is no background"
            .to_owned();
    }
    if misses_everything(entry, has) {
        let name = entry.name;
        return format!("{name} cannot find the light of any lamp of this scene");
    }
    let seen = look(scene);
    let sky = has.sky != Sky::Black;
    let lamps = has.point_lights + has.area_lights > 0;
    let why = if seen.hits == 0 {
        "the camera sees nothing: its rays leave the scene without meeting a surface"
    } else if seen.lit == 0 && seen.hits > 1 && seen.inner == seen.hits && seen.left == 0 {
        "the camera is inside an object, whose inner side is all that it sees"
    } else if max_depth < 2 {
        "paths end after one segment, so only lamps themselves can be seen (max_depth)"
    } else if seen.points == 0 && seen.backs > 0 {
        "every lamp that is seen shows its back: quads and triangles shine on their front side alone"
    } else if seen.points == 0 {
        "what the camera sees reflects no light"
    } else if !lamps && seen.left == 0 {
        "surfaces enclose what the camera sees, so no light of the sky reaches it"
    } else if !lamps {
        "no sample found light: where rays leave the scene, the sky is black or hardly ever met"
    } else if seen.facing == 0 && sky {
        "every lamp shows its back to what the camera sees, and no light of the sky reaches it"
    } else if seen.facing == 0 {
        "every lamp shows its back to what the camera sees: quads and triangles shine on their front \
         side alone"
    } else if seen.beside == 0 {
        "lamps light only the far side of what the camera sees"
    } else if seen.lit == 0 {
        "no lamp reaches what the camera sees: surfaces stand between"
    } else {
        let name = entry.name;
        return format!(
            "lamps shine on what the camera sees, but no sample of {name} found one: they are too small \
             or too hidden for so few samples"
        );
    };
    why.to_owned()
}

/// Walks from the eye.
fn look(scene: &Scene) -> Seen {
    let mut seen = Seen::default();
    let mut first = None;
    let mut tracer = Tracer::new(scene);
    let [width, height] = scene.size;
    for i in 0..GRID * GRID {
        let pixel = [(i % GRID, width), (i / GRID, height)];
        let [x, y] = pixel.map(|(k, n)| (u64::from(k) * u64::from(n) / u64::from(GRID)) as u32);
        let (mut ray, stream) = camera_sample(scene, &Options::default(), [x, y], i);
        for segment in 1..=LONGEST {
            let Some(at) = tracer.intersect(&ray, segment) else {
                seen.left += 1;
                break;
            };
            let behind = at.wo.z < 0.0;
            if segment == 1 {
                seen.hits += 1;
                let object: *const _ = at.object;
                let same = *first.get_or_insert(object) == object;
                seen.inner += usize::from(same && behind);
            }
            seen.backs += usize::from(behind && at.object.light.is_some());
            if tracer.smooth_event(&at).is_some() {
                seen.points += 1;
                ask(&mut seen, &mut tracer, &at);
            }
            match tracer.sample_bsdf(&at, u64::from(segment), &stream) {
                Some(step) => ray = step.ray,
                None => break,
            }
        }
    }
    seen
}

/// Asks every lamp for light at a point.
fn ask(seen: &mut Seen, tracer: &mut Tracer, at: &Interaction) {
    let Some(bsdf) = at.bsdf else {
        return;
    };
    for lamp in 0..tracer.scene().lights.len() {
        for u in ASKED {
            let Some(sample) = tracer.light_sample(lamp, &at.surface, MIDDLE, u) else {
                continue;
            };
            if sample.incident.facing_irradiance().is_black() {
                continue;
            }
            seen.facing += 1;
            let wi = at.frame.to_local(sample.wi);
            if wi.z.abs() < GRAZING || bsdf.f(at.wo, wi).is_black() {
                continue;
            }
            seen.beside += 1;
            seen.lit += usize::from(tracer.visible(lamp, &sample));
        }
    }
}
