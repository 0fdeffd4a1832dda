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

/// What stands on the picture in its right corners.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overlays {
    /// In the upper corner.
    pub upper: Size,
    /// In the lower corner.
    pub lower: Size,
}

impl Overlays {
    /// Compass and zoom buttons on a picture of this size; `static/app.css` puts them there. On a narrow one both
    /// stand in its lower corners, so that it keeps its width.
    #[must_use]
    pub fn on(picture: Size) -> Self {
        let size = |w, h| Size { w, h };
        match picture.w <= 430.0 {
            true => Self { upper: Size::default(), lower: size(picture.w, 72.0) },
            false => Self { upper: size(84.0, 84.0), lower: size(144.0, 58.0) },
        }
    }
}

/// Cells of room around a maze that fills the picture, and pixels where that is more: the bot keeps its size.
const MARGIN: f64 = 0.75;
const MARGIN_PX: f64 = 24.0;
/// The fewest and the most pixels a cell.
const SCALES: (f64, f64) = (2.0, 160.0);

/// What a lattice takes with its margins, in pixels.
fn room(bounds: Bounds, scale: f64) -> Size {
    let side = |points: u32| f64::from(points - 1) * scale + 2.0 * (MARGIN * scale).max(MARGIN_PX);
    Size { w: side(bounds.width()), h: side(bounds.height()) }
}

impl Viewport {
    /// The whole lattice, as large as it fits, but no cell larger than `most` pixels.
    #[must_use]
    pub fn fit(bounds: Bounds, size: Size, most: f64) -> Self {
        let fits = |side: f64, points: u32| {
            let cells = f64::from(points - 1);
            (side / (cells + 2.0 * MARGIN)).min((side - 2.0 * MARGIN_PX) / cells)
        };
        let scale = fits(size.w, bounds.width()).min(fits(size.h, bounds.height())).clamp(0.5, most);
        Self {
            x: f64::from(bounds.sw().x + bounds.ne().x) / 2.0,
            y: f64::from(bounds.sw().y + bounds.ne().y) / 2.0,
            scale,
        }
    }

    /// As [`Viewport::fit`], but with the lattice beside what stands in the picture's right corners: as if that
    /// were not there where the lattice leaves the corners free anyway, else in the part of the picture where it
    /// gets largest.
    #[must_use]
    pub fn fit_beside(bounds: Bounds, size: Size, most: f64, over: Overlays) -> Self {
        let Overlays { upper, lower } = over;
        let whole = Self::fit(bounds, size, most);
        // Half a cell around a point belongs to its disc, its walls, and the robot there.
        let (east, north) = (f64::from(bounds.ne().x) + 0.5, f64::from(bounds.ne().y) + 0.5);
        let (right, top) = whole.to_screen(size, east, north);
        let bottom = whole.to_screen(size, east, f64::from(bounds.sw().y) - 0.5).1;
        let hides = |corner: Size, free: f64| right > size.w - corner.w && free < corner.h;
        if !hides(upper, top) && !hides(lower, size.h - bottom) {
            return whole;
        }
        // Width taken on the right, height taken above and below.
        let parts = [
            (upper.w.max(lower.w), 0.0, 0.0),
            (upper.w, 0.0, lower.h),
            (lower.w, upper.h, 0.0),
            (0.0, upper.h, lower.h),
        ];
        parts
            .into_iter()
            .map(|(right, above, below)| {
                let part = Size { w: (size.w - right).max(1.0), h: (size.h - above - below).max(1.0) };
                let fitted = Self::fit(bounds, part, most);
                let room = room(bounds, fitted.scale);
                // As near to the picture's middle as the part lets it be.
                let shift = |whole: f64, from: f64, to: f64, room: f64| {
                    let half = room / 2.0;
                    (whole / 2.0).min(to - half).max(from + half) - whole / 2.0
                };
                fitted.moved(
                    shift(size.w, 0.0, size.w - right, room.w),
                    shift(size.h, above, size.h - below, room.h),
                )
            })
            .max_by(|a, b| a.scale.total_cmp(&b.scale))
            .unwrap_or(whole)
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
