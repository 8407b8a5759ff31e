// A tetrahedral mesh that can be turned and cut open.
'use strict';

// The corners of the face opposite each corner, counter-clockwise seen from outside.
const kFaces = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
const kStart = {yaw: -0.55, pitch: 0.4, zoom: 1};
const kFlat = Math.cos(10 * Math.PI / 180);

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) =>
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
function unit(a) {
  const length = Math.sqrt(dot(a, a)) || 1;
  return a.map(x => x / length);
}

// The mesh in a cube of side 2 around the origin: points, tets, and for each tet, four numbers each,
// the tets beyond its faces (-1: none).
class Solid {
  constructor({points, tets}) {
    const steps = new Uint32Array(decodeBytes(points.xyz).buffer);
    const middle = points.size.map(size => size / 2), half = Math.max(...middle) || 1;
    this.points = Float64Array.from(steps, (step, i) => (step - middle[i % 3]) / half);
    this.reach = 0;
    for (let i = 0; i < this.points.length; i += 3)
      this.reach = Math.max(this.reach, Math.hypot(...this.points.subarray(i, i + 3)));
    this.tets = new Uint32Array(decodeBytes(tets.data).buffer);
    this.count = tets.count;
    this.beyond = this.neighbours();
    this.normals = new Float64Array(12 * this.count);
    this.middles = new Float64Array(3 * this.count);
    this.centres = new Float64Array(3 * this.count);
    this.isFlat = new Uint8Array(this.count);
    for (let t = 0; t < this.count; ++t) this.measure(t);
  }

  point(v) { return [this.points[3 * v], this.points[3 * v + 1], this.points[3 * v + 2]]; }
  corners(t) { return [0, 1, 2, 3].map(i => this.point(this.tets[4 * t + i])); }
  face(f) { return kFaces[f % 4].map(i => this.tets[f - f % 4 + i]); }

  // Pairs up faces: those with one lowest corner hang on a chain.
  neighbours() {
    const faces = 4 * this.count, beyond = new Int32Array(faces).fill(-1);
    const latest = new Int32Array(this.points.length / 3).fill(-1), before = new Int32Array(faces);
    const middle = new Uint32Array(faces), highest = new Uint32Array(faces);
    for (let f = 0; f < faces; ++f) {
      const [i, j, k] = this.face(f), low = Math.min(i, j, k);
      highest[f] = Math.max(i, j, k);
      middle[f] = i ^ j ^ k ^ low ^ highest[f];
      let twin = latest[low];
      while (twin >= 0 && !(middle[twin] === middle[f] && highest[twin] === highest[f])) twin = before[twin];
      before[f] = latest[low];
      latest[low] = f;
      if (twin < 0) continue;
      beyond[f] = twin >> 2;
      beyond[twin] = f >> 2;
    }
    return beyond;
  }

  // Normals of the faces, middle, circumcentre (for the order of depth), and whether it is flat.
  measure(t) {
    const p = this.corners(t);
    const [u, v, w] = [1, 2, 3].map(i => minus(p[i], p[0]));
    const vw = cross(v, w), wu = cross(w, u), uv = cross(u, v), volume = 2 * dot(u, vw);
    const [uu, vv, ww] = [dot(u, u), dot(v, v), dot(w, w)];
    for (let k = 0; k < 3; ++k) {
      const middle = (p[0][k] + p[1][k] + p[2][k] + p[3][k]) / 4;
      const centre = p[0][k] + (uu * vw[k] + vv * wu[k] + ww * uv[k]) / volume;
      this.middles[3 * t + k] = middle;
      this.centres[3 * t + k] = Number.isFinite(centre) ? centre : middle;
    }
    const normals = kFaces.map(([a, b, c]) => unit(cross(minus(p[b], p[a]), minus(p[c], p[a]))));
    this.normals.set(normals.flat(), 12 * t);
    for (let i = 0; i < 4; ++i)
      for (let j = 0; j < i; ++j)
        if (Math.abs(dot(normals[i], normals[j])) > kFlat) this.isFlat[t] = 1;
  }

  // The faces of what is left when a share is cut away, from the side of an axis (sign 1 or -1).
  exposed(axis, sign, share) {
    let low = Infinity, high = -Infinity;
    for (let i = axis; i < this.points.length; i += 3) {
      low = Math.min(low, sign * this.points[i]);
      high = Math.max(high, sign * this.points[i]);
    }
    const plane = high - share * (high - low);
    const isKept = t => share === 0 || sign * this.middles[3 * t + axis] <= plane;
    const faces = [];
    for (let t = 0; t < this.count; ++t) {
      if (!isKept(t)) continue;
      for (let f = 4 * t; f < 4 * t + 4; ++f) {
        const u = this.beyond[f];
        if (u < 0 || !isKept(u)) faces.push(f);
      }
    }
    return Uint32Array.from(faces);
  }
}

