//! A page's end and a virtual robot on one wire, in simulated time.

use line_maze_lab::link::demo::DemoRobot;
use line_maze_lab::link::live::Mind;
use line_maze_lab::link::page::{Action, Command, Link, Port, PortEvent, State};
use line_maze_lab::settings::{Order, Preference};

use crate::support::figure_3_1;

/// What pulling the reset line does when the port is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opening {
    /// An Uno.
    Resets,
    /// A Bluetooth module.
    Leaves,
}

/// The whole bench.
pub struct Bench {
    pub link: Link,
    pub robot: DemoRobot,
    pub now_ms: u64,
    pub opening: Opening,
    /// Whether the cable is in.
    pub plugged: bool,
    pub open: bool,
    /// Whether what is written stays in the computer: its promise never ends.
    pub stalled: bool,
    /// What the computer holds meanwhile.
    pub held: Vec<u8>,
    /// Everything that was asked of the port.
    pub actions: Vec<Action>,
    /// What is done to bytes on their way to the page.
    pub to_page: Box<dyn FnMut(Vec<u8>) -> Vec<u8>>,
    /// What is done to bytes on their way to the robot.
    pub to_robot: Box<dyn FnMut(Vec<u8>) -> Vec<u8>>,
}

pub const USB: Port = Port::Serial(Some((0x2341, 0x0043)));

pub fn mind() -> Mind {
    Mind { order: Order::Fixed(Preference::SRL), epsilon_ms: 200, node_max: 50 }
}

impl Bench {
    pub fn new(robot: DemoRobot) -> Self {
        Self {
            link: Link::new(0, 0),
            robot,
            now_ms: 0,
            opening: Opening::Resets,
            plugged: true,
            open: false,
            stalled: false,
            held: Vec::new(),
            actions: Vec::new(),
            to_page: Box::new(|bytes| bytes),
            to_robot: Box::new(|bytes| bytes),
        }
    }

    /// Figure 3.1, connected and ready, everything read.
    pub fn ready() -> Self {
        let mut bench = Self::new(DemoRobot::new(&figure_3_1(), 0).unwrap());
        bench.command(Command::Use(USB));
        bench.until(State::Ready);
        bench.wait(1_000);
        bench
    }

    pub fn command(&mut self, command: Command) {
        let actions = self.link.command(command, self.now_ms);
        self.act(actions);
    }

    pub fn port(&mut self, event: PortEvent) {
        let actions = self.link.port_event(event, self.now_ms);
        self.act(actions);
    }

    /// The cable is pulled.
    pub fn unplug(&mut self) {
        self.plugged = false;
        self.open = false;
        self.port(PortEvent::Gone);
    }

    fn act(&mut self, actions: Vec<Action>) {
        for action in actions {
            self.actions.push(action.clone());
            match action {
                Action::Choose => {}
                Action::Open { .. } if self.plugged => {
                    self.open = true;
                    if self.opening == Opening::Resets {
                        self.robot.reset(self.now_ms);
                    }
                    self.port(PortEvent::Opened);
                }
                Action::Open { .. } => {
                    self.port(PortEvent::OpenFailed(line_maze_lab::link::page::OpenError::Unplugged));
                }
                Action::Write(bytes) if self.open && self.stalled => self.held.extend(bytes),
                Action::Write(bytes) if self.open => {
                    let bytes = (self.to_robot)(bytes);
                    self.robot.bytes_in(&bytes, self.now_ms);
                    self.port(PortEvent::Written);
                }
                Action::Abort => {
                    self.held.clear();
                    self.port(PortEvent::Aborted);
                }
                Action::Write(_) => panic!("written to a closed port"),
                Action::Close => self.open = false,
                Action::Look if self.plugged => self.port(PortEvent::Appeared),
                Action::Look => {}
            }
        }
    }

    /// Lets time pass.
    pub fn wait(&mut self, ms: u64) {
        let until_ms = self.now_ms + ms;
        while self.now_ms < until_ms {
            self.now_ms += 5;
            let bytes = (self.to_page)(self.robot.tick(self.now_ms));
            if self.open {
                let actions = self.link.bytes_in(&bytes, self.now_ms);
                self.act(actions);
            }
            let actions = self.link.tick(self.now_ms);
            self.act(actions);
        }
    }

    /// Waits for a state, at most two minutes.
    pub fn until(&mut self, state: State) {
        self.until_so(|bench| bench.link.state() == state);
    }

    pub fn until_so(&mut self, so: impl Fn(&Self) -> bool) {
        let limit_ms = self.now_ms + 120_000;
        while !so(self) {
            assert!(self.now_ms < limit_ms, "{:?}\n{}", self.link.state(), self.tail());
            self.wait(5);
        }
    }

    /// The end of the log.
    pub fn tail(&self) -> String {
        let text = self.link.monitor().download();
        let lines: Vec<&str> = text.lines().filter(|line| !line.contains(" < ir ")).collect();
        lines[lines.len().saturating_sub(40)..].join("\n")
    }

    /// Lines that were sent, without checksums, from a moment on.
    pub fn sent(&self, from: usize) -> Vec<String> {
        let bytes: Vec<u8> = self.actions[from..]
            .iter()
            .filter_map(|action| if let Action::Write(bytes) = action { Some(bytes.clone()) } else { None })
            .flatten()
            .collect();
        let text = String::from_utf8(bytes).unwrap();
        text.lines().map(|line| line.split('*').next().unwrap().to_owned()).collect()
    }

    /// Does what a person does before a run.
    pub fn explore(&mut self) {
        self.command(Command::Place);
        self.command(Command::Explore(mind()));
        self.until(State::Running);
    }
}

/// Tells whole lines otherwise and seals them anew; a line that is told as nothing is lost.
pub fn retelling(mut tell: impl FnMut(&str) -> Option<String>) -> impl FnMut(Vec<u8>) -> Vec<u8> {
    let mut line = Vec::new();
    move |bytes| {
        let mut out = Vec::new();
        for byte in bytes {
            line.push(byte);
            if byte == b'\n' {
                let text = String::from_utf8(std::mem::take(&mut line)).unwrap();
                if let Some(body) = tell(text.split('*').next().unwrap()) {
                    out.extend(sealed(&body));
                }
            }
        }
        out
    }
}

/// A line with its checksum.
pub fn sealed(body: &str) -> Vec<u8> {
    format!("{body}*{:02X}\n", line_maze_lab::link::frame::crc8(body.as_bytes())).into_bytes()
}

/// An `at` line with its coordinates moved.
pub fn moved(line: &str, by: impl FnOnce(i32, i32) -> (i32, i32)) -> String {
    let mut fields: Vec<String> = line.split(' ').map(Into::into).collect();
    if fields[0] == "at" {
        let (x, y) = by(fields[5].parse().unwrap(), fields[6].parse().unwrap());
        (fields[5], fields[6]) = (x.to_string(), y.to_string());
    }
    fields.join(" ")
}
