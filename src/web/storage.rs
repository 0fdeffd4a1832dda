//! What the browser keeps for the user: the maze, the settings, the theme. Storage may be full or forbidden;
//! then the page works on and says so.

use crate::maze::{Maze, Scale, text};
use crate::settings::{Pace, Settings};

const MAZE: &str = "line-maze-lab/maze";
const SETTINGS: &str = "line-maze-lab/settings";
const THEME: &str = "line-maze-lab/theme";

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

/// The user's own last maze.
#[must_use]
pub fn maze() -> Option<Maze> {
    text::parse(&get(MAZE)?).ok()
}

/// Keeps the maze.
///
/// # Errors
/// Where storage is full or forbidden.
pub fn keep_maze(maze: &Maze) -> Result<(), NotKept> {
    set(MAZE, &text::write(maze))
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
            Some(("pace", pace)) => settings.pace = pace_of(pace).unwrap_or(settings.pace),
            _ => {}
        }
    }
    settings
}

/// Speed, turn, U-turn and stop, in one line.
fn pace_of(text: &str) -> Option<Pace> {
    let mut numbers = text.split(' ').map(str::parse);
    let mut next = || numbers.next()?.ok();
    let pace = Pace { speed_mm_s: next()?, turn_s: next()?, uturn_s: next()?, stop_s: next()? };
    pace.checked(Scale::default()).ok()
}

/// Keeps the settings, if the browser lets us; they are quickly set again.
pub fn keep_settings(settings: &Settings) {
    let epsilon = settings.epsilon_ms.map_or(String::new(), |ms| ms.to_string());
    let Pace { speed_mm_s, turn_s, uturn_s, stop_s } = settings.pace;
    let pace = format!("{speed_mm_s} {turn_s} {uturn_s} {stop_s}");
    let text =
        format!("order={}\nepsilon={epsilon}\nnode_max={}\npace={pace}", settings.order, settings.node_max);
    let _ = set(SETTINGS, &text);
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
        Theme::System => storage().and_then(|storage| storage.remove_item(THEME).map_err(|_| NotKept)),
    };
}
