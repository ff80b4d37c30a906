//! A chapter's program at work: what it says is kept, and passed on line by line.

use crate::lab::chapter::on_ctrl_c;
use std::io::{BufRead, BufReader, Read};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// How long a chapter may take to end by itself, and how often it is looked at.
const GRACE: Duration = Duration::from_millis(500);
const OFTEN: Duration = Duration::from_millis(20);

/// Runs a program to its end, or until a wish to stop: Ctrl-C reaches it, too, so that it may end by
/// itself; a request to terminate may be this program's alone. `said` hears of each line that it prints.
pub(super) fn finish(
    mut command: Command,
    said: impl Fn(&str) + Send + 'static,
) -> std::io::Result<Output> {
    let stop = on_ctrl_c();
    command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn()?;
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    let lines = std::thread::spawn(move || {
        let mut read = Vec::new();
        if let Some(pipe) = stdout {
            let mut pipe = BufReader::new(pipe);
            let mut from = 0;
            while pipe.read_until(b'\n', &mut read)? > 0 {
                said(String::from_utf8_lossy(&read[from..]).trim());
                from = read.len();
            }
        }
        Ok(read)
    });
    // A full pipe would hold the program up.
    let complaints = std::thread::spawn(move || {
        let mut read = Vec::new();
        let result = stderr.map_or(Ok(0), |mut pipe| pipe.read_to_end(&mut read));
        result.map(|_| read)
    });
    let mut asked = None;
    let status = loop {
        if let Some(status) = child.try_wait()? {
            break status;
        }
        if stop.load(Ordering::Relaxed) {
            let asked = *asked.get_or_insert_with(Instant::now);
            if asked.elapsed() > GRACE {
                // Its files are whole at any time.
                child.kill()?;
                break child.wait()?;
            }
        }
        std::thread::sleep(OFTEN);
    };
    let nothing = || Ok::<_, std::io::Error>(Vec::new());
    Ok(Output {
        status,
        stdout: lines.join().unwrap_or_else(|_| nothing())?,
        stderr: complaints.join().unwrap_or_else(|_| nothing())?,
    })
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::sync::mpsc;

    #[test]
    fn each_line_is_heard_when_it_is_said_and_all_is_kept() {
        let (hear, heard) = mpsc::channel();
        let mut command = Command::new("sh");
        command.args(["-c", "echo 'one  1'; echo oops >&2; echo two; exit 3"]);
        let output = finish(command, move |line| {
            let _ = hear.send(line.to_owned());
        });
        let output = output.unwrap();
        assert_eq!(heard.iter().collect::<Vec<_>>(), ["one  1", "two"]);
        assert_eq!(output.stdout, b"one  1\ntwo\n");
        assert_eq!(output.stderr, b"oops\n");
        assert_eq!(output.status.code(), Some(3));
    }
}
