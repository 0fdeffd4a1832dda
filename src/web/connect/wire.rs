//! The connection's place in the page: it carries out what the core's [`Link`] says, gives it bytes and time,
//! and lets views look at it at most once a frame. It outlives the room.

use std::time::Duration;

use leptos::leptos_dom::helpers::IntervalHandle;
use leptos::prelude::*;

use crate::link::demo::{DemoRobot, Eeprom};
use crate::link::live::LiveRun;
use crate::link::page::{Action, Command, Link, Port, PortEvent, Snapshot, State};
use crate::web::browser;
use crate::web::serial_port::{self, SerialPort};
use crate::web::state::Lab;

use super::halt;
use super::record::Recorded;

mod port;
mod run;

/// How often the link is looked after.
const TICK: Duration = Duration::from_millis(20);

/// The connection; cheap to copy.
#[derive(Clone, Copy)]
pub struct Wire {
    pub(super) lab: Lab,
    inner: StoredValue<Inner, LocalStorage>,
    /// Counts what views may look at.
    frame: RwSignal<u32>,
    /// The ports that may be opened without asking.
    pub(super) known: RwSignal<Vec<Port>>,
    /// A recording that is open.
    pub(super) recorded: RwSignal<Option<Recorded>>,
}

/// Everything that is no signal.
struct Inner {
    link: Link,
    demo: Option<DemoRobot>,
    /// What the demo robot keeps while it is off.
    kept: Option<Eeprom>,
    known: Vec<SerialPort>,
    port: Option<SerialPort>,
    timer: Option<IntervalHandle>,
    frame_comes: bool,
    /// Whether the alarm was shown.
    alarmed: bool,
    runs: Vec<LiveRun>,
    /// The run that was shown last: stops, whether it was over, and whether the connection was.
    shown: Option<(u32, bool, bool)>,
}

impl Inner {
    /// From now on this port; one that may still be closing stays itself.
    fn take(&mut self, port: SerialPort) {
        if self.port.as_ref().is_none_or(|mine| !mine.is(&port)) {
            self.port = Some(port);
        }
    }
}

fn now_ms() -> u64 {
    (browser::now_s() * 1000.0) as u64
}

/// Milliseconds after midnight, on the wall's clock.
fn wall_ms() -> u64 {
    let now = js_sys::Date::new_0();
    let minutes = u64::from(now.get_hours()) * 60 + u64::from(now.get_minutes());
    (minutes * 60 + u64::from(now.get_seconds())) * 1000 + u64::from(now.get_milliseconds())
}

impl Wire {
    /// The page's connection, made when it is first asked for.
    pub fn of(lab: Lab) -> Option<Self> {
        lab.link.try_update_value(|place| {
            place.get_or_insert_with(|| Box::new(Self::new(lab))).downcast_ref::<Self>().copied()
        })?
    }

    fn new(lab: Lab) -> Self {
        // The whole page's: the room that asked first may be left.
        let mut owner = Owner::current().unwrap_or_default();
        while let Some(parent) = owner.parent() {
            owner = parent;
        }
        let wire = owner.with(|| Self {
            lab,
            inner: StoredValue::new_local(Inner {
                link: Link::new(now_ms(), wall_ms()),
                demo: None,
                kept: None,
                known: Vec::new(),
                port: None,
                timer: None,
                frame_comes: false,
                alarmed: false,
                runs: Vec::new(),
                shown: None,
            }),
            frame: RwSignal::new(0),
            known: RwSignal::new(Vec::new()),
            recorded: RwSignal::new(None),
        });
        match serial_port::ports() {
            None => wire.happened(PortEvent::NoSerial),
            Some(ports) => {
                ports.on_change(move |port, here| wire.plugged(&port, here));
                wire.find_known();
            }
        }
        halt::listen(wire);
        let _ = window_event_listener(leptos::ev::beforeunload, move |event| {
            if wire.peek(Link::is_busy) {
                event.prevent_default();
                event.set_return_value("");
            }
        });
        wire
    }

