// The theme before the first paint: the one chosen in this browser, otherwise the system's, also when that changes.
"use strict";
(() => {
  const dark = matchMedia("(prefers-color-scheme: dark)");

  function chosen() {
    try {
      return localStorage.getItem("line-maze-lab/theme");
    } catch {
      return null;
    }
  }

  function apply() {
    const theme = chosen();
    const known = theme === "light" || theme === "dark";
    document.documentElement.dataset.theme = known ? theme : dark.matches ? "dark" : "light";
  }

  apply();
  dark.addEventListener("change", apply);
  // Another tab chose.
  addEventListener("storage", apply);
})();
