//! Sets of words, walked letter by letter and compared.

use super::numbering::Numbering;
use super::{Letter, Word};
use std::collections::VecDeque;

/// Where each letter of the alphabet leads.
pub(super) type Row = [u32; Letter::ALL.len()];

/// A set of words, as a table: a state and a letter give the next state.
///
/// The language of an expression has as few states as possible; what [`Language::intersection`] and
/// [`Language::difference`] make may have more.
#[derive(Clone, Debug)]
pub struct Language {
    /// The start is state 0.
    next: Vec<Row>,
    accepting: Vec<bool>,
    /// The states from which an accepting one can be reached.
    alive: Vec<bool>,
}

/// How far a word has been read.
#[derive(Clone, Copy, Debug)]
pub struct State<'a> {
    language: &'a Language,
    index: u32,
}

impl<'a> State<'a> {
    /// The state after one more letter.
    #[must_use]
    pub fn next(self, letter: Letter) -> State<'a> {
        let index = self.language.next[self.index as usize][letter as usize];
        State { index, ..self }
    }

    /// True where the letters so far are a word of the language.
    pub fn is_accepting(self) -> bool {
        self.language.accepting[self.index as usize]
    }

    /// True where the letters so far are a word or the beginning of one.
    pub fn can_still_accept(self) -> bool {
        self.language.alive[self.index as usize]
    }
}

impl Language {
    pub(super) fn new(next: Vec<Row>, accepting: Vec<bool>) -> Language {
        // Walk backwards from the accepting states.
        let mut before = vec![Vec::new(); next.len()];
        for (state, row) in next.iter().enumerate() {
            for &to in row {
                before[to as usize].push(state);
            }
        }
        let mut alive = accepting.clone();
        let mut open: Vec<usize> = (0..next.len()).filter(|&s| alive[s]).collect();
        while let Some(state) = open.pop() {
            for &from in &before[state] {
                if !std::mem::replace(&mut alive[from], true) {
                    open.push(from);
                }
            }
        }
        Language {
            next,
            accepting,
            alive,
        }
    }

    /// The state before the first letter.
    pub fn start(&self) -> State<'_> {
        State {
            language: self,
            index: 0,
        }
    }

    /// True where the whole word is in the language.
    pub fn accepts(&self, word: &[Letter]) -> bool {
        let end = word.iter().fold(self.start(), |s, &letter| s.next(letter));
        end.is_accepting()
    }

    /// The number of states of the table.
    pub fn states(&self) -> usize {
        self.next.len()
    }

    /// True where no word is in the language.
    pub fn is_empty(&self) -> bool {
        !self.start().can_still_accept()
    }

    /// True where every word of `other` is in this language, too.
    pub fn includes(&self, other: &Language) -> bool {
        other.difference(self).is_empty()
    }

    /// The words of both languages.
    #[must_use]
    pub fn intersection(&self, other: &Language) -> Language {
        self.product(other, |own, others| own && others)
    }

    /// The words of this language that are not in `other`.
    #[must_use]
    pub fn difference(&self, other: &Language) -> Language {
        self.product(other, |own, others| own && !others)
    }

    // ANCHOR: product
    /// Reads a word in both languages at once, and lets `accept` decide from their answers.
    fn product(&self, other: &Language, accept: fn(bool, bool) -> bool) -> Language {
        let mut pairs = Numbering::default();
        pairs.number((0, 0));
        let (mut next, mut accepting) = (Vec::new(), Vec::new());
        while let Some(&(a, b)) = pairs.items.get(next.len()) {
            let (row_a, row_b) = (&self.next[a as usize], &other.next[b as usize]);
            next.push(Letter::ALL.map(|l| pairs.number((row_a[l as usize], row_b[l as usize]))));
            accepting.push(accept(
                self.accepting[a as usize],
                other.accepting[b as usize],
            ));
        }
        Language::new(next, accepting)
    }
    // ANCHOR_END: product

    /// The first words of the language, at most `limit`, in the order of [`Word`]: shortest first.
    ///
    /// No state is left more than `limit` times: of the beginnings that lead to one state, a later
    /// one continues to later words only.
    pub fn shortest(&self, limit: usize) -> Vec<Word> {
        let mut words = Vec::new();
        let mut visits = vec![0; self.next.len()];
        // Beginnings of words: the state reached, the last letter, and the beginning before it.
        let mut trail: Vec<(Letter, Option<usize>)> = Vec::new();
        let mut open = VecDeque::from([(0, None)]);
        while let Some((state, last)) = open.pop_front() {
            if words.len() == limit {
                break;
            }
            visits[state] += 1;
            if !self.alive[state] || visits[state] > limit {
                continue;
            }
            if self.accepting[state] {
                words.push(spell(&trail, last));
            }
            for letter in Letter::ALL {
                trail.push((letter, last));
                let to = self.next[state][letter as usize] as usize;
                open.push_back((to, Some(trail.len() - 1)));
            }
        }
        words
    }
}

/// Two languages are equal where they hold the same words.
impl PartialEq for Language {
    fn eq(&self, other: &Language) -> bool {
        self.includes(other) && other.includes(self)
    }
}

fn spell(trail: &[(Letter, Option<usize>)], mut last: Option<usize>) -> Word {
    let mut letters = Vec::new();
    while let Some((letter, before)) = last.and_then(|i| trail.get(i)) {
        letters.push(*letter);
        last = *before;
    }
    letters.reverse();
    Word(letters)
}
