//! Hand on the wall (book §1.2); all names are the lab's.

entries! {
    Array Ours "" {
        "path" "The letters so far: L, S or R for a node, B for a dead end; corners have none."
            "The turn letters, row path[n]; at the finish it is the route."
    }
    Variable Ours "" {
        "n" "How many letters there are; in path[n], the place of one, counted from 0."
            "The turn letters, row n; lines 8 to 10."
        "xBy" "A way that led back: between x and y the robot turned round. The three letters become one, the sum of their turns modulo 360°: L B L is S."
            "Under the turn letters, at the stop where it happens; line 10."
    }
    Function Ours "" {
        "add" "Appends a letter, and makes one of three where that closes an x B y." "The algorithm, lines 7 to 10."
    }
}
