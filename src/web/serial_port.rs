//! The Web Serial of the browser, and the only file that touches it: it moves bytes and says what happens to
//! the port. web-sys keeps this interface behind a flag for the whole build, so it is written out here.
//!
//! Source: <https://wicg.github.io/serial/>. While `readable` is not null, a fresh reader survives framing
//! errors, breaks and full buffers. To close: cancel the reader, release the lock, then close.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use js_sys::{Object, Promise, Reflect, Uint8Array};
use leptos::prelude::{set_timeout, window};
use wasm_bindgen::prelude::*;
use wasm_bindgen_futures::{JsFuture, future_to_promise, spawn_local};

use crate::link::page::OpenError;

#[wasm_bindgen]
extern "C" {
    type JsSerial;
    #[wasm_bindgen(method, catch, js_name = getPorts)]
    fn get_ports(this: &JsSerial) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, catch, js_name = requestPort)]
    fn request_port(this: &JsSerial) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, js_name = addEventListener)]
    fn listen(this: &JsSerial, event: &str, handler: &JsValue);

    #[derive(Clone, Debug)]
    type JsPort;
    #[wasm_bindgen(method, catch)]
    fn open(this: &JsPort, options: &JsValue) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, catch)]
    fn close(this: &JsPort) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, catch, js_name = getInfo)]
    fn get_info(this: &JsPort) -> Result<JsValue, JsValue>;
    #[wasm_bindgen(method, getter)]
    fn connected(this: &JsPort) -> Option<bool>;
    #[wasm_bindgen(method, getter)]
    fn readable(this: &JsPort) -> Option<JsReadable>;
    #[wasm_bindgen(method, getter)]
    fn writable(this: &JsPort) -> Option<JsWritable>;

    #[derive(Clone, Debug)]
    type JsReadable;
    #[wasm_bindgen(method, catch, js_name = getReader)]
    fn get_reader(this: &JsReadable) -> Result<JsReader, JsValue>;

    #[derive(Clone, Debug)]
    type JsReader;
    #[wasm_bindgen(method, catch)]
    fn read(this: &JsReader) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, catch)]
    fn cancel(this: &JsReader) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, catch, js_name = releaseLock)]
    fn release(this: &JsReader) -> Result<(), JsValue>;

    #[derive(Clone, Debug)]
    type JsWritable;
    #[wasm_bindgen(method, catch, js_name = getWriter)]
    fn get_writer(this: &JsWritable) -> Result<JsWriter, JsValue>;
    #[wasm_bindgen(method, catch)]
    fn abort(this: &JsWritable) -> Result<Promise, JsValue>;

    #[derive(Clone, Debug)]
    type JsWriter;
    #[wasm_bindgen(method, catch)]
    fn write(this: &JsWriter, bytes: &Uint8Array) -> Result<Promise, JsValue>;
    #[wasm_bindgen(method, catch, js_name = releaseLock)]
    fn release(this: &JsWriter) -> Result<(), JsValue>;
}

/// Bytes that the browser keeps for the page: enough for a device that floods.
const BUFFER: u32 = 65_536;
/// After an error without a byte, the next reader waits so long: a line that only breaks must not freeze the page.
const PAUSE_MS: i32 = 20;

/// What an open port tells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Told {
    /// Bytes have come.
    Bytes(Vec<u8>),
    /// The port has gone, or cannot be read or written any more.
    Gone,
}

/// Why no port was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotChosen {
    /// The user closed the list.
    Cancelled,
    /// The browser or a policy does not show it.
    Forbidden,
}

/// The browser's serial ports.
#[derive(Debug)]
pub struct Ports(JsSerial);

impl std::fmt::Debug for JsSerial {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("Serial")
    }
}

/// The ports, if the browser has Web Serial and the page comes from a secure origin.
#[must_use]
pub fn ports() -> Option<Ports> {
    let serial = Reflect::get(&window().navigator(), &"serial".into()).ok()?;
    serial.is_object().then(|| Ports(serial.unchecked_into()))
}

impl Ports {
    /// The ports that the user has allowed before, and that are there.
    pub async fn known(&self) -> Vec<SerialPort> {
        let Ok(promise) = self.0.get_ports() else { return Vec::new() };
        let Ok(list) = JsFuture::from(promise).await else { return Vec::new() };
        js_sys::Array::from(&list).iter().map(SerialPort::of).filter(SerialPort::is_there).collect()
    }

