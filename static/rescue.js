// The screen for the worst case: the program broke, or never arrived. Plain JavaScript, so that it outlives the wasm,
// and in the language of 2018, so that it also speaks in browsers that are too old for the wasm.
"use strict";
(() => {
  const MAZE = "line-maze-lab/maze";
  const EMPTY_WASM = new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0]);
  const SANDBOXED = "The lab can’t be loaded in a sandboxed frame. Please open this page in a tab of its own.";
  const FROM_A_FILE = "Opened as a file, a browser lets no program start. In the page’s folder run "
    + "“python3 -m http.server”, then open http://localhost:8000.";
  const NO_WEBASSEMBLY = "The lab is a WebAssembly program, and this browser has WebAssembly switched off. Lockdown "
    + "Mode on an iPhone, iPad or Mac does that, and some companies’ rules. Allow it for this page, or open the page "
    + "in another browser.";
  const FORBIDDEN = "The lab is a WebAssembly program, and the server of this page forbids WebAssembly. Whoever looks "
    + "after it can add 'wasm-unsafe-eval' to script-src in its Content-Security-Policy.";
  const TOO_OLD = "This browser is too old for the lab: it does not understand the program. A newer version of it "
    + "does, or another browser.";
  const COPY_AGAIN = "Please start again. If that doesn’t help, whoever looks after this page should copy its whole "
    + "folder to the server once more.";

  const element = (id) => document.getElementById(id);
  // The app takes the first words of the page away when it's there.
  const running = () => document.readyState !== "loading" && !element("loading");
  const hasWasm = () => typeof WebAssembly === "object";
  let problem = null;
  // The maze, as long as the browser does not keep it.
  let unkept = null;

  addEventListener("linemaze:not-kept", (event) => { unkept = event.detail; });

  // The panic's own words come first, and the trap that follows adds nothing.
  addEventListener("linemaze:panic", (event) => broke(String(event.detail)));
  addEventListener("error", (event) => {
    const missing = event.target instanceof HTMLScriptElement;
    if (event instanceof ErrorEvent) failed(event.error, event.message);
    else if (missing && !running()) lost(null, `${nameOf(event.target.src)} is missing`);
  }, true);
  addEventListener("unhandledrejection", (event) => failed(event.reason, String(event.reason)));

  // Strangers' errors, such as an extension's, are no reason to stop a lab that runs.
  function failed(error, message) {
    const trap = hasWasm() && error instanceof WebAssembly.RuntimeError;
    if (trap) broke(message);
    else if (!running()) lost(error, message);
  }

  function broke(message) {
    rescue(message, "Please start again; if it breaks at the same place, send us the report.");
  }

  function lost(error, message) {
    if (problem === null) diagnosis(error).then((text) => rescue(message, text));
  }

  // Why the program is not here, as far as the page can find out.
  async function diagnosis(error) {
    if (location.protocol === "file:") return FROM_A_FILE;
    if (!hasWasm()) return NO_WEBASSEMBLY;
    if (origin === "null") return SANDBOXED;
    for (const link of document.querySelectorAll("link[rel=modulepreload], link[as=fetch]")) {
      const wrong = await wrongWith(link);
      if (wrong) return wrong;
    }
    try {
      new WebAssembly.Module(EMPTY_WASM);
    } catch (refused) {
      return FORBIDDEN;
    }
    const misunderstood = error instanceof WebAssembly.CompileError || error instanceof SyntaxError;
    return misunderstood ? TOO_OLD : incomplete("", "Please check the connection, then start again.");
  }

  // One of the program's files is asked for again, to see what the server says.
  async function wrongWith(link) {
    const name = nameOf(link.href);
    let answer, start;
    try {
      answer = await fetch(link.href);
      start = new Uint8Array(await answer.arrayBuffer()).subarray(0, 4);
    } catch (unreachable) {
      return incomplete("", "Please check the connection, then start again.");
    }
    const type = String(answer.headers.get("Content-Type"));
    if (!answer.ok) return incomplete(`: the server answers ${answer.status} for ${name}`, COPY_AGAIN);
    if (link.as === "fetch" && String(start) !== String(EMPTY_WASM.subarray(0, 4))) {
      return incomplete(`: what the server sends as ${name} is something else (${type})`, COPY_AGAIN);
    }
    if (link.as !== "fetch" && !type.includes("javascript")) {
      return `The server says that ${name} is “${type}”, so the browser does not run it. Whoever looks after this `
        + "page can tell the server that .js files are text/javascript.";
    }
    return null;
  }

  function incomplete(what, cure) {
    return `The lab did not arrive completely${what}. ${cure}`;
  }

  function nameOf(address) {
    return address.split("/").pop();
  }

  function rescue(message, text) {
    if (problem !== null) return;
    problem = message;
    if (document.readyState === "loading") addEventListener("DOMContentLoaded", () => show(text));
    else show(text);
  }

  function show(text) {
    const screen = element("rescue");
    for (const other of document.body.children) other.inert = other !== screen;
    if (element("loading")) element("loading").remove();
    element("rescue-text").textContent = text + promise();
    element("rescue-detail").textContent = `${problem} · version ${version()}`;
    element("rescue-restart").addEventListener("click", restart);
    element("rescue-download").addEventListener("click", download);
    element("rescue-report").addEventListener("click", copyReport);
    document.body.append(screen);
    screen.hidden = false;
    element("rescue-title").focus();
  }

  function restart() {
    // The address may hold the very maze that broke.
    try {
      history.replaceState(null, "", location.pathname + location.search);
    } catch (fixed) { /* A file's address can't be changed; loading it again is what's left. */ }
    location.reload();
  }

  // Nothing is promised that is not so.
  function promise() {
    if (unkept !== null) return " This browser does not keep your maze: download it before you start again.";
    return kept() ? " Your maze is safe: it is kept in this browser." : "";
  }

  function kept() {
    try {
      return localStorage.getItem(MAZE);
    } catch (forbidden) {
      return null;
    }
  }

  function download() {
    const maze = unkept === null ? kept() : unkept;
    if (!maze) return say("This browser has kept no maze.");
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([maze], { type: "text/plain" }));
    link.download = "my.maze";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    say("Saved as my.maze; Draw › Open reads it again.");
  }

  async function copyReport() {
    const report = [problem, `version ${version()}`, location.origin + location.pathname, navigator.userAgent].join("\n");
    try {
      await navigator.clipboard.writeText(report);
      say("The report is in the clipboard.");
    } catch (refused) {
      element("rescue-detail").textContent = report;
      getSelection().selectAllChildren(element("rescue-detail"));
      say("This browser did not allow copying. The report is marked below: copy it with Ctrl+C or ⌘C.");
    }
  }

  function say(text) {
    element("rescue-status").textContent = text;
  }

  function version() {
    return document.querySelector('meta[name="version"]').content;
  }
})();
