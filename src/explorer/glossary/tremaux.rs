//! Trémaux's marks (Lucas, 1882).

entries! {
    Array Ours "" {
        "marks" "How often each way of a node was used at this node: 0, 1 or 2." "The marks on the ways, columns N, E, S, W; on the floor, bars across the ways."
    }
    Case Shown "Lucas 1882" {
        "one mark" "The way was used once: at the finish, those of the route." "On the floor, one bar across the way; lines 7 to 10."
        "two marks" "The way was used there and back, and is never used again." "On the floor, two bars across the way; lines 7 to 10."
    }
    Variable Ours "" {
        "order" "In which order ways without a mark are tried, from the heading on arrival." "The settings; line 8."
    }
}
