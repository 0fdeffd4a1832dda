//! The notes, in the order of the book; what is about the whole of it comes last.

use super::Kind::{Open, Slip};
use super::Place::{Figure24, Figure31, Overflow};
use super::{Case, Erratum, Kind, Line, Place};

/// A note without code.
const fn note(kind: Kind, section: &'static str, title: &'static str, places: &'static [Place]) -> Erratum {
    Erratum { section, title, text: "", printed: None, meant: None, kind, places }
}

impl Erratum {
    const fn says(self, text: &'static str) -> Self {
        Self { text, ..self }
    }

    const fn code(self, printed: &'static str, meant: &'static str) -> Self {
        Self { printed: Some(printed), meant: Some(meant), ..self }
    }
}

/// All of them.
pub static ERRATA: &[Erratum] = NOTES;

/// Where each of them applies: what has to be known to tell that there is a note, without the notes.
pub(super) static PLACES: [&[Place]; NOTES.len()] = {
    let mut places: [&[Place]; NOTES.len()] = [&[]; NOTES.len()];
    let mut i = 0;
    while i < NOTES.len() {
        places[i] = NOTES[i].places;
        i += 1;
    }
    places
};

const NOTES: &[Erratum] = &[
    note(Open, "§2.3", "Turning is not driving", &[Place::Line(Line::GET)]).says(
        "prev_time has to be taken again when the bot drives off after a turn. \
         Otherwise the time of the turn counts as distance, and every coordinate behind it is wrong.",
    ),
    note(Slip, "§2.3", "An Uno's int is too short", &[Overflow, Place::Line(Line::GET)])
        .says(
            "An Uno's int ends at 32767, so a coordinate overflows after 32.767 seconds of driving along one axis. \
             The lab counts with 32 bits.",
        )
        .code("int cur_x", "long cur_x"),
    note(
        Slip,
        "§2.4.2",
        "Room for 49, not 50",
        &[Place::Case(Case::TableFull), Place::Line(Line::RECORD)],
    )
    .says(
        "The array has 50 places, but its nodes are numbered from 1, so place 0 is never used and it holds 49. \
         The lab's table holds as many as NODE_MAX says.",
    )
    .code("nodes[50]", "nodes[NODE_MAX + 1]"),
    note(
        Slip,
        "§2.4.3",
        "returning is asked, not set",
        &[Figure31 { stop: 10 }, Place::Line(Line::IF_RETURNING)],
    )
    .says(
        "The book says that returning is set in the two cases. It is the other way round: the bot only looks at \
         returning, as it stands on arrival, to tell RETURN-KNOWN from RETURN-UNKNOWN.",
    )
    .code("set returning = true", "if returning"),
    note(Slip, "§2.6, node 1", "The wrong array", &[Figure24 { stop: 1 }])
        .says("The path that the bot leaves by exists already; what has to be marked is that it is visited.")
        .code("node1.paths[1] = true", "nodes[1].vpaths[1] = true"),
    note(Slip, "§2.6, node 2", "Node 1 is set twice", &[Figure24 { stop: 2 }])
        .says("Below “node 2” the snippet sets node 1's paths, back path and visited path again. They are node 2's.")
        .code("node1.paths[2]", "nodes[2].paths[2]"),
    note(Slip, "§2.6, node 2", "The wrong array, again", &[Figure24 { stop: 2 }])
        .says("As at node 1: the path that the bot leaves by is to be marked as visited, not as existing.")
        .code("node2.paths[1] = true", "nodes[2].vpaths[1] = true"),
    note(Slip, "§2.6", "A U-turn that is not needed", &[Figure24 { stop: 6 }]).says(
        "The book turns round at node 2 and drives the whole loop again. By §3.1 nothing is unvisited there, \
         so the bot forgets the loop and takes the back path at once.",
    ),
    note(
        Open,
        "§2.6",
        "The path of arrival is visited",
        &[Figure31 { stop: 13 }, Place::Line(Line::MARK_ARRIVAL)],
    )
    .says(
        "The book never marks the path by which a RETURN-UNKNOWN arrives, yet §2.6 counts on it. \
         The lab marks it before the check; otherwise a forgotten node would be recorded a second time.",
    ),
    note(Slip, "§3.1, node 1", "The wrong node", &[Figure31 { stop: 1 }])
        .says("It is node 1 that is left by path 0, so its path is the one to mark.")
        .code("node[2].vpath[0]", "nodes[1].vpaths[0]"),
    note(Slip, "§3.1, node 4", "The third path is west", &[Figure31 { stop: 6 }])
        .says(
            "Node 4 has no path to the east (1). The text later leaves it in direction 3: \
             its third path goes west.",
        )
        .code("node[4].path[1]", "nodes[4].paths[3]"),
    note(Slip, "§3.1, node 4", "Node 4, not node 2", &[Figure31 { stop: 8 }])
        .says(
            "After this dead end the book forgets a path of node 2. \
             The path that leads here is node 4's path 2.",
        )
        .code("such a path existed for node 2", "such a path existed for node 4"),
    note(Open, "§3.1", "RETURN-KNOWN sets ptr too", &[Place::Line(Line::KNOWN_PTR)]).says(
        "The book leaves ptr alone here. With exact coordinates it is m + 1 already; \
         where they have drifted, the nodes above m are stale and have to go.",
    ),
    note(
        Slip,
        "§3.1",
        "ptr: the node, or one more?",
        &[Place::Case(Case::UnknownBack), Place::Line(Line::LOOP_PTR)],
    )
    .says(
        "One place sets ptr to the matched node, another to that node + 1. By the meaning of ptr it is one more: \
         the matched node is still remembered.",
    )
    .code("set the ptr variable to currently matched node", "ptr = m + 1"),
    note(
        Slip,
        "§3.1",
        "Nothing is left to try",
        &[Place::Case(Case::UnknownBack), Place::Line(Line::LOOP_CHOOSE)],
    )
    .says(
        "The book tries to choose some other unvisited path of this node. There can be none: \
         the check before has covered this node too. The line is kept for the reader.",
    ),
    note(Slip, "§3.1, node 4", "One stop late", &[Figure31 { stop: 22 }])
        .says(
            "The book lowers ptr for node 4 only when it has reached node 3. For node 6 it does so on leaving \
             by the back path; the lab always does.",
        ),
    note(Slip, "§3.1", "ptr is one more", &[Place::Case(Case::Finish)]).says(
        "The book says that ptr now equals the number of nodes on the path. By its own definition it is one more: \
         figure 3.1 ends with 4, for nodes 1, 2 and 3. It is right if the finish counts.",
    ),
    note(
        Open,
        "§3.1",
        "No finish, no end",
        &[Place::Case(Case::Start)],
    )
    .says(
        "The book does not say what happens where no finish can be reached. \
         The lab ends the run when the bot is back at the start with no node remembered.",
    ),
    note(Slip, "Tables 2.1 and 2.2", "One thing, two names", &[Figure31 { stop: 1 }, Figure24 { stop: 1 }])
        .says(
            "vpath and vpaths are the same, and so are path and paths, curr_x and cur_x. \
             The lab writes vpaths, paths and cur_x throughout.",
        )
        .code("vpath, path, curr_x", "vpaths, paths, cur_x"),
];
