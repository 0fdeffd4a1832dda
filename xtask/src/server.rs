//! A small web server that shows the newest page, and tells open pages of newer ones.

use std::convert::Infallible;
use std::net::TcpListener;
use std::sync::Arc;
use std::thread;

use anyhow::{Context, Result};
use http_body_util::channel::{Channel, Sender};
use http_body_util::{Either, Full};
use hyper::body::{Bytes, Incoming};
use hyper::header::{CACHE_CONTROL, CONTENT_TYPE, HeaderValue};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Method, Request, Response, StatusCode};
use hyper_util::rt::TokioIo;
use serde_json::json;
use tokio::runtime;
use tokio::sync::watch;

use crate::compile::NotBuilt;
use crate::page::{Page, hash};

/// What the page loads besides its own files, to hear of newer ones.
const SCRIPT: &str = "xtask-reload.js";
const NEWS: &str = "xtask-news";

/// Holds the newest page.
pub(crate) struct Desk {
    state: watch::Sender<State>,
}

#[derive(Debug, Clone)]
struct State {
    page: Arc<Page>,
    edition: Edition,
    /// Why the page could not be made anew.
    complaint: Option<String>,
}

/// Which page this is. Where only the style differs, it need not be loaded again.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Edition {
    content: String,
    style: String,
}

impl Edition {
    fn of(page: &Page) -> Self {
        let of = |style: bool| {
            hash(
                page.0.iter().filter(|(name, _)| name.ends_with(".css") == style).map(|(_, content)| content),
            )
        };
        Self { content: of(false), style: of(true) }
    }
}

impl Desk {
    pub(crate) fn new(page: Page) -> Result<Self> {
        Ok(Self { state: watch::Sender::new(State::of(page)?) })
    }

    /// Shows another page from now on; whether it is another.
    pub(crate) fn show(&self, page: Page) -> Result<bool> {
        let next = State::of(page)?;
        let new = self.state.borrow().edition != next.edition;
        self.state.send_if_modified(|state| {
            let changed = new || state.complaint.is_some();
            *state = next;
            changed
        });
        Ok(new)
    }

    /// Shows the old page, and why there is no new one.
    pub(crate) fn complain(&self, error: &NotBuilt) {
        let complaint = match error {
            NotBuilt::Code(words) => words.clone(),
            NotBuilt::Cargo | NotBuilt::Other(_) => error.to_string(),
        };
        self.state.send_modify(|state| state.complaint = Some(complaint));
    }
}

impl State {
    fn of(page: Page) -> Result<Self> {
        let edition = Edition::of(&page);
        Ok(Self { page: Arc::new(listening(page, &edition)?), edition, complaint: None })
    }

    /// As the page hears of it.
    fn news(&self) -> String {
        let Edition { content, style } = &self.edition;
        let news = json!({ "content": content, "style": style, "complaint": self.complaint });
        format!("data: {news}\n\n")
    }
}

/// The page with the script that hears of newer ones.
fn listening(mut page: Page, edition: &Edition) -> Result<Page> {
    let Edition { content, style } = edition;
    let script = format!(
        "<script src=\"{SCRIPT}\" data-content=\"{content}\" data-style=\"{style}\" defer></script></head>"
    );
    page.edit_index(|html| Ok(html.replacen("</head>", &script, 1)))?;
    page.0.insert(SCRIPT.to_owned(), include_bytes!("reload.js").to_vec());
    Ok(page)
}

/// Answers everyone from now on.
pub(crate) fn start(listener: TcpListener, desk: Arc<Desk>) -> Result<()> {
    let runtime =
        runtime::Builder::new_current_thread().enable_io().build().context("starting the server")?;
    listener.set_nonblocking(true)?;
    let listener = {
        let _guard = runtime.enter();
        tokio::net::TcpListener::from_std(listener)?
    };
    thread::spawn(move || {
        runtime.block_on(async move {
            loop {
                // Who has gone away before being heard needs no answer.
                let Ok((stream, _)) = listener.accept().await else {
                    tokio::task::yield_now().await;
                    continue;
                };
                let desk = Arc::clone(&desk);
                let service = service_fn(move |request| {
                    let answer = answer(&request, &desk);
                    async { Ok::<_, Infallible>(answer) }
                });
                tokio::spawn(http1::Builder::new().serve_connection(TokioIo::new(stream), service));
            }
        });
    });
    Ok(())
}

type Answer = Response<Either<Full<Bytes>, Channel<Bytes>>>;

fn answer(request: &Request<Incoming>, desk: &Desk) -> Answer {
    let address = request.uri().path().trim_start_matches('/');
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return words(StatusCode::METHOD_NOT_ALLOWED, "this server only gives files out");
    }
    if address == NEWS {
        let (to, body) = Channel::new(1);
        tokio::spawn(tell_news(to, desk.state.subscribe()));
        return of_type("text/event-stream", Either::Right(body));
    }
    let name = if address.is_empty() { "index.html" } else { address };
    match desk.state.borrow().page.0.get(name) {
        Some(content) => of_type(mime(name), Either::Left(Bytes::copy_from_slice(content).into())),
        None => words(StatusCode::NOT_FOUND, "the page has no such file"),
    }
}

