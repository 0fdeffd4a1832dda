//! What the core's actions mean for a port: choosing, opening, writing and closing one, and looking for one that
//! is lost. The demo robot is a port too.

use leptos::prelude::*;

use super::{Wire, now_ms};
use crate::link::demo::DemoRobot;
use crate::link::page::{Command, Link, OpenError, Port, PortEvent, Trouble};
use crate::web::serial_port::{self, NotChosen, SerialPort, Told};
use crate::web::state::ToastTone;

impl Wire {
    pub(super) fn choose(self) {
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
                        self.say_while_off(trouble.cause(), trouble.cure());
                    }
                    self.happened(PortEvent::Cancelled);
                }
            }
        });
    }

    pub(super) fn open(self, baud: u32) {
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
                self.say_while_off("The demo robot can’t start", why);
            }
            None => {}
        }
    }

    /// Why there is no connection, until there is one.
    fn say_while_off(self, cause: impl Into<String>, cure: impl Into<String>) {
        self.lab.say_while(ToastTone::Error, cause, cure, move || !self.look(Link::is_open));
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

    pub(super) fn write(self, bytes: &[u8]) {
        // What happens then is told later, not in the middle of carrying out what came before.
        let then = self.change(|inner| match (&mut inner.demo, &inner.port) {
            (Some(demo), _) => {
                demo.bytes_in(bytes, now_ms());
                Some(PortEvent::Written)
            }
            (None, Some(port)) => port
                .write(bytes, move || self.happened(PortEvent::Written))
                .is_err()
                .then_some(PortEvent::Gone),
            (None, None) => None,
        });
        if then == Some(PortEvent::Gone) {
            self.release();
        }
        if let Some(event) = then {
            leptos::task::spawn_local(async move { self.happened(event) });
        }
    }

    pub(super) fn abort(self) {
        let port = self.inner.with_value(|inner| inner.port.clone());
        leptos::task::spawn_local(async move {
            if let Some(port) = port {
                port.abort().await;
            }
            self.happened(PortEvent::Aborted);
        });
    }

    pub(super) fn close(self) {
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
    pub(super) fn look_for_port(self) {
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

    pub(super) fn plugged(self, port: &SerialPort, here: bool) {
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
    pub(super) fn find_known(self) {
        leptos::task::spawn_local(async move {
            let Some(ports) = serial_port::ports() else { return };
            let found = ports.known().await;
            let known = found.iter().map(|port| Port::Serial(port.ids())).collect();
            self.change(|inner| inner.known = found);
            self.known.set(known);
        });
    }
}
