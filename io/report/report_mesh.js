// The pictures of the levels: canvases that share one view.
'use strict';

// Where all pictures look: the centre, and how many units of length the narrower side shows.
class View {
  constructor(report) {
    this.listeners = [];
    this.whole = boxOf(report.points, 0);
    this.show(this.whole);
  }
  show({x, y, width}) {
    Object.assign(this, {x, y, width});
    this.listeners.forEach(listener => listener());
  }
  move(dx, dy) { this.show({x: this.x + dx, y: this.y + dy, width: this.width}); }
  // Zooms so that the point (x, y) stays where it is on the screen.
  zoom(factor, x = this.x, y = this.y) {
    const width = Math.min(Math.max(this.width * factor, this.whole.width * 1e-8),
                           this.whole.width * 4);
    const applied = width / this.width;
    this.show({x: x + (this.x - x) * applied, y: y + (this.y - y) * applied, width});
  }
}

// The box of all points but a share `trim` at each end of both axes, a little enlarged.
function boxOf({x, y}, trim) {
  const range = values => {
    const sorted = Float64Array.from(values).sort();
    const cut = Math.floor(trim * sorted.length);
    return [sorted[cut] ?? 0, sorted[sorted.length - 1 - cut] ?? 1];
  };
  const [left, right] = range(x), [bottom, top] = range(y);
  return {x: (left + right) / 2, y: (bottom + top) / 2,
          width: 1.06 * Math.max(right - left, top - bottom) || 1};
}

// Around the shortest edge, as wide as needed to show a twentieth of the nodes.
function finestView(tenths, {x, y}) {
  if (tenths.length === 0) return null;
  const centre = tenths[0].members[0];
  const all = tenths.flatMap(tenth => tenth.members);
  const reach = all.map(p => Math.max(Math.abs(x[p] - x[centre]), Math.abs(y[p] - y[centre])))
      .sort((a, b) => a - b)[Math.floor(all.length / 20)];
  return {x: x[centre], y: y[centre], width: 2 * reach || 1};
}

// Maps the plane to the pixels of a canvas.
class Frame {
  constructor(view, width, height) {
    this.scale = Math.min(width, height) / view.width;
    Object.assign(this, {view, width, height});
  }
  x(x) { return this.width / 2 + (x - this.view.x) * this.scale; }
  y(y) { return this.height / 2 - (y - this.view.y) * this.scale; }
  shows(x, y) { return x >= 0 && x <= this.width && y >= 0 && y <= this.height; }
}

const angleClass = angle => angle <= 10 ? 'below-10' : angle <= 20 ? 'below-20' : 'fine';

// What the frame shows of a geometry: pixel coordinates by point, and lists of points: faces by
// class of smallest angle, edges, boundary; `tiny` are the bad faces that are too small to be seen.
function describe(geometry, points, frame) {
  const {triangles, segments, angles} = geometry;
  const px = new Float32Array(points.x.length), py = new Float32Array(points.x.length);
  for (const p of geometry.nodes) {
    px[p] = frame.x(points.x[p]);
    py[p] = frame.y(points.y[p]);
  }
  const scene = {px, py, fine: [], 'below-20': [], 'below-10': [], tiny: [], edges: [], outline: []};
  const hidden = (a, b, c) =>
      Math.max(px[a], px[b], px[c]) < 0 || Math.min(px[a], px[b], px[c]) > frame.width ||
      Math.max(py[a], py[b], py[c]) < 0 || Math.min(py[a], py[b], py[c]) > frame.height;
  const extent = values => Math.max(...values) - Math.min(...values);
  for (let t = 0; t < angles.length; ++t) {
    const a = triangles[3 * t], b = triangles[3 * t + 1], c = triangles[3 * t + 2];
    if (hidden(a, b, c)) continue;
    scene[angleClass(angles[t])].push(a, b, c);
    // Two triangles run through an inner edge in opposite ways; boundary edges are in the outline.
    for (const [p, q] of [[a, b], [b, c], [c, a]]) if (p < q) scene.edges.push(p, q);
    if (angles[t] <= 10 && extent([px[a], px[b], px[c]]) + extent([py[a], py[b], py[c]]) < 24)
      scene.tiny.push([(px[a] + px[b] + px[c]) / 3, (py[a] + py[b] + py[c]) / 3]);
  }
  for (let s = 0; s < segments.length; s += 2)
    if (!hidden(segments[s], segments[s + 1], segments[s])) scene.outline.push(segments[s], segments[s + 1]);
  return scene;
}

