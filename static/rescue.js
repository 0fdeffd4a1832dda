// The screen for the worst case: the program broke, or never arrived. Plain JavaScript, so that it outlives the wasm.
"use strict";
(() => {
  const MAZE = "line-maze-lab/maze";
  const LOST = "The lab did not arrive completely. Please check the connection, then start again.";
  const SANDBOXED = "The lab can’t be loaded in a sandboxed frame. Please open this page in a tab of its own.";
  const FROM_A_FILE = "Opened as a file, a browser lets no program start. In the page’s folder run "
    + "“python3 -m http.server”, then open http://localhost:8000.";

  const element = (id) => document.getElementById(id);
  // The app takes the first words of the page away when it's there.
  const running = () => document.readyState !== "loading" && !element("loading");
  let problem = null;
  // The maze, as long as the browser does not keep it.
  let unkept = null;

  addEventListener("linemaze:not-kept", (event) => { unkept = event.detail; });

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
    const text = location.protocol === "file:" ? FROM_A_FILE : origin === "null" ? SANDBOXED : LOST;
    rescue(message, text);
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
    element("rescue-text").textContent += promise();
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

  // Nothing is promised that is not so.
  function promise() {
    if (unkept !== null) return " This browser does not keep your maze: download it before you start again.";
    return kept() ? " Your maze is safe: it is kept in this browser." : "";
  }

  function kept() {
    try {
      return localStorage.getItem(MAZE);
    } catch {
      return null;
    }
  }

  function download() {
    const maze = unkept ?? kept();
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