fn words(status: StatusCode, words: &'static str) -> Answer {
    let mut answer =
        of_type("text/plain; charset=utf-8", Either::Left(Bytes::from_static(words.as_bytes()).into()));
    *answer.status_mut() = status;
    answer
}

fn of_type(mime: &'static str, body: Either<Full<Bytes>, Channel<Bytes>>) -> Answer {
    let mut answer = Response::new(body);
    answer.headers_mut().insert(CONTENT_TYPE, HeaderValue::from_static(mime));
    answer.headers_mut().insert(CACHE_CONTROL, HeaderValue::from_static("no-store"));
    answer
}

/// Events for as long as the other end listens.
async fn tell_news(mut to: Sender<Bytes>, mut state: watch::Receiver<State>) {
    loop {
        let news = state.borrow_and_update().news();
        if to.send_data(news.into()).await.is_err() || state.changed().await.is_err() {
            return;
        }
    }
}

fn mime(name: &str) -> &'static str {
    match name.rsplit('.').next() {
        Some("html") => "text/html; charset=utf-8",
        Some("js") => "text/javascript; charset=utf-8",
        Some("css") => "text/css; charset=utf-8",
        Some("json") => "application/json",
        Some("wasm") => "application/wasm",
        Some("svg") => "image/svg+xml",
        Some("png") => "image/png",
        Some("txt" | "md") => "text/plain; charset=utf-8",
        Some("webmanifest") => "application/manifest+json",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use std::io::{Read, Write};
    use std::net::{Ipv4Addr, SocketAddr, TcpStream};

    use super::*;

    fn page(script: &str, style: &str) -> Page {
        let files = [("index.html", "<head></head>"), ("a.wasm", script), ("a.css", style)];
        Page(files.into_iter().map(|(name, text)| (name.into(), text.into())).collect())
    }

    fn served() -> (Arc<Desk>, SocketAddr) {
        let desk = Arc::new(Desk::new(page("1", "1")).unwrap());
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        let address = listener.local_addr().unwrap();
        start(listener, Arc::clone(&desk)).unwrap();
        (desk, address)
    }

    fn asked(address: SocketAddr, target: &str) -> TcpStream {
        let mut stream = TcpStream::connect(address).unwrap();
        write!(stream, "GET {target} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n").unwrap();
        stream
    }

    fn get(address: SocketAddr, target: &str) -> String {
        let mut answer = String::new();
        asked(address, target).read_to_string(&mut answer).unwrap();
        answer
    }

    /// Reads until these words come.
    fn hear(stream: &mut TcpStream, words: &str) -> String {
        let mut heard = String::new();
        while !heard.contains(words) {
            let mut byte = [0];
            stream.read_exact(&mut byte).unwrap();
            heard.push(byte[0] as char);
        }
        heard
    }

    #[test]
    fn files_have_their_types_and_are_never_kept() {
        let (_, address) = served();
        let wasm = get(address, "/a.wasm?x=1");
        assert!(wasm.starts_with("HTTP/1.1 200") && wasm.ends_with("\r\n\r\n1"), "{wasm}");
        assert!(wasm.contains("content-type: application/wasm\r\n"), "{wasm}");
        assert!(wasm.contains("cache-control: no-store\r\n"), "{wasm}");
        let index = get(address, "/");
        assert!(index.contains("text/html") && index.contains("<script src=\"xtask-reload.js\""), "{index}");
        for lost in ["/b.js", "/../Cargo.toml", "//etc/passwd"] {
            assert!(get(address, lost).starts_with("HTTP/1.1 404"), "{lost}");
        }
    }

    #[test]
    fn connections_that_stay_open_hold_nobody_up() {
        let (_, address) = served();
        let silent: Vec<_> = (0..20).map(|_| TcpStream::connect(address).unwrap()).collect();
        let listening: Vec<_> = (0..20).map(|_| asked(address, "/xtask-news")).collect();
        assert!(get(address, "/a.css").ends_with("\r\n\r\n1"));
        drop((silent, listening));
    }

    #[test]
    fn open_pages_hear_of_a_new_page_and_of_a_broken_one() {
        let (desk, address) = served();
        let mut news = asked(address, "/xtask-news");
        let first = hear(&mut news, "}\n\n");
        assert!(first.contains("text/event-stream") && first.contains("\"complaint\":null"), "{first}");
        desk.complain(&NotBuilt::Code("error: no \"x\"\n".into()));
        let complaint = hear(&mut news, "}\n\n");
        assert!(complaint.contains(r#""complaint":"error: no \"x\"\n""#), "{complaint}");
        // The same page again takes the complaint away.
        assert!(!desk.show(page("1", "1")).unwrap());
        assert!(hear(&mut news, "}\n\n").contains("\"complaint\":null"));
        assert!(desk.show(page("2", "1")).unwrap());
        let new = Edition::of(&page("2", "1")).content;
        assert!(hear(&mut news, "}\n\n").contains(&format!("\"content\":\"{new}\"")));
        assert!(get(address, "/a.wasm").ends_with("\r\n\r\n2"));
    }

    #[test]
    fn a_style_is_told_from_other_content() {
        let (one, style, script) = (page("1", "1"), page("1", "2"), page("2", "1"));
        let [one, style, script] = [one, style, script].map(|page| Edition::of(&page));
        assert!(one.content == style.content && one.style != style.style);
        assert!(one.content != script.content && one.style == script.style);
    }
}
