//! Full mapping (Sakib and others, 2014, §III and §IV).

entries! {
    Variable Shown "§III" {
        "Point" "Which point was visited, a column for every visit; points are numbered from 0 as they were recorded."
            "The arrays, row Point; on the floor, the number in the disc."
        "Type" "The point’s ways less one." "The arrays, row Type."
        "Explored" "How many different neighbours of the point are known after this visit. The paper’s own definition is one less."
            "The arrays, row Explored; line 5."
        "Total_points" "How many points are recorded." "Under the arrays; line 3."
    }
    Variable Shown "Figure 3" {
        "CoOr_X" "How far east of the start the point is, in the robot’s own frame: the start faces north."
            "The arrays, row CoOr_X, in cells; line 4."
        "CoOr_Y" "How far north of the start the point is, in the robot’s own frame."
            "The arrays, row CoOr_Y, in cells; line 4."
    }
    Variable Shown "§III" {
        "Direction" "The robot’s absolute direction: 1 east, 2 north, 3 west, 4 south; the start faces north."
            "In the sentences, by its name."
        "tolerance" "Two places nearer than this on both axes are one point; epsilon in the settings."
            "The algorithm, line 2."
    }
    Term Ours "" {
        "point" "The number of the point where the robot stands." "The algorithm, lines 2 to 6."
    }
}
