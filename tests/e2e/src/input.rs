//! Hands: keys, mouse and fingers, with the browser's own trusted events.

use std::time::{SystemTime, UNIX_EPOCH};

use anyhow::{Context, Result, bail};
use fantoccini::Locator;
use serde_json::{Value, json};

use crate::Page;

/// A place in the viewport, in CSS pixels.
pub type Place = (f64, f64);

/// A mouse button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// The usual one.
    Left,
    /// The other one.
    Right,
}

/// The name by which a person calls a control: its label without the key in brackets, or its text.
const CONTROL: &str = "(name) => {
    const plain = (text) => text.trim().replace(/\\s+/g, ' ').replace(/ \\([^)]*\\)$/, '');
    const said = (control) => {
        const copy = control.cloneNode(true);
        copy.querySelectorAll('[aria-hidden=true]').forEach((mute) => mute.remove());
        return copy.textContent;
    };
    const called = (control) => plain(control.ariaLabel ?? said(control));
    const open = document.querySelector('dialog[open]') ?? document;
    const controls = [...open.querySelectorAll('button, a[href], summary, [role=button], [role=menuitem]')];
    return controls.find((control) => control.checkVisibility() && called(control) === name);
}";

/// Where to click an element, after it was scrolled into view; says what is in the way.
const MIDDLE: &str = "(element) => {
    if (!element) return 'it is not there';
    element.scrollIntoView({ block: 'center', inline: 'nearest', behavior: 'instant' });
    const { left, top, width, height } = element.getBoundingClientRect();
    const [x, y] = [left + width / 2, top + height / 2];
    const hit = document.elementFromPoint(x, y);
    if (!hit || !(element.contains(hit) || hit.contains(element) || hit.closest('label')?.control === element))
        return `${hit?.outerHTML.slice(0, 200)} is in the way`;
    return [x, y];
}";

impl Page {
    /// Presses a key, or several together: `"Space"`, `"ArrowRight"`, `"Shift+N"`, `"Control+Z"`.
    ///
    /// # Errors
    /// If there's no such key.
    pub async fn press(&self, keys: &str) -> Result<()> {
        self.press_times(keys, 1).await
    }

    /// Presses a key several times.
    ///
    /// # Errors
    /// If there's no such key.
    pub async fn press_times(&self, keys: &str, times: usize) -> Result<()> {
        let codes: Vec<String> = keys.split('+').map(code).collect::<Result<_>>()?;
        let key = |kind: &str, code: &String| json!({ "type": kind, "value": code });
        let down = codes.iter().map(|code| key("keyDown", code));
        let up = codes.iter().rev().map(|code| key("keyUp", code));
        let stroke: Vec<Value> = down.chain(up).collect();
        let actions: Vec<Value> = std::iter::repeat_n(stroke, times).flatten().collect();
        self.act(json!([{ "type": "key", "id": "keyboard", "actions": actions }])).await
    }

    /// Leaves a dialog by Esc, and waits until it's gone: a key that comes sooner is still the dialog's.
    ///
    /// # Errors
    /// If it stays.
    pub async fn leave_dialog(&self) -> Result<()> {
        self.press("Escape").await?;
        self.wait_for_no("dialog").await
    }

    /// Types into a field in place of what it holds, and leaves the field.
    ///
    /// # Errors
    /// If there's no such field.
    pub async fn fill(&self, css: &str, text: &str) -> Result<()> {
        self.wait_for(css).await?;
        let field = self.session.client.find(Locator::Css(css)).await?;
        field.clear().await?;
        if !text.is_empty() {
            field.send_keys(text).await?;
        }
        self.call("(css) => document.querySelector(css).blur()", &[json!(css)]).await?;
        Ok(())
    }

    /// Chooses from a list by the entry's text.
    ///
    /// # Errors
    /// If there's no such list or entry.
    pub async fn choose(&self, css: &str, entry: &str) -> Result<()> {
        self.wait_for(css).await?;
        self.session.client.find(Locator::Css(css)).await?.select_by_label(entry).await?;
        Ok(())
    }

    /// Clicks a button or link by its name.
    ///
    /// # Errors
    /// If it's not there, or something is in the way.
    pub async fn click(&self, name: &str) -> Result<()> {
        // A part of the page may be on its way.
        self.wait_until(&format!("({CONTROL})({})", json!(name))).await?;
        let place = self.call(&format!("(name) => ({MIDDLE})(({CONTROL})(name))"), &[json!(name)]).await?;
        self.click_at(place_of(&place, name)?).await
    }

    /// Clicks an element.
    ///
    /// # Errors
    /// If it's not there, or something is in the way.
    pub async fn click_css(&self, css: &str) -> Result<()> {
        self.click_at(self.middle(css).await?).await
    }

    /// The middle of an element, scrolled into view.
    ///
    /// # Errors
    /// If it's not there, or something is in the way.
    pub async fn middle(&self, css: &str) -> Result<Place> {
        self.wait_for(css).await?;
        let find = format!("(css) => ({MIDDLE})(document.querySelector(css))");
        place_of(&self.call(&find, &[json!(css)]).await?, css)
    }

