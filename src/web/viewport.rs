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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Heading, Point};
    use crate::gesture::{nearest_cell, nearest_point};

    const SIZE: Size = Size { w: 800.0, h: 600.0 };

    fn view() -> Viewport {
        Viewport { x: 3.0, y: -2.5, scale: 40.0 }
    }

    #[test]
    fn there_and_back_is_the_same_place() {
        for (x, y) in [(0.0, 0.0), (3.0, -2.5), (-7.25, 11.5)] {
            let (px, py) = view().to_screen(SIZE, x, y);
            let (bx, by) = view().to_lattice(SIZE, px, py);
            assert!((bx - x).abs() < 1e-9 && (by - y).abs() < 1e-9);
        }
    }

    #[test]
    fn north_is_up_and_the_middle_is_the_middle() {
        assert_eq!(view().to_screen(SIZE, 3.0, -2.5), (400.0, 300.0));
        assert!(view().to_screen(SIZE, 3.0, -1.5).1 < 300.0);
    }

    #[test]
    fn a_fitted_lattice_lies_in_the_picture() {
        let bounds = Bounds::new(Point::new(-4, 2), Point::new(20, 9)).unwrap();
        let view = Viewport::fit(bounds, SIZE, 90.0);
        for corner in [bounds.sw(), bounds.ne()] {
            let (px, py) = view.to_screen(SIZE, f64::from(corner.x), f64::from(corner.y));
            assert!((0.0..=SIZE.w).contains(&px) && (0.0..=SIZE.h).contains(&py));
        }
    }

    #[test]
    fn zooming_keeps_the_place_under_the_pointer() {
        let pointer = (123.0, 456.0);
        let before = view().to_lattice(SIZE, pointer.0, pointer.1);
        let after = view().zoomed(SIZE, 1.7, pointer).to_lattice(SIZE, pointer.0, pointer.1);
        assert!((before.0 - after.0).abs() < 1e-9 && (before.1 - after.1).abs() < 1e-9);
    }

    #[test]
    fn moving_the_paper_moves_what_is_drawn_on_it() {
        let (px, py) = view().to_screen(SIZE, 1.0, 1.0);
        let (mx, my) = view().moved(30.0, -12.0).to_screen(SIZE, 1.0, 1.0);
        assert!((mx - px - 30.0).abs() < 1e-9 && (my - py + 12.0).abs() < 1e-9);
    }

    #[test]
    fn the_nearest_point_and_cell_are_under_the_pointer() {
        assert_eq!(nearest_point((1.4, -0.6)), Point::new(1, -1));
        assert_eq!(nearest_cell((2.1, 3.5)).0, (Point::new(2, 3), Heading::North));
        assert_eq!(nearest_cell((2.4, 2.9)).0, (Point::new(2, 3), Heading::East));
        assert_eq!(nearest_cell((-0.5, 0.1)).0, (Point::new(-1, 0), Heading::East));
    }
}
