//! The league: chosen explorers over samples, generated mazes and files, worked out in a worker.

use crate::web::erase::{event, mouse, part, sig};
use leptos::prelude::*;
use wasm_bindgen::JsCast;

use super::desk::{Page, desk};
use super::lineup::{Choices, sig_in};
use super::office::{self, Office};
use super::{Tabs, files, open_in_stepper};
use crate::compare::league::desk::{Ask, Made, Plan, Sheet, Shown, Tell, Terms, View};
use crate::compare::score::Column;
use crate::explorer::name::Name;
use crate::maze::text;
use crate::web::browser;
use crate::web::dialogs::settings::NumberField;
use crate::web::state::{Lab, ToastTone};

mod runs;

use runs::Runs;

/// The league's state on the page.
#[derive(Clone, Copy)]
pub struct LeagueDesk {
    lab: Lab,
    /// Who runs.
    pub chosen: RwSignal<Vec<Name>>,
    /// Whether the samples are courses.
    pub samples: RwSignal<bool>,
    /// Whether mazes are generated.
    pub generate: RwSignal<bool>,
    /// Which.
    pub made: RwSignal<Made>,
    /// Files: names, and bytes in base64.
    pub files: RwSignal<Vec<(String, String)>>,
    /// Files that are being read: how many of how many.
    pub reading: RwSignal<Option<(usize, usize)>>,
    /// Files that could not be read, and why.
    pub unread: RwSignal<Vec<(String, String)>>,
    refused: RwSignal<Vec<(String, String)>>,
    progress: RwSignal<Option<(usize, usize)>>,
    busy: RwSignal<bool>,
    /// The results.
    pub shown: RwSignal<Option<Shown>>,
    /// Which runs are listed, and how.
    pub view: RwSignal<View>,
    /// Who works it out.
    pub office: StoredValue<Option<Office>, LocalStorage>,
}

impl LeagueDesk {
    /// Nothing chosen but a small league of samples.
    pub fn new(lab: Lab) -> Self {
        let chosen = vec![Name::Book, Name::LeftHand, Name::Mapping, Name::Tremaux, Name::FloodFill];
        Self {
            lab,
            chosen: RwSignal::new(chosen),
            samples: RwSignal::new(true),
            generate: RwSignal::new(true),
            made: RwSignal::new(Made { count: 100, side: 16, loops_percent: 10, seed: 1 }),
            files: RwSignal::new(Vec::new()),
            reading: RwSignal::new(None),
            unread: RwSignal::new(Vec::new()),
            refused: RwSignal::new(Vec::new()),
            progress: RwSignal::new(None),
            busy: RwSignal::new(false),
            shown: RwSignal::new(None),
            view: RwSignal::new(View::default()),
            office: StoredValue::new_local(None),
        }
    }

    fn courses(self) -> u32 {
        let samples = if self.samples.get() { crate::maze::samples::SAMPLES.len() as u32 } else { 0 };
        let made = if self.generate.get() { self.made.get().count } else { 0 };
        samples + made + self.files.with(Vec::len) as u32
    }

    /// From the beginning.
    pub fn begin(self) {
        let made = self.generate.get_untracked().then(|| self.made.get_untracked());
        if let Some(Err(why)) = made.map(Made::checked) {
            let unmade = move || self.generate.get() && self.made.get().checked().is_err();
            return self.lab.say_while(ToastTone::Error, "No such mazes", why.to_string(), unmade);
        }
        if self.chosen.with_untracked(Vec::is_empty) || untrack(|| self.courses()) == 0 {
            let empty = move || self.chosen.with(Vec::is_empty) || self.courses() == 0;
            let cure = "Choose an explorer and some mazes first.";
            return self.lab.say_while(ToastTone::Error, "An empty league", cure, empty);
        }
        self.refused.set(Vec::new());
        self.shown.set(None);
        self.progress.set(Some((0, untrack(|| self.courses()) as usize)));
        self.busy.set(true);
        self.view.update(|view| view.more = 0);
        office::ask(self, Ask::Show(self.view.get_untracked()));
        let plan = Plan {
            explorers: self.chosen.with_untracked(|names| names.iter().map(ToString::to_string).collect()),
            terms: self.lab.settings.with_untracked(Terms::of),
            samples: self.samples.get_untracked(),
            generated: made,
            files: self.files.get_untracked(),
        };
        office::ask(self, Ask::Begin(plan));
    }

    /// Hears what the worker tells.
    pub fn hear(self, tell: Tell) {
        match tell {
            Tell::Ready => {}
            Tell::Progress { done, of } => {
                self.progress.set(Some((done, of)));
                if done >= of {
                    self.busy.set(false);
                }
            }
            Tell::Refused(files) => self.refused.set(files),
            Tell::Shown(shown) => {
                if shown.runs > 0 || !self.busy.get_untracked() {
                    self.shown.set(Some(shown));
                }
            }
            Tell::Csv { name, text } => browser::download(&name, "text/csv", &text),
            Tell::Maze { text, explorer } => {
                if let (Ok(maze), Ok(name)) = (text::parse(&text), explorer.parse()) {
                    self.lab.open(maze);
                    open_in_stepper(self.lab, name, 0);
                }
            }
        }
    }

