// The screen for the worst case: the program broke, or never arrived. Plain JavaScript, so that it outlives the wasm.
"use strict";
(() => {
  const MAZE = "line-maze-lab/maze";
  const LOST = "The lab did not arrive completely. Your maze is safe, it is kept in this browser. "
    + "Please check the connection, then start again.";
  const FROM_A_FILE = "Opened as a file, a browser lets no program start. In the page’s folder run "
    + "“python3 -m http.server”, then open http://localhost:8000.";

  const element = (id) => document.getElementById(id);
  // The app takes the first words of the page away when it's there.
  const running = () => document.readyState !== "loading" && !element("loading");
  let problem = null;

  // The panic's own words come first, and the trap that follows adds nothing.
  addEventListener("linemaze:panic", (event) => rescue(String(event.detail)));
  addEventListener("error", (event) => {
    const missing = event.target instanceof HTMLScriptElement;
    if (event instanceof ErrorEvent) broken(event.error, event.message);
    else if (missing && !running()) lost("a script is missing");
  }, true);
  addEventListener("unhandledrejection", (event) => broken(event.reason, String(event.reason)));

  // Strangers' errors, such as an extension's, are no reason to stop a lab that runs.
  function broken(error, message) {
    const ours = error instanceof WebAssembly.RuntimeError;
    if (ours) rescue(message);
    else if (!running()) lost(message);
  }

  function lost(message) {
    rescue(message, location.protocol === "file:" ? FROM_A_FILE : LOST);
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
    element("loading")?.remove();
    if (text) element("rescue-text").textContent = text;
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
    } catch { /* A file's address can't be changed; loading it again is what's left. */ }
    location.reload();
  }

  function download() {
    const maze = keptMaze();
    if (!maze) return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([maze], { type: "text/plain" }));
    link.download = "my.maze";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
    say("Saved as my.maze; Draw › Open reads it again.");
  }

  function keptMaze() {
    try {
      const maze = localStorage.getItem(MAZE);
      if (!maze) say("This browser has kept no maze yet.");
      return maze;
    } catch {
      say("This browser keeps nothing for this page, so there’s no maze to download.");
      return null;
    }
  }

  async function copyReport() {
    const report = [problem, `version ${version()}`, location.origin + location.pathname, navigator.userAgent].join("\n");
    try {
      await navigator.clipboard.writeText(report);
      say("The report is in the clipboard.");
    } catch {
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
