//! Every name of the book and of the pseudo-code has its entry.

use line_maze_lab::explorer::book::code::LISTING;
use line_maze_lab::explorer::book::glossary::{Belongs, GLOSSARY, Kind, Token, entry, split};
use line_maze_lab::explorer::glossary;
use line_maze_lab::explorer::name::Name;

#[test]
fn every_identifier_of_the_listing_is_a_keyword_or_in_the_glossary() {
    for line in LISTING {
        let tokens: Vec<Token<'_>> = split(line.text).collect();
        assert_eq!(tokens.iter().map(|token| token.text()).collect::<String>(), line.text);
        for (i, token) in tokens.iter().enumerate() {
            let Token::Text(text) = token else { continue };
            // Prose has plain words; code has brackets, dots, underscores or an equals sign beside them.
            for (at, word) in words(text) {
                let next = text[at + word.len()..].trim_start();
                let code = text[at + word.len()..].starts_with(['(', '['])
                    || text[..at].ends_with('.')
                    || next.starts_with('=')
                    || word.contains('_')
                    || (word.len() == 1 && word != "1" && word != "0");
                assert!(!code, "{word} in “{}”, piece {i}", line.text);
            }
        }
    }
    let names =
        |text| split(text).filter_map(|t| if let Token::Name(name, _) = t { Some(name) } else { None });
    let line = "  nodes[m].vpaths[d] = true; last_path = d; returning = false; turn to d; return true";
    assert!(names(line).eq(["nodes", "m", "vpaths", "d", "last_path", "d", "returning", "d"]));
    assert!(names("d = first of the order that exists at m, unvisited").eq(["d", "m"]));
    assert_eq!(split("ptr # m").last(), Some(Token::Comment("# m")));
    assert_eq!(split("").next(), None);
    assert_eq!(split("– ptr").next(), Some(Token::Text("– ")));
}

fn words(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_')
        .filter(|word| !word.is_empty())
        .map(move |word| (word.as_ptr() as usize - text.as_ptr() as usize, word))
}

#[test]
fn the_glossary_has_every_name_of_the_book_once() {
    let shown = "cur_x cur_y returning ptr bot_dir curr_time prev_time time_diff left_path right_path \
                 left_path_var right_path_var blank_var junction_var finish_var paths vpaths back_path x_cor y_cor \
                 nodes Node epsilon act node choose_path take_return_path match_cur_node unvisited get_coords \
                 record_node finish get_paths uturn vpath path curr_x RETURN-KNOWN RETURN-UNKNOWN";
    let robot = "line sensor turning kp ki kd loop readLineandgetError followline_pid brake turn_left turn_right \
                 stick_to_line left_forward left_backward right_forward right_backward";
    let ours = "last_path NODE_MAX m d arrival";
    for (names, belongs) in [(shown, Belongs::Shown), (robot, Belongs::Robot), (ours, Belongs::Ours)] {
        for name in names.split_whitespace() {
            assert_eq!(entry(name).map(|entry| entry.belongs), Some(belongs), "{name}");
        }
    }
    let spellings = || GLOSSARY.iter().flat_map(|e| e.aliases.iter().chain([&e.name]));
    let unique: std::collections::BTreeSet<_> = spellings().collect();
    assert_eq!(unique.len(), spellings().count());
    for entry in GLOSSARY {
        assert!(entry.meaning.ends_with('.') && entry.seen.ends_with('.'), "{}", entry.name);
        assert_eq!(entry.section.is_empty(), entry.belongs == Belongs::Ours, "{}", entry.name);
    }
    assert_eq!(entry("back_path").unwrap().kind, Kind::Field);
    assert_eq!(entry("nothing_of_the_kind"), None);
}

/// What a listing writes as code: names before a bracket or an equals sign, and names in capitals or with an underscore.
fn coded(line: &str) -> Vec<&str> {
    let code = line.split('#').next().unwrap();
    let is_coded = |(at, word): &(usize, &str)| {
        let rest = code[at + word.len()..].trim_start();
        word.starts_with(|c: char| c.is_ascii_alphabetic())
            && (code[at + word.len()..].starts_with(['(', '['])
                || ["= ", "+ ", "- ", "|= ", "== ", ">= ", "> "].iter().any(|op| rest.starts_with(op))
                || word.contains('_')
                || (word.len() > 1 && word.chars().all(|c| c.is_ascii_uppercase())))
    };
    words(code).filter(is_coded).map(|(_, word)| word).collect()
}