    /// Clicks a place.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn click_at(&self, place: Place) -> Result<()> {
        self.drag(&[place], Button::Left).await
    }

    /// Puts the mouse over a place.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn point_at(&self, place: Place) -> Result<()> {
        self.act(json!([mouse(&[to(place)])])).await
    }

    /// Drags the mouse along places with a button down.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn drag(&self, places: &[Place], button: Button) -> Result<()> {
        let button = if button == Button::Left { 0 } else { 2 };
        let (first, rest) = places.split_first().context("a drag along no places")?;
        let mut actions = vec![to(*first), json!({ "type": "pointerDown", "button": button })];
        actions.extend(rest.iter().copied().map(to));
        actions.push(json!({ "type": "pointerUp", "button": button }));
        self.act(json!([mouse(&actions)])).await
    }

    /// Turns the mouse wheel over a place.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn wheel(&self, (x, y): Place, by: f64) -> Result<()> {
        let event = json!({ "type": "mouseWheel", "x": x, "y": y, "deltaX": 0, "deltaY": by });
        self.tools("Input.dispatchMouseEvent", event).await.map(drop)
    }

    /// Touches an element.
    ///
    /// # Errors
    /// If it's not there, or something is in the way.
    pub async fn tap(&self, name: &str) -> Result<()> {
        // A part of the page may be on its way.
        self.wait_until(&format!("({CONTROL})({})", json!(name))).await?;
        let place = self.call(&format!("(name) => ({MIDDLE})(({CONTROL})(name))"), &[json!(name)]).await?;
        self.touch_drag(&[&[place_of(&place, name)?]]).await
    }

    /// Moves fingers along places: each finger along its own, as many steps as the first has. They rest before
    /// they are lifted: a finger that leaves in full swing throws the page, and what it throws swallows the next tap.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn touch_drag(&self, fingers: &[&[Place]]) -> Result<()> {
        const FRAME_S: f64 = 0.016;
        const REST_S: f64 = 0.2;
        let steps = fingers.first().map_or(0, |places| places.len());
        let mut time = SystemTime::now().duration_since(UNIX_EPOCH)?.as_secs_f64() - REST_S;
        time -= FRAME_S * steps as f64;
        let at = |step: usize| fingers.iter().filter_map(move |places| places.get(step).copied());
        for step in 0..steps {
            let kind = if step == 0 { "touchStart" } else { "touchMove" };
            time += FRAME_S;
            self.touch(kind, time, at(step)).await?;
        }
        if steps > 1 {
            time += REST_S;
            self.touch("touchMove", time, at(steps - 1)).await?;
        }
        self.touch("touchEnd", time, []).await
    }

    /// Two fingers on both sides of a place move apart, or together, from one distance to another.
    ///
    /// # Errors
    /// If the browser refuses.
    pub async fn pinch(&self, (x, y): Place, from: f64, to: f64) -> Result<()> {
        let distance = |step: u32| (from + (to - from) * f64::from(step) / 8.0) / 2.0;
        let left: Vec<Place> = (0..=8).map(|step| (x - distance(step), y)).collect();
        let right: Vec<Place> = (0..=8).map(|step| (x + distance(step), y)).collect();
        self.touch_drag(&[&left, &right]).await
    }

    async fn touch(&self, kind: &str, time: f64, fingers: impl IntoIterator<Item = Place>) -> Result<()> {
        let point = |(id, (x, y)): (usize, Place)| json!({ "x": x, "y": y, "id": id });
        let points: Vec<Value> = fingers.into_iter().enumerate().map(point).collect();
        self.tools(
            "Input.dispatchTouchEvent",
            json!({ "type": kind, "touchPoints": points, "timestamp": time }),
        )
        .await
        .map(drop)
    }

    async fn act(&self, actions: Value) -> Result<()> {
        self.session.tell("actions", json!({ "actions": actions })).await.map(drop)
    }
}

fn place_of(found: &Value, what: &str) -> Result<Place> {
    match (found[0].as_f64(), found[1].as_f64()) {
        (Some(x), Some(y)) => Ok((x, y)),
        _ => bail!("can't click “{what}”: {}", found.as_str().unwrap_or("it has no place")),
    }
}

fn mouse(actions: &[Value]) -> Value {
    json!({ "type": "pointer", "id": "mouse", "parameters": { "pointerType": "mouse" }, "actions": actions })
}

fn to((x, y): Place) -> Value {
    json!({ "type": "pointerMove", "duration": 0, "origin": "viewport", "x": x.round(), "y": y.round() })
}

/// The key's character in the WebDriver standard.
fn code(name: &str) -> Result<String> {
    let code = match name {
        "Space" => ' ',
        "Tab" => '\u{e004}',
        "Enter" => '\u{e007}',
        "Shift" => '\u{e008}',
        "Control" => '\u{e009}',
        "Alt" => '\u{e00a}',
        "Escape" => '\u{e00c}',
        "PageUp" => '\u{e00e}',
        "PageDown" => '\u{e00f}',
        "End" => '\u{e010}',
        "Home" => '\u{e011}',
        "ArrowLeft" => '\u{e012}',
        "ArrowUp" => '\u{e013}',
        "ArrowRight" => '\u{e014}',
        "ArrowDown" => '\u{e015}',
        "Delete" => '\u{e017}',
        _ => {
            let mut letters = name.chars();
            match (letters.next(), letters.next()) {
                (Some(letter), None) => letter,
                _ => bail!("there's no key “{name}”"),
            }
        }
    };
    Ok(code.to_string())
}
