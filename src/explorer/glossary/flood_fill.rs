//! Flood fill, in the lab's words.

entries! {
    Array Ours "" {
        "number" "How many squares a square is from the goal, as far as the robot knows; infinite where no way leads."
            "The numbers of the flood, and on the floor in the squares; lines 4 to 6."
    }
    Variable Ours "" {
        "goal" "The squares of the finish, which this robot is told." "Number 0; line 4."
        "walls" "A byte for every square, as in the Cornell map; a side that was not seen counts as open." "The numbers of the flood, lines between squares; line 2."
    }
}
