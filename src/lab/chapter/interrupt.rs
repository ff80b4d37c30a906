//! Ctrl-C and requests to terminate: the first one asks to stop and keep what is there, the second one
//! ends the program at once.

use super::tell;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::io;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock};
use std::time::Duration;

static STOP: LazyLock<Arc<AtomicBool>> = LazyLock::new(|| {
    let stop = Arc::new(AtomicBool::new(false));
    let requests = [SIGINT, SIGTERM].into_iter().chain(hang_up());
    for signal in requests {
        // Without a handler the signal ends the program as it always did.
        if let Err(error) = watch(signal, &stop) {
            tell(format_args!(
                "warning: Ctrl-C will lose what is unfinished: {error}"
            ));
        }
    }
    stop
});

/// The signal that came, once one did.
static SIGNAL: LazyLock<Arc<AtomicUsize>> = LazyLock::new(Arc::default);

/// A flag that becomes true at the first Ctrl-C (or request to terminate) from now on.
pub fn on_ctrl_c() -> &'static AtomicBool {
    &STOP
}

/// The exit code of a program that was interrupted: 130 after Ctrl-C, 143 after a request to terminate,
/// as shells have it.
pub fn interrupted_code() -> u8 {
    match SIGNAL.load(Ordering::Relaxed) {
        0 => code_of(SIGINT),
        signal => code_of(signal as i32),
    }
}

fn code_of(signal: i32) -> u8 {
    128_u8.wrapping_add(signal as u8)
}

fn watch(signal: i32, stop: &Arc<AtomicBool>) -> io::Result<()> {
    // In this order: whoever finds the flag set also finds the signal, and the second one an end.
    flag::register_conditional_shutdown(signal, i32::from(code_of(signal)), Arc::clone(stop))?;
    flag::register_usize(signal, Arc::clone(&SIGNAL), signal as usize)?;
    flag::register(signal, Arc::clone(stop))?;
    Ok(())
}

/// The signal of a terminal that is closed, unless it is ignored, as `nohup` has it.
#[cfg(target_os = "linux")]
fn hang_up() -> Option<i32> {
    use signal_hook::consts::SIGHUP;
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    (ignored.unwrap_or(0) >> (SIGHUP - 1) & 1 == 0).then_some(SIGHUP)
}

/// Elsewhere nobody says whether it is ignored, so it is left as it is.
#[cfg(not(target_os = "linux"))]
fn hang_up() -> Option<i32> {
    None
}

/// A write beyond the largest file that is allowed becomes an error, where it would kill the program.
pub(super) fn survive_large_files() {
    #[cfg(unix)]
    {
        let unread = Arc::new(AtomicBool::new(false));
        // Without it the signal kills as it always did.
        let _ = flag::register(signal_hook::consts::SIGXFSZ, unread);
    }
}

/// How long a program may take to end by itself.
const GRACE: Duration = Duration::from_millis(700);
/// How often it is asked whether it should.
const OFTEN: Duration = Duration::from_millis(50);

/// Ends a program that does not end by itself soon after it is asked to, with these words. For those
/// who have nothing left to write.
pub(super) fn end_soon(words: String) {
    let stop = on_ctrl_c();
    let wait = move || {
        while !stop.load(Ordering::Relaxed) {
            std::thread::sleep(OFTEN);
        }
        std::thread::sleep(GRACE);
        tell(format_args!("error: {words}"));
        std::process::exit(i32::from(interrupted_code()));
    };
    // Without the thread, a second Ctrl-C does it.
    let _ = std::thread::Builder::new().spawn(wait);
}
