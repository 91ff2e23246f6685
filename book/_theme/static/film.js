"use strict";

// Films: figures with a slider for time.  The frames of a film are put together
// on a canvas from the tiles of a sheet; book/_ext/drawings.py gives the list
// of tiles with the page, and figures/draw/sheet.h says what is in it.  The
// canvas takes the place of the still when the film is first used.

const SECONDS = 4;      // that a film takes to play

// The tiles of all frames: for each a list of indices into the sheet.
function readFrames(sheet) {
  const across = Math.ceil(sheet.width / sheet.tile);
  const places = across * Math.ceil(sheet.height / sheet.tile);
  let tiles = new Int32Array(places).fill(-1);
  return sheet.frames.map(runs => {
    tiles = tiles.slice();
    let place = 0;
    for (const run of runs ? runs.split(" ") : []) {
      const [skip, count, first] = run.split(",").map(n => parseInt(n, 36));
      place += skip;
      for (let i = 0; i < count; i++) tiles[place++] = first + i;
    }
    return tiles;
  });
}

class Film {
  constructor(figure) {
    this.figure = figure;
    this.controls = figure.querySelector(".film-controls");
    this.button = this.controls.querySelector("button");
    this.slider = this.controls.querySelector("input");
    this.sheets = JSON.parse(
      this.controls.querySelector("script").textContent);
    this.last = Number(this.slider.max);
    this.button.addEventListener("click", () => this.toggle());
    this.slider.addEventListener("input", () => {
      this.pause();
      this.show(Number(this.slider.value));
    });
    this.slider.addEventListener("keydown", event => {
      if (event.key !== " ") return;
      event.preventDefault();
      this.toggle();
    });
    this.announce(Number(this.slider.value));
    this.controls.hidden = false;
  }

  announce(frame) {
    this.slider.setAttribute("aria-valuetext",
                             `t = ${(frame / this.last).toFixed(2)}`);
  }

  // The sheet of the theme, with its picture, which is loaded only once.
  load() {
    const sheet = this.sheets[isDark() ? "dark" : "light"];
    if (!sheet.ready) {
      sheet.picture = new Image();
      sheet.picture.src = sheet.sheet;
      sheet.tiles = readFrames(sheet);
      sheet.ready = sheet.picture.decode().then(() => sheet);
    }
    return sheet.ready;
  }

  canvasFor(sheet) {
    if (!this.canvas) {
      this.canvas = document.createElement("canvas");
      this.canvas.setAttribute("role", "img");
      const still = this.figure.querySelector("img");
      this.canvas.setAttribute("aria-label", still.alt);
      if (still.naturalWidth)   // as high as the still, so that nothing moves
        this.canvas.style.aspectRatio =
          `${still.naturalWidth} / ${still.naturalHeight}`;
      this.canvas.width = sheet.width;
      this.canvas.height = sheet.height;
      this.controls.before(this.canvas);
      this.figure.classList.add("used");
    }
    return this.canvas;
  }

  paint(sheet, frame) {
    const context = this.canvasFor(sheet).getContext("2d", {alpha: false});
    context.imageSmoothingEnabled = false;
    const {tile, columns, picture} = sheet;
    const across = Math.ceil(sheet.width / tile);
    const tiles = sheet.tiles[frame];
    for (let i = 0; i < tiles.length; i++) {
      if (this.sheet === sheet && this.tiles[i] === tiles[i]) continue;
      context.drawImage(
        picture,
        tiles[i] % columns * tile, Math.floor(tiles[i] / columns) * tile,
        tile, tile,
        i % across * tile, Math.floor(i / across) * tile, tile, tile);
    }
    this.sheet = sheet;
    this.tiles = tiles;
    this.canvas.dataset.frame = frame;
  }

  // Show a frame; where the sheet is still to come, the last that was wanted.
  async show(frame) {
    this.frame = frame;
    this.slider.value = frame;
    this.announce(frame);
    const sheet = await this.load();
    this.paint(sheet, this.frame);
  }

  async play() {
    this.playing = true;
    this.figure.classList.add("playing");
    this.button.setAttribute("aria-label", "Pause");
    let frame = Number(this.slider.value);
    if (frame === this.last) frame = 0;
    await this.show(frame);
    let begin;
    const step = now => {
      if (!this.playing) return;
      begin ??= now - frame / this.last * SECONDS * 1000;
      const passed = (now - begin) / 1000 / SECONDS;
      this.show(Math.min(this.last, Math.floor(passed * this.last)));
      if (passed < 1) requestAnimationFrame(step);
      else this.pause();
    };
    requestAnimationFrame(step);
  }

  pause() {
    this.playing = false;
    this.figure.classList.remove("playing");
    this.button.setAttribute("aria-label", "Play");
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  changeTheme() {
    if (this.canvas) this.show(this.frame);
  }
}

const films = [...document.querySelectorAll(".film")].map(f => new Film(f));
const coming = new IntersectionObserver(entries => {
  for (const {target, isIntersecting} of entries)
    if (isIntersecting) films.find(f => f.figure === target).load();
}, {rootMargin: "50%"});

for (const film of films) coming.observe(film.figure);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () =>
  films.forEach(film => film.changeTheme()));
new MutationObserver(() => films.forEach(film => film.changeTheme()))
  .observe(document.documentElement, {attributeFilter: ["data-theme"]});
