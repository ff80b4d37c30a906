//! Fields of two colours in turn.

use crate::color::Rgb;
use crate::materials::Texture;
use crate::scene::value::Repeat;
use glam::Vec2;
use serde::Deserialize;

/// Fields of two colours in turn, described by colours of type `C`.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Checker<C> {
    /// The colour of the field at `(0, 0)`, and of all whose numbers add up to an even one.
    pub even: C,
    /// The colour of its neighbours.
    pub odd: C,
    /// How many fields there are from 0 to 1 along `u` and along `v`.
    #[serde(default)]
    pub fields: Repeat,
}

impl Texture for Checker<Rgb> {
    fn color(&self, uv: Vec2) -> Rgb {
        let field = (uv.as_dvec2() * self.fields.times()).floor();
        if (field.x + field.y).rem_euclid(2.0) < 1.0 {
            self.even
        } else {
            self.odd
        }
    }

    fn brightest(&self) -> Rgb {
        self.even.max(self.odd)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_checker_changes_at_every_field_in_all_four_quarters() {
        let checker = Checker {
            even: Rgb::BLACK,
            odd: Rgb::WHITE,
            fields: Repeat([2.0, 4.0]),
        };
        for (u, v, white) in [
            (0.1, 0.1, false),
            (0.6, 0.1, true),
            (0.6, 0.3, false),
            (-0.1, 0.1, true),
            (-0.1, -0.1, false),
            (7.1, 0.3, true),
        ] {
            let color = checker.color(Vec2::new(u, v));
            assert_eq!(
                color,
                if white { Rgb::WHITE } else { Rgb::BLACK },
                "{u} {v}"
            );
        }
    }
}
