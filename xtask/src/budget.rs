//! How much a first visit may fetch, compressed as web servers do it.

use std::path::Path;

use anyhow::{Context, Result, bail, ensure};

use crate::page::Page;
use crate::shell::{Shell, printed};
use crate::split::press;

/// What the page fetches before it can be used.
const FIRST: usize = 250_000;

#[derive(Debug)]
struct Weight {
    address: String,
    raw: usize,
    brotli: usize,
}

/// Prints what every file in the folder weighs; an error past a budget.
pub(crate) fn check(shell: &Shell, folder: &Path) -> Result<()> {
    let weights = weigh(shell, folder)?;
    let totals = totals(&weights);
    print!("{}", table(&weights));
    println!("first load {} kB of {} allowed,", kb(totals.first), FIRST / 1000);
    println!("of it wasm {} kB;", kb(totals.wasm));
    println!("what follows when it is needed, or in the background, {} kB", kb(totals.later));
    complaint(&totals).map_or(Ok(()), |complaint| bail!("the page got too heavy: {complaint}"))
}

fn weigh(shell: &Shell, folder: &Path) -> Result<Vec<Weight>> {
    let files = Page::read(folder)?.0;
    let mut scale = press(shell, "weigh");
    let printed = printed(scale.args(files.keys().map(|address| folder.join(address))))?;
    let weights = printed.lines().map(|line| line.parse().context("press prints a number a line"));
    let weights = weights.collect::<Result<Vec<usize>>>()?;
    ensure!(weights.len() == files.len(), "press weighed {} of {} files", weights.len(), files.len());
    let weight = |((address, content), brotli): ((String, Vec<u8>), usize)| Weight {
        address,
        raw: content.len(),
        brotli,
    };
    Ok(files.into_iter().zip(weights).map(weight).collect())
}

#[derive(Debug, PartialEq, Eq)]
struct Totals {
    first: usize,
    wasm: usize,
    later: usize,
}

fn totals(weights: &[Weight]) -> Totals {
    let sum = |which: fn(&str) -> bool| {
        weights.iter().filter(|weight| which(&weight.address)).map(|weight| weight.brotli).sum()
    };
    Totals { first: sum(|file| !is_later(file)), wasm: sum(is_main), later: sum(is_later) }
}

/// The wasm that the page starts with.
fn is_main(file: &str) -> bool {
    file.ends_with("_bg.wasm")
}

/// The other parts of the wasm come when they are needed, and the offline worker starts behind the page.
fn is_later(file: &str) -> bool {
    file.ends_with(".wasm") && !is_main(file) || file == "sw.js"
}

fn complaint(totals: &Totals) -> Option<String> {
    let over = totals.first.checked_sub(FIRST).filter(|&over| over > 0)?;
    Some(format!("{} kB at first, {} more than allowed", kb(totals.first), kb(over)))
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
        let first = |first| Totals { first, wasm: 0, later: 1 << 30 };
        assert_eq!(complaint(&first(FIRST)), None);
        let heavy = format!("{} kB at first, 1.5 more than allowed", kb(FIRST + 1500));
        assert_eq!(complaint(&first(FIRST + 1500)), Some(heavy));
        assert!(complaint(&first(FIRST + 1)).is_some());
    }

    #[test]
    fn parts_that_come_later_do_not_count_at_first() {
        let weight = |address: &str, brotli| Weight { address: address.into(), raw: 0, brotli };
        let page = [
            weight("a_bg.wasm", 5),
            weight("a.js", 2),
            weight("draw-0123.wasm", 10),
            weight("sw.js", 20),
            weight("a.css", 100),
        ];
        assert_eq!(totals(&page), Totals { first: 107, wasm: 5, later: 30 });
    }
}
