// A worker for the league: it loads the page's own program, which sees that it has no window and serves.
"use strict";
onmessage = async (first) => {
  onmessage = null;
  try {
    const page = await import(first.data.script);
    await page.default({ module_or_path: first.data.wasm });
  } catch (error) {
    // The page hears of it and does the work itself.
    setTimeout(() => {
      throw error;
    });
  }
};
