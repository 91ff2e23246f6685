"use strict";

// search-index.js defines `sections`: [page, anchor, number, title, text], and
// `titles`, those of the pages.
const input = document.getElementById("query");
const list = document.getElementById("results");
const status = document.getElementById("found");

function count(text, word) {
  return text.toLowerCase().split(word).length - 1;
}

function score([, anchor, , title, text], words) {
  let sum = 0;
  for (const word of words) {
    const here = 20 * count(title, word) + count(text, word);
    if (here === 0) return 0;
    sum += here + (title.toLowerCase() === word ? 100 : 0);
    if (title === input.value.trim()) sum++;
  }
  return sum + (anchor ? 0 : 1);
}

// The words around the first that is found, found words marked; where only
// the title has them, how the text begins.
function excerpt(text, words) {
  const lower = text.toLowerCase();
  const places = words.map(word => lower.indexOf(word))
                      .filter(place => place >= 0);
  const first = places.length === 0 ? 0 : Math.min(...places);
  const begin = lower.lastIndexOf(" ", Math.max(0, first - 70)) + 1;
  const end = text.indexOf(" ", begin + 220);
  const part = end < 0 ? text.slice(begin) : text.slice(begin, end) + " …";
  const escaped = words.map(word => word.replace(/[^\p{L}\p{N}\s]/gu, "\\$&"));
  const line = document.createElement("p");
  for (const piece of part.split(new RegExp(`(${escaped.join("|")})`, "i"))) {
    const found = words.includes(piece.toLowerCase());
    const node = found ? document.createElement("mark") : new Text(piece);
    if (found) node.textContent = piece;
    line.append(node);
  }
  return line;
}

function item([page, anchor, number, title, text], words) {
  const link = document.createElement("a");
  link.href = `${page}.html${anchor}`;
  link.textContent = number ? `${number} ${title}` : title;
  const entry = document.createElement("li");
  entry.append(link);
  if (anchor) {
    const home = document.createElement("span");
    home.className = "home-page";
    home.textContent = titles[page];
    entry.append(" ", home);
  }
  entry.append(excerpt(text, words));
  return entry;
}

function search() {
  const words = input.value.toLowerCase().split(/\s+/).filter(word => word);
  const found = words.length === 0 ? [] : sections
    .map(section => [score(section, words), section])
    .filter(([points]) => points > 0)
    .sort(([a], [b]) => b - a);
  list.replaceChildren(...found.map(([, section]) => item(section, words)));
  status.textContent = words.length === 0 ? "" :
    found.length === 0 ? "Nothing found." :
    found.length === 1 ? "One section." : `${found.length} sections.`;
}

input.value = new URLSearchParams(location.search).get("q") || "";
input.addEventListener("input", search);
search();
