//! The form of a robot's settings: what was typed and not sent yet, checked as it is typed, sent together or not
//! at all.

use alloc::string::String;
use alloc::vec::Vec;

use super::tune::Name;

/// What the robot told of its settings; none where it has not yet.
pub type Told = [Option<i32>; Name::COUNT];

/// What was typed and not sent yet.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Form {
    typed: [Option<String>; Name::COUNT],
}

/// A setting as the robot told it.
fn show(name: Name, told: &Told) -> String {
    told[name as usize].map(|value| name.show(value)).unwrap_or_default()
}

impl Form {
    /// A field has been changed. What the robot told anyway is no change.
    pub fn set(&mut self, name: Name, text: String, told: &Told) {
        self.typed[name as usize] = (text != show(name, told)).then_some(text);
    }

    /// What stands in a field.
    #[must_use]
    pub fn text(&self, name: Name, told: &Told) -> String {
        self.typed[name as usize].clone().unwrap_or_else(|| show(name, told))
    }

    /// Whether a field was changed and not sent.
    #[must_use]
    pub const fn is_unsent(&self, name: Name) -> bool {
        self.typed[name as usize].is_some()
    }

    /// Fields that were changed and not sent.
    #[must_use]
    pub fn unsent(&self) -> usize {
        self.typed.iter().flatten().count()
    }

    /// What is wrong with a field, with its cure.
    #[must_use]
    pub fn wrong(&self, name: Name) -> Option<String> {
        name.read(self.typed[name as usize].as_deref()?).err()
    }

    /// Takes the changes that are to be sent.
    ///
    /// # Errors
    /// Where something is wrong: names the first such field, and nothing is taken.
    pub fn send(&mut self, told: &Told) -> Result<Vec<(Name, i32)>, Name> {
        let mut changes = Vec::new();
        for name in Name::ALL {
            let Some(text) = &self.typed[name as usize] else { continue };
            let value = name.read(text).map_err(|_| name)?;
            if told[name as usize] != Some(value) {
                changes.push((name, value));
            }
        }
        *self = Self::default();
        Ok(changes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOLD: Told = [Some(400); Name::COUNT];

    fn form(typed: &[(Name, &str)]) -> Form {
        let mut form = Form::default();
        for (name, text) in typed {
            form.set(*name, (*text).into(), &TOLD);
        }
        form
    }

    #[test]
    fn a_wrong_value_is_told_as_soon_as_it_is_typed() {
        let form = form(&[(Name::Kp, "abc"), (Name::Speed, "-1"), (Name::Turn, "99999"), (Name::Ki, "1")]);
        assert_eq!(form.wrong(Name::Kp), Some("kp: a number from 0 to 1000".into()));
        assert_eq!(form.wrong(Name::Speed), Some("speed: a whole number from 1 to 5000 mm/s".into()));
        assert_eq!(form.wrong(Name::Turn), Some("turn: a whole number from 1 to 10000 ms".into()));
        assert_eq!((form.wrong(Name::Ki), form.wrong(Name::Kd)), (None, None));
        assert_eq!(form.unsent(), 4);
    }

    #[test]
    fn all_is_sent_or_nothing() {
        let mut form = form(&[(Name::Ki, "1"), (Name::Line4, "x"), (Name::Speed, "0")]);
        let before = form.clone();
        assert_eq!(form.send(&TOLD), Err(Name::Speed));
        assert_eq!(form, before);
        form.set(Name::Speed, "500".into(), &TOLD);
        assert_eq!(form.send(&TOLD), Err(Name::Line4));
        form.set(Name::Line4, "0400".into(), &TOLD);
        // The robot has that already, however it is written.
        assert_eq!(form.send(&TOLD), Ok(Vec::from([(Name::Ki, 1_000), (Name::Speed, 500)])));
        assert_eq!(form, Form::default());
    }

    #[test]
    fn what_the_robot_told_is_no_change() {
        let mut form = form(&[(Name::Kp, "0.5")]);
        assert_eq!(form.text(Name::Kp, &TOLD), "0.5");
        form.set(Name::Kp, "0.4".into(), &TOLD);
        assert!(!form.is_unsent(Name::Kp));
        assert_eq!(form.text(Name::Kp, &TOLD), "0.4");
        // Of a robot that tells nothing, an empty field is no change either.
        form.set(Name::Kp, String::new(), &[None; Name::COUNT]);
        assert_eq!(form, Form::default());
    }
}
