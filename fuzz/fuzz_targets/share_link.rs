//! Any text as the payload of a link: refused in words, or exactly what would be written. Every run also
//! puts a fitting length and checksum on the bytes, which chance alone never would.
#![no_main]

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use crc::{CRC_32_ISO_HDLC, Crc};
use libfuzzer_sys::fuzz_target;
use line_maze_lab::share::{decode, encode};

fuzz_target!(|bytes: &[u8]| {
    if let Ok(text) = core::str::from_utf8(bytes) {
        check(text);
    }
    check(&sealed(1, bytes));
    check(&sealed(2, bytes));
});

fn check(payload: &str) {
    match decode(payload) {
        Err(error) => assert!(!error.to_string().is_empty()),
        Ok(shared) => assert_eq!(encode(&shared).as_deref(), Ok(payload)),
    }
}

/// The bytes as the body of a payload of this version.
fn sealed(version: u8, body: &[u8]) -> String {
    let length = u16::try_from(body.len() + 7).unwrap_or(u16::MAX);
    let mut bytes = vec![version];
    bytes.extend(length.to_be_bytes());
    bytes.extend(body);
    let checksum = Crc::<u32>::new(&CRC_32_ISO_HDLC).checksum(&bytes);
    bytes.extend(checksum.to_be_bytes());
    URL_SAFE_NO_PAD.encode(bytes)
}
