//! One ball on one floor: each material under the same light, and the same ball under each light.

use super::{DeskError, Drawn};
use halfdisk::lab::chapter::Desk;

/// The scene. Its material for the ball and its light, the last part of it, are exchanged.
const STAGE: &str = include_str!("../../examples/recipes/stage.toml");

/// The line that says what the ball is made of.
const BALL: &str = "lambert = { albedo = [0.7, 0.3, 0.2] }\n";

/// Where the last part begins.
const LIGHT: &str = "# The light.\n";

/// Name, line of the file, samples of a pixel, what to look at.
const MATERIALS: [(&str, &str, u32, &str); 9] = [
    (
        "lambert",
        "lambert = { albedo = [0.7, 0.3, 0.2] }",
        32,
        "one shade for each angle to the light, from wherever one looks",
    ),
    (
        "mirror",
        "mirror = { reflectance = 0.9 }",
        32,
        "the floor and the light, once each",
    ),
    (
        "glass",
        "glass = { ior = 1.5 }",
        32,
        "the floor upside down, the light mirrored twice, and a caustic",
    ),
    (
        "glossy",
        "glossy = { reflectance = [1, 0.78, 0.34], roughness = 0.2 }",
        32,
        "the light is blurred to a highlight",
    ),
    (
        "rough_glass",
        "rough_glass = { ior = 1.5, roughness = 0.1 }",
        64,
        "frosted: the floor is a blur, and so is the caustic",
    ),
    (
        "mixture",
        "mixture = { kd = [0.5, 0.15, 0.1], ks = 0.2, kt = 0.2 }",
        32,
        "a diffuse colour, a sharp reflection, and some of the floor behind",
    ),
    (
        "smooth",
        "glossy = { reflectance = 0.9, roughness = 0.05 }",
        32,
        "roughness 0.05",
    ),
    (
        "middling",
        "glossy = { reflectance = 0.9, roughness = 0.2 }",
        32,
        "roughness 0.2",
    ),
    (
        "rough",
        "glossy = { reflectance = 0.9, roughness = 0.5 }",
        32,
        "roughness 0.5",
    ),
];

/// The same for lights; several lines become one in the caption.
const LIGHTS: [(&str, &str, u32, &str); 6] = [
    (
        "quad",
        "[[objects]]\nemits = 12\nquad = { corner = [-2.6, 3.2, -0.6], u = [1.6, 0, 0], v = [0, 0, 1.6] }",
        32,
        "a wide light, and a shadow with a wide edge",
    ),
    (
        "sphere",
        "[[objects]]\nemits = 60\nsphere = { center = [-2, 3, 1], radius = 0.3 }",
        32,
        "a smaller light, and a narrower edge",
    ),
    (
        "point",
        "[[lights]]\npoint = { position = [-2, 3, 1], intensity = 18 }",
        32,
        "no size: a sharp edge",
    ),
    (
        "directional",
        "[[lights]]\ndirectional = { direction = [2, -3, -1], irradiance = 2.5 }",
        32,
        "from very far away: as bright everywhere",
    ),
    (
        "sky",
        "[environment]\nradiance = [0.5, 0.65, 0.9]",
        32,
        "from all sides: shade only where ball and floor meet",
    ),
    (
        "image",
        "[environment]\nimage = \"dusk.hdr\"",
        32,
        "an evening sky with a low sun, 64 x 32 pixels",
    ),
];

/// Draws all of them.
pub fn work(desk: &mut Desk, drawn: &mut Drawn) -> Result<(), DeskError> {
    let wrong = || DeskError::Missing("stage.toml has no such material or light".to_owned());
    let (scene, _) = STAGE.split_once(LIGHT).ok_or_else(wrong)?;
    if STAGE.matches(BALL).count() != 1 {
        return Err(wrong());
    }
    for (name, line, spp, says) in MATERIALS {
        let text = STAGE.replace(BALL, &format!("{line}\n"));
        drawn.picture(desk, name, &text, spp, &format!("{line}: {says}."))?;
    }
    for (name, lines, spp, says) in LIGHTS {
        let text = format!("{scene}{lines}\n");
        let line = lines
            .replace("]]\n", "]] ")
            .replace("]\n", "] ")
            .replace('\n', ", ");
        drawn.picture(desk, name, &text, spp, &format!("{line}: {says}."))?;
    }
    Ok(())
}
