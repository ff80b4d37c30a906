//! The line on a terminal while a chapter is at work: which one, at what, and how long the rest may take.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::{Duration, Instant};

/// How often the line is drawn again.
const TICK: Duration = Duration::from_millis(120);
/// The letters of a chapter's news that a narrow terminal can show.
const NEWS: usize = 52;

/// How far a tour is.
#[derive(Debug)]
pub(super) struct Waiting {
    bar: ProgressBar,
    start: Instant,
    /// The usual seconds of the chapters to run, one after the other.
    usual: Vec<f64>,
    done: usize,
}

impl Waiting {
    /// A tour of chapters that usually take so many seconds. Where stderr is no terminal, nothing is shown.
    pub(super) fn new(usual: Vec<f64>) -> Self {
        Waiting {
            bar: ProgressBar::new_spinner(),
            start: Instant::now(),
            usual,
            done: 0,
        }
    }

    /// The chapter that begins; what hears of its news.
    pub(super) fn begin(&self, title: &str) -> impl Fn(&str) + Send + 'static + use<> {
        let left = match self.left() {
            Some(seconds) => format!(", about {} left", lasting(seconds)),
            None => String::new(),
        };
        let head = format!("[{}/{}] {title}", self.done + 1, self.usual.len());
        let template = "{spinner} {prefix}, {elapsed} gone{wide_msg}";
        if let Ok(style) = ProgressStyle::with_template(template) {
            self.bar.set_style(style);
        }
        self.bar.set_message(left.clone());
        self.bar.set_prefix(head);
        self.bar.enable_steady_tick(TICK);
        let bar = self.bar.clone();
        move |news| {
            if let Some(news) = short(news) {
                bar.set_message(format!("{left}: {news}"));
            }
        }
    }

    /// The end of a chapter. Its line is printed by others, and must not meet this one.
    pub(super) fn end(&mut self) {
        self.done += 1;
        self.bar.finish_and_clear();
        self.bar.reset();
    }

    /// The seconds that are left, by those that the chapters so far took; unknown at first.
    fn left(&self) -> Option<f64> {
        let (before, after) = self.usual.split_at(self.done);
        let before: f64 = before.iter().sum();
        (before > 0.0)
            .then(|| self.start.elapsed().as_secs_f64() / before * after.iter().sum::<f64>())
    }
}

impl Drop for Waiting {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Seconds as one says them.
pub(super) fn lasting(seconds: f64) -> String {
    match seconds {
        s if s < 9.95 => format!("{s:.1} s"),
        s if s < 99.5 => format!("{s:.0} s"),
        s => {
            let whole = s.round() as u64;
            format!("{} min {} s", whole / 60, whole % 60)
        }
    }
}

/// What a chapter is at, from a line of its report: the words before the number. Its last line sums it up, and is
/// no news.
fn short(line: &str) -> Option<String> {
    if line.starts_with("ledger:") {
        return None;
    }
    let words = line.split("  ").next().unwrap_or_default().trim();
    let mut short: String = words.chars().take(NEWS).collect();
    if short.len() < words.len() {
        short.push('…');
    }
    (!short.is_empty()).then_some(short)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_news_are_the_words_before_the_number() {
        let line = "rays wasted for each of them                       380.3";
        assert_eq!(short(line).unwrap(), "rays wasted for each of them");
        assert_eq!(short("   "), None);
        assert_eq!(short("ledger: 12 rays, 2.69 s, variance 1.7e-1"), None);
        let long = short(&"a".repeat(60)).unwrap();
        assert_eq!(long.chars().count(), NEWS + 1);
    }

    #[test]
    fn the_time_left_follows_the_pace_so_far() {
        let mut waiting = Waiting::new(vec![2.0, 6.0, 1.0]);
        assert_eq!(waiting.left(), None, "nothing is known yet");
        waiting.start -= Duration::from_secs(4);
        waiting.end();
        // Twice as slow as usual: fourteen seconds for the seven to come.
        let left = waiting.left().unwrap();
        assert!((left - 14.0).abs() < 0.5, "{left}");
        assert_eq!(
            [9.0, 34.2, 130.4].map(lasting),
            ["9.0 s", "34 s", "2 min 10 s"]
        );
    }
}