function keptInFrame(next, points, frame) {
  return Array.from(next.nodes, p => [frame.x(points.x[p]), frame.y(points.y[p])])
      .filter(([x, y]) => frame.shows(x, y));
}

const colourOf = name => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();

class MeshPanel {
  constructor(report, view, k) {
    Object.assign(this, {report, view, k, method: report.methods[k], level: 0, showKept: false});
    this.canvas = element('canvas', {tabindex: 0, role: 'img'});
    this.caption = element('p');
    const download = element('button', {type: 'button'}, 'Save as SVG');
    download.addEventListener('click', () => this.save());
    this.figure = element('figure', {},
        element('figcaption', {},
            element('div', {class: 'head'},
                element('h3', {}, methodMark(k), methodName(this.method)), download),
            this.caption),
        this.canvas);
    view.listeners.push(() => this.redraw());
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
    listenToPointer(this.canvas, this);
    listenToKeys(this.canvas, view);
  }

  show(level, showKept) {
    Object.assign(this, {level, showKept});
    this.caption.textContent = levelCaption(this.method, level);
    this.canvas.setAttribute('aria-label', `Mesh, ${methodName(this.method)}, ${this.caption.textContent}. `
        + 'Arrow keys move, plus and minus zoom, 0 shows the whole.');
    this.redraw();
  }

  frame() { return new Frame(this.view, this.canvas.clientWidth, this.canvas.clientHeight); }
  geometry() { return this.method.levels[this.level].geometry; }
  next() { return this.showKept ? this.method.levels[this.level + 1]?.geometry : null; }

  redraw() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => { this.pending = 0; this.draw(); });
  }

  draw() {
    const frame = this.frame(), ratio = Math.max(2, window.devicePixelRatio || 1);
    if (frame.width === 0) return;
    this.canvas.width = frame.width * ratio;
    this.canvas.height = frame.height * ratio;
    const context = this.canvas.getContext('2d');
    context.scale(ratio, ratio);
    context.lineJoin = 'round';
    if (!this.geometry()) return drawNotice(context, frame, this.method.levels[this.level]);
    const scene = describe(this.geometry(), this.report.points, frame);
    for (const layer of layers(scene)) paint(context, scene, layer);
    for (const centre of scene.tiny) paintRing(context, centre);
    if (this.next()) paintDots(context, keptInFrame(this.next(), this.report.points, frame), this.k);
  }

  save() {
    if (!this.geometry()) return;
    const scene = describe(this.geometry(), this.report.points, this.frame());
    const dots = this.next() ? keptInFrame(this.next(), this.report.points, this.frame()) : [];
    saveFile(`${this.method.method}_level_${this.level}.svg`, sceneSvg(scene, dots, this.frame(), this.k));
  }
}

// What is painted in which way, from back to front. Many edges get thin lines.
function layers(scene) {
  const edges = scene.edges.length / 2, line = edges > 20000 ? 0.35 : edges > 5000 ? 0.5 : 0.8;
  return [
    {kind: 'fine', corners: 3, colour: 'domain', line: 0.5},
    {kind: 'below-20', corners: 3, colour: 'below-20', line: 0.5},
    {kind: 'below-10', corners: 3, colour: 'below-10', line: 0.5},
    {kind: 'edges', corners: 2, colour: 'mesh', line},
    {kind: 'outline', corners: 2, colour: 'outline', line: 1.5},
  ];
}

// Faces are filled and stroked, so that no seam shows between them.
function paint(context, scene, {kind, corners, colour, line}) {
  const {px, py, [kind]: points} = scene;
  context.beginPath();
  for (let i = 0; i < points.length; i += corners) {
    context.moveTo(px[points[i]], py[points[i]]);
    for (let k = 1; k < corners; ++k) context.lineTo(px[points[i + k]], py[points[i + k]]);
    if (corners > 2) context.closePath();
  }
  context.lineWidth = line;
  context.strokeStyle = context.fillStyle = colourOf(colour);
  if (corners > 2) context.fill();
  context.stroke();
}

