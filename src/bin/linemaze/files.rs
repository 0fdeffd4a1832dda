//! Mazes in and out: reading a file or standard input, `generate`, and `convert`.

use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;

use line_maze_lab::maze::file::{self, ReadError};
use line_maze_lab::maze::generate;
use line_maze_lab::maze::json::{self, JsonError};
use line_maze_lab::maze::micromouse::Spot;
use line_maze_lab::maze::text::Place;
use line_maze_lab::maze::{Maze, Reading, text};

use crate::args::{Generate, Input, Marks};
use crate::locate;
use crate::{Failure, Status};

/// Reads the maze that a command takes, with start and finish where its options have them.
pub(crate) fn open(input: &Input) -> Result<Maze, Failure> {
    marked(&input.path, &input.marks)
}

/// A file's maze with other marks than its own; what there is to say about it goes to standard error.
pub(crate) fn marked(path: &Path, marks: &Marks) -> Result<Maze, Failure> {
    let Reading { mut maze, remarks } = read(path)?;
    let name = name(path);
    // What an option says, the file need not.
    for remark in remarks.iter().filter(|remark| !marks.settle(remark)) {
        crate::complain(&match remark.place() {
            Some(Place { line, column }) => format!("{name}:{line}:{column}: remark: {remark}"),
            None => format!("{name}: remark: {remark}"),
        });
    }
    marks.put_on(&mut maze).map_err(|why| Failure::Message(format!("{name}: {why}")))?;
    Ok(maze)
}

/// Reads a maze from a file, or from standard input where the path is `-`.
pub(crate) fn read(path: &Path) -> Result<Reading, Failure> {
    if path.is_dir() {
        return Err(Failure::Message(format!("{}: this is a folder; name a maze file in it", name(path))));
    }
    let bytes = bytes(path).map_err(|error| Failure::at(path, &error))?;
    file::read(&bytes).map_err(|error| {
        Failure::Message(match placed(&bytes, &error) {
            (Some(place), message) => format!("{}:{}:{}: {message}", name(path), place.line, place.column),
            (None, message) => format!("{}: {message}", name(path)),
        })
    })
}

/// How messages call an input.
pub(crate) fn name(path: &Path) -> String {
    if path == Path::new("-") { "standard input".to_owned() } else { path.display().to_string() }
}

/// One byte more than any format may have is enough to know that it is too much.
fn bytes(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let most = json::MAX_BYTES as u64 + 1;
    if path == Path::new("-") {
        io::stdin().lock().take(most).read_to_end(&mut bytes)?;
    } else {
        File::open(path)?.take(most).read_to_end(&mut bytes)?;
    }
    Ok(bytes)
}

/// Where in the file an error is, if it is at a place, and what it says without that.
fn placed(bytes: &[u8], error: &ReadError) -> (Option<Place>, String) {
    const START: Place = Place { line: 1, column: 1 };
    let (place, message) = match error {
        ReadError::Text(error) => (error.place, error.problem.to_string()),
        ReadError::Json(JsonError::Syntax { line, column, message }) => {
            (Place { line: *line, column: *column }, message.clone())
        }
        ReadError::Json(error @ JsonError::Value { path, .. }) => {
            let text = String::from_utf8_lossy(bytes);
            (locate::value(&text, path), error.to_string())
        }
        // A byte's place is in the message: a binary file has no lines.
        ReadError::Micromouse(error) => match error.spot {
            Spot::Text(place) => (place, error.problem.to_string()),
            Spot::Byte(_) | Spot::File => (START, error.to_string()),
        },
        ReadError::NotText { at, .. } => {
            (Place::after(&String::from_utf8_lossy(&bytes[..*at])), error.to_string())
        }
        ReadError::Unknown { place, .. } => (*place, error.what()),
        ReadError::Empty => (START, error.to_string()),
        // Nobody looked into it.
        ReadError::TooLarge | ReadError::Json(JsonError::TooLarge { .. }) => {
            return (None, error.to_string());
        }
    };
    (Some(place), message)
}

/// `linemaze generate`
pub(crate) fn generate(args: &Generate, out: &mut impl Write) -> Result<Status, Failure> {
    let maze = generate::generate(&args.recipe()).map_err(|error| Failure::Message(error.to_string()))?;
    out.write_all(text::write(&maze).as_bytes())?;
    Ok(Status::Good)
}