    /// The runs in another order.
    pub fn look(self, change: impl FnOnce(&mut View)) {
        self.view.update(change);
        office::ask(self, Ask::Show(self.view.get_untracked()));
    }
}

/// The league beside the comparison: its box plot, or the way to it.
#[component]
pub fn Card() -> impl IntoView {
    let desk = desk();
    let league = desk.league;
    let open = move || {
        view! { <button class="btn" on:click=mouse(move |_| desk.turn_to(Page::League))>"Open the league"</button> }
    };
    let title = move || match league.progress.get() {
        Some((_, of)) => format!("League, {of} mazes"),
        None => "League".to_owned(),
    };
    view! {
        <section class="card league" aria-labelledby="league-card-title">
            <h2 id="league-card-title">{part(title)}</h2>
            {part(move || match league.shown.get() {
                Some(shown) if !shown.boxes.is_empty() => view! {
                    <div class="pad stack"><Boxes markup=shown.boxes /><div class="row">{open()}</div></div>
                }.into_any(),
                _ => view! {
                    <div class="blank">
                        <p>"One maze proves little. Let explorers run over hundreds: samples, generated mazes, your own files."</p>
                        {open()}
                    </div>
                }.into_any(),
            })}
        </section>
    }
}

/// Box plots of route by shortest.
#[component]
fn Boxes(markup: String) -> impl IntoView {
    let part = markup.contains(" part\"");
    view! {
        <p class="small">"Route ÷ shortest. Box: the middle half; mark: the median."</p>
        <div role="img" aria-label="Box plots of route by shortest route; the table has the numbers" inner_html=markup></div>
        {part.then(|| view! { <p class="small"><i class="key-part"></i>"did not solve every maze; its box counts those that it solved."</p> })}
    }
}

/// The league's own page.
#[component]
pub fn Room() -> impl IntoView {
    let league = desk().league;
    view! {
        <section class="card league-form" aria-label="What the league runs">
            <h2 class="bare"><Tabs /></h2>
            <div class="pad stack">
                <Courses />
                <details class="who-runs">
                    <summary class="btn">{part(move || format!("{} of {} explorers", league.chosen.with(Vec::len), Name::ALL.len()))}</summary>
                    <Choices is_in=sig_in(move |name| league.chosen.with(|names| names.contains(&name))) locked=sig_in(|_| false)
                        change={move |name, there| league.chosen.update(|names| {
                            names.retain(|&other| other != name);
                            if there {
                                names.push(name);
                                names.sort();
                            }
                        })} />
                </details>
            </div>
            <div class="league-go"><Go /></div>
        </section>
        <div class="league-results">
            <Refused />
            {part(move || match league.shown.get() {
                Some(shown) if shown.runs > 0 || !league.view.with(|view| view.explorer.is_empty()) => view! { <Standings shown=shown.clone() /><Runs shown=shown /> }.into_any(),
                _ => view! {
                    <section class="card"><div class="blank">
                        <p><b>"No results yet"</b></p>
                        <p class="small">"Choose mazes and explorers and run the league. Or drop a folder of maze files anywhere on the page."</p>
                    </div></section>
                }.into_any(),
            })}
        </div>
    }
}

