// Starts the program, whose two files index.html names. What goes wrong meanwhile is told by rescue.js.
"use strict";
(async () => {
  const address = (link) => document.querySelector(`link[${link}]`).href;
  const program = await import(address("rel=modulepreload"));
  await program.default({ module_or_path: address("as=fetch") });
  dispatchEvent(new Event("linemaze:started"));
})();
