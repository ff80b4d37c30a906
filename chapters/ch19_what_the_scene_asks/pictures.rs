//! The room, whole and class by class.

use crate::{ROOM, load};
use halfdisk::integrators::{FilteredPath, Integrator, Path};
use halfdisk::lab::chapter::{Desk, DeskError, Number};
use halfdisk::lab::effects::language::{Class, Finds, finds};
use halfdisk::render::{Options, Rendered, render};
use halfdisk::sampling::stream::Sampler;
use halfdisk::scene::Scene;

/// What the pictures cost.
pub struct Drawn {
    /// Rays traced.
    pub rays: u64,
    /// Variance of one sample of the picture.
    pub variance: f64,
    /// Rays of one of its samples.
    pub per_sample: f64,
}

/// How a class is called in numbers and files.
fn short(class: Class) -> &'static str {
    match class {
        Class::Seen => "seen",
        Class::SeenSpecular => "seen_specular",
        Class::Direct => "direct",
        Class::DirectSpecular => "direct_specular",
        Class::Bleeding => "bleeding",
        Class::Caustic => "caustic",
    }
}

/// What to look at in the picture of a class.
fn look_at(class: Class) -> &'static str {
    match class {
        Class::Seen => "The lamp, and nothing else.",
        Class::SeenSpecular => "The lamp in the ball and in the block, where they show it.",
        Class::Direct => "Shadows are black: no light comes from the walls.",
        Class::DirectSpecular => "The lit room in the mirror, and upside down in the glass.",
        Class::Bleeding => {
            "The ceiling, which the lamp itself does not reach, and the tint of the walls."
        }
        Class::Caustic => "The spot under the ball, and its glow on the walls around.",
    }
}

/// Paints them.
pub fn work(desk: &mut Desk) -> Result<Drawn, DeskError> {
    let scene = load(ROOM, desk.choose([176; 2], [48; 2]))?;
    let path = Path::new(scene.suggested.max_depth);
    let whole = paint(desk, &scene, desk.spp(16, 8), &path)?;
    let caption = "The room. Look for the bright spot that the glass ball gathers on the floor, for the second one \
                   high on the green wall, which the mirror throws there, and for the tint that the walls lend to the \
                   ceiling. The specks on the block and in the ball are caustics seen in a mirror or through glass: the \
                   one kind of light here that is still found by chance.";
    desk.picture("image.png", caption, &whole.film, &scene)?;

    let scene = load(ROOM, desk.choose([72; 2], [32; 2]))?;
    let spp = desk.spp(16, 8);
    let all = paint(desk, &scene, spp, &path)?;
    let total = all.film.mean().0;
    let mut rays = whole.rays.total() + all.rays.total();
    let mut sum = 0.0;
    for class in Class::ALL {
        if finds(&Path::ENTRY, class, &scene.inventory) == Finds::Absent {
            continue;
        }
        let expression = class.expression();
        let paths = expression.eye_first();
        let part = paint(desk, &scene, spp, &FilteredPath { path, paths })?;
        let caption = format!("{}: {}. {}", class.text(), class.name(), look_at(class));
        let name = short(class);
        desk.picture(&format!("{name}.png"), &caption, &part.film, &scene)?;
        let (mean, error) = part.film.mean();
        let number = Number {
            error: Some(100.0 * error / total),
            ..Number::new(&format!("share of {}", class.text()), 100.0 * mean / total).unit("%")
        };
        desk.number(&format!("share_{name}"), number);
        sum += mean / total;
        rays += part.rays.total();
    }
    let says = "the sum of the classes, over the whole";
    desk.known("share_sum", says, sum, 1.0);
    Ok(Drawn {
        rays,
        variance: whole.film.sample_variance(),
        per_sample: whole.rays.total() as f64 / whole.rays.camera as f64,
    })
}

fn paint(
    desk: &Desk,
    scene: &Scene,
    spp: u32,
    by: &impl Integrator,
) -> Result<Rendered, DeskError> {
    let options = Options {
        spp,
        seed: desk.options.seed,
        sampler: Sampler::Sobol,
        ..Options::default()
    };
    let rendered = render(scene, by, &options, &desk.bar("room"));
    if rendered.interrupted {
        return Err(DeskError::Interrupted);
    }
    Ok(rendered)
}
