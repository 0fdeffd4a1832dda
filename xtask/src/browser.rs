//! A browser for tests, with its driver, and Node.js for the tools that are written for it.

use std::env;
use std::ffi::OsString;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use anyhow::{Context, Result, bail};

use crate::shell::{Cure, Shell, run};
use crate::tools::say;

/// Where the browser and its driver are.
#[derive(Debug, Clone)]
pub(crate) struct Browser {
    pub(crate) chromium: PathBuf,
    pub(crate) driver: PathBuf,
}

/// Finds Chromium and chromedriver; on Debian it installs them if need be.
pub(crate) fn browser(shell: &Shell) -> Result<Browser> {
    if let Some(browser) = find(shell) {
        return Ok(browser);
    }
    apt_install(shell, "Chromium, for the tests in a browser", &["chromium", "chromium-driver"]).cure(
        "install Chromium or Chrome, and the chromedriver of the same version, so that `chromedriver --version` \
         answers; or set CHROMIUM and CHROMEDRIVER to their paths",
    )?;
    find(shell).context("Chromium was installed, but isn't on the PATH")
}

/// What mocks a serial port, and shows a browser's window where there is no screen.
const SERIAL: [&str; 7] =
    ["umockdev", "libumockdev-dev", "gir1.2-umockdev-1.0", "python3-gi", "xvfb", "openbox", "xdotool"];

/// Whether the browser's serial ports can be tried; on Debian what that needs is installed. It must not be
/// left out on CI.
pub(crate) fn serial(shell: &Shell) -> Result<bool> {
    let there = |name: &&str| shell.find(name).is_some();
    if ["umockdev-run", "Xvfb", "openbox", "xdotool"].iter().all(there) {
        return Ok(true);
    }
    match apt_install(shell, "a mocked serial port, for the tests of Connect", &SERIAL) {
        Ok(()) => Ok(true),
        Err(error) if env::var_os("CI").is_some_and(|value| value == "true") => {
            Err(error).cure("on CI the tests of the serial port must not be left out: run them on Debian")
        }
        Err(error) => {
            say(&format!("LEFT OUT: the tests of the real serial port, which need umockdev ({error})"));
            Ok(false)
        }
    }
}

/// Sees to it that node and npm are there.
pub(crate) fn node(shell: &Shell) -> Result<()> {
    if shell.find("node").is_some() && shell.find("npm").is_some() {
        return Ok(());
    }
    apt_install(shell, "Node.js, for tools of the build", &["nodejs", "npm"])
        .cure("install Node.js 18 or newer with npm; https://nodejs.org has it for every system")
}

fn find(shell: &Shell) -> Option<Browser> {
    let chromium = named("CHROMIUM").or_else(|| {
        ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"]
            .iter()
            .find_map(|name| shell.find(name))
    })?;
    let driver = named("CHROMEDRIVER").or_else(|| shell.find("chromedriver"))?;
    Some(Browser { chromium, driver })
}

fn named(variable: &str) -> Option<PathBuf> {
    env::var_os(variable).filter(|path: &OsString| !path.is_empty()).map(PathBuf::from)
}

fn apt_install(shell: &Shell, what: &str, packages: &[&str]) -> Result<()> {
    if shell.find("apt-get").is_none() {
        bail!("there's no {}, and without Debian's apt-get xtask can't install that", packages.join(" or "));
    }
    say(&format!("Installing {what} (some minutes)"));
    run(apt_get(shell)?.args(["update", "-qq"])).cure("is this computer connected to the internet?")?;
    run(apt_get(shell)?.args(["install", "-y", "-qq", "--no-install-recommends"]).args(packages))
}

/// `apt-get` with the rights to install.
fn apt_get(shell: &Shell) -> Result<Command> {
    let mut command = if shell.ask("id", &["-u"]).as_deref() == Some("0") {
        shell.command("apt-get")
    } else if shell.ask("sudo", &["-n", "true"]).is_some() {
        let mut sudo = shell.command("sudo");
        sudo.args(["-n", "apt-get"]);
        sudo
    } else {
        bail!("installing needs the rights of root, and sudo wants a password");
    };
    command.env("DEBIAN_FRONTEND", "noninteractive").stdin(Stdio::null()).stdout(Stdio::null());
    Ok(command)
}