#[test]
fn every_name_of_every_listing_has_its_entry() {
    for &name in Name::ALL.iter().filter(|&&name| name != Name::Book) {
        for line in name.about().listing {
            let linked: Vec<&str> = glossary::split(name, line)
                .filter_map(|token| if let Token::Name(text, _) = token { Some(text) } else { None })
                .collect();
            assert_eq!(glossary::split(name, line).map(Token::text).collect::<String>(), *line);
            for word in coded(line) {
                // Letters of the turn list, and a point that is told of in plain words too.
                if ["L", "S", "R", "B", "point", "letter", "its"].contains(&word) {
                    continue;
                }
                assert!(linked.contains(&word), "{name}: {word} in “{line}” is in no glossary");
            }
        }
    }
}

#[test]
fn every_glossary_is_whole() {
    for &name in Name::ALL {
        let entries = glossary::of(name);
        let unique: std::collections::BTreeSet<_> = entries.iter().map(|entry| entry.name).collect();
        assert_eq!(unique.len(), entries.len(), "{name}");
        for entry in entries {
            assert!(entry.meaning.ends_with('.'), "{name}: {}", entry.name);
            assert!(entry.seen.ends_with(['.', '…']), "{name}: {}", entry.name);
            assert_eq!(entry.section.is_empty(), entry.belongs == Belongs::Ours, "{name}: {}", entry.name);
            assert_eq!(glossary::entry(name, entry.name), Some(entry));
        }
    }
    // As the inspectors write them.
    let written = [
        (Name::LeftHand, "path[n]"),
        (Name::DirectionSumRight, "a[j]"),
        (Name::Mapping, "CoOr_X"),
        (Name::ParexLeft, "CSIP"),
        (Name::Cornell2, "maze[2][1]"),
        (Name::DepthFirst, "first entry"),
    ];
    for (name, heading) in written {
        assert!(glossary::entry(name, heading).is_some(), "{name}: {heading}");
    }
}

#[test]
fn what_is_the_labs_is_said_of_every_explorer() {
    use line_maze_lab::explorer::book::code::OURS;
    use line_maze_lab::explorer::book::errata::Kind;
    use line_maze_lab::explorer::name::Extent;
    assert!(OURS.iter().all(|line| !line.listed().label.is_empty()));
    for &name in Name::ALL {
        let about = name.about();
        assert!(about.reading.text.ends_with('.') && about.reading.text.contains("lab’s"), "{name}");
        assert_eq!(about.ours.len(), about.listing.len(), "{name}");
        if name == Name::Book || about.reading.extent == Extent::Whole {
            continue;
        }
        // Marked lines have a note that says what the source leaves open.
        assert!(about.ours.contains(&true) && about.ours.contains(&false), "{name}");
        assert!(about.errata.iter().any(|note| note.kind == Kind::Open), "{name}");
    }
    let marked = |name: Name, part: &str| {
        let about = name.about();
        let (nth, _) = about.listing.iter().enumerate().find(|(_, line)| line.contains(part)).unwrap();
        about.ours[nth]
    };
    // The paper: down is 4, no remainder, no junction that is used up. Its counting and turning back are its own.
    for (part, ours) in [("mod 4", true), ("j - 2", true), ("j + 1", false), ("j = j - 1", false)] {
        assert_eq!(marked(Name::DirectionSumLeft, part), ours, "{part}");
    }
    // Cornell's page has the first and the bytes, and names the third only.
    for (part, ours) in
        [("breadth first", true), ("follow it", true), ("1: first open", false), ("|= walls", false)]
    {
        assert_eq!(marked(Name::Cornell3, part), ours, "{part}");
    }
    // The article prints the basic rule; special case 1 cannot run as printed.
    for (part, ours) in [("two steps ago", false), ("anywhere", true)] {
        assert_eq!(marked(Name::ParexRight, part), ours, "{part}");
    }
}
