//! What a scene calls for, told from what is in it.

use super::Scene;
use super::motion::TransformedShapes;
use crate::camera::Lens;
use crate::geometry::Shape;
use crate::materials::{Bsdf, Event, kinds};

/// A way of light that a scene may call for, or may not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effect {
    /// Points and directions that shine: lights without extent, which only a shadow ray finds.
    PointLights,
    /// Surfaces that shine: a path may meet them.
    AreaLights,
    /// Light from beyond the scene.
    Sky,
    /// Surfaces that scatter light in all directions alike: `D`.
    Diffuse,
    /// Mirrors and glass: `S`.
    Specular,
    /// Reflection and refraction into lobes of some width: `G`.
    Gloss,
    /// Light that a rough surface, lit directly, hands on to another: colour that bleeds,
    /// `L(D|G)S*(D|G)(D|S|G)*E`.
    Bleeding,
    /// Light that comes to its first rough surface by mirrors and glass alone,
    /// `LS+(D|G)(D|S|G)*E`.
    Caustics,
    /// Depth of field.
    Lens,
    /// What moves while the shutter is open.
    Motion,
}

impl Effect {
    /// All of them, in the order in which they are reported.
    pub const ALL: [Effect; 10] = [
        Effect::PointLights,
        Effect::AreaLights,
        Effect::Sky,
        Effect::Diffuse,
        Effect::Specular,
        Effect::Gloss,
        Effect::Bleeding,
        Effect::Caustics,
        Effect::Lens,
        Effect::Motion,
    ];

    /// How it is written.
    pub fn name(self) -> &'static str {
        match self {
            Effect::PointLights => "point-lights",
            Effect::AreaLights => "area-lights",
            Effect::Sky => "sky",
            Effect::Diffuse => "diffuse",
            Effect::Specular => "specular",
            Effect::Gloss => "gloss",
            Effect::Bleeding => "bleeding",
            Effect::Caustics => "caustics",
            Effect::Lens => "lens",
            Effect::Motion => "motion",
        }
    }
}

/// A set of effects.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effects(u16);

impl Effects {
    /// True where the effect is in the set.
    pub fn has(self, effect: Effect) -> bool {
        self.0 & 1 << effect as u16 != 0
    }

    /// The effects of the set, in the order of [`Effect::ALL`].
    pub fn iter(self) -> impl Iterator<Item = Effect> {
        Effect::ALL.into_iter().filter(move |&e| self.has(e))
    }
}

impl FromIterator<Effect> for Effects {
    fn from_iter<I: IntoIterator<Item = Effect>>(effects: I) -> Self {
        Effects(effects.into_iter().fold(0, |set, e| set | 1 << e as u16))
    }
}

/// What is in a scene and does something. A material that no object uses is not in it, nor is a
/// lens of radius 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inventory {
    /// Lights at a point or from one direction.
    pub point_lights: usize,
    /// Surfaces that shine.
    pub area_lights: usize,
    /// Light from beyond.
    pub sky: Sky,
    /// Objects that scatter light in all directions alike.
    pub diffuse: usize,
    /// Objects that mirror or refract perfectly.
    pub specular: usize,
    /// Objects with lobes of some width, rough glass among them.
    pub glossy: usize,
    /// Objects that send light on, in whatever way.
    pub scattering: usize,
    /// Those among them that cannot light themselves, being one flat shape.
    pub flat: usize,
    /// Objects that paths aim at because they may focus light.
    pub casters: usize,
    /// The lens; `None` for a pinhole.
    pub lens: Option<Lens>,
    /// Objects that are elsewhere when the shutter closes.
    pub moving: usize,
    /// Objects with a motion that the shutter, open for no time, does not see.
    pub frozen: usize,
    /// Names of materials that no object uses, in their order.
    pub unused_materials: Vec<String>,
}

/// Light from beyond the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sky {
    /// None.
    #[default]
    Black,
    /// The same from all directions.
    Constant,
    /// An image.
    Image,
}

impl Inventory {
    /// Counts an object.
    pub(super) fn count(&mut self, material: &Bsdf, shapes: &[Shape]) {
        if material.albedo().is_black() {
            return;
        }
        self.scattering += 1;
        let flat = matches!(shapes, [shape] if shape.is_flat());
        self.flat += usize::from(flat);
        match material.smooth_event() {
            Some(Event::Diffuse) => self.diffuse += 1,
            Some(_) => self.glossy += 1,
            None => {}
        }
        self.specular += usize::from(material.is_specular());
    }

    /// True where anything scatters light in more than single directions.
    pub fn is_rough(&self) -> bool {
        self.diffuse + self.glossy > 0
    }

    /// True where no light can go from one surface to another.
    pub fn is_alone(&self) -> bool {
        self.scattering == self.flat && self.scattering <= 1
    }

    /// True where nothing shines: every picture is black.
    pub fn is_dark(&self) -> bool {
        self.point_lights == 0 && !self.light_can_be_met()
    }

    /// True where a path may meet light by going on.
    pub fn light_can_be_met(&self) -> bool {
        self.area_lights > 0 || self.sky != Sky::Black
    }

    /// True where there is light whose caustics are traced from where it starts.
    pub fn caustics_start_at_lights(&self) -> bool {
        let by_lamps = self.diffuse > 0 && (self.area_lights > 0 || self.sky == Sky::Image);
        let by_points = self.is_rough() && self.point_lights > 0;
        self.specular > 0 && (by_lamps || by_points)
    }

    // ANCHOR: effects
    /// What has to be simulated; nothing in the dark.
    pub fn effects(&self) -> Effects {
        if self.is_dark() {
            return Effects::default();
        }
        let needs = |effect| match effect {
            Effect::PointLights => self.point_lights > 0,
            Effect::AreaLights => self.area_lights > 0,
            Effect::Sky => self.sky != Sky::Black,
            Effect::Diffuse => self.diffuse > 0,
            Effect::Specular => self.specular > 0,
            Effect::Gloss => self.glossy > 0,
            Effect::Bleeding => self.is_rough() && !self.is_alone(),
            Effect::Caustics => self.specular > 0 && self.is_rough(),
            Effect::Lens => self.lens.is_some(),
            Effect::Motion => self.moving > 0,
        };
        Effect::ALL.into_iter().filter(|&e| needs(e)).collect()
    }
    // ANCHOR_END: effects
}

impl Scene {
    /// The same scene with every effect at work, those it does not call for at no strength: a lens
    /// of radius 0, motion of nothing, the kernel for all materials. The picture is the same, bit
    /// for bit; what it costs more is what leaving them out saves.
    #[must_use]
    pub fn with_all_effects(mut self) -> Scene {
        let pinhole = Lens {
            radius: 0.0,
            focus: 1.0,
        };
        let lens = self.camera.lens().unwrap_or(pinhole);
        self.camera = self.camera.with_lens(Some(lens));
        self.kinds = kinds::ALL;
        let lights = self.lights.len();
        self.transformed
            .get_or_insert_with(|| TransformedShapes::of_nothing(lights));
        self.dark = false;
        self
    }
}
