//! Why a robot does not carry out a request.

/// The code of an `err` line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// The line is longer than 80 bytes.
    Long,
    /// The line holds bytes that no line may hold.
    Byte,
    /// The checksum is wrong, or missing where one is needed.
    Sum,
    /// No such verb.
    Verb,
    /// The arguments do not fit the verb.
    Args,
    /// No such setting.
    Name,
    /// A number out of its range.
    Range,
    /// Not while a run goes on.
    Busy,
    /// The robot does not know that it is at the start.
    Place,
    /// There is no turn list.
    NoList,
    /// There is no upload with this number, or it has a gap.
    NoUpload,
    /// The number belongs to the list that is kept.
    Id,
    /// The list is longer than the robot can keep.
    Full,
    /// The list's length or checksum is not what was announced.
    Crc,
    /// What was written could not be read back.
    Store,
}

impl Code {
    /// Every code.
    pub const ALL: [Self; 15] = [
        Self::Long,
        Self::Byte,
        Self::Sum,
        Self::Verb,
        Self::Args,
        Self::Name,
        Self::Range,
        Self::Busy,
        Self::Place,
        Self::NoList,
        Self::NoUpload,
        Self::Id,
        Self::Full,
        Self::Crc,
        Self::Store,
    ];

    /// As the wire names it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Long => "long",
            Self::Byte => "byte",
            Self::Sum => "sum",
            Self::Verb => "verb",
            Self::Args => "args",
            Self::Name => "name",
            Self::Range => "range",
            Self::Busy => "busy",
            Self::Place => "place",
            Self::NoList => "no-list",
            Self::NoUpload => "no-upload",
            Self::Id => "id",
            Self::Full => "full",
            Self::Crc => "crc",
            Self::Store => "store",
        }
    }

    /// What the robot writes behind it, for people.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::Long => "at most 80 bytes a line",
            Self::Byte => "only bytes 20 to 7E",
            Self::Sum => "checksum wrong or missing",
            Self::Verb => "no such verb",
            Self::Args => "arguments not understood",
            Self::Name => "no such setting",
            Self::Range => "number out of range",
            Self::Busy => "a run goes on, stop it first",
            Self::Place => "put me back at the start and say place",
            Self::NoList => "there is no turn list",
            Self::NoUpload => "no such upload, begin anew",
            Self::Id => "number taken, choose another",
            Self::Full => "list too long",
            Self::Crc => "length or checksum of the list is wrong",
            Self::Store => "memory failed",
        }
    }

    /// The code with this name.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|code| code.word() == word)
    }
}
