//! The one projection between lattice and screen: where a lattice point is in the picture, and which one is
//! under the pointer. Screen coordinates are CSS pixels from the picture's upper left corner, y down.

use crate::maze::Bounds;

/// A size in CSS pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Size {
    /// Width.
    pub w: f64,
    /// Height.
    pub h: f64,
}

/// Which part of the lattice the picture shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewport {
    /// Lattice x in the middle of the picture.
    pub x: f64,
    /// Lattice y in the middle.
    pub y: f64,
    /// Pixels a cell.
    pub scale: f64,
}

/// Cells of room around a maze that fills the picture.
const MARGIN: f64 = 0.75;
/// The fewest and the most pixels a cell.
const SCALES: (f64, f64) = (2.0, 160.0);

impl Viewport {
    /// The whole lattice, as large as it fits, but no cell larger than `most` pixels.
    #[must_use]
    pub fn fit(bounds: Bounds, size: Size, most: f64) -> Self {
        let (w, h) =
            (f64::from(bounds.width() - 1) + 2.0 * MARGIN, f64::from(bounds.height() - 1) + 2.0 * MARGIN);
        let scale = (size.w / w).min(size.h / h).clamp(0.5, most);
        Self {
            x: f64::from(bounds.sw().x + bounds.ne().x) / 2.0,
            y: f64::from(bounds.sw().y + bounds.ne().y) / 2.0,
            scale,
        }
    }

    /// A place on the lattice in the picture.
    #[must_use]
    pub fn to_screen(&self, size: Size, x: f64, y: f64) -> (f64, f64) {
        (size.w / 2.0 + (x - self.x) * self.scale, size.h / 2.0 - (y - self.y) * self.scale)
    }

    /// A place in the picture on the lattice.
    #[must_use]
    pub fn to_lattice(&self, size: Size, px: f64, py: f64) -> (f64, f64) {
        (self.x + (px - size.w / 2.0) / self.scale, self.y - (py - size.h / 2.0) / self.scale)
    }

    /// Larger or smaller by a factor, with one place of the picture standing still.
    #[must_use]
    pub fn zoomed(&self, size: Size, factor: f64, (px, py): (f64, f64)) -> Self {
        let (x, y) = self.to_lattice(size, px, py);
        let scale = (self.scale * factor).clamp(SCALES.0, SCALES.1);
        let kept = self.scale / scale;
        Self { x: x - (x - self.x) * kept, y: y - (y - self.y) * kept, scale }
    }

    /// Moved by pixels, as a hand moves paper.
    #[must_use]
    pub fn moved(&self, dx: f64, dy: f64) -> Self {
        Self { x: self.x - dx / self.scale, y: self.y + dy / self.scale, ..*self }
    }
}
