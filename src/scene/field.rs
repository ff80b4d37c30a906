//! The address of a value in a scene file, what may be wrong with it, and checks on numbers.

use super::description::{Color, Exactly, Triple};
use crate::color::Rgb;
use glam::DVec3;
use std::fmt;

/// One step from a table or list to a value in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// The value of a key.
    Key(String),
    /// An item of a list, counted from 0.
    Item(usize),
}

/// The way from the top of a file to a value, such as `objects[2].sphere.radius`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Field(pub Vec<Step>);

impl Field {
    /// The whole file.
    pub fn top() -> Self {
        Field::default()
    }

    /// The value of a key in this table.
    #[must_use]
    pub fn key(&self, key: &str) -> Field {
        self.step(Step::Key(key.to_owned()))
    }

    /// An item of this list.
    #[must_use]
    pub fn item(&self, index: usize) -> Field {
        self.step(Step::Item(index))
    }

    fn step(&self, step: Step) -> Field {
        let mut steps = self.0.clone();
        steps.push(step);
        Field(steps)
    }

    /// A complaint about this value.
    pub fn problem(&self, what: impl Into<String>) -> Problem {
        Problem {
            field: self.clone(),
            what: what.into(),
        }
    }
}

impl fmt::Display for Field {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for (i, step) in self.0.iter().enumerate() {
            match step {
                Step::Key(key) => {
                    let dot = if i == 0 { "" } else { "." };
                    // Other keys stand in quotes in the file too, and may hold line breaks.
                    let bare = |c: char| c.is_ascii_alphanumeric() || "-_".contains(c);
                    if !key.is_empty() && key.chars().all(bare) {
                        write!(f, "{dot}{key}")?;
                    } else {
                        write!(f, "{dot}{key:?}")?;
                    }
                }
                Step::Item(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

/// A value that is not allowed: which one, and what is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Which value.
    pub field: Field,
    /// What is wrong and what is allowed.
    pub what: String,
}

/// What a check returns.
pub type Checked<T> = Result<T, Problem>;

/// A number that `f32` can hold.
pub fn finite(field: &Field, x: f64) -> Checked<f64> {
    if (x as f32).is_finite() {
        Ok(x)
    } else {
        Err(field.problem(format!(
            "must be a finite number of at most 3.4e38, not {x}"
        )))
    }
}

/// A number above zero, also after rounding to `f32`.
pub fn positive(field: &Field, x: f64) -> Checked<f64> {
    if finite(field, x)? as f32 > 0.0 {
        Ok(x)
    } else {
        Err(field.problem(format!("must be greater than 0, not {x}")))
    }
}

/// A number that is zero or more in `f64`; smaller than `f32` can tell from zero is zero.
pub fn not_negative(field: &Field, x: f64) -> Checked<f64> {
    if finite(field, x)? >= 0.0 {
        Ok(x)
    } else {
        Err(field.problem(format!("must be 0 or more, not {x}")))
    }
}

/// A point or direction whose coordinates `f32` can hold.
pub fn vector(field: &Field, Exactly(xyz): Triple) -> Checked<DVec3> {
    for (i, x) in xyz.into_iter().enumerate() {
        finite(&field.item(i), x)?;
    }
    Ok(DVec3::from(xyz))
}

/// A direction that points somewhere.
pub fn direction(field: &Field, xyz: Triple) -> Checked<DVec3> {
    vector(field, xyz)?
        .try_normalize()
        .ok_or_else(|| field.problem("must not be [0, 0, 0]: it is a direction"))
}

/// A share of light: each channel in `[0, 1]`.
pub fn reflectance(field: &Field, color: Color) -> Checked<Rgb> {
    channels(
        field,
        color,
        |x| (0.0..=1.0).contains(&x),
        "between 0 and 1",
    )
}

/// An amount of light: each channel finite and not negative, and not all of them zero.
pub fn light(field: &Field, color: Color) -> Checked<Rgb> {
    let rgb = channels(field, color, |x| x >= 0.0, "0 or more")?;
    if rgb.is_black() {
        return Err(field.problem("gives no light at all; leave the light out, or make it shine"));
    }
    Ok(rgb)
}

/// An amount of light that may be zero.
pub fn light_or_none(field: &Field, color: Color) -> Checked<Rgb> {
    channels(field, color, |x| x >= 0.0, "0 or more")
}

fn channels(
    field: &Field,
    Color(rgb): Color,
    allowed: impl Fn(f64) -> bool,
    range: &str,
) -> Checked<Rgb> {
    for (x, name) in rgb.into_iter().zip(["red", "green", "blue"]) {
        if !((x as f32).is_finite() && allowed(x)) {
            return Err(field.problem(format!(
                "must be {range} in each channel, but {name} is {x}"
            )));
        }
    }
    Ok(Rgb::from(rgb.map(|x| x as f32)))
}

/// A whole number from `low` to `high`.
pub fn whole(field: &Field, x: i64, low: u32, high: u32) -> Checked<u32> {
    u32::try_from(x)
        .ok()
        .filter(|x| (low..=high).contains(x))
        .ok_or_else(|| {
            field.problem(format!(
                "must be a whole number from {low} to {high}, not {x}"
            ))
        })
}

/// The one entry that is given; anything but exactly one is a problem.
pub fn exactly_one<T>(field: &Field, what: &str, given: Vec<(&str, Option<T>)>) -> Checked<T> {
    let names: Vec<&str> = given.iter().map(|(name, _)| *name).collect();
    let mut found: Vec<(&str, T)> = given
        .into_iter()
        .filter_map(|(name, entry)| Some((name, entry?)))
        .collect();
    match (found.pop(), found.pop()) {
        (Some((_, entry)), None) => Ok(entry),
        (None, _) => Err(field.problem(format!("needs a {what}: one of {}", names.join(", ")))),
        (Some((a, _)), Some((b, _))) => {
            Err(field.problem(format!("has both {b} and {a}, but takes only one {what}")))
        }
    }
}