// Three unit vectors: to the right, up, and to the viewer.
function screenOf({yaw, pitch}) {
  const viewer = [Math.cos(pitch) * Math.cos(yaw), Math.cos(pitch) * Math.sin(yaw), Math.sin(pitch)];
  const right = [-Math.sin(yaw), Math.cos(yaw), 0];
  return {right, up: cross(viewer, right), viewer};
}

// A colour of the style, #rrggbb, in 32 shades from dark to light.
function shadesOf(name) {
  const base = [1, 3, 5].map(i => parseInt(colourOf(name).slice(i, i + 2), 16));
  const shade = (part, k) => Math.round(part * (0.5 + 0.5 * k / 31) + (255 - part) * 0.4 * k / 31);
  return Array.from({length: 32}, (_, k) => `rgb(${base.map(part => shade(part, k)).join(' ')})`);
}

class SolidPage {
  constructor(data) {
    this.data = data;
    this.canvas = document.getElementById('solid');
    this.view = {...kStart};
    if (data.tets) this.solid = new Solid(data);
    this.connect();
    if (this.solid) this.describeColours();
    else this.canvas.setAttribute('aria-label', this.notice());
    this.cut();
  }

  value(id) { return Number(document.getElementById(id).value); }
  isOn(id) { return document.getElementById(id).checked; }

  connect() {
    const on = (id, event, action) => document.getElementById(id).addEventListener(event, action);
    for (const id of ['cut', 'axis']) on(id, 'input', () => this.cut());
    for (const id of ['edges', 'flat']) on(id, 'input', () => this.redraw());
    const actions = {
      'turn-left': () => this.turn(-0.2, 0), 'turn-right': () => this.turn(0.2, 0),
      'turn-up': () => this.turn(0, 0.2), 'turn-down': () => this.turn(0, -0.2),
      'zoom-in': () => this.zoom(1.25), 'zoom-out': () => this.zoom(0.8),
      'view-reset': () => this.reset(), 'save': () => this.save(),
    };
    for (const [id, action] of Object.entries(actions)) on(id, 'click', action);
    this.connectKeys(actions);
    this.connectPointer();
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
    for (const [event, theme] of [['beforeprint', 'paper'], ['afterprint', '']])
      window.addEventListener(event, () => {
        document.documentElement.dataset.theme = theme;
        this.draw();
      });
  }

