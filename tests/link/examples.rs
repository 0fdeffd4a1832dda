//! The examples of `PROTOCOL.md` are what a robot says, word for word.

use std::fs;
use std::path::{Path, PathBuf};

use line_maze_lab::link::demo::DemoRobot;
use line_maze_lab::link::frame::{Decoder, Heard, Sum};
use line_maze_lab::link::report::Report;

use crate::support::figure_3_1;

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

const EXAMPLES: &str = "tests/fixtures/link/examples.txt";

/// A robot whose words are read one by one.
struct Robot {
    robot: DemoRobot,
    now_ms: u64,
    decoder: Decoder,
    said: Vec<String>,
}

impl Robot {
    /// The next line that is no chatter, unless chatter is what is expected.
    fn next(&mut self, verb: &str) -> String {
        for _ in 0..20_000 {
            while !self.said.is_empty() {
                let line = self.said.remove(0);
                let chatter = line.starts_with("ir ") || line.starts_with("beat ");
                if !chatter || line.starts_with(&format!("{verb} ")) {
                    return line;
                }
            }
            self.wait(5);
        }
        panic!("no {verb} line came");
    }

    fn wait(&mut self, ms: u64) {
        self.now_ms += ms;
        for byte in self.robot.tick(self.now_ms) {
            if let Heard::Line(line) = self.decoder.push(byte) {
                assert_eq!(line.sum, Sum::Right);
                let report = Report::parse(line.body).expect(line.body);
                self.said.push(String::from_utf8(report.write().seal().to_vec()).unwrap().trim().to_owned());
            }
        }
    }
}

#[test]
fn the_examples_are_what_the_robot_says() {
    let text = fs::read_to_string(root(EXAMPLES)).unwrap();
    let robot = DemoRobot::new(&figure_3_1(), 0).unwrap();
    let mut robot = Robot { robot, now_ms: 0, decoder: Decoder::new(), said: Vec::new() };
    // It is switched on and says so.
    robot.next("ready");
    let mut came = String::new();
    for line in text.lines() {
        let said = if let Some(line) = line.strip_prefix("> ") {
            // At most one `err` in 100 ms.
            robot.wait(120);
            robot.robot.bytes_in(format!("{line}\n").as_bytes(), robot.now_ms);
            format!("> {line}")
        } else if let Some(expected) = line.strip_prefix("< ") {
            let verb = expected.split([' ', '*']).next().unwrap();
            let line = robot.next(verb);
            // Sensors are what they are.
            let form = verb == "ir" && expected.len() > 3 && line.starts_with("ir ");
            format!("< {}", if form { expected.to_owned() } else { line })
        } else {
            line.to_owned()
        };
        came += &said;
        came.push('\n');
    }
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        fs::write(root(EXAMPLES), came).unwrap();
    } else {
        assert_eq!(came, text);
    }
}

#[test]
fn the_protocol_and_the_file_agree() {
    let protocol = fs::read_to_string(root("PROTOCOL.md")).unwrap();
    let mut examples = String::new();
    for block in protocol.split("```link\n").skip(1) {
        examples += block.split("```").next().unwrap();
    }
    assert_eq!(examples, fs::read_to_string(root(EXAMPLES)).unwrap());
}

#[test]
fn the_protocol_names_every_rule_code_and_setting() {
    use line_maze_lab::link::{check::RULES, report::Code, tune::Name};
    let protocol = fs::read_to_string(root("PROTOCOL.md")).unwrap();
    for rule in RULES {
        assert!(protocol.contains(&format!("| `{}` |", rule.name)), "rule {}", rule.name);
    }
    for code in Code::ALL {
        assert!(protocol.contains(&format!("| `{}` | ", code.word())), "code {}", code.word());
    }
    for name in Name::ALL {
        let (least, most) = name.range();
        let (word, range) = (name.word(), format!("{least} to {most}"));
        let told = protocol.lines().any(|line| line.contains(&format!("`{word}`")) && line.contains(&range));
        assert!(told, "setting {word}: {range}");
    }
}
