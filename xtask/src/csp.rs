//! The Content Security Policy: the page runs only its own scripts, and talks to no one else.

use anyhow::{Context, Result, ensure};

const POLICY: &str = "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; \
    img-src 'self' data: blob:; font-src 'self'; connect-src 'self'; manifest-src 'self'; \
    worker-src 'self'; base-uri 'none'; form-action 'none'";

/// Puts the policy at the head's beginning, so that it holds for everything after it.
pub(crate) fn seal(html: &str) -> Result<String> {
    ensure!(
        !has_inline_script(html),
        "index.html has a script in itself, which the page's policy forbids; put it into a file in static/"
    );
    let (before, after) = html.split_once("<head>").context("index.html has no <head>")?;
    Ok(format!("{before}<head><meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">{after}"))
}

/// Whether a script's tag names no file.
fn has_inline_script(html: &str) -> bool {
    let tags = html.split("<script").skip(1).filter_map(|tag| tag.split('>').next());
    tags.into_iter().any(|tag| !tag.split_whitespace().any(|word| word.starts_with("src=")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_policy_comes_first_in_the_head() {
        let sealed =
            seal("<html><head><meta charset=\"utf-8\"><script src=\"x.js\"></script></head>").unwrap();
        assert!(sealed.starts_with("<html><head><meta http-equiv=\"Content-Security-Policy\""), "{sealed}");
        assert!(sealed.contains("script-src 'self' 'wasm-unsafe-eval';"), "{sealed}");
        assert!(
            sealed.ends_with("><meta charset=\"utf-8\"><script src=\"x.js\"></script></head>"),
            "{sealed}"
        );
        assert!(seal("<p>").is_err());
    }

    #[test]
    fn a_script_that_the_policy_would_stop_is_told() {
        let inline = "<head><script src=\"a.js\" defer></script><script type=\"module\">two</script></head>";
        assert!(seal(inline).unwrap_err().to_string().contains("static/"));
        assert!(seal("<head><script>one</script></head>").is_err());
        assert!(seal("<head><script defer src='b.js'></script></head>").is_ok());
    }
}
