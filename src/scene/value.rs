//! Values that a scene file may hold, each a type with a rule.
//!
//! The rule is asked where a file is read, so that a complaint names the value's line, and again by
//! `get` where a scene is built: a description may be written or changed by a program.

use super::field::{Checked, Problem, Within, check};
use crate::color::Rgb;
use glam::{DVec2, DVec3, Vec3};
use serde::{Deserialize, Deserializer, de};
use std::convert::identity;
use std::ops::RangeInclusive;

/// Types with what they hold if nothing is said, what they are read from, and the rule that makes of it what
/// they stand for.
macro_rules! values {
    ($($(#[$about:meta])* $name:ident($of:ty) = $usual:expr, by $read:expr; $value:ident -> $good:ty $rule:block)*) => {$(
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name(pub $of);

        impl $name {
            /// What it stands for, if the rule allows it.
            pub fn get(self) -> Checked<$good> {
                let $value = self.0;
                $rule
            }
        }

        impl Default for $name {
            fn default() -> Self {
                $name($usual)
            }
        }

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                let value = $name($read(Deserialize::deserialize(deserializer)?));
                value.get().map(|_| value).map_err(de::Error::custom)
            }
        }
    )*};
}

values! {
    /// A number that `f32` can hold.
    Finite(f64) = 0.0, by identity::<f64>; x -> f64 {
        let finite = (x as f32).is_finite();
        check(finite, format_args!("must be a finite number of at most 3.4e38, not {x}")).map(|()| x)
    }

    /// A number above zero, also after rounding to `f32`.
    Positive(f64) = 1.0, by identity::<f64>; x -> f64 {
        let above = Finite(x).get()? as f32 > 0.0;
        check(above, format_args!("must be greater than 0, not {x}")).map(|()| x)
    }

    /// A number that is zero or more in `f64`; smaller than `f32` can tell from zero is zero.
    NotNegative(f64) = 0.0, by identity::<f64>; x -> f64 {
        check(Finite(x).get()? >= 0.0, format_args!("must be 0 or more, not {x}")).map(|()| x)
    }

    /// An angle of view in degrees; what it stands for is in radians.
    Fov(f64) = 40.0, by identity::<f64>; x -> f64 {
        let what = format_args!("must be an angle between 0 and 180 degrees, not {x}");
        check(x > 0.0 && x < 180.0, what).map(|()| x.to_radians())
    }

    /// An index of refraction; usual glass, if nothing is said.
    Ior(f64) = 1.5, by identity::<f64>; x -> f32 {
        let what = format_args!("must be between 0.1 and 10, not {x}");
        check((0.1..=10.0).contains(&x), what).map(|()| x as f32)
    }

    /// The roughness α of microfacets, in `(0, 1]`.
    Roughness(f64) = 0.5, by identity::<f64>; x -> f32 {
        let smooth = "perfectly smooth surfaces are `mirror` and `glass`";
        let what = format_args!("must be greater than 0 and at most 1, not {x}; {smooth}");
        check(x > 0.0 && x <= 1.0, what).map(|()| x as f32)
    }

    /// A share of light: each channel in `[0, 1]`.
    Albedo([f64; 3]) = [0.5; 3], by Color::rgb; rgb -> Rgb {
        channels(rgb, 0.0..=1.0, "between 0 and 1")
    }

    /// An amount of light that may be zero: each channel finite and not negative.
    Radiance([f64; 3]) = [0.0; 3], by Color::rgb; rgb -> Rgb {
        channels(rgb, 0.0..=f64::MAX, "0 or more")
    }

    /// An amount of light that something gives: each channel finite and not negative, not all zero.
    Emission([f64; 3]) = [1.0; 3], by Color::rgb; rgb -> Rgb {
        let light = Radiance(rgb).get()?;
        let what = "gives no light at all; leave the light out, or make it shine";
        check(!light.is_black(), what).map(|()| light)
    }

    /// Factors along the axes: as `f32`, like every other length, not zero.
    Scale([f64; 3]) = [1.0; 3], by Factors::xyz; factors -> DVec3 {
        let scale = Triple(factors).get()?;
        let flat = scale.as_vec3().cmpeq(Vec3::ZERO).any();
        let what = "must not be 0 along any axis: the shape would have no volume left";
        check(!flat, what).map(|()| scale)
    }

    /// How often something is repeated in two directions.
    Repeat([f64; 2]) = [1.0; 2], by Two::uv; times -> DVec2 {
        for (x, name) in times.into_iter().zip(["u", "v"]) {
            check(Positive(x).get().is_ok(), format_args!("must be greater than 0 along {name}, not {x}"))?;
        }
        Ok(DVec2::from(times))
    }

    /// A point or a vector in space whose coordinates `f32` can hold.
    Triple([f64; 3]) = [0.0; 3], by plain; xyz -> DVec3 {
        finite(xyz).map(DVec3::from)
    }

    /// A point or a vector in the plane whose coordinates `f32` can hold.
    Pair([f64; 2]) = [0.0; 2], by plain; xy -> DVec2 {
        finite(xy).map(DVec2::from)
    }

    /// A vector that points somewhere, up if nothing is said; what it stands for has length 1.
    Direction([f64; 3]) = [0.0, 1.0, 0.0], by plain; xyz -> DVec3 {
        let along = finite(xyz).map(DVec3::from)?.try_normalize();
        along.ok_or_else(|| Problem::new("must not be [0, 0, 0]: it is a direction"))
    }

    /// When a shutter opens and when it closes.
    Shutter([f64; 2]) = [0.0; 2], by plain; times -> [f64; 2] {
        let [open, close] = finite(times)?;
        let what = format_args!("must not close before it opens, but opens at {open} and closes at {close}");
        check(open <= close, what).map(|()| times)
    }
}