    /// Shows the browser's list. To be called while the browser still sees the user's click.
    ///
    /// # Errors
    /// Where nothing was chosen.
    pub async fn choose(&self) -> Result<SerialPort, NotChosen> {
        let asked = self.0.request_port();
        let chosen = match asked {
            Ok(promise) => JsFuture::from(promise).await,
            Err(error) => Err(error),
        };
        chosen.map(SerialPort::of).map_err(|error| match name(&error).as_str() {
            "NotFoundError" => NotChosen::Cancelled,
            _ => NotChosen::Forbidden,
        })
    }

    /// Calls with every port that is plugged in (`true`) or out (`false`), as long as the page lives.
    pub fn on_change(&self, changed: impl Fn(SerialPort, bool) + Clone + 'static) {
        for (event, here) in [("connect", true), ("disconnect", false)] {
            let changed = changed.clone();
            let handle = Closure::<dyn FnMut(web_sys::Event)>::new(move |event: web_sys::Event| {
                if let Some(port) = event.target() {
                    changed(SerialPort::of(port.into()), here);
                }
            });
            self.0.listen(event, handle.as_ref());
            handle.forget();
        }
    }
}

/// A serial port, open or not.
#[derive(Clone, Debug)]
pub struct SerialPort {
    js: JsPort,
    state: Rc<State>,
}

/// What becomes of an open port.
#[derive(Debug, Default)]
struct State {
    closing: Cell<bool>,
    reader: RefCell<Option<JsReader>>,
    /// Settled when the reading is over.
    reading: RefCell<Option<Promise>>,
    /// Settled when the last closing is over.
    closed: RefCell<Option<Promise>>,
    /// Counts what was thrown away: writes from before are not told any more.
    aborts: Cell<u32>,
}

impl SerialPort {
    /// A port of the browser, or one that behaves like it.
    #[must_use]
    pub fn of(js: JsValue) -> Self {
        Self { js: js.unchecked_into(), state: Rc::default() }
    }

    /// Whether it is the same port.
    #[must_use]
    pub fn is(&self, other: &Self) -> bool {
        Object::is(&self.js, &other.js)
    }

    /// Whether it is plugged in, as far as the browser says.
    #[must_use]
    pub fn is_there(&self) -> bool {
        self.js.connected() != Some(false)
    }

    /// Vendor and product, if it is on USB.
    #[must_use]
    pub fn ids(&self) -> Option<(u16, u16)> {
        let info = self.js.get_info().ok()?;
        let id = |key: &str| Reflect::get(&info, &key.into()).ok()?.as_f64().map(|id| id as u16);
        Some((id("usbVendorId")?, id("usbProductId")?))
    }

    /// Opens it; from then on `told` hears everything.
    ///
    /// # Errors
    /// Where it cannot be opened: why.
    pub async fn open(&self, baud: u32, told: impl Fn(Told) + 'static) -> Result<(), OpenError> {
        let closed = self.state.closed.borrow_mut().take();
        if let Some(closed) = closed {
            let _ = JsFuture::from(closed).await;
        }
        let options = Object::new();
        for (key, value) in [("baudRate", baud), ("bufferSize", BUFFER)] {
            let _ = Reflect::set(&options, &key.into(), &value.into());
        }
        let opened = match self.js.open(&options) {
            Ok(promise) => JsFuture::from(promise).await,
            Err(error) => Err(error),
        };
        opened.map_err(|error| self.refusal(&error))?;
        self.state.closing.set(false);
        let (port, told) = (self.clone(), Rc::new(told) as Rc<dyn Fn(Told)>);
        let reading = future_to_promise(async move {
            port.read_on(&*told).await;
            if !port.state.closing.get() {
                told(Told::Gone);
            }
            Ok(JsValue::UNDEFINED)
        });
        *self.state.reading.borrow_mut() = Some(reading);
        Ok(())
    }

    fn refusal(&self, error: &JsValue) -> OpenError {
        if !self.is_there() {
            return OpenError::Unplugged;
        }
        match name(error).as_str() {
            // This page has it open already.
            "InvalidStateError" => OpenError::InUse,
            "NetworkError" => OpenError::InUseOrNoPermission,
            "NotFoundError" => OpenError::Unplugged,
            "SecurityError" | "NotAllowedError" => OpenError::Policy,
            _ => OpenError::Other,
        }
    }

