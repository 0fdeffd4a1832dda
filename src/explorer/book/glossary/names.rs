//! The names themselves, in the order of the book's tables, ours last.

use super::{Belongs, Entry, Kind, Spelling};

macro_rules! glossary {
    ($($kind:ident $belongs:ident $section:literal {
        $($name:literal $([$($alias:literal)*])? $meaning:literal $seen:literal)*
    })*) => {
        /// Every name of the book's tables and of the pseudo-code.
        pub static GLOSSARY: &[Entry] = &[$($(Entry {
            name: $name,
            aliases: &[$($($alias),*)?],
            kind: Kind::$kind,
            meaning: $meaning,
            seen: $seen,
            belongs: Belongs::$belongs,
            section: $section,
        }),*),*];

        /// The same names without their meanings, for those who only have to know them.
        pub static SPELLINGS: &[Spelling] = &[$($(Spelling {
            name: $name,
            aliases: &[$($($alias),*)?],
            kind: Kind::$kind,
        }),*),*];
    };
}

glossary! {
    Variable Shown "Table 2.1, §2.3" {
        "cur_x" ["curr_x"] "How far east of the start the bot is, in milliseconds of driving; west counts negative."
            "Among the variables; set in line 2."
        "cur_y" ["curr_y"] "How far north of the start the bot is, in milliseconds of driving; south counts negative."
            "Among the variables; set in line 2."
        "curr_time" "The clock at this stop, in milliseconds since the robot was switched on."
            "Among the variables, under “clock, sensors”."
        "prev_time" "The clock when the bot last drove off. It is taken again after a turn, so that turning does not count as distance."
            "Among the variables, under “clock, sensors”."
        "time_diff" "curr_time less prev_time: how long the bot has just driven, and so how far."
            "Among the variables, under “clock, sensors”; line 2 adds it to cur_x or cur_y."
    }
    Variable Shown "Table 2.1, §2.5" {
        "returning" "True while the bot drives back from a way that does not lead to the finish. Set on every U-turn and back path, cleared when an unvisited path is chosen."
            "Among the variables; lines 4, 13, 18, 26 and 29. Lines driven while it is true are crossed out."
    }
    Variable Shown "Table 2.1, §3.1" {
        "ptr" "One more than the number of nodes that the bot remembers: the place that the next new node gets."
            "Among the variables; lines 11, 14, 20 and 30."
    }
    Variable Shown "Table 2.1, §2.2" {
        "bot_dir" "Where the bot faces: 0 north, 1 east, 2 south, 3 west. North is where it faced at the start, whatever the drawing says."
            "Among the variables, and as the arrow on the bot; the compass shows the bot's north."
    }
    Variable Shown "Table 2.1" {
        "left_path" "Whether there is a way to the left of this stop." "Among the variables, under “clock, sensors”, as get_paths() leaves it."
        "right_path" "Whether there is a way to the right of this stop." "Among the variables, under “clock, sensors”, as get_paths() leaves it."
        "left_path_var" "The sensors see line to the left." "Among the variables, under “clock, sensors”."
        "right_path_var" "The sensors see line to the right." "Among the variables, under “clock, sensors”."
        "blank_var" "The sensors see no line in any direction: a dead end." "Among the variables, under “clock, sensors”; line 4 asks for it."
        "junction_var" "The sensors see that three or four ways meet here: a node."
            "Among the variables, under “clock, sensors”."
        "finish_var" "The sensors see the black patch of the finish." "Among the variables, under “clock, sensors”; line 3 asks for it."
    }
    Variable Shown "Table 2.1, §2.4.2" {
        "nodes" ["Node"] "The node table: an array of struct Node, numbered from 1. The last node in it is forgotten first."
            "The node table; places 1 to ptr - 1 are in use."
    }
    Variable Shown "§2.4.3" {
        "epsilon" "Two places nearer than this on both axes count as one node, in milliseconds. Half a cell if you don't set it."
            "In the settings; match_cur_node() uses it."
    }
    Field Shown "Table 2.2, §2.4.2" {
        "paths" ["path"] "Which of the four directions have a line at this node." "The node table, column paths · vpaths: a letter for each direction."
        "vpaths" ["vpath"] "Which of the node's paths the bot has taken or come by." "The node table, column paths · vpaths: letters on a ground of their own; lines 17 and 26."
        "back_path" "The way by which the bot first came to the node." "The node table, column back_path; line 29."
        "x_cor" "The node's cur_x, as it was when the node was recorded." "The node table, column x_cor, y_cor."
        "y_cor" "The node's cur_y, as it was when the node was recorded." "The node table, column x_cor, y_cor."
    }
    Function Shown "Table 2.2, §3.1" {
        "act" "Decides what to do at a stop: finish, dead end, corner or node." "The algorithm, lines 1 to 6."
        "node" "Decides at a node: new, RETURN-KNOWN or RETURN-UNKNOWN." "The algorithm, lines 8 to 21."
        "choose_path" "Takes the first way of the preference order that exists here and is unvisited; false if there is none."
            "The algorithm, lines 23 to 26."
        "take_return_path" "Turns to the node's back path and forgets the node." "The algorithm, lines 28 to 30."
        "unvisited" "unvisited(a, b): whether any of the nodes a to b has a path not yet taken." "The algorithm, line 18."
        "record_node" "Writes a new node into the table: its paths, its place, and its back path, which is visited at once."
            "The algorithm, line 11."
        "finish" "Stops the bot on the finish." "The algorithm, line 3."
    }
    Function Shown "Table 2.2, §2.4.3" {
        "match_cur_node" "The number of the remembered node that is here, within epsilon; 0 if there is none."
            "The algorithm, line 9."
    }
    Function Shown "Table 2.2, §2.3" {
        "get_coords" "Adds time_diff to cur_x or cur_y, along bot_dir." "The algorithm, line 2."
    }
    Function Shown "Table 2.2" {
        "get_paths" "Finds out which ways there are at this stop." "The algorithm, line 2."
    }
    Function Shown "Table 2.2, §2.5" {
        "uturn" "Turns the bot round, to where it came from." "The algorithm, lines 4 and 18."
    }
    Case Shown "§2.4.3, §2.5" {
        "RETURN-KNOWN" "The bot comes back to a node by the way that it left it last: returning is true on arrival. It takes an unvisited path, or the back path if there is none."
            "The badge over the sentence, the events of the time line; lines 13 to 15."
        "RETURN-UNKNOWN" "The bot comes to a node that it knows by a path that is new to it: returning is false on arrival. It turns round if any node since then has an unvisited path."
            "The badge over the sentence, the events of the time line; lines 16 to 21."
    }
    Variable Robot "Table 2.1" {
        "line" "Where the line lies under the sensor array, left or right of its middle." "On a physical robot."
        "sensor" "The five pins of the sensor array." "On a physical robot."
        "turning" "True while the robot turns on the spot." "On a physical robot."
    }
    Variable Robot "Table 2.2" {
        "kp" "How strongly the wheels answer to the robot being off the line." "On a physical robot."
        "ki" "How strongly they answer to being off the line for long." "On a physical robot."
        "kd" "How strongly they answer to drifting off the line quickly." "On a physical robot."
    }
    Function Robot "Table 2.2" {
        "loop" "The Arduino's main loop: follows the line and calls act() at every stop." "On a physical robot."
        "readLineandgetError" "Reads the sensors and works out how far off the line the robot is." "On a physical robot."
        "followline_pid" "Keeps the robot on the line by driving its wheels at different speeds." "On a physical robot."
        "brake" "Stops the wheels." "On a physical robot."
        "turn_left" "Turns the robot to the left until it meets the line there." "On a physical robot; here a turn."
        "turn_right" "Turns the robot to the right until it meets the line there." "On a physical robot; here a turn."
        "stick_to_line" "Moves the robot back into the middle of the line." "On a physical robot."
        "left_forward" "Makes the left wheel turn forwards." "On a physical robot."
        "left_backward" "Makes the left wheel turn backwards." "On a physical robot."
        "right_forward" "Makes the right wheel turn forwards." "On a physical robot."
        "right_backward" "Makes the right wheel turn backwards." "On a physical robot."
    }
    Field Ours "" {
        "last_path" "The way last chosen at the node. With back_path it gives the turn of round 2, which the book leaves unwritten."
            "The turn list at the finish; line 26."
    }
    Variable Ours "" {
        "NODE_MAX" "How many nodes the bot can remember at once. The book writes 50 into its array."
            "In the settings; one node more ends the run."
        "m" "The number of the node where the bot stands; 0 while it is new." "Among the variables while its functions run, line by line; lines 9 to 30."
        "d" "The direction that choose_path() picks." "Among the variables while choose_path() runs, line by line; lines 24 and 26."
        "arrival" "The way by which the bot has just come to the node, seen from the node." "Among the variables while node() runs, line by line; line 17."
    }
}
