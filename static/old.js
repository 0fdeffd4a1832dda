// Only browsers without modules run this. They understand neither the lab nor rescue.js: plain words, in the language
// of 2009.
document.getElementById("loading").textContent =
  "This browser is too old for Line Maze Lab. Please open this page in a newer one.";
