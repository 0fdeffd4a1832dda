//! Who makes the chips of boards' serial ports, by their USB ids: so that people know theirs in a list.

use alloc::string::String;

use super::page::Port;

/// A name for a port, as people know it.
#[must_use]
pub fn name(port: Port) -> &'static str {
    match port {
        Port::Demo => "Demo robot",
        Port::Serial(None) => "Serial port",
        Port::Serial(Some((0x2341 | 0x2a03, 0x0043 | 0x0001))) => "Arduino Uno",
        Port::Serial(Some((0x2341 | 0x2a03, 0x0010 | 0x0042))) => "Arduino Mega",
        Port::Serial(Some((0x2341 | 0x2a03, _))) => "Arduino",
        Port::Serial(Some((0x1a86, _))) => "CH340 board",
        Port::Serial(Some((0x0403, _))) => "FTDI adapter",
        Port::Serial(Some((0x10c4, _))) => "CP210x board",
        Port::Serial(Some((0x067b, _))) => "Prolific adapter",
        Port::Serial(Some((0x303a, _))) => "ESP32 board",
        Port::Serial(Some((0x2e8a, _))) => "Raspberry Pi Pico",
        Port::Serial(Some(_)) => "USB serial port",
    }
}

/// Its ids, as in `2341:0043`; nothing off USB.
#[must_use]
pub fn ids(port: Port) -> Option<String> {
    match port {
        Port::Serial(Some((vendor, product))) => Some(alloc::format!("{vendor:04x}:{product:04x}")),
        Port::Serial(None) | Port::Demo => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_uno_is_known() {
        let uno = Port::Serial(Some((0x2341, 0x0043)));
        assert_eq!((name(uno), ids(uno)), ("Arduino Uno", Some("2341:0043".into())));
        assert_eq!((name(Port::Serial(None)), ids(Port::Demo)), ("Serial port", None));
    }
}
