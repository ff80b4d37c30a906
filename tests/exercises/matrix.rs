//! The confusion matrix: each named mistake is graded as itself.

use super::{Visit, each};
use halfdisk::lab::exercises::*;
use std::fmt::Write;
use std::sync::Mutex;

/// A line for each mistake: what it is graded as, and how far the nearest other hypothesis lies.
struct Matrix(Mutex<Vec<(u32, String)>>);

impl Visit for Matrix {
    fn visit<A: Sync>(&self, exam: Exam<A>, solution: &A) {
        let right = exam.read(solution, 2);
        let table = exam.table();
        let mut text = format!("{:02} {}\n", exam.entry.number, exam.entry.name);
        for (mistake, own) in exam.mistakes.iter().zip(table) {
            let report = exam.grade(&mistake.answer, 1);
            println!("{report}");
            assert_eq!(report.verdict, Verdict::Named, "{report}");
            assert_eq!(report.mistakes[0], mistake.name, "{report}");
            assert!(
                report.said.contains(mistake.forgot) && report.points < report.of,
                "{report}"
            );
            // Not two hypotheses within the noise of both.
            let others = table.iter().filter(|other| *other != own).chain([&right]);
            let nearest = others.map(|other| exam.apart(own, other));
            let nearest = nearest.fold(f64::INFINITY, f64::min);
            assert!(nearest > 8.8, "{}: {nearest:.1}", mistake.name);
            let wrong = report.checks.iter().filter(|check| !check.passed).count();
            let named = report.mistakes.join(", ");
            writeln!(
                text,
                "  {}: {named}; {wrong} of {} wrong",
                mistake.name,
                report.checks.len()
            )
            .unwrap();
        }
        self.0.lock().unwrap().push((exam.entry.number, text));
    }
}

#[test]
fn every_named_mistake_is_graded_as_itself_and_nothing_else() {
    let matrix = Matrix(Mutex::default());
    each(&matrix);
    let mut parts = matrix.0.into_inner().unwrap();
    parts.sort();
    let text: String = parts.into_iter().map(|(_, text)| text).collect();
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../snapshots");
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("confusion", text));
}
