//! How much a first visit may fetch, compressed as web servers do it.

use std::io::Write;
use std::path::Path;

use anyhow::{Result, bail};

use crate::dist;

/// A first visit fetches every file of the page: the service worker keeps all of them. This is what the page
/// weighs now; it may get lighter, not heavier. Lower the numbers with it until they meet the goals.
const ALL: usize = 315_000;
const WASM: usize = 290_000;
/// What a first visit may weigh in the end.
const GOAL_ALL: usize = 250_000;
const GOAL_WASM: usize = 200_000;

#[derive(Debug)]
struct Weight {
    address: String,
    raw: usize,
    brotli: usize,
}

/// Prints what every file weighs; an error past a budget.
pub(crate) fn check(folder: &Path) -> Result<()> {
    let weights = dist::files(folder)?
        .into_iter()
        .map(|(address, content)| Ok(Weight { address, raw: content.len(), brotli: brotli(&content)? }))
        .collect::<Result<Vec<_>>>()?;
    let (all, wasm) = totals(&weights);
    print!("{}", table(&weights));
    println!(
        "{:>9}   {:>8}   of {} kB allowed, wasm {} of {}",
        "",
        kb(all),
        ALL / 1000,
        kb(wasm),
        WASM / 1000
    );
    let to_go = all.saturating_sub(GOAL_ALL).max(wasm.saturating_sub(GOAL_WASM));
    if to_go > 0 {
        println!("the goal is {} kB, wasm {}: {} kB to go", GOAL_ALL / 1000, GOAL_WASM / 1000, kb(to_go));
    }
    let complaints = complaints(all, wasm);
    if !complaints.is_empty() {
        bail!("the page got too heavy: {}", complaints.join("; "));
    }
    Ok(())
}

fn brotli(content: &[u8]) -> Result<usize> {
    let mut compressor = brotli::CompressorWriter::new(Vec::new(), 1 << 16, 11, 22);
    compressor.write_all(content)?;
    Ok(compressor.into_inner().len())
}

fn totals(weights: &[Weight]) -> (usize, usize) {
    let all = weights.iter().map(|weight| weight.brotli).sum();
    let wasm =
        weights.iter().filter(|weight| weight.address.ends_with(".wasm")).map(|weight| weight.brotli).sum();
    (all, wasm)
}

fn complaints(all: usize, wasm: usize) -> Vec<String> {
    [("in all", all, ALL), ("of wasm", wasm, WASM)]
        .into_iter()
        .filter(|(_, weight, budget)| weight > budget)
        .map(|(what, weight, budget)| {
            format!("{} kB {what}, {} more than allowed", kb(weight), kb(weight - budget))
        })
        .collect()
}

fn table(weights: &[Weight]) -> String {
    let row =
        |weight: &Weight| format!("{:>9}   {:>8}   {}\n", kb(weight.raw), kb(weight.brotli), weight.address);
    let head = format!("{:>9}   {:>8}\n", "kB", "brotli");
    std::iter::once(head).chain(weights.iter().map(row)).collect()
}

fn kb(bytes: usize) -> String {
    format!("{}.{}", bytes / 1000, bytes % 1000 / 100)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn up_to_the_budget_is_fine_and_a_byte_more_is_not() {
        assert!(complaints(ALL, WASM).is_empty());
        assert_eq!(complaints(ALL + 1, WASM).len(), 1);
        let heavy = format!("{} kB of wasm, 1.5 more than allowed", kb(WASM + 1500));
        assert_eq!(complaints(ALL, WASM + 1500), [heavy]);
        assert_eq!(complaints(ALL + 1, WASM + 1).len(), 2);
    }

    #[test]
    fn wasm_counts_in_both_totals() {
        let weight = |address: &str, brotli| Weight { address: address.into(), raw: 0, brotli };
        assert_eq!(totals(&[weight("a_bg.wasm", 5), weight("a.js", 2)]), (7, 5));
    }

    #[test]
    fn repetition_compresses() {
        assert!(brotli(&[b'a'; 10_000]).unwrap() < 100);
    }
}