    /// Looks at the link; what looks is told when there is something new, once a frame.
    pub fn look<T>(self, of: impl FnOnce(&Link) -> T) -> T {
        self.frame.track();
        self.peek(of)
    }

    /// Looks at the link once.
    pub fn peek<T>(self, of: impl FnOnce(&Link) -> T) -> T {
        self.inner.with_value(|inner| of(&inner.link))
    }

    /// What decides how the panel looks.
    pub fn snapshot(self) -> Snapshot {
        self.look(Link::snapshot)
    }

    /// The page's clock, as the link has it.
    pub fn now_ms(self) -> u64 {
        now_ms()
    }

    fn change<T: Default>(self, change: impl FnOnce(&mut Inner) -> T) -> T {
        self.inner.try_update_value(change).unwrap_or_default()
    }

    /// Does what a person asks for.
    pub fn command(self, command: Command) {
        let pace = self.lab.settings.with_untracked(|settings| settings.pace);
        let actions = self.change(|inner| {
            inner.link.set_pace(pace);
            inner.link.command(command, now_ms())
        });
        self.carry_out(actions);
    }

    /// Opens a known port.
    pub fn use_known(self, index: usize) {
        let port = self.change(|inner| {
            inner.take(inner.known.get(index)?.clone());
            inner.port.as_ref().map(SerialPort::ids)
        });
        if let Some(ids) = port {
            self.command(Command::Use(Port::Serial(ids)));
        }
    }

    fn happened(self, event: PortEvent) {
        let actions = self.change(|inner| inner.link.port_event(event, now_ms()));
        self.carry_out(actions);
    }

    fn tick(self) {
        let actions = self.change(|inner| {
            let now_ms = now_ms();
            let bytes = inner.demo.as_mut().map(|demo| demo.tick(now_ms)).unwrap_or_default();
            let mut actions = inner.link.bytes_in(&bytes, now_ms);
            actions.extend(inner.link.tick(now_ms));
            actions
        });
        self.carry_out(actions);
    }

    fn carry_out(self, actions: Vec<Action>) {
        for action in actions {
            match action {
                Action::Choose => self.choose(),
                Action::Open { baud } => self.open(baud),
                Action::Write(bytes) => self.write(&bytes),
                Action::Abort => self.abort(),
                Action::Close => self.close(),
                Action::Look => self.look_for_port(),
            }
        }
        self.keep_time();
        self.show_soon();
    }

    /// Time passes while there is something to wait for.
    fn keep_time(self) {
        let rests = matches!(
            self.peek(Link::state),
            State::Absent | State::Closed | State::Choosing | State::Failed(_)
        );
        let ticks = self.inner.with_value(|inner| inner.timer.is_some());
        if rests == ticks {
            let timer = if rests { None } else { set_interval_with_handle(move || self.tick(), TICK).ok() };
            self.change(|inner| {
                if let Some(timer) = std::mem::replace(&mut inner.timer, timer) {
                    timer.clear();
                }
            });
        }
    }

    fn show_soon(self) {
        if self.change(|inner| std::mem::replace(&mut inner.frame_comes, true)) {
            return;
        }
        request_animation_frame(move || {
            self.change(|inner| inner.frame_comes = false);
            self.frame.update(|frame| *frame = frame.wrapping_add(1));
            self.show_run();
            self.offer_stop();
        });
    }

    /// While the robot drives, or may, it can be stopped in every room. An alarm is not hidden by a dialog.
    fn offer_stop(self) {
        let drives = self.peek(Link::may_drive);
        if drives != self.lab.halt.with_untracked(Option::is_some) {
            self.lab.halt.set(drives.then_some(halt::bar));
        }
        let alarm = matches!(self.peek(Link::state), State::Alarm(_));
        if alarm && !self.change(|inner| std::mem::replace(&mut inner.alarmed, true)) {
            self.lab.dialog.set(None);
        }
        self.change(|inner| inner.alarmed = alarm);
    }
}
