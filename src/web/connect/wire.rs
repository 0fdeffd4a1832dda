//! The connection's place in the page: it carries out what the core's [`Link`] says, gives it bytes and time,
//! and lets views look at it at most once a frame. It outlives the room.

use std::time::Duration;

use leptos::leptos_dom::helpers::IntervalHandle;
use leptos::prelude::*;

use crate::link::demo::{DemoRobot, Eeprom};
use crate::link::live::{LiveRun, Mind};
use crate::link::page::{Action, Command, Link, OpenError, Port, PortEvent, Snapshot, State, Trouble};
use crate::web::browser;
use crate::web::serial_port::{self, NotChosen, SerialPort, Told};
use crate::web::state::{Lab, ToastTone};

use super::record::Recorded;

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
    runs: Vec<LiveRun>,
    /// The run that was shown last: stops, and whether it was over.
    shown: Option<(u32, bool)>,
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
        });
    }

    fn choose(self) {
        leptos::task::spawn_local(async move {
            let Some(ports) = serial_port::ports() else { return self.happened(PortEvent::NoSerial) };
            match ports.choose().await {
                Ok(port) => {
                    let ids = port.ids();
                    self.change(|inner| inner.take(port));
                    self.happened(PortEvent::Chosen(Port::Serial(ids)));
                    self.find_known();
                }
                Err(why) => {
                    if why == NotChosen::Forbidden {
                        let trouble = Trouble::Open(OpenError::Policy);
                        self.lab.say(ToastTone::Error, trouble.cause(), trouble.cure());
                    }
                    self.happened(PortEvent::Cancelled);
                }
            }
        });
    }

    fn open(self, baud: u32) {
        if self.peek(Link::snapshot).port == Some(Port::Demo) {
            return self.switch_on(baud);
        }
        let Some(port) = self.inner.with_value(|inner| inner.port.clone()) else {
            return self.happened(PortEvent::OpenFailed(OpenError::Unplugged));
        };
        leptos::task::spawn_local(async move {
            let opened = port.open(baud, move |told| self.heard(told)).await;
            self.happened(match opened {
                Ok(()) => PortEvent::Opened,
                Err(why) => PortEvent::OpenFailed(why),
            });
        });
    }

    /// The demo robot stands in the page's maze; what it keeps outlives being switched off.
    fn switch_on(self, baud: u32) {
        let maze = self.lab.maze.get_untracked();
        let opened = self.change(|inner| {
            let kept = inner.kept.take().unwrap_or_default();
            Some(match DemoRobot::with_memory(&maze, kept, now_ms()) {
                Ok(demo) => {
                    inner.demo = Some(demo.at_baud(baud));
                    Ok(())
                }
                Err(why) => Err(why.to_string()),
            })
        });
        match opened {
            Some(Ok(())) => self.happened(PortEvent::Opened),
            Some(Err(why)) => {
                self.happened(PortEvent::Gone);
                self.command(Command::Disconnect);
                self.lab.say(ToastTone::Error, "The demo robot can’t start", why);
            }
            None => {}
        }
    }

    fn heard(self, told: Told) {
        match told {
            Told::Bytes(bytes) => {
                let actions = self.change(|inner| inner.link.bytes_in(&bytes, now_ms()));
                self.carry_out(actions);
            }
            Told::Gone => {
                self.release();
                self.happened(PortEvent::Gone);
            }
        }
    }

    fn write(self, bytes: &[u8]) {
        let gone = self.change(|inner| match (&mut inner.demo, &inner.port) {
            (Some(demo), _) => {
                demo.bytes_in(bytes, now_ms());
                false
            }
            (None, Some(port)) => port.write(bytes).is_err(),
            (None, None) => false,
        });
        if gone {
            self.release();
            // Not in the middle of carrying out what came before.
            leptos::task::spawn_local(async move { self.happened(PortEvent::Gone) });
        }
    }

    fn close(self) {
        let was_on = self.change(|inner| {
            let demo = inner.demo.take();
            inner.kept = demo.as_ref().and_then(DemoRobot::eeprom).cloned().or(inner.kept.take());
            demo.is_some()
        });
        if !was_on {
            self.release();
        }
    }

    /// Lets go of the port, so that it can be opened again.
    fn release(self) {
        if let Some(port) = self.inner.with_value(|inner| inner.port.clone()) {
            leptos::task::spawn_local(async move { port.close().await });
        }
    }

    /// The lost port: the same, or another with its USB ids.
    fn look_for_port(self) {
        leptos::task::spawn_local(async move {
            let Some(ports) = serial_port::ports() else { return };
            let known = ports.known().await;
            let found = self.change(|inner| {
                let lost = inner.port.clone()?;
                let same = known.iter().find(|port| port.is(&lost));
                let alike = || known.iter().find(|port| port.ids().is_some() && port.ids() == lost.ids());
                match (same, same.or_else(alike)) {
                    (Some(_), _) => Some(()),
                    (None, Some(port)) => {
                        inner.port = Some(port.clone());
                        Some(())
                    }
                    (None, None) => None,
                }
            });
            if found.is_some() {
                self.happened(PortEvent::Appeared);
            }
        });
    }

    fn plugged(self, port: &SerialPort, here: bool) {
        let ours = self.inner.with_value(|inner| inner.port.as_ref().is_some_and(|our| our.is(port)));
        if here {
            self.look_for_port();
        } else if ours && self.peek(Link::snapshot).port != Some(Port::Demo) {
            self.release();
            self.happened(PortEvent::Gone);
        }
        self.find_known();
    }

    /// Looks which ports may be opened without asking.
    fn find_known(self) {
        leptos::task::spawn_local(async move {
            let Some(ports) = serial_port::ports() else { return };
            let found = ports.known().await;
            let known = found.iter().map(|port| Port::Serial(port.ids())).collect();
            self.change(|inner| inner.known = found);
            self.known.set(known);
        });
    }

    /// What the page's explorer decides with.
    pub fn mind(self) -> Mind {
        let scale = self.lab.maze.with_untracked(|maze| maze.scale);
        self.lab.settings.with_untracked(|settings| Mind {
            order: settings.order,
            epsilon_ms: settings.epsilon(scale),
            node_max: settings.node_max,
        })
    }

    /// Opens the runs of a recording; the last is shown.
    pub(super) fn open_recording(self, name: String, runs: Vec<LiveRun>) {
        let open = Recorded::new(name, &runs);
        self.change(|inner| inner.runs = runs);
        self.recorded.set(Some(open));
        self.show_again();
    }

    /// Shows another run of the recording.
    pub(super) fn choose_run(self, index: usize) {
        let difference = self.inner.with_value(|inner| inner.runs.get(index).and_then(LiveRun::difference));
        self.recorded.update(|open| {
            if let Some(open) = open {
                (open.chosen, open.difference) = (index, difference);
            }
        });
        self.show_again();
    }

    /// Back to the robot, or to the page's own run.
    pub(super) fn close_recording(self) {
        self.recorded.set(None);
        self.change(|inner| inner.runs.clear());
        self.lab.rewind();
        self.show_again();
    }

    /// Shows the run again that was sent away.
    pub fn show_again(self) {
        self.change(|inner| inner.shown = None);
        self.show_run();
    }

    /// Shows the run in the stepper, if there is anything new in it.
    fn show_run(self) {
        let chosen =
            self.recorded.with_untracked(|open| open.as_ref().map(|open| (open.chosen, open.name.clone())));
        let guest_there = self.lab.guest.with_untracked(Option::is_some);
        let coming = self.change(|inner| {
            let run = match &chosen {
                Some((index, _)) => inner.runs.get(*index),
                None => inner.link.live(),
            }?;
            let now = (run.stops(), run.end().is_some());
            // Sent away by the user: only another run comes by itself.
            let dismissed =
                !guest_there && inner.shown.is_some_and(|(stops, over)| now.0 >= stops && (now.1 || !over));
            if inner.shown == Some(now) || dismissed {
                return None;
            }
            inner.shown = Some(now);
            Some(run.clone())
        });
        if let Some(run) = coming {
            super::live::show(self.lab, &run, chosen.map(|(_, name)| name));
        }
    }
}