    /// One reader after the other, until the port has gone or is closed.
    async fn read_on(&self, told: &dyn Fn(Told)) {
        let mut last: Option<JsReadable> = None;
        while let Some(readable) = self.js.readable() {
            // A stream that failed stays failed: only a new one is worth reading.
            let same = last.as_ref().is_some_and(|last| Object::is(last, &readable));
            let Ok(reader) = readable.get_reader() else { return };
            if same || self.state.closing.get() {
                let _ = reader.release();
                return;
            }
            *self.state.reader.borrow_mut() = Some(reader.clone());
            let heard = self.read(&reader, told).await;
            self.state.reader.borrow_mut().take();
            let _ = reader.release();
            if self.state.closing.get() {
                return;
            }
            if !heard {
                pause().await;
            }
            last = Some(readable);
        }
    }

    /// Reads until an error or the end; whether anything came.
    async fn read(&self, reader: &JsReader, told: &dyn Fn(Told)) -> bool {
        let mut heard = false;
        loop {
            let Ok(promise) = reader.read() else { return heard };
            let Ok(result) = JsFuture::from(promise).await else { return heard };
            let done = Reflect::get(&result, &"done".into()).is_ok_and(|done| done.is_truthy());
            let value = Reflect::get(&result, &"value".into()).ok().filter(JsValue::is_object);
            if let Some(value) = value.filter(|_| !self.state.closing.get()) {
                let bytes = Uint8Array::new(&value).to_vec();
                if !bytes.is_empty() {
                    heard = true;
                    told(Told::Bytes(bytes));
                }
            }
            if done {
                return heard;
            }
        }
    }

    /// Sends bytes, after those that were sent before; `done` hears when the system has taken them, or that it
    /// never will.
    ///
    /// # Errors
    /// Where the port cannot be written any more, or somebody else writes it.
    pub fn write(&self, bytes: &[u8], done: impl FnOnce() + 'static) -> Result<(), JsValue> {
        let writable = self.js.writable().ok_or_else(|| JsValue::from_str("not writable"))?;
        let writer = writable.get_writer()?;
        // The lock is given back at once; what was written is sent all the same.
        let sent = writer.write(&Uint8Array::from(bytes));
        writer.release()?;
        // That it failed is heard from the reader, or from the robot's silence.
        let sent = sent?;
        let (state, aborts) = (Rc::clone(&self.state), self.state.aborts.get());
        spawn_local(async move {
            let _ = JsFuture::from(sent).await;
            if state.aborts.get() == aborts {
                done();
            }
        });
        Ok(())
    }

    /// Throws away what was written and has not left, also what the system holds; then it can be written again.
    pub async fn abort(&self) {
        self.state.aborts.set(self.state.aborts.get().wrapping_add(1));
        if let Some(Ok(aborted)) = self.js.writable().map(|writable| writable.abort()) {
            let _ = JsFuture::from(aborted).await;
        }
    }

    /// Closes it, in the right order; done when nothing holds it any more.
    pub async fn close(&self) {
        if self.state.closing.replace(true) {
            return;
        }
        let port = self.clone();
        let closed = future_to_promise(async move {
            let reader = port.state.reader.borrow().clone();
            if let Some(Ok(cancelled)) = reader.map(|reader| reader.cancel()) {
                let _ = JsFuture::from(cancelled).await;
            }
            let reading = port.state.reading.borrow_mut().take();
            if let Some(reading) = reading {
                let _ = JsFuture::from(reading).await;
            }
            if let Ok(closed) = port.js.close() {
                let _ = JsFuture::from(closed).await;
            }
            Ok(JsValue::UNDEFINED)
        });
        *self.state.closed.borrow_mut() = Some(closed.clone());
        let _ = JsFuture::from(closed).await;
    }
}

/// A DOM exception's name.
fn name(error: &JsValue) -> String {
    Reflect::get(error, &"name".into()).ok().and_then(|name| name.as_string()).unwrap_or_default()
}

async fn pause() {
    let waited = Promise::new(&mut |done, _| {
        set_timeout(
            move || {
                let _ = done.call0(&JsValue::NULL);
            },
            std::time::Duration::from_millis(PAUSE_MS as u64),
        );
    });
    let _ = JsFuture::from(waited).await;
}
