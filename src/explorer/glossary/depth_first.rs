//! Depth first, in the lab's words.

entries! {
    Variable Ours "" {
        "first entry" "The way by which a node was reached first; the start has none." "The stack, column first entry; lines 6 and 12."
        "used" "The ways of a node that were driven, in or out." "The stack, column ways: letters on a ground of their own; lines 6, 7 and 11."
        "order" "In which order unused ways are tried, from the heading on arrival." "The settings; line 11."
    }
    Term Ours "" {
        "way" "The nodes from the start to here; going back by the first entry takes the last one off." "In the sentence at the finish."
    }
    Function Ours "" {
        "explore" "Takes the first unused way, or goes back by the first entry." "The algorithm, lines 10 to 13."
    }
}
