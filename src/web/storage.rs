//! What the browser keeps for the user: the maze, the settings, the theme. Storage may be full or forbidden;
//! then the page works on and says so.

use crate::explorer::name::Name;
use crate::maze::Scale;
use crate::settings::{Pace, Rule, Search, Settings};

const MAZE: &str = "line-maze-lab/maze";
const SETTINGS: &str = "line-maze-lab/settings";
const EXPLORER: &str = "line-maze-lab/explorer";
const THEME: &str = "line-maze-lab/theme";
const LETTERS: &str = "line-maze-lab/letters";
const NOTE: &str = "line-maze-lab/note";
/// Mazes that could not be read, each beside a number.
const ASIDE: &str = "line-maze-lab/aside";
/// So many are put aside.
const MOST_ASIDE: usize = 9;

/// The browser does not keep anything: forbidden, or full.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotKept;

fn storage() -> Result<web_sys::Storage, NotKept> {
    let window = web_sys::window().ok_or(NotKept)?;
    window.local_storage().ok().flatten().ok_or(NotKept)
}

fn get(key: &str) -> Option<String> {
    storage().ok()?.get_item(key).ok()?
}

fn set(key: &str, value: &str) -> Result<(), NotKept> {
    storage()?.set_item(key, value).map_err(|_| NotKept)
}

fn remove(key: &str) {
    if let Ok(storage) = storage() {
        let _ = storage.remove_item(key);
    }
}

/// Whether the browser gives this page no storage at all.
#[must_use]
pub fn is_forbidden() -> bool {
    storage().is_err()
}

/// The user's own last maze, as it was kept.
#[must_use]
pub fn maze() -> Option<String> {
    get(MAZE)
}

/// Keeps the maze.
///
/// # Errors
/// Where storage is full or forbidden.
pub fn keep_maze(text: &str) -> Result<(), NotKept> {
    set(MAZE, text)
}

fn places_aside() -> impl Iterator<Item = String> {
    (1..=MOST_ASIDE).map(|nth| format!("{ASIDE}-{nth}"))
}

/// Keeps a text that can't be read beside the maze, until somebody has seen it.
///
/// # Errors
/// Where there is no room for it.
pub fn put_aside(text: &str) -> Result<(), NotKept> {
    let free = |place: &String| get(place).is_none_or(|other| other == text);
    let place = places_aside().find(free).ok_or(NotKept)?;
    set(&place, text)
}

/// The first text that was put aside.
#[must_use]
pub fn aside() -> Option<String> {
    places_aside().find_map(|place| get(&place))
}

/// Throws a text away that was put aside.
pub fn drop_aside(text: &str) {
    places_aside().filter(|place| get(place).as_deref() == Some(text)).for_each(|place| remove(&place));
}

/// The user's last settings; what cannot be read is as at first.
#[must_use]
pub fn settings() -> Settings {
    let mut settings = Settings::default();
    for line in get(SETTINGS).unwrap_or_default().lines() {
        match line.split_once('=') {
            Some(("order", order)) => settings.order = order.parse().unwrap_or(settings.order),
            Some(("epsilon", ms)) => settings.epsilon_ms = ms.parse().ok(),
            Some(("node_max", nodes)) => settings.node_max = nodes.parse().unwrap_or(settings.node_max),
            Some(("rule", "basic")) => settings.rule = Rule::Basic,
            Some(("path_max", squares)) => settings.path_max = squares.parse().ok(),
            Some(("search", "a-star")) => settings.search = Search::AStar,
            Some(("pace", numbers)) => settings.pace = pace(numbers).unwrap_or(settings.pace),
            _ => {}
        }
    }
    settings
}

/// A pace as four numbers by their bits: nothing is lost, and little is needed to read them.
fn pace(numbers: &str) -> Option<Pace> {
    let mut numbers = numbers.split(' ').map(|bits| bits.parse().ok().map(f64::from_bits));
    let mut next = || numbers.next().flatten();
    let pace = Pace { speed_mm_s: next()?, turn_s: next()?, uturn_s: next()?, stop_s: next()? };
    pace.checked(Scale::default()).ok()
}

/// Who drove last; the book's explorer where nothing is kept.
#[must_use]
pub fn explorer() -> Name {
    let place: Option<usize> = get(EXPLORER).and_then(|place| place.parse().ok());
    place.and_then(|place| Name::ALL.get(place).copied()).unwrap_or_default()
}

/// Keeps the settings and the explorer, by its place in [`Name::ALL`], if the browser lets us; they are
/// quickly set again.
pub fn keep_settings(settings: &Settings, explorer: Name) {
    let maybe = |number: Option<u32>| number.map_or(String::new(), |number| number.to_string());
    let mut text = format!(
        "order={}\nepsilon={}\nnode_max={}\npath_max={}",
        settings.order,
        maybe(settings.epsilon_ms),
        settings.node_max,
        maybe(settings.path_max)
    );
    if settings.rule == Rule::Basic {
        text.push_str("\nrule=basic");
    }
    if settings.search == Search::AStar {
        text.push_str("\nsearch=a-star");
    }
    if settings.pace != Pace::default() {
        let Pace { speed_mm_s, turn_s, uturn_s, stop_s } = settings.pace;
        let numbers = [speed_mm_s, turn_s, uturn_s, stop_s].map(|number| number.to_bits().to_string());
        text.push_str(&format!("\npace={}", numbers.join(" ")));
    }
    let _ = set(SETTINGS, &text);
    let place = Name::ALL.iter().position(|&name| name == explorer).unwrap_or(0);
    let _ = set(EXPLORER, &place.to_string());
}

/// Light, dark, or as the system has it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// As the system has it.
    #[default]
    System,
    /// Light.
    Light,
    /// Dark.
    Dark,
}

/// The theme that was chosen.
#[must_use]
pub fn theme() -> Theme {
    match get(THEME).as_deref() {
        Some("light") => Theme::Light,
        Some("dark") => Theme::Dark,
        _ => Theme::System,
    }
}

/// Keeps the theme, if the browser lets us.
pub fn keep_theme(theme: Theme) {
    let _ = match theme {
        Theme::Light => set(THEME, "light"),
        Theme::Dark => set(THEME, "dark"),
        Theme::System => {
            remove(THEME);
            Ok(())
        }
    };
}

/// Whether letters, digits and marks are keys of the page.
#[must_use]
pub fn letters() -> bool {
    get(LETTERS).as_deref() != Some("off")
}

/// Keeps that, if the browser lets us.
pub fn keep_letters(on: bool) {
    if on {
        remove(LETTERS)
    } else {
        let _ = set(LETTERS, "off");
    }
}

/// Whether the maze's note was folded or unfolded last; none where nobody has done either.
#[must_use]
pub fn note_open() -> Option<bool> {
    get(NOTE).map(|how| how == "open")
}

/// Keeps that, if the browser lets us.
pub fn keep_note_open(open: bool) {
    let _ = set(NOTE, if open { "open" } else { "folded" });
}
