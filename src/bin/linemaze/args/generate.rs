//! What a generated maze should be like.

use clap::{Args, ValueEnum};
use line_maze_lab::maze::generate::Recipe;
use line_maze_lab::maze::{Kind, MAX_SIDE};

use super::numbers::seed;

/// What `generate` takes.
#[derive(Args)]
pub(crate) struct Generate {
    /// Lattice points from west to east and from south to north, as in 20x12
    #[arg(long, value_name = "WxH", default_value = "9x6", allow_hyphen_values = true, value_parser = size)]
    pub(crate) size: Size,
    /// How many of the links that a tree leaves out become loops: 0 to 1 in steps of 0.01, or 0% to 100%
    #[arg(long, value_name = "SHARE", default_value = "25%", allow_hyphen_values = true, value_parser = percent)]
    pub(crate) loops: u8,
    /// How many of the dead ends are cut back to the next node: 0 to 1 in steps of 0.01, or 0% to 100%
    #[arg(long, value_name = "SHARE", default_value = "80%", allow_hyphen_values = true, value_parser = percent)]
    pub(crate) dead_ends: u8,
    /// Another seed, another maze
    #[arg(long, value_name = "N", default_value_t = 1, allow_negative_numbers = true, value_parser = seed())]
    pub(crate) seed: u64,
    /// Drawn as lines on the floor, or as walls between squares
    #[arg(long, value_name = "KIND", value_enum, default_value_t)]
    pub(crate) kind: Drawn,
}

impl Generate {
    /// The recipe that the options make.
    pub(crate) const fn recipe(&self) -> Recipe {
        Recipe {
            width: self.size.width,
            height: self.size.height,
            loops_percent: self.loops,
            dead_ends_cut_percent: self.dead_ends,
            seed: self.seed,
            kind: match self.kind {
                Drawn::Line => Kind::Line,
                Drawn::Wall => Kind::Wall,
            },
        }
    }
}

/// Points along the sides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Size {
    pub(crate) width: u32,
    pub(crate) height: u32,
}

/// How a maze is drawn.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub(crate) enum Drawn {
    #[default]
    Line,
    Wall,
}

fn size(text: &str) -> Result<Size, String> {
    let side = |text: &str| text.trim().parse().ok().filter(|side| (1..=MAX_SIDE).contains(side));
    let sides =
        text.split_once(['x', 'X', '×']).and_then(|(width, height)| Some((side(width)?, side(height)?)));
    let (width, height) = sides
        .ok_or(format!("a size is two whole numbers from 1 to {MAX_SIDE} with an x between, as in 20x12"))?;
    Ok(Size { width, height })
}

/// A share in whole per cent; what is between them would be lost.
fn percent(text: &str) -> Result<u8, String> {
    let text = text.trim();
    let (number, whole) = text.strip_suffix('%').map_or((text, 1.0), |number| (number, 100.0));
    let percent = match number.trim().parse::<f64>() {
        Ok(share) if (0.0..=whole).contains(&share) => share / whole * 100.0,
        _ => return Err("a share is a number from 0 to 1, as in 0.25, or from 0% to 100%".to_owned()),
    };
    let nearest = percent.round();
    // 0.07 times 100 is not quite 7.
    if (percent - nearest).abs() > 1e-9 {
        return Err(format!("a share goes in steps of 0.01, which is 1%; the nearest is {nearest}%"));
    }
    Ok(nearest as u8)
}
