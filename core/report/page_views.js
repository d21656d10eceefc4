// Frames of one size, each with a canvas, that all show the same part of images of one size.

const zoomStep = Math.SQRT2;
const closest = 96;  // the largest size of a pixel of the image, in CSS pixels, unless a fitting one is larger
const ratio = () => window.devicePixelRatio || 1;
const spread = ([a, b]) => Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY));
const middle = ([a, b]) => ({clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2});

/** The part of the image that is shown, and how pointers move it: a drag, a wheel or two fingers in any frame. */
class Viewport {
  zoom = 1;             // 1 fits the image into its frame
  #pointers = new Map();  // those that are down, by their id: where each was last
  #dragged = 0;           // how far, in CSS pixels, since the first of them went down

  /** `canvas()` is any of those that are shown; `changed()` is called when another part is to be shown. */
  constructor({width, height, canvas, changed}) {
    Object.assign(this, {width, height, canvas, changed});
    this.center = {column: width / 2, row: height / 2};
  }

  /** How the image lies in a canvas: the size of a pixel, and where its left upper corner is, in the canvas's pixels. */
  placing() {
    const {width: across, height: down} = this.canvas();
    const scale = this.zoom * Math.min(across / this.width, down / this.height);
    return {scale, left: across / 2 - this.center.column * scale, top: down / 2 - this.center.row * scale};
  }

  /** In CSS pixels. */
  pixelSize() {
    return this.placing().scale / ratio();
  }

  clampCenter() {
    const {scale} = this.placing();
    const clamped = (center, size, shown) => (shown >= size ? size / 2 : clamp(center, shown / 2, size - shown / 2));
    this.center = {
      column: clamped(this.center.column, this.width, this.canvas().width / scale),
      row: clamped(this.center.row, this.height, this.canvas().height / scale)
    };
  }

  /** Shows the image around a place. */
  panTo(center) {
    this.center = center;
    this.clampCenter();
    this.changed();
  }

  /** Zooms so that a place of the image, in pixels and parts of them, stays where it is in the frames. */
  zoomAbout(place, factor) {
    const fitting = this.pixelSize() / this.zoom;
    const zoom = clamp(this.zoom * factor, 1, Math.max(1, closest / fitting));
    const kept = this.zoom / zoom;
    this.zoom = zoom;
    this.panTo({
      column: place.column + (this.center.column - place.column) * kept,
      row: place.row + (this.center.row - place.row) * kept
    });
  }

  fit() {
    this.zoom = 1;
    this.panTo(this.center);
  }

  /** The place of the image under a pointer. */
  placeAt(frame, event) {
    const box = frame.getBoundingClientRect();
    const {scale, left, top} = this.placing();
    return {
      column: ((event.clientX - box.left) * ratio() - left) / scale,
      row: ((event.clientY - box.top) * ratio() - top) / scale
    };
  }

  pixelAt(frame, event) {
    const place = this.placeAt(frame, event);
    const pixel = {column: Math.floor(place.column), row: Math.floor(place.row)};
    const inside = pixel.column >= 0 && pixel.column < this.width && pixel.row >= 0 && pixel.row < this.height;
    return inside ? pixel : null;
  }

  /**
   * Listens to the pointers in a frame; what happens to a control in it is the control's. `hover(pixel)` is called for the
   * pixel under a pointer, or null, `click(pixel)` for one that is clicked.
   */
  listen(frame, {hover = () => {}, click = () => {}} = {}) {
    const on = (type, listener) => frame.addEventListener(type, listener, {passive: false});
    const isControl = (event) => event.target instanceof HTMLInputElement;
    on('pointerdown', (event) => isControl(event) || this.#down(frame, event));
    on('pointermove', (event) => {
      if (this.#pointers.has(event.pointerId))
        this.#move(frame, event, hover);
      else
        hover(isControl(event) ? null : this.pixelAt(frame, event));
    });
    on('pointerup', (event) => this.#up(frame, event, click));
    on('pointercancel', (event) => this.#up(frame, event, click));
    on('pointerleave', () => hover(null));
    on('wheel', (event) => this.#wheel(frame, event, hover));
    on('dblclick', (event) => isControl(event) || this.fit());
  }

  #panBy(frame, before, after) {
    const from = this.placeAt(frame, before), to = this.placeAt(frame, after);
    this.panTo({column: this.center.column + from.column - to.column, row: this.center.row + from.row - to.row});
  }

  #pinch(frame, before, after) {
    this.zoomAbout(this.placeAt(frame, middle(before)), spread(after) / spread(before));
    this.#panBy(frame, middle(before), middle(after));
  }

  #down(frame, event) {
    if (event.button !== 0) return;
    if (this.#pointers.size === 0) this.#dragged = 0;
    this.#pointers.set(event.pointerId, event);
    frame.setPointerCapture(event.pointerId);
  }

  #move(frame, event, hover) {
    const last = this.#pointers.get(event.pointerId);
    const before = [...this.#pointers.values()];
    this.#pointers.set(event.pointerId, event);
    this.#dragged += Math.hypot(event.clientX - last.clientX, event.clientY - last.clientY);
    if (this.#dragged < 4) return;  // a hand that clicks is not quite still
    frame.closest('.views').classList.add('panning');
    if (this.#pointers.size === 1)
      this.#panBy(frame, last, event);
    else
      this.#pinch(frame, before.slice(0, 2), [...this.#pointers.values()].slice(0, 2));
    hover(this.pixelAt(frame, event));
  }

  #up(frame, event, click) {
    const wasDown = this.#pointers.delete(event.pointerId);
    frame.closest('.views').classList.remove('panning');
    const pixel = wasDown && event.type === 'pointerup' && this.#dragged < 4 && this.pixelAt(frame, event);
    if (pixel) click(pixel);
  }

  #wheel(frame, event, hover) {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    const speed = event.ctrlKey ? 0.01 : 0.0015;  // what a pinch on a touch pad says, and a wheel
    this.zoomAbout(this.placeAt(frame, event), Math.exp(-clamp(event.deltaY * lines, -240, 240) * speed));
    hover(this.pixelAt(frame, event));
  }
}

/** Gives a canvas as many pixels as the screen has in its frame. */
function fillFrame(canvas, frame) {
  const across = Math.max(1, Math.round(frame.clientWidth * ratio())),
        down = Math.max(1, Math.round(frame.clientHeight * ratio()));
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
}

/** The slider that a swipe is drawn by: its thumb is a line over the whole height. */
function makeDivider(label) {
  return make('input', {className: 'divider', type: 'range', min: 0, max: 100, step: 0.5, value: 50, ariaLabel: label});
}

/** Draws one picture left of the divider's line and another right of it. */
function drawSwipe({context, canvas}, divider, drawLeft, drawRight) {
  const thumb = 24 * ratio();
  const at = Math.round(thumb / 2 + (canvas.width - thumb) * Number(divider.value) / 100);
  for (const [drawPart, from, to] of [[drawLeft, 0, at], [drawRight, at, canvas.width]]) {
    context.save();
    context.beginPath();
    context.rect(from, 0, to - from, canvas.height);
    context.clip();
    drawPart();
    context.restore();
  }
}

/** `draw` once before the next frame, however often what is returned is called. */
function oncePerFrame(draw) {
  let requested = false;
  return () => {
    if (requested) return;
    requested = true;
    requestAnimationFrame(() => {
      requested = false;
      draw();
    });
  };
}

