// Works without a network after the first visit. Tells the app by events when a newer page waits:
//   linemaze:update-ready   from here: there is a newer page; the old one stays until a person wants the new one
//   linemaze:update-now     to here: a person wants it
//   linemaze:started        to here, from index.html: the program runs
// `data-offline="ready"` on the root element says that everything is kept.
"use strict";
(() => {
  const version = document.querySelector('meta[name="version"]').content;
  const served = location.protocol === "https:" || location.protocol === "http:";
  if (version === "development" || !served || !("serviceWorker" in navigator)) return;

  const workers = navigator.serviceWorker;
  let waiting = null;

  function announce(worker) {
    waiting = worker;
    dispatchEvent(new CustomEvent("linemaze:update-ready"));
  }

  function follow(worker) {
    worker.addEventListener("statechange", () => {
      // The very first worker has nothing to replace.
      if (worker.state === "installed" && workers.controller) announce(worker);
    });
  }

  async function start() {
    const registration = await workers.register("sw.js");
    if (registration.waiting && workers.controller) announce(registration.waiting);
    if (registration.installing) follow(registration.installing);
    registration.addEventListener("updatefound", () => follow(registration.installing));
    await workers.ready;
    document.documentElement.dataset.offline = "ready";
  }

  addEventListener("linemaze:update-now", () => {
    if (!waiting) return;
    workers.addEventListener("controllerchange", () => location.reload(), { once: true });
    waiting.postMessage({ type: "use-new-version" });
  });

  // Keeping a copy is a comfort: a browser that refuses, as private windows do, shows the page all the same. It
  // begins when the page is there, so as not to hold it up.
  addEventListener("linemaze:started", () => start().catch(() => {}), { once: true });
})();
