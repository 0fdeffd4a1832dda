//! What the strokes and marks on the floor mean, each drawn as it is there.

use leptos::prelude::*;

use crate::explorer::name::{Name, Stops};
use crate::maze::Kind;
use crate::web::maze_view::bot_shape;
use crate::web::state::Lab;

/// A sign and its meaning.
struct Sign {
    drawn: AnyView,
    name: &'static str,
    meaning: &'static str,
}

/// The signs of an explorer's stage.
pub fn signs(lab: Lab, explorer: Name) -> impl IntoView {
    let walls = untrack(|| lab.stage.with(|maze| maze.kind == Kind::Wall));
    let mut signs = common(walls);
    if explorer == Name::Book {
        signs.extend(of_the_book());
    } else {
        signs.extend(of_the_others(explorer));
    }
    let row = |sign: Sign| {
        view! {
            <div>
                <dt><svg class="maze sign" class:walls=walls viewBox="0 0 80 44" aria-hidden="true">{sign.drawn}</svg>{sign.name}</dt>
                <dd>{sign.meaning}</dd>
            </div>
        }
    };
    view! {
        <h3 id="floor">"On the floor"</h3>
        <dl class="entries floor">{signs.into_iter().map(row).collect_view()}</dl>
    }
}

/// A stroke over the line.
fn stroke(class: &'static str) -> AnyView {
    view! { <path class="tape" d="M10 22h60" /><path class=class d="M10 22h60" /> }.into_any()
}

fn common(walls: bool) -> Vec<Sign> {
    let (name, meaning) = if walls {
        ("wall", "What the robot cannot pass.")
    } else {
        ("line", "The tape that the robot follows.")
    };
    vec![
        Sign { drawn: view! { <path class="tape" d="M10 22h60" /> }.into_any(), name, meaning },
        Sign {
            drawn: view! { <g class="bot" transform="translate(40 26)">{bot_shape()}</g> }.into_any(),
            name: "robot",
            meaning: "At a stop it faces where it goes on to; line by line, as far as the lines so far have turned it. The compass shows its own north, 0.",
        },
        Sign {
            drawn: view! { <rect class="finish" x="22" y="8" width="36" height="28" rx="3" /> }.into_any(),
            name: "finish",
            meaning: "The black patch. In the robot’s eye it is there once the robot has been on it.",
        },
    ]
}

fn of_the_book() -> Vec<Sign> {
    let node = |class: &'static str| {
        view! { <path class="tape" d="M10 22h60" /><g class=class transform="translate(40 22)"><circle class="disc" r="17" /><text y="6">"3"</text></g> }
            .into_any()
    };
    vec![
        Sign { drawn: stroke("remembered"), name: "remembered", meaning: "On the way of the remembered nodes, or driven just now." },
        Sign {
            drawn: stroke("given-up"),
            name: "given up",
            meaning: "Driven on from the newest node, and not the way to the finish: the bot is on its way back over it and crosses it out as it drives.",
        },
        Sign {
            drawn: view! {
                <path class="tape" d="M10 22h60" />
                <path class="cross-halo" d="M19 15l12 14m0-14l-12 14M47 15l12 14m0-14l-12 14" />
                <path class="cross-mark" d="M19 15l12 14m0-14l-12 14M47 15l12 14m0-14l-12 14" />
            }
            .into_any(),
            name: "crossed out",
            meaning: "Driven over with returning true, or part of a loop that was forgotten: never driven again.",
        },
        Sign { drawn: node("node"), name: "node", meaning: "A remembered node, with its place in the table." },
        Sign { drawn: node("node here"), name: "node here", meaning: "The node where the bot stands." },
        Sign {
            drawn: view! {
                <path class="tape" d="M10 22h60" />
                <path class="open-way-halo" d="M34 13L43 22L34 31M48 13L57 22L48 31" />
                <path class="open-way" d="M34 13L43 22L34 31M48 13L57 22L48 31" />
            }
            .into_any(),
            name: "unvisited",
            meaning: "At RETURN-UNKNOWN: an unvisited way that the sentence lists.",
        },
        Sign {
            drawn: view! { <g class="differs" transform="translate(40 22) scale(.55)"><circle r="34" /><circle class="plate" cx="-34" cy="-26" r="15" /><path d="M-40-29h12M-40-23h12M-31-34l-6 16" /></g> }.into_any(),
            name: "differs",
            meaning: "Where a robot and the page decided differently for the first time.",
        },
    ]
}

fn of_the_others(explorer: Name) -> Vec<Sign> {
    let mut signs = vec![
        Sign { drawn: stroke("remembered"), name: "driven once", meaning: "The robot has driven here once." },
        Sign {
            drawn: stroke("given-up"),
            name: "driven again",
            meaning: "The robot has driven here more than once.",
        },
    ];
    if matches!(explorer, Name::ParexLeft | Name::ParexRight) {
        signs.push(Sign {
            drawn: stroke("route"),
            name: "path",
            meaning: "The squares of Path(1) to Path(CSIP).",
        });
    }
    if explorer == Name::Tremaux {
        signs.push(Sign {
            drawn: view! { <path class="tape" d="M10 22h60" /><path class="chalk-halo" d="M36 11v22M44 11v22" /><path class="chalk" d="M36 11v22M44 11v22" /> }.into_any(),
            name: "marks",
            meaning: "How often the way was used at this node.",
        });
    }
    if matches!(explorer, Name::Mapping | Name::Tremaux | Name::DepthFirst) {
        signs.push(Sign {
            drawn: view! { <path class="tape" d="M10 22h60" /><g class="node" transform="translate(40 22)"><circle class="disc" r="17" /><text y="6">"3"</text></g> }.into_any(),
            name: "number",
            meaning: "A place that the robot has numbered, where its coordinates say that it is.",
        });
    }
    if explorer.about().stops == Stops::Square {
        signs.push(Sign {
            drawn: view! { <text class="label" x="40" y="27" text-anchor="middle">"7"</text> }.into_any(),
            name: "small numbers",
            meaning: match explorer {
                Name::FloodFill => {
                    "Squares to the goal, as far as the robot knows; seen when the picture is large enough."
                }
                _ => "What the robot calls a square that it was on; seen when the picture is large enough.",
            },
        });
    }
    signs
}
