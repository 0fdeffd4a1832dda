//! The byte pump of the serial port with a fake port in a real browser: errors that are survived, closing in
//! the right order, locked streams, a list that is closed without choosing.
#![cfg(target_arch = "wasm32")]
#![allow(missing_docs, clippy::unwrap_used)]

use std::cell::RefCell;
use std::rc::Rc;

use js_sys::{Function, Promise, Reflect};
use line_maze_lab::link::page::OpenError;
use line_maze_lab::web::serial_port::{NotChosen, SerialPort, Told, ports};
use wasm_bindgen::JsValue;
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

/// A port that does what it is told, and writes down what is done to it.
const FAKE: &str = "
    const done = [];
    const port = {
        done, connected: true, written: [], fails: null,
        getInfo: () => ({ usbVendorId: 0x2341, usbProductId: 0x43 }),
        fresh() {
            port.readable = new ReadableStream({
                start(control) { port.feed = control; },
                cancel() { done.push('cancel'); },
            });
        },
        async open({ baudRate }) {
            if (port.fails) throw new DOMException('no', port.fails);
            done.push('open ' + baudRate);
            port.fresh();
            port.writable = new WritableStream({ write(chunk) { port.written.push(...chunk); } });
        },
        async close() {
            if (port.readable?.locked || port.writable?.locked) throw new TypeError('locked');
            port.readable = port.writable = null;
            done.push('close');
        },
        say(text) { port.feed.enqueue(new TextEncoder().encode(text)); },
        fail(name) { const { feed } = port; port.fresh(); feed.error(new DOMException('no', name)); },
        vanish() { const { feed } = port; port.readable = port.writable = null; feed.error(new DOMException('gone', 'NetworkError')); },
    };
    return port;
";

fn fake() -> JsValue {
    Function::new_no_args(FAKE).call0(&JsValue::NULL).unwrap()
}

fn tell(port: &JsValue, method: &str, argument: &str) {
    let method: Function = Reflect::get(port, &method.into()).unwrap().into();
    method.call1(port, &argument.into()).unwrap();
}

fn done(port: &JsValue) -> String {
    let done: js_sys::Array = Reflect::get(port, &"done".into()).unwrap().into();
    done.join(",").into()
}

/// Waits until something holds, ten seconds at most.
async fn until(so: impl Fn() -> bool) {
    let window = web_sys::window().unwrap();
    for _ in 0..1_000 {
        if so() {
            return;
        }
        let blink = Promise::new(&mut |done, _| {
            window.set_timeout_with_callback_and_timeout_and_arguments_0(&done, 10).unwrap();
        });
        JsFuture::from(blink).await.unwrap();
    }
    panic!("it never came about");
}

type Heard = Rc<RefCell<Vec<Told>>>;

async fn open(js: &JsValue) -> (SerialPort, Heard) {
    let (port, heard) = (SerialPort::of(js.clone()), Heard::default());
    let hears = Rc::clone(&heard);
    port.open(9_600, move |told| hears.borrow_mut().push(told)).await.unwrap();
    (port, heard)
}

fn text(heard: &Heard) -> String {
    let bytes = |told: &Told| match told {
        Told::Bytes(bytes) => bytes.clone(),
        Told::Gone => b"<gone>".to_vec(),
    };
    String::from_utf8(heard.borrow().iter().flat_map(bytes).collect()).unwrap()
}

#[wasm_bindgen_test]
async fn framing_errors_and_breaks_are_survived() {
    let js = fake();
    let (port, heard) = open(&js).await;
    assert_eq!(port.ids(), Some((0x2341, 0x43)));
    let mut said = "one ".to_owned();
    tell(&js, "say", "one ");
    until(|| text(&heard) == said).await;
    for name in ["FramingError", "BreakError", "BufferOverrunError", "ParityError"] {
        tell(&js, "fail", name);
        tell(&js, "say", name);
        said.push_str(name);
        until(|| text(&heard) == said).await;
    }
}

#[wasm_bindgen_test]
async fn it_is_closed_in_the_right_order_and_can_be_opened_again() {
    let js = fake();
    let (port, heard) = open(&js).await;
    port.write(b"hi\n", || {}).unwrap();
    let written = || {
        let written: js_sys::Array = Reflect::get(&js, &"written".into()).unwrap().into();
        String::from(written.join(","))
    };
    tell(&js, "say", "ready");
    until(|| written() == "104,105,10" && text(&heard) == "ready").await;
    port.close().await;
    assert_eq!(done(&js), "open 9600,cancel,close");
    port.close().await;
    port.open(115_200, |_| {}).await.unwrap();
    assert_eq!(done(&js), "open 9600,cancel,close,open 115200");
    assert_eq!(text(&heard), "ready");
    // Before anybody reads it, there is nothing to cancel.
    port.close().await;
    assert_eq!(done(&js), "open 9600,cancel,close,open 115200,close");
}

#[wasm_bindgen_test]
async fn a_device_that_goes_is_told_once() {
    let js = fake();
    let (port, heard) = open(&js).await;
    tell(&js, "say", "at ");
    until(|| text(&heard) == "at ").await;
    tell(&js, "vanish", "");
    until(|| text(&heard) == "at <gone>").await;
    assert!(port.write(b"stop\n", || {}).is_err());
    port.close().await;
    assert_eq!(text(&heard), "at <gone>");
}

#[wasm_bindgen_test]
async fn streams_that_somebody_else_holds_are_told() {
    let js = fake();
    let (port, heard) = open(&js).await;
    let locked = Function::new_with_args(
        "port",
        "port.writable.getWriter(); port.fail('BreakError'); port.readable.getReader()",
    );
    locked.call1(&JsValue::NULL, &js).unwrap();
    until(|| text(&heard) == "<gone>").await;
    assert!(port.write(b"hi\n", || {}).is_err());
}

#[wasm_bindgen_test]
async fn why_it_cannot_be_opened_is_told() {
    for (name, why) in [
        ("InvalidStateError", OpenError::InUse),
        ("NetworkError", OpenError::InUseOrNoPermission),
        ("SecurityError", OpenError::Policy),
        ("UnknownError", OpenError::Other),
    ] {
        let js = fake();
        Reflect::set(&js, &"fails".into(), &name.into()).unwrap();
        assert_eq!(SerialPort::of(js.clone()).open(9_600, |_| {}).await, Err(why), "{name}");
        Reflect::set(&js, &"connected".into(), &false.into()).unwrap();
        assert_eq!(SerialPort::of(js).open(9_600, |_| {}).await, Err(OpenError::Unplugged));
    }
}

#[wasm_bindgen_test]
async fn a_list_that_is_closed_is_no_failure() {
    let replaced = Function::new_with_args(
        "name",
        "Object.defineProperty(navigator, 'serial', { configurable: true, value: { \
            getPorts: async () => [], addEventListener() {}, \
            requestPort: async () => { throw new DOMException('none', name); } } })",
    );
    for (name, why) in [("NotFoundError", NotChosen::Cancelled), ("SecurityError", NotChosen::Forbidden)] {
        replaced.call1(&JsValue::NULL, &name.into()).unwrap();
        let ports = ports().unwrap();
        assert_eq!(ports.choose().await.err(), Some(why));
        assert!(ports.known().await.is_empty());
    }
}