#[component]
fn Courses() -> impl IntoView {
    let league = desk().league;
    let made = move |of: fn(Made) -> u64| Signal::derive(move || of(league.made.get()).to_string());
    let choose = move |event: web_sys::Event| {
        let input = event.target().and_then(|target| target.dyn_into::<web_sys::HtmlInputElement>().ok());
        files::chosen(league, input.and_then(|input| input.files()));
    };
    let told = move || match (league.reading.get(), league.files.with(Vec::len)) {
        (Some((done, of)), _) => format!("Reading {done} of {of} files…"),
        (None, 0) => "No files; a dropped folder comes here.".to_owned(),
        (None, 1) => "1 file.".to_owned(),
        (None, count) => format!("{count} files."),
    };
    view! {
        <label class="switch"><input type="checkbox" id="league-samples" prop:checked=sig(move || league.samples.get()) on:change=event(move |event| league.samples.set(event_target_checked(&event))) />
            {format!("The {} samples", crate::maze::samples::SAMPLES.len())}</label>
        <label class="switch"><input type="checkbox" id="league-generate" prop:checked=sig(move || league.generate.get()) on:change=event(move |event| league.generate.set(event_target_checked(&event))) />
            "Generated mazes"</label>
        {part(move || league.generate.get().then(|| view! {
            <div class="pair">
                <NumberField id="league-count" label="How many" value=made(|made| made.count.into()) hint="1 to 5,000"
                    read={|text: &str| text.parse().ok().filter(|n| (1..=Made::MOST).contains(n))} set={move |count| league.made.update(|made| made.count = count)} />
                <NumberField id="league-side" label="Points a side" value=made(|made| made.side.into()) hint="2 to 200"
                    read={|text: &str| text.parse().ok().filter(|n| (2..=200).contains(n))} set={move |side| league.made.update(|made| made.side = side)} />
                <NumberField id="league-loops" label="Loops, %" value=made(|made| made.loops_percent.into()) hint="0 to 100"
                    read={|text: &str| text.parse().ok().filter(|n| *n <= 100)} set={move |loops| league.made.update(|made| made.loops_percent = loops)} />
                <NumberField id="league-seed" label="First seed" value=made(|made| made.seed) hint="A whole number, 0 or more"
                    read={|text: &str| text.parse().ok()} set={move |seed| league.made.update(|made| made.seed = seed)} />
            </div>
        }))}
        <div class="row">
            <label class="btn file">"Files…"<input class="vh" type="file" id="league-files" multiple accept=".maze,.json,.txt,.map,.num,.maz" on:change=event(choose) /></label>
            <label class="btn file">"Folder…"<input class="vh" type="file" id="league-folder" prop:webkitdirectory=true multiple on:change=event(choose) /></label>
            {part(move || (league.files.with(Vec::len) > 0).then(|| view! { <button class="btn quiet" on:click=mouse(move |_| league.files.set(Vec::new()))>"No files"</button> }))}
        </div>
        <p class="small" role="status">{part(told)}</p>
    }
}

/// Begin, progress, stop.
#[component]
fn Go() -> impl IntoView {
    let league = desk().league;
    let stop = move |_| {
        league.busy.set(false);
        office::ask(league, Ask::Stop);
    };
    let told = move || match (league.progress.get(), league.busy.get()) {
        (None, _) => String::new(),
        (Some((0, of)), true) => format!("Getting ready for {of} mazes…"),
        (Some((done, of)), true) => format!("{done} of {of} mazes"),
        (Some((done, of)), false) if done < of => format!("Cancelled after {done} of {of} mazes."),
        (Some((_, of)), false) => format!("All {of} mazes are run."),
    };
    view! {
        {part(move || if league.busy.get() {
            view! { <button class="btn" id="league-stop" on:click=mouse(stop)>"Cancel"</button> }.into_any()
        } else {
            view! { <button class="btn primary" id="league-run" on:click=mouse(move |_| league.begin())>{part(move || format!("Run over {} mazes", league.courses()))}</button> }.into_any()
        })}
        {part(move || league.progress.get().map(|(done, of)| view! {
            <progress max=of.max(1).to_string() value=done.to_string() aria-label="Mazes that are run"></progress>
        }))}
        <p class="small" id="league-status" role="status">{part(told)}</p>
    }
}

/// Files that are no mazes: each with place and cure.
#[component]
fn Refused() -> impl IntoView {
    let league = desk().league;
    let all = move || [league.unread.get(), league.refused.get()].concat();
    part(move || {
        let all = all();
        (!all.is_empty()).then(|| {
            let title = if all.len() == 1 { "1 file can’t be read".to_owned() } else { format!("{} files can’t be read", all.len()) };
            let few = all.len() < 6;
            let file = |(name, why): (String, String)| view! { <li><b>{name}</b><br /><span class="small">{why}</span></li> };
            view! {
                <details class="note bad refused" role="alert" open=few>
                    <summary><b>{title}</b></summary>
                    <ul class="stack scroll" tabindex="0">{all.into_iter().map(file).collect_view()}</ul>
                </details>
            }
        })
    })
}

#[component]
fn Standings(shown: Shown) -> impl IntoView {
    let league = desk().league;
    view! {
        <section class="card standings" aria-labelledby="standings-title">
            <h2 id="standings-title">"Standings: median, and the middle half"<span class="spacer"></span>
                <button class="btn" aria-label="Save the standings as CSV" on:click=mouse(move |_| office::ask(league, Ask::Csv(Sheet::Standings)))>"CSV"</button></h2>
            <div class="standings-body">
                <div class="scroll" tabindex="0" role="region" aria-labelledby="standings-title"><table>
                    <thead><tr>
                        <th scope="col">"Explorer"</th><th scope="col" class="num">"Runs"</th><th scope="col" class="num">"Solved"</th>
                        <th scope="col" class="num">"÷ shortest"</th><th scope="col" class="num">"÷ fastest"</th>
                        <th scope="col" class="num">{format!("Explored, {}", Column::Distance.title())}</th><th scope="col" class="num">"Bytes"</th>
                    </tr></thead>
                    <tbody inner_html=shown.standings></tbody>
                </table></div>
                {(!shown.boxes.is_empty()).then(|| view! { <div class="stack"><Boxes markup=shown.boxes /></div> })}
            </div>
        </section>
    }
}
