//! Choosing the port that the lab is served on.

use std::io::ErrorKind;
use std::net::{Ipv4Addr, TcpListener};

use anyhow::{Context, Result, bail};

const FIRST: u16 = 8080;
const TRIES: u16 = 100;

/// Takes the port that was asked for, or the first free one from 8080 up.
pub(crate) fn take(wanted: Option<u16>) -> Result<TcpListener> {
    take_among(wanted, |port| match TcpListener::bind((Ipv4Addr::LOCALHOST, port)) {
        Ok(listener) => Ok(Some(listener)),
        Err(error) if error.kind() == ErrorKind::AddrInUse => Ok(None),
        // Windows and containers keep some ports for themselves.
        Err(_) if wanted.is_none() => Ok(None),
        Err(error) => {
            Err(error).with_context(|| format!("port {port} can't be used; name another with --port"))
        }
    })
}

fn take_among<T>(wanted: Option<u16>, mut take: impl FnMut(u16) -> Result<Option<T>>) -> Result<T> {
    if let Some(port) = wanted {
        return match take(port)? {
            Some(taken) => Ok(taken),
            None => bail!(
                "port {port} is taken, perhaps by another `cargo xtask serve`; stop that one, or leave --port away \
                 and a free one is found"
            ),
        };
    }
    for port in FIRST..FIRST + TRIES {
        if let Some(taken) = take(port)? {
            return Ok(taken);
        }
    }
    bail!("no port from {FIRST} to {} is free; name one with --port", FIRST + TRIES - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn among(wanted: Option<u16>, is_free: impl Fn(u16) -> bool) -> Result<u16> {
        take_among(wanted, |port| Ok(is_free(port).then_some(port)))
    }

    #[test]
    fn the_first_free_port_is_taken() {
        assert_eq!(among(None, |_| true).unwrap(), 8080);
        assert_eq!(among(None, |port| port > 8082).unwrap(), 8083);
        assert_eq!(among(Some(9000), |_| true).unwrap(), 9000);
    }

    #[test]
    fn a_taken_port_is_refused_with_the_cure() {
        let error = among(Some(8080), |port| port != 8080).unwrap_err().to_string();
        assert!(error.starts_with("port 8080 is taken") && error.contains("leave --port away"), "{error}");
        assert!(among(None, |_| false).unwrap_err().to_string().contains("name one with --port"));
    }

    #[test]
    fn a_port_in_use_is_seen() {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        assert!(take(Some(listener.local_addr().unwrap().port())).is_err());
    }
}
