//! A thousand runs of the book's explorer with random orders: how much luck there is.

use std::time::Duration;

use crate::web::erase::{mouse, part};
use leptos::prelude::*;

use super::desk::desk;
use super::open_in_stepper;
use crate::compare::orders::{Draw, Draws, draw};
use crate::compare::plot::{Marked, draws_words, histogram, histogram_words};
use crate::explorer::name::Name;
use crate::grouped::Grouped;
use crate::settings::{Order, Settings};
use crate::web::browser;
use crate::web::run_view::Same;
use crate::web::state::Lab;

/// So many orders are drawn.
const COUNT: u64 = 1000;
/// Bars of the histogram.
const BARS: u32 = 13;
/// In larger mazes they are drawn only when asked for.
const AT_ONCE_CELLS: usize = 400;
/// Work for at most so long before the page may do something else.
const SLICE_S: f64 = 0.012;

/// The draws and how far they are.
#[derive(Clone, Copy)]
pub struct OrdersDesk {
    lab: Lab,
    draws: RwSignal<Option<Same<Draws>>>,
    drawn: RwSignal<Option<u64>>,
    /// Grows with each beginning: what an earlier one still does is of no use.
    round: StoredValue<u32>,
}

impl OrdersDesk {
    /// None drawn yet.
    pub fn new(lab: Lab) -> Self {
        Self { lab, draws: RwSignal::new(None), drawn: RwSignal::new(None), round: StoredValue::new(0) }
    }

    fn reset(self) {
        self.round.update_value(|round| *round += 1);
        self.draws.set(None);
        self.drawn.set(None);
    }

    fn begin(self) {
        self.reset();
        self.drawn.set(Some(0));
        let round = self.round.get_value();
        self.slice(round, Vec::new(), self.lab.settings.get_untracked());
    }

    fn slice(self, round: u32, mut all: Vec<Draw>, settings: Settings) {
        let work = move || {
            if self.round.try_get_value() != Some(round) {
                return;
            }
            let (maze, begin) = (self.lab.maze.get_untracked(), browser::now_s());
            while all.len() < COUNT as usize && browser::now_s() - begin < SLICE_S {
                match draw(&maze, &settings, all.len() as u64 + 1) {
                    Ok(one) => all.push(one),
                    Err(_) => return self.drawn.set(None),
                }
            }
            if all.len() < COUNT as usize {
                self.drawn.set(Some(all.len() as u64));
                return self.slice(round, all, settings);
            }
            self.drawn.set(None);
            self.draws.set(Some(Same::new(all.into_iter().collect())));
        };
        set_timeout(work, Duration::ZERO);
    }
}

/// The card.
#[component]
pub fn Orders() -> impl IntoView {
    let desk = desk();
    let (lab, orders) = (desk.lab, desk.orders);
    Effect::new(move |_| {
        let maze = lab.maze.get();
        lab.settings.track();
        match maze.cells() <= AT_ONCE_CELLS && lab.own.with(Result::is_ok) {
            true => orders.begin(),
            false => orders.reset(),
        }
    });
    on_cleanup(move || orders.round.update_value(|round| *round += 1));
    view! {
        <section class="card orders" aria-labelledby="orders-title">
            <h2 id="orders-title">{format!("{} random orders, the book’s explorer", Grouped(COUNT as usize))}</h2>
            {part(move || match (orders.draws.get(), orders.drawn.get()) {
                (Some(draws), _) => view! { <Drawn draws=draws /> }.into_any(),
                (None, Some(drawn)) => view! {
                    <div class="blank" role="status"><p>"Drawing orders…"</p>
                        <progress max=COUNT.to_string() value=drawn.to_string() aria-label="Orders drawn"></progress></div>
                }.into_any(),
                (None, None) if lab.own.with(Result::is_err) => view! {
                    <div class="blank"><p>{lab.own.with(|run| run.as_ref().err().map(ToString::to_string))}</p></div>
                }.into_any(),
                (None, None) => view! {
                    <div class="blank">
                        <p>"How long is the route when every choice is left to chance, as the book’s §3.1 advises?"</p>
                        <button class="btn" on:click=mouse(move |_| orders.begin())>{format!("Draw {} orders", Grouped(COUNT as usize))}</button>
                    </div>
                }.into_any(),
            })}
        </section>
    }
}

#[component]
fn Drawn(draws: Same<Draws>) -> impl IntoView {
    let desk = desk();
    let lab = desk.lab;
    let shortest = desk.field.with_untracked(|field| field.bests.shortest.map(|best| best.cells));
    let own = lab.run.with_untracked(|run| run.as_ref().ok().and_then(|run| run.route_cells()));
    let bars = draws.bars(shortest, BARS);
    let open = move |draw: Draw| {
        lab.set(|settings| settings.order = Order::Random(draw.seed));
        open_in_stepper(lab, Name::Book, 0);
    };
    let button = move |which: &'static str, draw: Option<Draw>| {
        draw.map(|draw| {
            let cells = draw.route_cells.unwrap_or(0);
            view! {
                <button class="btn" title=format!("Seed {}", draw.seed) on:click=mouse(move |_| open(draw))>
                    {format!("Open the {which}, {cells}")}
                </button>
            }
        })
    };
    let order = lab.settings.with_untracked(|settings| settings.order.to_string());
    view! {
        <figure class="pad">
            <div role="img" aria-label=histogram_words(&bars) inner_html=histogram(&bars, Marked { shortest, own })></div>
            <div class="plot-keys small">
                {shortest.map(|cells| view! { <span><i class="best"></i>{format!("shortest, {cells} cells")}</span> })}
                {own.filter(|_| own != shortest).map(|_| view! { <span><i class="own"></i>{format!("where {order} lands")}</span> })}
            </div>
            <figcaption>{format!("Route in cells. {}", draws_words(&draws, shortest))}</figcaption>
            <div class="row">
                {button("best", draws.best())}
                {button("worst", draws.worst())}
                            </div>
        </figure>
    }
    .into_any()
}
