//! Every name of the book and of the pseudo-code has its entry.

use line_maze_lab::explorer::book::code::LISTING;
use line_maze_lab::explorer::book::glossary::{Belongs, GLOSSARY, Kind, Token, entry, split};

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
                 record_node finish get_paths uturn vpath path curr_x";
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
