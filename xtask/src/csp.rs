//! The Content Security Policy: the page runs only the scripts it was built with, and talks to no one else.

use anyhow::{Context, Result};
use base64::prelude::{BASE64_STANDARD, Engine};
use sha2::{Digest, Sha256};

/// Puts the policy at the head's beginning, so that it holds for everything after it.
pub(crate) fn seal(html: &str) -> Result<String> {
    let (before, after) = html.split_once("<head>").context("index.html has no <head>")?;
    let policy = policy(&inline_scripts(html).iter().map(|script| hash(script)).collect::<Vec<_>>());
    Ok(format!("{before}<head><meta http-equiv=\"Content-Security-Policy\" content=\"{policy}\">{after}"))
}

fn policy(hashes: &[String]) -> String {
    let hashes: String = hashes.iter().map(|hash| format!(" '{hash}'")).collect();
    format!(
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'{hashes}; style-src 'self'; \
         img-src 'self' data: blob:; font-src 'self'; connect-src 'self'; manifest-src 'self'; \
         worker-src 'self'; base-uri 'none'; form-action 'none'"
    )
}

/// What stands between `<script…>` and `</script>` wherever the tag names no file.
fn inline_scripts(html: &str) -> Vec<&str> {
    let mut scripts = Vec::new();
    let mut rest = html;
    while let Some((_, tag)) = rest.split_once("<script") {
        let Some((attributes, body)) = tag.split_once('>') else { break };
        let (script, after) = body.split_once("</script>").unwrap_or((body, ""));
        let names_a_file = attributes.split_whitespace().any(|word| word.starts_with("src="));
        if !names_a_file {
            scripts.push(script);
        }
        rest = after;
    }
    scripts
}

fn hash(script: &str) -> String {
    format!("sha256-{}", BASE64_STANDARD.encode(Sha256::digest(script)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hashes_are_those_of_browsers() {
        // The example of the specification, Content Security Policy Level 3, section 8.
        assert_eq!(hash("alert('Hello, world.');"), "sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng=");
    }

    #[test]
    fn only_scripts_in_the_page_itself_are_hashed() {
        let html = "<script src=\"a.js\"></script><script type=\"module\">\nlet a = 1 < 2;\n</script>\
                    <script defer src='b.js'></script><script>two</script>";
        assert_eq!(inline_scripts(html), ["\nlet a = 1 < 2;\n", "two"]);
    }

    #[test]
    fn the_policy_comes_first_in_the_head() {
        let sealed = seal("<html><head><meta charset=\"utf-8\"><script>x</script></head>").unwrap();
        assert!(sealed.starts_with("<html><head><meta http-equiv=\"Content-Security-Policy\""), "{sealed}");
        assert!(sealed.contains(&format!("'wasm-unsafe-eval' '{}';", hash("x"))), "{sealed}");
        assert!(sealed.ends_with("><meta charset=\"utf-8\"><script>x</script></head>"), "{sealed}");
        assert!(seal("<p>").is_err());
    }
}