  connectKeys(actions) {
    const names = {
      ArrowLeft: 'turn-left', ArrowRight: 'turn-right', ArrowUp: 'turn-up', ArrowDown: 'turn-down',
      '+': 'zoom-in', '=': 'zoom-in', '-': 'zoom-out', '0': 'view-reset',
    };
    this.canvas.addEventListener('keydown', event => {
      if (!names[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      actions[names[event.key]]();
    });
  }

  // The wheel zooms only in a picture that was clicked, so that the page can be scrolled.
  connectPointer() {
    let last = null;
    this.canvas.addEventListener('pointerdown', event => {
      last = [event.clientX, event.clientY];
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener('pointermove', event => {
      if (!last) return;
      this.turn((last[0] - event.clientX) / 150, (event.clientY - last[1]) / 150);
      last = [event.clientX, event.clientY];
    });
    for (const end of ['pointerup', 'pointercancel'])
      this.canvas.addEventListener(end, () => last = null);
    this.canvas.addEventListener('wheel', event => {
      if (document.activeElement !== this.canvas && !event.ctrlKey) return;
      event.preventDefault();
      const pixels = event.deltaY * (event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1);
      this.zoom(2 ** (-pixels / 300));
    }, {passive: false});
  }

  turn(yaw, pitch) {
    this.view.yaw += yaw;
    this.view.pitch = Math.min(Math.PI / 2, Math.max(-Math.PI / 2, this.view.pitch + pitch));
    this.redraw();
  }
  zoom(factor) {
    this.view.zoom = Math.min(50, Math.max(0.2, this.view.zoom * factor));
    this.redraw();
  }
  reset() {
    this.view = {...kStart};
    this.redraw();
  }

  cut() {
    const axis = this.value('axis'), share = this.value('cut') / 100;
    document.getElementById('cut-text').textContent = `${this.value('cut')} %`;
    if (this.solid) {
      this.faces = this.solid.exposed(axis % 3, axis < 3 ? 1 : -1, share);
      const cutFaces = this.faces.filter(f => this.solid.beyond[f] >= 0).length;
      const words = `${count(this.faces.length - cutFaces)} faces of the boundary, ${count(cutFaces)} of the cut`;
      document.getElementById('shown').textContent = words;
      this.canvas.setAttribute('aria-label', `The mesh, ${this.value('cut')} percent cut away: ${words}. `
          + 'Arrow keys turn it, plus and minus zoom, 0 resets the view.');
    }
    this.redraw();
  }

  describeColours() {
    const item = (name, words) => element('span', {},
        element('span', {class: 'face', style: `background: var(--${name})`}), words);
    const flat = this.solid.isFlat.reduce((sum, one) => sum + one, 0);
    document.getElementById('legend').append(
        item('series-0', 'the boundary'), item('series-3', 'tets at the cut'),
        item('below-10', `of them, if marked, flat ones: of ${count(flat)} with a dihedral angle `
            + 'below 10° or above 170°'),
        element('span', {class: 'screen-only'}, 'Drag to turn; click, then scroll to zoom.'));
  }

  redraw() {
    if (this.pending) return;
    this.pending = requestAnimationFrame(() => { this.pending = 0; this.draw(); });
  }

  // What is seen, from back to front: the places of the corners and a colour for each face.
  scene() {
    const {solid} = this, {right, up, viewer} = screenOf(this.view);
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    const scale = this.view.zoom * Math.min(width, height) / 2 / (solid.reach || 1);
    const light = unit([0, 1, 2].map(k => viewer[k] + 0.6 * up[k] - 0.5 * right[k]));
    const along = (a, array, i) => a[0] * array[i] + a[1] * array[i + 1] + a[2] * array[i + 2];
    const seen = this.faces.filter(f => along(viewer, solid.normals, 3 * f) > 0);
    const nearness = new Float64Array(seen.length);
    seen.forEach((f, k) => { nearness[k] = along(viewer, solid.centres, 3 * (f >> 2)); });
    const order = Uint32Array.from(seen, (_, k) => k).sort((a, b) => nearness[a] - nearness[b] || a - b);
    const shades = ['series-0', 'series-3', 'below-10'].map(shadesOf), markFlat = this.isOn('flat');
    return Array.from(order, k => {
      const f = seen[k], isCut = solid.beyond[f] >= 0;
      const kind = isCut && markFlat && solid.isFlat[f >> 2] ? 2 : isCut ? 1 : 0;
      const shade = Math.round(31 * Math.max(0, along(light, solid.normals, 3 * f)));
      const places = solid.face(f).map(v => [width / 2 + scale * along(right, solid.points, 3 * v),
                                             height / 2 - scale * along(up, solid.points, 3 * v)]);
      return {places, colour: shades[kind][shade]};
    });
  }

  // Faces without edges are stroked in their own colour, so that no seam shows between them.
  draw() {
    const ratio = Math.max(1, window.devicePixelRatio || 1);
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (width === 0) return;
    this.canvas.width = width * ratio;
    this.canvas.height = height * ratio;
    const context = this.canvas.getContext('2d');
    context.scale(ratio, ratio);
    if (!this.solid) return this.drawNotice(context, width, height);
    context.lineJoin = 'round';
    context.lineWidth = this.isOn('edges') ? this.lineWidth() : 0.5;
    const ink = this.edgeColour();
    for (const {places, colour} of this.scene()) {
      context.beginPath();
      context.moveTo(...places[0]);
      context.lineTo(...places[1]);
      context.lineTo(...places[2]);
      context.closePath();
      context.fillStyle = colour;
      context.strokeStyle = ink ?? colour;
      context.fill();
      context.stroke();
    }
  }

  lineWidth() { return this.faces.length > 20000 ? 0.25 : this.faces.length > 5000 ? 0.4 : 0.6; }
  edgeColour() { return this.isOn('edges') ? '#12202b' : null; }

  notice() { return `${count(this.data.count)} tets: too many to draw here`; }

  drawNotice(context, width, height) {
    context.fillStyle = colourOf('soft');
    context.font = '15px system-ui, sans-serif';
    context.textAlign = 'center';
    context.fillText(this.notice(), width / 2, height / 2);
  }

  save() {
    if (!this.solid) return;
    const ink = this.edgeColour(), line = ink ? this.lineWidth() : 0.5;
    const paths = this.scene().map(({places, colour}) =>
        `<path fill="${colour}"${ink ? '' : ` stroke="${colour}"`} d="M` +
        places.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join('L') + 'Z"/>');
    const {clientWidth: width, clientHeight: height} = this.canvas;
    saveFile('mesh.svg', `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}">\n` +
        `<g stroke="${ink ?? 'none'}" stroke-width="${line}" stroke-linejoin="round">\n${paths.join('\n')}\n</g></svg>\n`);
  }
}

new SolidPage(JSON.parse(document.getElementById('data').textContent));
