//! Lines for people, on stderr, and results, on stdout.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};

/// Writes a line to stderr. That nobody can read it, because the pipe is closed or the disk full, is no
/// reason to end or to lose anything: `eprintln!` would panic.
pub fn tell(line: impl Display) {
    // In one piece, so that the lines of several programs do not mix.
    let line = format!("{line}\n");
    let _ = io::stderr().write_all(line.as_bytes());
}

/// Writes a result to stdout. A reader who has seen enough and left is no failure.
pub fn answer(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    let written = stdout.write_all(text.as_bytes());
    match written.and_then(|()| stdout.flush()) {
        Err(e) if e.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}
