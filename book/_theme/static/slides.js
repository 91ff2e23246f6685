"use strict";

// A deck: one slide at a time.  Without this script the slides are below each
// other, and on paper each is a page.

function isDark() {     // for film.js
  return false;
}

const root = document.documentElement;
let slides = [];
let current = 0;

function number(slide) {
  return slides.indexOf(slide);
}

function show(index) {
  current = Math.max(0, Math.min(slides.length - 1, index));
  slides.forEach((slide, i) => slide.classList.toggle("current",
                                                      i === current));
  root.classList.remove("overview");
  document.activeElement.blur();
  history.replaceState(null, "", "#" + slides[current].id);
}

function overview() {
  if (root.classList.toggle("overview"))
    slides[current].scrollIntoView({block: "center"});
}

function playFilm() {
  slides[current].querySelector(".film-controls button")?.click();
}

function fillScreen() {
  if (document.fullscreenElement) document.exitFullscreen();
  else root.requestFullscreen();
}

const KEYS = {
  ArrowRight: () => show(current + 1), ArrowLeft: () => show(current - 1),
  ArrowDown: () => show(current + 1), ArrowUp: () => show(current - 1),
  PageDown: () => show(current + 1), PageUp: () => show(current - 1),
  " ": event => show(current + (event.shiftKey ? -1 : 1)),
  Home: () => show(0), End: () => show(slides.length - 1),
  Escape: () => root.classList.contains("overview") && overview(),
  p: playFilm, f: fillScreen, o: overview,
};

// A slider, a button or a link that has the focus takes some keys itself.
function isTaken(event) {
  const own = {INPUT: ["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown", " ",
                       "Home", "End"], BUTTON: [" "]};
  return event.ctrlKey || event.altKey || event.metaKey
    || own[event.target.tagName]?.includes(event.key);
}

function press(event) {
  const act = KEYS[event.key];
  if (!act || isTaken(event)) return;
  event.preventDefault();
  act(event);
}

// A finger moves a slide away; in the overview a click chooses one.
let touch = null;

function lift(event) {
  const across = event.changedTouches[0].clientX - touch;
  if (Math.abs(across) > 50 && event.target.tagName !== "INPUT")
    show(current - Math.sign(across));
}

function choose(event) {
  const slide = event.target.closest(".slide");
  if (slide && root.classList.contains("overview")) show(number(slide));
}

function follow() {     // the address
  const slide = document.getElementById(location.hash.slice(1));
  show(slide ? number(slide) : 0);
}

addEventListener("DOMContentLoaded", () => {
  slides = [...document.querySelectorAll(".slide")];
  root.classList.add("live");
  follow();
  addEventListener("keydown", press);
  addEventListener("hashchange", follow);
  addEventListener("click", choose);
  addEventListener("touchstart", event => {
    touch = event.changedTouches[0].clientX;
  }, {passive: true});
  addEventListener("touchend", lift);
});