/// A whole number from `LOW` to `HIGH`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(try_from = "i64")]
pub struct Whole<const LOW: u32, const HIGH: u32>(pub i64);

impl<const LOW: u32, const HIGH: u32> Whole<LOW, HIGH> {
    /// What it stands for, if the rule allows it.
    pub fn get(self) -> Checked<u32> {
        let x = u32::try_from(self.0).ok();
        let what = format!(
            "must be a whole number from {LOW} to {HIGH}, not {}",
            self.0
        );
        x.filter(|x| (LOW..=HIGH).contains(x))
            .ok_or(Problem::new(what))
    }
}

impl<const LOW: u32, const HIGH: u32> TryFrom<i64> for Whole<LOW, HIGH> {
    type Error = Problem;

    fn try_from(x: i64) -> Checked<Self> {
        Self(x).get().map(|_| Self(x))
    }
}

/// Three channels.
#[derive(Deserialize)]
#[serde(rename = "3 numbers in brackets, or one number for all three")]
struct Color(f64, f64, f64);

impl Color {
    fn rgb(self) -> [f64; 3] {
        [self.0, self.1, self.2]
    }
}

impl Repeat {
    /// Along `u` and `v`, whatever the rule says.
    pub(super) fn times(self) -> DVec2 {
        DVec2::from(self.0)
    }
}

/// A number for each of two directions.
#[derive(Deserialize)]
#[serde(rename = "2 numbers in brackets, or one number for both")]
struct Two(f64, f64);

impl Two {
    fn uv(self) -> [f64; 2] {
        [self.0, self.1]
    }
}

/// Factors along the axes, each of which is checked by itself, so that a complaint names it.
#[derive(Deserialize)]
#[serde(rename = "3 numbers in brackets, or one number for all three")]
struct Factors(Finite, Finite, Finite);

impl Factors {
    fn xyz(self) -> [f64; 3] {
        [self.0.0, self.1.0, self.2.0]
    }
}

/// Coordinates; they are checked one by one, too.
fn plain<const N: usize>(list: [Finite; N]) -> [f64; N] {
    list.map(|Finite(x)| x)
}

fn finite<const N: usize>(list: [f64; N]) -> Checked<[f64; N]> {
    for (i, x) in list.into_iter().enumerate() {
        Finite(x).get().within(i)?;
    }
    Ok(list)
}

fn channels(rgb: [f64; 3], allowed: RangeInclusive<f64>, range: &str) -> Checked<Rgb> {
    for (x, name) in rgb.into_iter().zip(["red", "green", "blue"]) {
        let what = format_args!("must be {range} in each channel, but {name} is {x}");
        check((x as f32).is_finite() && allowed.contains(&x), what)?;
    }
    Ok(Rgb::from(rgb.map(|x| x as f32)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::build::build;
    use crate::scene::description::{Description, Light, Object, Shape};

    /// A sphere and a light, told by a program.
    fn described(radius: f64, intensity: f64) -> Description {
        let ball = Shape::Sphere {
            center: Triple([0.0, 0.0, -5.0]),
            radius: Positive(radius),
            inward: false,
        };
        Description {
            name: "in code".to_owned(),
            objects: vec![Object {
                emits: Some(Emission([1.0; 3]).into()),
                ..ball.into()
            }],
            lights: vec![Light::Point {
                position: Triple::default(),
                intensity: Emission([intensity; 3]),
            }],
            ..Description::default()
        }
    }

    #[test]
    fn a_scene_told_by_a_program_is_held_to_the_same_rules() {
        let scene = build(described(1.0, 2.0), None).unwrap();
        assert_eq!((scene.lights.len(), scene.size), (2, [256, 256]));
        for (radius, intensity, field, what) in [
            (-1.0, 2.0, "objects[0]", "must be greater than 0, not -1"),
            (f64::NAN, 2.0, "objects[0]", "must be a finite number"),
            (1.0, 0.0, "lights[0]", "gives no light at all"),
        ] {
            let problem = build(described(radius, intensity), None).unwrap_err();
            assert_eq!(problem.field.to_string(), field);
            assert!(problem.what.starts_with(what), "{problem}");
        }
        let mut far = described(1.0, 2.0);
        far.camera.fov = Fov(180.0);
        let problem = build(far, None).unwrap_err();
        assert_eq!(problem.field.to_string(), "camera");
    }
}
