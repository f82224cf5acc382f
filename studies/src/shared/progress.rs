//! Progress of a long run.

use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Between two lines.
const PAUSE: Duration = Duration::from_secs(10);

/// Writes to stderr now and then.
pub struct Progress {
    pub start: Instant,
    latest: Mutex<Instant>,
}

impl Progress {
    #[allow(clippy::new_without_default)] // it starts a clock
    pub fn new() -> Self {
        let start = Instant::now();
        let latest = Mutex::new(start);
        Self { start, latest }
    }

    /// `what` is asked only if it is written.
    pub fn say(&self, what: impl FnOnce() -> String) {
        let mut latest = self.latest.lock().unwrap();
        if latest.elapsed() >= PAUSE {
            *latest = Instant::now();
            eprintln!("{:4.0} s: {}", self.start.elapsed().as_secs_f64(), what());
        }
    }
}
