// Decodes the data block: coordinates once, each level's nodes and triangles as variable-length
// differences. report_data.cpp writes it and says how.
'use strict';

function decodeBytes(base64) {
  return Uint8Array.from(atob(base64), c => c.charCodeAt(0));
}

// Unsigned integers of 7 bits a byte, lowest first; the high bit says that more follow.
class IntegerReader {
  constructor(base64) { this.bytes = decodeBytes(base64); this.position = 0; }
  unsigned() {
    let value = 0;
    for (let scale = 1; ; scale *= 128) {
      const byte = this.bytes[this.position++];
      value += (byte & 127) * scale;
      if (byte < 128) return value;
    }
  }
  signed() {
    const value = this.unsigned();
    return value % 2 ? -(value + 1) / 2 : value / 2;
  }
}

function decodePoints({count, origin, step, xy}) {
  const view = new DataView(decodeBytes(xy).buffer);
  const x = new Float64Array(count), y = new Float64Array(count);
  for (let i = 0; i < count; ++i) {
    x[i] = origin[0] + step * view.getUint32(8 * i, true);
    y[i] = origin[1] + step * view.getUint32(8 * i + 4, true);
  }
  return {x, y};
}

function decodeNodes({count, data}) {
  const reader = new IntegerReader(data);
  const result = new Uint32Array(count);
  for (let i = 0, last = -1; i < count; ++i) result[i] = last += 1 + reader.unsigned();
  return result;
}

function decodeTriangles({count, data}, nodes) {
  const reader = new IntegerReader(data);
  const result = new Uint32Array(3 * count);
  for (let t = 0, a = 0; t < count; ++t) {
    a += reader.unsigned();
    const b = a + reader.unsigned();
    const c = b + reader.signed();
    result.set([nodes[a], nodes[b], nodes[c]], 3 * t);
  }
  return result;
}

function decodeSegments({count, data}, nodes) {
  const reader = new IntegerReader(data);
  const result = new Uint32Array(2 * count);
  for (let s = 0, a = 0; s < count; ++s) {
    a += reader.signed();
    result.set([nodes[a], nodes[a + reader.signed()]], 2 * s);
  }
  return result;
}

function smallestAnglesDeg(triangles, {x, y}) {
  const corner = (p, q, r) => {
    const ux = x[q] - x[p], uy = y[q] - y[p], vx = x[r] - x[p], vy = y[r] - y[p];
    return Math.atan2(Math.abs(ux * vy - uy * vx), ux * vx + uy * vy) * 180 / Math.PI;
  };
  return Float32Array.from({length: triangles.length / 3}, (_, t) => {
    const [a, b, c] = triangles.subarray(3 * t, 3 * t + 3);
    return Math.min(corner(a, b, c), corner(b, c, a), corner(c, a, b));
  });
}

function decodeGeometry(encoded, points) {
  const nodes = decodeNodes(encoded.nodes);
  const triangles = decodeTriangles(encoded.triangles, nodes);
  return {
    nodes, triangles,
    segments: decodeSegments(encoded.segments, nodes),
    angles: smallestAnglesDeg(triangles, points),
  };
}

// Replaces the encoded points by arrays, and each level's number of a geometry by the geometry, or
// null where the level is too large to be drawn.
function decodeReport(data) {
  const points = decodePoints(data.points);
  const geometries = data.geometries.map(encoded => decodeGeometry(encoded, points));
  const methods = data.methods.map(method => ({
    ...method,
    levels: method.levels.map(
        level => ({...level, geometry: level.geometry === null ? null : geometries[level.geometry]})),
  }));
  return {...data, points, methods};
}

// For every point the length of its shortest edge in the geometry; infinity where it has none.
function localSizes({triangles}, {x, y}) {
  const sizes = new Float64Array(x.length).fill(Infinity);
  for (let i = 0; i < triangles.length; ++i) {
    const a = triangles[i], b = triangles[i % 3 === 2 ? i - 2 : i + 1];
    const length = Math.hypot(x[a] - x[b], y[a] - y[b]);
    if (length < sizes[a]) sizes[a] = length;
    if (length < sizes[b]) sizes[b] = length;
  }
  return sizes;
}

// The nodes of the finest drawn level in ten equal groups by local size, the finest first.
function sizeTenths(report) {
  const finest = report.methods[0].levels.find(level => level.geometry);
  if (!finest) return [];
  const sizes = localSizes(finest.geometry, report.points);
  const order = Array.from(finest.geometry.nodes).filter(node => sizes[node] < Infinity)
      .sort((a, b) => sizes[a] - sizes[b] || a - b);
  return Array.from({length: 10}, (_, k) => {
    const members = order.slice(Math.floor(k * order.length / 10),
                                Math.floor((k + 1) * order.length / 10));
    return {members, size: sizes[members[members.length >> 1]]};
  }).filter(tenth => tenth.members.length > 0);
}

// The share of each tenth's members that are nodes of the geometry.
function sharesKept(tenths, geometry) {
  const kept = new Set(geometry.nodes);
  return tenths.map(({members}) => members.filter(node => kept.has(node)).length / members.length);
}
