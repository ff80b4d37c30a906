//! What an exercise is about, and its file.

use super::{
    choose, compensated, cosine, edge, form_factor, gather, half_disk, malley, mis, next_event,
    open, paths, roulette, sphere_lamp, turn,
};

/// An exercise, as it is listed.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its place on the ladder, from 1.
    pub number: u32,
    /// Its name, one word or several with hyphens.
    pub name: &'static str,
    /// What is to be written, in a line.
    pub title: &'static str,
    /// The page of the book, without its ending.
    pub page: &'static str,
    /// What a right answer is worth.
    pub points: u32,
    /// Hints, the vaguest first.
    pub hints: &'static [&'static str],
    /// The source, with its solution between marks.
    pub source: &'static str,
}

/// All exercises in their order.
pub const LADDER: [&Entry; 15] = [
    &half_disk::ENTRY,
    &turn::ENTRY,
    &gather::ENTRY,
    &cosine::ENTRY,
    &malley::ENTRY,
    &choose::ENTRY,
    &roulette::ENTRY,
    &sphere_lamp::ENTRY,
    &next_event::ENTRY,
    &mis::ENTRY,
    &paths::ENTRY,
    &form_factor::ENTRY,
    &edge::ENTRY,
    &compensated::ENTRY,
    &open::ENTRY,
];

/// The exercise of this number.
pub fn of_number(number: u32) -> Option<&'static Entry> {
    LADDER.into_iter().find(|entry| entry.number == number)
}

const BEGIN: &str = "// BEGIN SOLUTION";
const END: &str = "// END SOLUTION";
const HOLE: &str = "todo!(\"write this\")";

impl Entry {
    /// The name of its program, and of its file without the ending.
    pub fn program(&self) -> String {
        format!("ex{:02}_{}", self.number, self.name.replace('-', "_"))
    }

    /// What is to be done: the text at the head of its source.
    pub fn task(&self) -> String {
        let lines = self.source.lines();
        let head = lines.map_while(|line| line.strip_prefix("//!"));
        let text: Vec<&str> = head.map(|l| l.strip_prefix(' ').unwrap_or(l)).collect();
        text.join("\n") + "\n"
    }

    /// The file that a learner fills in.
    pub fn unfilled(&self) -> String {
        let mut text = String::new();
        let mut inside = false;
        for line in self.source.lines() {
            let code = line.trim_start();
            if code == BEGIN {
                let indent = &line[..line.len() - code.len()];
                text += &format!("{indent}{HOLE}\n");
                inside = true;
            } else if code == END {
                inside = false;
            } else if !inside {
                text += &format!("{line}\n");
            }
        }
        text
    }

    /// The solved file, without the marks.
    pub fn solved(&self) -> String {
        let marks = |line: &&str| ![BEGIN, END].contains(&line.trim_start());
        let lines: Vec<&str> = self.source.lines().filter(marks).collect();
        lines.join("\n") + "\n"
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ladder_is_numbered_and_each_source_has_a_task_holes_and_a_page() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        for (entry, number) in LADDER.into_iter().zip(1..) {
            let name = entry.name;
            assert_eq!(entry.number, number, "{name}");
            assert!(
                entry.task().len() > 200 && !entry.hints.is_empty(),
                "{name}"
            );
            let page = std::fs::read_to_string(root.join(format!("book/src/{}.md", entry.page)));
            let command = format!("exercises start {number}`");
            assert!(
                page.expect(name).contains(&command),
                "{name}: its page does not name it"
            );
            let holes = entry.source.matches(BEGIN).count();
            assert!(
                holes > 0 && holes == entry.source.matches(END).count(),
                "{name}"
            );
            assert_eq!(entry.unfilled().matches(HOLE).count(), holes, "{name}");
            assert!(!entry.unfilled().contains("SOLUTION") && !entry.solved().contains("SOLUTION"));
            assert_ne!(entry.unfilled(), entry.solved(), "{name}");
            assert_eq!(of_number(number).map(|e| e.name), Some(name));
        }
        assert!(of_number(0).is_none() && of_number(99).is_none());
    }
}
