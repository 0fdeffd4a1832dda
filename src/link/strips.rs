//! The plot's curves as SVG path data: sensors, error and motors over the last seconds, thinned out to what a
//! screen can show.

use alloc::string::String;
use core::fmt::Write;

use super::plot::Plot;
use super::report::Ir;

/// What the plot shows, in milliseconds of the robot's clock.
pub const SPAN_MS: u32 = 6_000;
/// A strip is so wide, in units of its picture.
pub const WIDTH: u32 = 300;
/// Points of a curve: more look the same.
const POINTS: u32 = 150;
const POINT_MS: u32 = SPAN_MS / POINTS;

/// One curve of the plot.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curve {
    /// A sensor, 0 the leftmost: 0 to 1023.
    Sensor(usize),
    /// The line's distance from the middle: −2000 to 2000.
    Error,
    /// Command of the left motor: −255 to 255.
    Left,
    /// The same of the right one.
    Right,
}

impl Curve {
    /// Its value in a sample.
    #[must_use]
    pub fn of(self, ir: &Ir) -> i32 {
        match self {
            Self::Sensor(sensor) => ir.sensors.get(sensor).copied().unwrap_or(0).into(),
            Self::Error => ir.error.into(),
            Self::Left => ir.left.into(),
            Self::Right => ir.right.into(),
        }
    }

    const fn range(self) -> (i32, i32) {
        match self {
            Self::Sensor(_) => (0, 1_023),
            Self::Error => (-2_000, 2_000),
            Self::Left | Self::Right => (-255, 255),
        }
    }
}

impl Plot {
    /// The newest sample.
    #[must_use]
    pub fn newest(&self) -> Option<&Ir> {
        self.samples(0).last()
    }

    /// A curve as path data in a picture [`WIDTH`] wide and so high, now at the right. Sensors are an area
    /// above the lower edge. Of samples that fall together, the one farthest from the one before is shown.
    #[must_use]
    pub fn path(&self, curve: Curve, height: u32) -> String {
        let Some(newest) = self.newest() else { return String::new() };
        let (least, most) = curve.range();
        let inner = f64::from(height) - 3.0;
        let y = |value: i32| {
            let share = f64::from(value.clamp(least, most) - least) / f64::from(most - least);
            1.5 + inner * (1.0 - share)
        };
        let mut data = String::new();
        let mut coming: Option<(u32, i32)> = None;
        let mut before = 0;
        let mut put = |column: u32, value: i32| {
            let x = f64::from(WIDTH) * f64::from(POINTS - column) / f64::from(POINTS);
            // Writing to a string cannot fail.
            let _ = write!(data, "{}{x:.0} {:.1}", if data.is_empty() { "M" } else { "L" }, y(value));
        };
        for ir in self.samples(SPAN_MS) {
            let (column, value) = (newest.ms.wrapping_sub(ir.ms) / POINT_MS, curve.of(ir));
            match &mut coming {
                Some((at, kept)) if *at == column => {
                    if (value - before).abs() > (*kept - before).abs() {
                        *kept = value;
                    }
                }
                _ => {
                    if let Some((at, kept)) = coming.replace((column, value)) {
                        put(at, kept);
                        before = kept;
                    }
                }
            }
        }
        if let Some((at, kept)) = coming {
            put(at, kept);
        }
        if let (Curve::Sensor(_), Some((first, _))) = (curve, data.get(1..).and_then(|d| d.split_once(' '))) {
            let closed = alloc::format!("{data}V{height}H{first}z");
            return closed;
        }
        data
    }

    /// Where the stops of the last seconds are, from 0 (long ago) to 100 (now).
    pub fn stop_places(&self) -> impl Iterator<Item = f64> {
        let newest_ms = self.newest().map(|ir| ir.ms);
        self.stops().filter_map(move |ms| {
            let ago_ms = newest_ms?.checked_sub(ms).filter(|&ago_ms| ago_ms <= SPAN_MS)?;
            Some(100.0 - f64::from(ago_ms) / f64::from(SPAN_MS) * 100.0)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ir(ms: u32, sensor: u16) -> Ir {
        Ir { ms, line: 0, sensors: [sensor, 0, 0, 0, 0], error: 0, left: 255, right: -255 }
    }

    #[test]
    fn now_is_at_the_right_and_a_sensor_is_an_area() {
        let mut plot = Plot::default();
        plot.push(ir(0, 0), 0);
        plot.push(ir(3_000, 1_023), 1);
        plot.push(ir(6_000, 0), 2);
        assert_eq!(plot.path(Curve::Sensor(0), 24), "M0 22.5L150 1.5L300 22.5V24H0z");
        assert_eq!(plot.path(Curve::Left, 24), "M0 1.5L150 1.5L300 1.5");
        assert_eq!(plot.path(Curve::Right, 24), "M0 22.5L150 22.5L300 22.5");
        plot.stop(3_000);
        assert!(plot.stop_places().eq([50.0]));
    }

    #[test]
    fn a_curve_has_few_points_and_no_peak_is_lost() {
        let mut plot = Plot::default();
        (0..600).for_each(|i| plot.push(ir(i * 10, if i == 301 { 1_023 } else { 0 }), u64::from(i)));
        let path = plot.path(Curve::Sensor(0), 24);
        assert!(path.matches('L').count() <= POINTS as usize);
        assert!(path.contains(" 1.5"), "{path}");
    }

    #[test]
    fn nothing_is_drawn_of_nothing() {
        assert_eq!(Plot::default().path(Curve::Error, 36), "");
        assert_eq!(Plot::default().stop_places().count(), 0);
    }
}
