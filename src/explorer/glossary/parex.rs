//! Path mapping (Fred Swirbul, PAReX, 2002).

entries! {
    Array Shown "Path Mapping Algorithm" {
        "Path" "The numbers of the squares on the way from the start, counted from 1; what led back is set to 0."
            "The path of squares; lines 2 to 8."
    }
    Variable Shown "Path Mapping Algorithm" {
        "CSIP" "Current square in path: how many squares the path has, and so the place of the last."
            "The path of squares, at the top; lines 2 to 8."
    }
    Variable Shown "Special Case Number 1" {
        "P" "A place in the path that is compared with the last." "The path of squares, row P; lines 7 and 8."
        "Q" "Counts over the places that are set to 0." "In the article’s listing; the lab clears them in one line, line 8."
    }
    Case Shown "Special Case Number 1" {
        "basic rule" "Cuts where the robot is on the square that it was on two steps ago." "The settings; lines 3 to 5."
        "special case 1" "Cuts back to an earlier visit of the square, anywhere on the path." "The settings; lines 6 to 8."
    }
    Variable Shown "Details, Details, Details" {
        "number" "What a square is called: 1 more to the right, a field’s width more upwards. Up is where the robot faced at the start."
            "On the floor, in the squares; line 2."
    }
}
