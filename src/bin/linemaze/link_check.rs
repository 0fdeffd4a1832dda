//! `linemaze link-check`: whether a robot keeps the rules of the protocol.

use std::io::Write;

use crate::args::LinkCheck;
use crate::{Failure, Status};

#[cfg(unix)]
pub(crate) fn link_check(args: &LinkCheck, out: &mut impl Write) -> Result<Status, Failure> {
    use std::io;
    use std::time::{Duration, Instant};

    use line_maze_lab::link::check::{Driving, Gone, Verdict, Wire, check};

    use crate::pty::Port;

    /// The port, and what went wrong with it.
    struct Line {
        port: Port,
        error: Option<io::Error>,
        since: Instant,
    }

    impl Line {
        fn failed(&mut self, error: io::Error) -> Gone {
            self.error = Some(error);
            Gone
        }
    }

    impl Wire for Line {
        fn send(&mut self, bytes: &[u8]) -> Result<(), Gone> {
            self.port.write(bytes).map_err(|error| self.failed(error))
        }

        fn wait(&mut self, ms: u64) -> Result<Vec<u8>, Gone> {
            let until = Instant::now() + Duration::from_millis(ms);
            let mut all = Vec::new();
            loop {
                let left = until.saturating_duration_since(Instant::now());
                let came = self.port.wait(left.as_millis() as u32);
                all.extend(came.map_err(|error| self.failed(error))?);
                if left.as_millis() == 0 {
                    return Ok(all);
                }
            }
        }

        fn now_ms(&self) -> u64 {
            self.since.elapsed().as_millis() as u64
        }
    }

    let fails = |error: &io::Error| Failure::Message(format!("{}: {error}", args.pty.display()));
    let port = Port::open(&args.pty, args.baud).map_err(|error| fails(&error))?;
    let mut line = Line { port, error: None, since: Instant::now() };
    let driving = if args.drive { Driving::Allowed } else { Driving::Forbidden };
    let mut status = Status::Good;
    let mut written = Ok(());
    let checked = check(&mut line, driving, |rule, verdict| {
        let said = match verdict {
            Verdict::Kept => format!("kept       {:9} {}", rule.name, rule.says),
            Verdict::NotTried(why) => format!("not tried  {:9} {}: {why}", rule.name, rule.says),
            Verdict::Remark(words) => {
                format!("remark     {:9} {}\n           {:9} {words}", rule.name, rule.says, "")
            }
            Verdict::Broken(words) => {
                status = Status::Bad;
                format!("BROKEN     {:9} {}\n           {:9} {words}", rule.name, rule.says, "")
            }
        };
        if written.is_ok() {
            written = writeln!(out, "{said}").and_then(|()| out.flush());
        }
    });
    written?;
    match (checked, line.error) {
        (Ok(()), _) => Ok(status),
        (Err(Gone), Some(error)) => Err(fails(&error)),
        (Err(Gone), None) => Err(fails(&io::ErrorKind::UnexpectedEof.into())),
    }
}

#[cfg(not(unix))]
pub(crate) fn link_check(args: &LinkCheck, _: &mut impl Write) -> Result<Status, Failure> {
    Err(Failure::Message(format!("{}: link-check needs Linux, macOS or another Unix", args.pty.display())))
}
