//! Choosing the port that the lab is served on.

use std::net::{Ipv4Addr, TcpListener};

use anyhow::{Context, Result, anyhow};

use crate::shell::Cure;

const FIRST: u16 = 8080;
const TRIES: u16 = 100;

/// The port that was asked for, or the first free one from 8080 up.
pub(crate) fn choose(wanted: Option<u16>) -> Result<u16> {
    choose_among(wanted, |port| TcpListener::bind((Ipv4Addr::LOCALHOST, port)).is_ok())
}

fn choose_among(wanted: Option<u16>, is_free: impl Fn(u16) -> bool) -> Result<u16> {
    let first_free = || (FIRST..FIRST + TRIES).find(|&port| is_free(port));
    match wanted {
        Some(port) if is_free(port) => Ok(port),
        Some(port) => {
            let other = first_free().map_or_else(String::new, |free| format!(" Port {free} is free."));
            Err(anyhow!("port {port} is taken, perhaps by another `cargo xtask serve`"))
                .cure(&format!("stop that one, or leave --port away and a free one is found.{other}"))
        }
        None => first_free().with_context(|| {
            format!("no port from {FIRST} to {} is free; name one with --port", FIRST + TRIES - 1)
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_free_port_is_taken() {
        assert_eq!(choose_among(None, |_| true).unwrap(), 8080);
        assert_eq!(choose_among(None, |port| port > 8082).unwrap(), 8083);
        assert_eq!(choose_among(Some(9000), |_| true).unwrap(), 9000);
    }

    #[test]
    fn a_taken_port_is_refused_with_the_cure() {
        let error = choose_among(Some(8080), |port| port != 8080).unwrap_err().to_string();
        assert!(error.starts_with("port 8080 is taken"), "{error}");
        assert!(error.ends_with("Port 8081 is free."), "{error}");
        assert!(choose_among(None, |_| false).unwrap_err().to_string().contains("name one with --port"));
    }

    #[test]
    fn a_port_in_use_is_seen() {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).unwrap();
        assert!(choose(Some(listener.local_addr().unwrap().port())).is_err());
    }
}