// A ring around a triangle that is too small to be seen.
function paintRing(context, [x, y]) {
  context.beginPath();
  context.arc(x, y, 5, 0, 2 * Math.PI);
  context.lineWidth = 1.8;
  context.strokeStyle = colourOf('below-10');
  context.stroke();
}

function paintDots(context, dots, k) {
  context.fillStyle = colourOf('series-' + k % 4);
  for (const [x, y] of dots) {
    context.beginPath();
    context.arc(x, y, dotRadius(dots), 0, 2 * Math.PI);
    context.fill();
  }
}

const dotRadius = dots => dots.length > 3000 ? 1.3 : dots.length > 500 ? 2.2 : 3.5;

function drawNotice(context, frame, level) {
  context.fillStyle = colourOf('soft');
  context.font = '15px system-ui, sans-serif';
  context.textAlign = 'center';
  context.fillText(`${count(level.statistics.nodes)} nodes: too many to draw here`,
                   frame.width / 2, frame.height / 2);
}

function layerSvg(scene, {kind, corners, colour, line}) {
  const {px, py, [kind]: points} = scene;
  let path = '';
  for (let i = 0; i < points.length; ++i)
    path += (i % corners ? 'L' : 'M') + px[points[i]].toFixed(2) + ' ' + py[points[i]].toFixed(2)
        + (corners > 2 && i % corners === corners - 1 ? 'Z' : '');
  return `<path d="${path}" fill="${corners > 2 ? colourOf(colour) : 'none'}" stroke="${colourOf(colour)}" `
      + `stroke-width="${line}" stroke-linejoin="round"/>`;
}

function circleSvg([x, y], radius, paint) {
  return `<circle cx="${x.toFixed(2)}" cy="${y.toFixed(2)}" r="${radius}" ${paint}/>`;
}

function sceneSvg(scene, dots, {width, height}, k) {
  const parts = [
    ...layers(scene).map(layer => layerSvg(scene, layer)),
    ...scene.tiny.map(at => circleSvg(at, 5, `fill="none" stroke="${colourOf('below-10')}" stroke-width="1.8"`)),
    ...dots.map(at => circleSvg(at, dotRadius(dots), `fill="${colourOf('series-' + k % 4)}"`)),
  ];
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}">\n${parts.join('\n')}\n</svg>\n`;
}

function saveFile(name, text) {
  const url = URL.createObjectURL(new Blob([text], {type: 'image/svg+xml'}));
  element('a', {href: url, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(url), 1000);
}

function listenToPointer(canvas, panel) {
  let last = null;
  canvas.addEventListener('pointerdown', event => {
    last = [event.clientX, event.clientY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener('pointermove', event => {
    if (!last) return;
    const {scale} = panel.frame();
    panel.view.move((last[0] - event.clientX) / scale, (event.clientY - last[1]) / scale);
    last = [event.clientX, event.clientY];
  });
  for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => last = null);
  // The wheel zooms only in a picture that was clicked, so that the page can be scrolled.
  canvas.addEventListener('wheel', event => {
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    const frame = panel.frame(), box = canvas.getBoundingClientRect();
    const x = panel.view.x + (event.clientX - box.left - frame.width / 2) / frame.scale;
    const y = panel.view.y - (event.clientY - box.top - frame.height / 2) / frame.scale;
    const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1);
    panel.view.zoom(2 ** (pixels / 300), x, y);
  }, {passive: false});
}

function listenToKeys(canvas, view) {
  const actions = {
    ArrowLeft: () => view.move(-view.width / 10, 0), ArrowRight: () => view.move(view.width / 10, 0),
    ArrowUp: () => view.move(0, view.width / 10), ArrowDown: () => view.move(0, -view.width / 10),
    '+': () => view.zoom(0.7), '=': () => view.zoom(0.7), '-': () => view.zoom(1 / 0.7),
    '0': () => view.show(view.whole),
  };
  canvas.addEventListener('keydown', event => {
    if (!actions[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    actions[event.key]();
  });
}
