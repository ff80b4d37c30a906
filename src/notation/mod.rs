//! Light paths as words, and expressions that stand for many of them.
//!
//! A path from a light to the eye is a [`Word`]: one [`Letter`] for each of its vertices, the light
//! first. An [`Expression`] stands for a [`Language`], the set of words it matches: what Whitted's
//! ray tracing finds is `LD?S*E`, and everything is `L(D|S|G)*E`.
//!
//! ```
//! use halfdisk::notation::{Expression, Letter};
//!
//! let whitted: Expression = "LD?S*E".parse()?;
//! let everything: Expression = "L(D|S)*E".parse()?;
//! // What light does Whitted's ray tracing leave out?
//! let missing = everything.light_first().difference(whitted.light_first());
//! let words: Vec<String> = missing.shortest(3).iter().map(|w| w.to_string()).collect();
//! assert_eq!(words, ["LDDE", "LSDE", "LDDDE"]);
//!
//! // A path traced from the eye is over once no word can follow: here at its second diffuse surface.
//! let eye = whitted.eye_first().start().next(Letter::Eye);
//! let once = eye.next(Letter::Diffuse);
//! assert!(once.can_still_accept() && once.next(Letter::Light).is_accepting());
//! assert!(!once.next(Letter::Diffuse).can_still_accept());
//! # Ok::<(), halfdisk::notation::ExpressionError>(())
//! ```
//!
//! Source: Heckbert, Adaptive Radiosity Textures for Bidirectional Ray Tracing (SIGGRAPH 1990).

mod automaton;
mod expression;
mod language;
mod numbering;
mod parser;

pub use expression::{Expression, ExpressionError};
pub use language::{Language, State};

use std::fmt::{self, Display, Formatter, Write};

/// What a path meets at one of its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Letter {
    /// `L`: a light.
    Light,
    /// `D`: a diffuse reflection.
    Diffuse,
    /// `S`: a mirror or glass, with one direction out for each direction in.
    Specular,
    /// `G`: gloss, a lobe of some width.
    Gloss,
    /// `E`: the eye.
    Eye,
}

impl Letter {
    /// The alphabet, in its order.
    pub const ALL: [Letter; 5] = [
        Letter::Light,
        Letter::Diffuse,
        Letter::Specular,
        Letter::Gloss,
        Letter::Eye,
    ];

    /// How the letter is written.
    pub fn symbol(self) -> char {
        match self {
            Letter::Light => 'L',
            Letter::Diffuse => 'D',
            Letter::Specular => 'S',
            Letter::Gloss => 'G',
            Letter::Eye => 'E',
        }
    }

    /// The letter written so; `None` for any other character.
    pub fn read(symbol: char) -> Option<Letter> {
        Letter::ALL.into_iter().find(|l| l.symbol() == symbol)
    }
}

/// A path as its letters. Words are ordered by length, then by the alphabet `L`, `D`, `S`, `G`, `E`.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Word(pub Vec<Letter>);

impl Word {
    /// The word of these symbols; `None` where one of them is no letter.
    pub fn read(text: &str) -> Option<Word> {
        text.chars()
            .map(Letter::read)
            .collect::<Option<_>>()
            .map(Word)
    }

    /// The same path from its other end.
    #[must_use]
    pub fn reversed(&self) -> Word {
        Word(self.0.iter().rev().copied().collect())
    }
}

impl Ord for Word {
    fn cmp(&self, other: &Word) -> std::cmp::Ordering {
        let by_length = self.0.len().cmp(&other.0.len());
        by_length.then_with(|| self.0.cmp(&other.0))
    }
}

impl PartialOrd for Word {
    fn partial_cmp(&self, other: &Word) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Display for Word {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|l| f.write_char(l.symbol()))
    }
}
