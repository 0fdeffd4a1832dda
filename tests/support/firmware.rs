//! A sketch as people write one: it answers `hi`, refuses the rest, and has one slip.
#![allow(dead_code, unreachable_pub)]

/// What it does wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slip {
    /// Nothing that `hi` shows.
    None,
    /// It ends its lines with CR alone.
    CrOnly,
    /// Its lines have no checksum.
    NoSum,
    /// Checksums in lower-case hex.
    LowerCase,
    /// The XOR of the bytes, as NMEA has it.
    Xor,
    /// A checksum of four digits.
    FourDigits,
    /// Two spaces between fields.
    Spaces,
    /// Another number in the answer than was asked.
    OtherNumber,
    /// It sends back what it hears.
    Echo,
    /// It prints what its sensors see, whatever it is asked.
    Sketch,
    /// It speaks at another rate.
    Noise,
    /// Not a word.
    Mute,
}

/// The sketch, byte by byte.
pub struct Firmware {
    pub slip: Slip,
    line: Vec<u8>,
    said: Vec<u8>,
    printed: u32,
}

impl Firmware {
    pub fn new(slip: Slip) -> Self {
        Self { slip, line: Vec::new(), said: Vec::new(), printed: 0 }
    }

    /// Takes bytes.
    pub fn hear(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            if self.slip == Slip::Echo {
                self.said.push(byte);
            }
            if byte != b'\n' {
                self.line.push(byte);
                continue;
            }
            let line = String::from_utf8_lossy(&std::mem::take(&mut self.line)).into_owned();
            self.obey(line.trim());
        }
    }

    /// What it says now.
    pub fn speak(&mut self) -> Vec<u8> {
        if self.slip == Slip::Sketch {
            self.printed += 1;
            if self.printed.is_multiple_of(20) {
                self.said.extend(format!("Left: {} Right: 201\r\n", self.printed % 90 + 10).bytes());
            }
        }
        std::mem::take(&mut self.said)
    }

    fn obey(&mut self, line: &str) {
        let body = line.split('*').next().unwrap_or_default();
        if body.is_empty() || matches!(self.slip, Slip::Echo | Slip::Sketch | Slip::Mute) {
            return;
        }
        let mut number = body.split('#').nth(1).unwrap_or("-").to_owned();
        if self.slip == Slip::OtherNumber {
            number = "99".to_owned();
        }
        if body.starts_with("hi") {
            self.say("ready 1 my uno 30 400");
            self.say(&format!("ok #{number}"));
        } else {
            self.say(&format!("err #{number} verb no"));
        }
    }

    fn say(&mut self, body: &str) {
        let body = if self.slip == Slip::Spaces { body.replace(' ', "  ") } else { body.to_owned() };
        let sum = crc8(body.as_bytes());
        let xor = body.bytes().fold(0, |sum, byte| sum ^ byte);
        let line = match self.slip {
            Slip::NoSum => format!("{body}\r\n"),
            Slip::LowerCase => format!("{body}*{sum:02x}\r\n"),
            Slip::Xor => format!("{body}*{xor:02X}\r\n"),
            Slip::FourDigits => format!("{body}*{sum:04X}\r\n"),
            Slip::CrOnly => format!("{body}*{sum:02X}\r"),
            _ => format!("{body}*{sum:02X}\r\n"),
        };
        let garble = |byte: u8| if self.slip == Slip::Noise { byte.rotate_left(3) ^ 0x9C } else { byte };
        self.said.extend(line.bytes().map(garble));
    }
}

/// As PROTOCOL.md tells it, bit by bit.
fn crc8(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0, |sum, byte| {
        (0..8).fold(sum ^ byte, |sum, _| if sum & 0x80 != 0 { sum << 1 ^ 7 } else { sum << 1 })
    })
}
