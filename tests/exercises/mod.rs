//! Exercises that are graded: solutions pass, mistakes are named, and other mistakes are answered usefully.

mod ladder;
mod matrix;
mod mixed;
mod unfilled;

use halfdisk::lab::exercises::*;
pub use ladder::each;

/// Something that is done with every exercise and its solution.
pub trait Visit: Sync {
    fn visit<A: Sync>(&self, exam: Exam<A>, solution: &A);
}

struct Passes {
    seeds: std::ops::Range<u64>,
}

impl Visit for Passes {
    fn visit<A: Sync>(&self, exam: Exam<A>, solution: &A) {
        for seed in self.seeds.clone() {
            let report = guarded(&exam, solution, seed);
            assert!(report.passed(), "seed {seed}: {report}");
            assert_eq!((report.points, report.mistakes.len()), (report.of, 0));
        }
    }
}

#[test]
fn every_solution_passes_with_twenty_seeds() {
    each(&Passes { seeds: 1..21 });
}

/// How many of a thousand right answers are called wrong.
#[test]
#[ignore = "takes minutes"]
fn long_one_right_answer_in_a_thousand_is_called_wrong_at_most() {
    struct Alarms;
    impl Visit for Alarms {
        fn visit<A: Sync>(&self, exam: Exam<A>, solution: &A) {
            let wrong = (1..=1000).filter(|&seed| {
                let report = exam.grade(solution, seed);
                if !report.passed() {
                    println!("seed {seed}: {report}");
                }
                !report.passed()
            });
            let alarms = wrong.count();
            println!("{}: {alarms} of 1000", exam.entry.name);
            assert!(alarms <= 1, "{}: {alarms}", exam.entry.name);
        }
    }
    each(&Alarms);
}

#[test]
fn the_same_seed_gives_the_same_report() {
    struct Same;
    impl Visit for Same {
        fn visit<A: Sync>(&self, exam: Exam<A>, _: &A) {
            let wrong = &exam.mistakes[0].answer;
            assert_eq!(exam.grade(wrong, 3), exam.grade(wrong, 3));
        }
    }
    each(&Same);
}
