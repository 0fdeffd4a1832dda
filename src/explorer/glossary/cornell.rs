//! The three traversals of a Cornell team (Milestone 3, 2018).

entries! {
    Array Shown "Second algorithm" {
        "maze" "A byte for every square: bit 4 visited, bits 3 to 0 walls to the north, east, south, west."
            "The grid of bytes; the byte of this square is spelled out. Line 2."
    }
    Variable Shown "Second algorithm" {
        "xpos" "The square’s column, from 0 in the west." "The grid of bytes, its upper edge; line 2."
        "ypos" "The square’s row, from 0 in the north, downwards." "The grid of bytes, its left edge; line 2."
        "orientation" "Where the robot faces on the map." "Under the byte: the robot faces …"
        "walls" "Bits 3 to 0 of a byte: north, east, south, west." "The byte of this square; line 2."
        "visited" "Bit 4 of a byte: the robot was on this square." "The byte of this square, and the ground of the squares; line 2."
        "L, B, R" "In the page’s code: what is to the left, before and to the right of the robot, first as walls, then as visited neighbours."
            "In the page’s code only."
    }
    Variable Ours "" {
        "route" "For the third: the squares to the one that the search found." "Under the byte, while it is followed; lines 6 to 9."
    }
}
