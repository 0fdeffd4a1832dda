//! Direction sums (Sakib and others, 2014, §II).

entries! {
    Variable Shown "§II" {
        "j" "The number of the present junction on the way from the start; turning back lowers it."
            "The direction sums, at the top and as row j; lines 8 and 12."
    }
    Array Shown "§II" {
        "a" "For each junction the sum of the directions that were taken there. The paper has no name for it but the array."
            "The direction sums, row a[j]; at the finish a[1] to a[j] are the route."
    }
    Variable Shown "§II" {
        "direction" "What a way counts, seen from the way behind: 1 right, 2 front, 3 left. Down, the way behind, is 4 in the paper and 0 here."
            "The algorithm, line 10; the row turn has the letter of each sum."
    }
    Case Ours "" {
        "used up" "The sum of a junction is 0: the robot leaves it by the way it first came, so the junction is forgotten."
            "The badge over the sentence; lines 11 and 12."
    }
}
