//! Every exercise with its solution: the files that learners get, with what is cut out of them.

use super::Visit;
use halfdisk::lab::exercises::*;

/// Learners write ordinary Rust, and each file is a program.
macro_rules! solutions {
    ($($file:literal $name:ident)*) => {
        $(
            #[path = $file]
            #[allow(dead_code, clippy::disallowed_methods)]
            mod $name;
        )*
    };
}

solutions! {
    "../../examples/exercises/ex01_half_disk.rs" ex01
    "../../examples/exercises/ex02_turn.rs" ex02
    "../../examples/exercises/ex03_gather.rs" ex03
    "../../examples/exercises/ex04_cosine.rs" ex04
    "../../examples/exercises/ex05_malley.rs" ex05
    "../../examples/exercises/ex06_choose.rs" ex06
    "../../examples/exercises/ex07_roulette.rs" ex07
    "../../examples/exercises/ex08_sphere_lamp.rs" ex08
    "../../examples/exercises/ex09_next_event.rs" ex09
    "../../examples/exercises/ex10_mis.rs" ex10
    "../../examples/exercises/ex11_paths.rs" ex11
    "../../examples/exercises/ex12_form_factor.rs" ex12
    "../../examples/exercises/ex13_edge.rs" ex13
    "../../examples/exercises/ex14_compensated.rs" ex14
    "../../examples/exercises/ex15_open.rs" ex15
}

/// Visits all exercises, several at a time.
pub fn each(visit: &impl Visit) {
    std::thread::scope(|scope| {
        scope.spawn(|| visit.visit(half_disk::exam(), &ex01::ANSWER));
        scope.spawn(|| visit.visit(turn::exam(), &ex02::ANSWER));
        scope.spawn(|| visit.visit(gather::exam(), &ex03::answer()));
        scope.spawn(|| visit.visit(cosine::exam(), &ex04::ANSWER));
        scope.spawn(|| visit.visit(malley::exam(), &ex05::ANSWER));
        scope.spawn(|| visit.visit(choose::exam(), &ex06::ANSWER));
        scope.spawn(|| visit.visit(roulette::exam(), &ex07::ANSWER));
        scope.spawn(|| visit.visit(sphere_lamp::exam(), &ex08::ANSWER));
        scope.spawn(|| visit.visit(next_event::exam(), &ex09::ANSWER));
        scope.spawn(|| visit.visit(mis::exam(), &ex10::ANSWER));
        scope.spawn(|| visit.visit(paths::exam(), &ex11::ANSWER));
        scope.spawn(|| visit.visit(form_factor::exam(), &ex12::ANSWER));
        scope.spawn(|| visit.visit(edge::exam(), &ex13::ANSWER));
        scope.spawn(|| visit.visit(compensated::exam(), &ex14::ANSWER));
        scope.spawn(|| visit.visit(open::exam(), &ex15::ANSWER));
    });
}
