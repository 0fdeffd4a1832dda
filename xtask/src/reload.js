// Only in the page that `cargo xtask serve` shows: hears of newer pages, and of builds that failed.
"use strict";
(() => {
  const shown = { ...document.currentScript.dataset };
  const ID = "xtask-complaint";

  const news = new EventSource("xtask-news");
  news.addEventListener("message", (event) => {
    const { content, style, complaint } = JSON.parse(event.data);
    if (complaint) console.error(`The page could not be built anew.\n${complaint}`);
    show(complaint);
    if (content !== shown.content) location.reload();
    else if (style !== shown.style) restyle(style);
    shown.style = style;
  });

  function restyle(edition) {
    for (const link of document.querySelectorAll('link[rel="stylesheet"]')) {
      link.href = `${link.href.split("?")[0]}?${edition}`;
    }
  }

  function show(complaint) {
    document.getElementById(ID)?.remove();
    if (!complaint) return;
    const box = document.createElement("pre");
    box.id = ID;
    box.role = "alert";
    box.textContent = `The page could not be built anew; this is the one before.\n\n${complaint}`;
    box.style.cssText = "position: fixed; inset: auto 0 0; max-height: 50vh; overflow: auto; margin: 0; padding: 1rem;"
      + "z-index: 99; background: #2b1114; color: #ffd9d6; font: 13px/1.5 monospace; white-space: pre-wrap";
    document.body.append(box);
  }
})();
