// Keeps every file of one version of the page, so that it opens without a network.
// `cargo xtask dist` fills in the next two lines. Empty, as `cargo xtask serve` gives it out, it removes a worker
// that an earlier page left at this address, so that nobody looks at yesterday's build.
"use strict";
const VERSION = "";
const FILES = [];

const PREFIX = `line-maze-lab ${new URL(registration.scope).pathname} `;
const CACHE = PREFIX + VERSION;
const HOME = new URL("index.html", registration.scope).href;
const KEPT = new Set(FILES.map((file) => new URL(file, registration.scope).href));

addEventListener("install", (event) => {
  event.waitUntil(VERSION ? keepAll() : skipWaiting());
});

addEventListener("activate", (event) => {
  event.waitUntil(VERSION ? removeOthers().then(() => clients.claim()) : leave());
});

// The page asks when a person wants the new version; until then the old one stays whole.
addEventListener("message", (event) => {
  if (event.data?.type === "use-new-version") skipWaiting();
});

addEventListener("fetch", (event) => {
  const { request } = event;
  const url = new URL(request.url);
  if (!VERSION || request.method !== "GET" || url.origin !== location.origin) return;
  const address = url.origin + url.pathname;
  const file = address === registration.scope ? HOME : address;
  if (KEPT.has(file)) {
    event.respondWith(kept(file, request));
  } else if (request.mode === "navigate" && address.startsWith(registration.scope)) {
    // An address that isn't ours may exist on the server; without a network, home is better than an error.
    event.respondWith(fetch(request).catch(() => Response.redirect(registration.scope)));
  }
});

async function keepAll() {
  const cache = await caches.open(CACHE);
  // The browser's own cache may hold a mixture of versions: ask the server.
  await cache.addAll([...KEPT].map((file) => new Request(file, { cache: "no-cache" })));
}

async function kept(file, request) {
  const cache = await caches.open(CACHE);
  return (await cache.match(file, { ignoreVary: true })) ?? fetch(request);
}

async function removeOthers() {
  const names = await caches.keys();
  await Promise.all(names.filter((name) => name.startsWith(PREFIX) && name !== CACHE).map((name) => caches.delete(name)));
}

async function leave() {
  await removeOthers();
  await registration.unregister();
  for (const client of await clients.matchAll({ type: "window" })) client.navigate(client.url);
}
