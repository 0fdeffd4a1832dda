//! A robot's settings as people read and type them: gains as decimals, the rest in its unit, wrong values with
//! place and cure.

use alloc::string::String;

use super::tune::Name;

/// Gains go over the wire × 1000.
const GAIN: i64 = 1_000;

impl Name {
    /// Its unit, or what it counts.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Kp | Self::Ki | Self::Kd => "",
            Self::Speed => "mm/s",
            Self::Turn | Self::Uturn | Self::Epsilon => "ms",
            Self::Line0 | Self::Line1 | Self::Line2 | Self::Line3 | Self::Line4 => "of 1023",
        }
    }

    /// What it is for.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Kp => "proportional gain of the line follower",
            Self::Ki => "integral gain of the line follower",
            Self::Kd => "derivative gain of the line follower",
            Self::Speed => "speed on a straight",
            Self::Turn => "time of a turn by 90°",
            Self::Uturn => "time of turning round",
            Self::Epsilon => "two places nearer than this are one node",
            Self::Line0 => "leftmost sensor: from this reading on it sees the line",
            Self::Line1 => "second sensor: from this reading on it sees the line",
            Self::Line2 => "middle sensor: from this reading on it sees the line",
            Self::Line3 => "fourth sensor: from this reading on it sees the line",
            Self::Line4 => "rightmost sensor: from this reading on it sees the line",
        }
    }

    const fn is_gain(self) -> bool {
        matches!(self, Self::Kp | Self::Ki | Self::Kd)
    }

    /// A value as people write it.
    #[must_use]
    pub fn show(self, value: i32) -> String {
        if !self.is_gain() {
            return alloc::format!("{value}");
        }
        let (whole, part) = (i64::from(value) / GAIN, i64::from(value) % GAIN);
        let text = alloc::format!("{whole}.{part:03}");
        text.trim_end_matches('0').trim_end_matches('.').into()
    }

    /// Reads what was typed.
    ///
    /// # Errors
    /// Where it is no number within the setting's range: says which.
    pub fn read(self, text: &str) -> Result<i32, String> {
        let (least, most) = self.range();
        let wrong = || {
            let unit = self.unit();
            let space = if unit.is_empty() { "" } else { " " };
            let sort = if self.is_gain() { "a number" } else { "a whole number" };
            alloc::format!(
                "{}: {sort} from {} to {}{space}{unit}",
                self.word(),
                self.show(least),
                self.show(most)
            )
        };
        let text = text.trim();
        let value = if self.is_gain() { thousandths(text) } else { text.parse().ok() };
        value.filter(|value| (least..=most).contains(value)).ok_or_else(wrong)
    }
}

/// A decimal number × 1000; a comma is a point.
fn thousandths(text: &str) -> Option<i32> {
    let (whole, part) = text.split_once(['.', ',']).unwrap_or((text, ""));
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(whole) || !digits(part) || part.len() > 3 || whole.len() + part.len() == 0 {
        return None;
    }
    let whole: i32 = if whole.is_empty() { 0 } else { whole.parse().ok()? };
    let part: i32 = alloc::format!("{part:0<3}").parse().ok()?;
    whole.checked_mul(GAIN as i32)?.checked_add(part)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gains_are_decimals_and_come_back() {
        for (value, text) in [(620, "0.62"), (0, "0"), (3_100, "3.1"), (12_345, "12.345"), (1_000, "1")] {
            assert_eq!(Name::Kp.show(value), text);
            assert_eq!(Name::Kp.read(text), Ok(value));
        }
        assert_eq!(Name::Kd.read(" 3,1 "), Ok(3_100));
        assert_eq!(Name::Kd.read(".5"), Ok(500));
    }

    #[test]
    fn what_makes_no_sense_is_told_with_its_range() {
        for text in ["", ".", "-1", "1.2345", "1e3", "9999999", "x"] {
            assert_eq!(Name::Kp.read(text), Err("kp: a number from 0 to 1000".into()), "{text}");
        }
        assert_eq!(Name::Speed.read("0"), Err("speed: a whole number from 1 to 5000 mm/s".into()));
        assert_eq!(Name::Line2.read("1024"), Err("line2: a whole number from 0 to 1023 of 1023".into()));
    }

    #[test]
    fn every_setting_comes_back_from_its_text() {
        for name in Name::ALL {
            let (least, most) = name.range();
            for value in [least, (least + most) / 2, most] {
                assert_eq!(name.read(&name.show(value)), Ok(value));
            }
        }
    }
}
