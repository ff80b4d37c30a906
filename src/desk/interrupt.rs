//! Ctrl-C: the first one asks to stop and keep what is there, the second one stops at once.

use std::sync::Once;
use std::sync::atomic::{AtomicBool, Ordering};

/// Exit code of a program that was interrupted.
pub const INTERRUPTED: u8 = 130;

static STOP: AtomicBool = AtomicBool::new(false);
static INSTALL: Once = Once::new();

/// A flag that becomes true at the first Ctrl-C (or termination request) from now on.
pub fn on_ctrl_c() -> &'static AtomicBool {
    INSTALL.call_once(|| {
        let handler = || {
            if STOP.swap(true, Ordering::Relaxed) {
                std::process::exit(i32::from(INTERRUPTED));
            }
        };
        // Without a handler Ctrl-C ends the program as it always did: nothing is lost by going on.
        if let Err(error) = ctrlc::set_handler(handler) {
            eprintln!("warning: Ctrl-C will lose the picture: {error}");
        }
    });
    &STOP
}
