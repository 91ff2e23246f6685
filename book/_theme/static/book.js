"use strict";

// Light or dark: as the system says, until the reader says otherwise.
const root = document.documentElement;
const stored = (() => {
  try { return localStorage.getItem("theme"); } catch { return null; }
})();
if (stored) root.dataset.theme = stored;

function isDark() {
  return root.dataset.theme
    ? root.dataset.theme === "dark"
    : matchMedia("(prefers-color-scheme: dark)").matches;
}

function switchTheme() {
  root.dataset.theme = isDark() ? "light" : "dark";
  try { localStorage.setItem("theme", root.dataset.theme); } catch { }
}

function closeMenu(event) {
  const menu = document.querySelector(".menu");
  const away = event.type === "click" && !menu.contains(event.target);
  if (menu.open && (away || event.key === "Escape")) {
    menu.open = false;
    if (!away) menu.querySelector("summary").focus();
  }
}

// A figure leads to its picture alone, which can be as large as one likes.
function linkPictures() {
  for (const image of document.querySelectorAll(".drawing img")) {
    const link = document.createElement("a");
    link.href = image.src;
    link.className = image.className;
    image.replaceWith(link);
    link.append(image);
  }
}

// The section that is being read is marked in the rail.
function markSection() {
  let current = null;
  for (const link of document.querySelectorAll(".rail li li > a")) {
    const section = document.getElementById(link.hash.slice(1));
    if (section && section.getBoundingClientRect().top < 150) current = link;
    link.removeAttribute("aria-current");
  }
  if (current) current.setAttribute("aria-current", "true");
}

addEventListener("DOMContentLoaded", () => {
  const button = document.querySelector("button.theme");
  button.hidden = false;
  button.addEventListener("click", switchTheme);
  linkPictures();
  document.addEventListener("click", closeMenu);
  document.addEventListener("keydown", closeMenu);
  if (document.querySelector(".rail")) {
    markSection();
    addEventListener("scroll", markSection, {passive: true});
  }
});
