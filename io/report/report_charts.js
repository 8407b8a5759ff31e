// Line charts as SVG, and the tables.
'use strict';

const kChart = {width: 400, height: 260, left: 46, right: 12, top: 12, bottom: 40};

// A scale from [low, high] to pixels; ticks are the values to be named on the axis.
function linearScale(low, high, from, to, ticks) {
  return {at: v => from + (to - from) * (v - low) / (high - low || 1), ticks};
}

function logScale(low, high, from, to) {
  const decades = [];
  for (let v = 10 ** Math.floor(Math.log10(low)); v <= high * 1.0001; v *= 10) if (v >= low) decades.push(v);
  const inner = linearScale(Math.log10(low), Math.log10(high), from, to, decades);
  return {at: v => inner.at(Math.log10(v)), ticks: decades};
}

function seriesSvg({values, k, dashed}, x, y) {
  const colour = seriesColour(k);
  const at = values.filter(([, v]) => v !== null).map(([u, v]) => [x.at(u), y.at(v)]);
  const path = at.map(p => p.map(v => v.toFixed(1)).join(',')).join(' ');
  return `<polyline points="${path}" fill="none" stroke="${colour}" stroke-width="2" `
      + `stroke-linejoin="round" ${dashed ? 'stroke-dasharray="5 4"' : ''}/>`
      + at.map(([u, v]) => markSvg(k, u, v, colour, dashed)).join('');
}

function axesSvg({x, y, xName, nameX, nameY, anchorX = () => 'middle'}) {
  const {width, height, left, right, top, bottom} = kChart;
  const text = (u, v, anchor, words) =>
      `<text x="${u}" y="${v}" text-anchor="${anchor}" fill="var(--soft)">${words}</text>`;
  return y.ticks.map(v => `<line x1="${left}" x2="${width - right}" y1="${y.at(v)}" y2="${y.at(v)}" `
      + `stroke="var(--rule)"/>` + text(left - 6, y.at(v) + 4, 'end', nameY(v))).join('')
      + x.ticks.map((u, i) => text(x.at(u), height - bottom + 17, anchorX(i), nameX(u))).join('')
      + text((left + width - right) / 2, height - 6, 'middle', xName);
}

// chart: {series: [{values: [[x, y|null]], k, dashed}], x, y, xName, nameX, nameY, anchorX, label}
function chartSvg(chart) {
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${kChart.width} ${kChart.height}" role="img" `
      + `aria-label="${chart.label}">${axesSvg(chart)}`
      + chart.series.map(series => seriesSvg(series, chart.x, chart.y)).join('') + '</svg>';
}

const plotX = (low, high, ticks) =>
    linearScale(low, high, kChart.left + 10, kChart.width - kChart.right - 8, ticks);
const plotBottom = kChart.height - kChart.bottom;

function levelAxis(methods) {
  const last = Math.max(1, ...methods.map(method => method.levels.length - 1));
  const stride = Math.ceil((last + 1) / 12);
  const ticks = Array.from({length: last + 1}, (_, level) => level).filter(level => level % stride === 0);
  return plotX(0, last, ticks);
}

function sizeChart({methods}) {
  const nodes = methods.flatMap(method => method.levels.map(level => level.statistics.nodes));
  return {
    label: 'Nodes by level, logarithmic', x: levelAxis(methods), xName: 'level', nameX: String,
    y: logScale(Math.max(1, Math.min(...nodes) / 1.5), Math.max(...nodes) * 1.3, plotBottom, kChart.top), nameY: count,
    series: methods.map((method, k) => ({
      k, values: method.levels.map((level, l) => [l, level.statistics.nodes])})),
  };
}

function angleChart({methods}) {
  const values = (method, key) => method.levels.map((level, l) => [l, level.statistics[key]]);
  const highest = Math.max(30, ...methods.flatMap(method => method.levels.flatMap(
      ({statistics: s}) => [s.interior_min ?? 0, s.boundary_min ?? 0])));
  return {
    label: 'Smallest angle by level', x: levelAxis(methods), xName: 'level', nameX: String,
    y: linearScale(0, highest, plotBottom, kChart.top, [0, 10, 20, 30, 40, 50, 60].filter(v => v <= highest)),
    nameY: v => v + '°',
    series: methods.flatMap((method, k) => [
      {k, values: values(method, 'interior_min')},
      {k, values: values(method, 'boundary_min'), dashed: true}]),
  };
}

// geometries: for each method that of the level that is shown.
function keptChart({methods}, tenths, geometries) {
  const series = methods.map((method, k) => ({k, geometry: geometries[k]})).filter(s => s.geometry)
      .map(({k, geometry}) => ({k, values: sharesKept(tenths, geometry).map((share, i) => [i, share])}));
  const highest = Math.max(...series.flatMap(({values}) => values.map(([, share]) => share)));
  const top = [0.04, 0.1, 0.2, 0.4, 1].find(limit => highest <= limit);
  return {
    series,
    label: 'Share of the nodes kept, from the finest to the coarsest part of the mesh',
    x: plotX(0, tenths.length - 1, [0, tenths.length - 1]),
    xName: 'tenths of the nodes by edge length',
    nameX: k => k === 0 ? 'finest' : 'coarsest',
    anchorX: k => k === 0 ? 'start' : 'end',
    y: linearScale(0, top, plotBottom, kChart.top, [0, 0.25, 0.5, 0.75, 1].map(part => part * top)),
    nameY: v => Number((100 * v).toFixed(1)) + '%',
  };
}

class ChartFigure {
  constructor(name, title) {
    this.body = element('div');
    const save = element('button', {type: 'button'}, 'Save as SVG');
    save.addEventListener('click', () => saveFile(name + '.svg', withColours(this.body.innerHTML)));
    this.words = element('p');
    this.figure = element('figure', {}, element('figcaption', {},
        element('div', {class: 'head'}, element('h3', {}, title), save), this.words), this.body);
  }
  // words: what stands above the chart, as nodes or texts.
  draw(chart, words) {
    this.body.innerHTML = chartSvg(chart);
    this.words.replaceChildren(...words);
  }
}

// A file of its own knows no style sheet: put the colours in.
const withColours = svg => svg.replace(/var\(--([a-z0-9-]+)\)/g, (_, name) => colourOf(name));

// The columns of the tables: key in the statistics, headings, digits.
const kColumns = [
  {group: '', key: 'nodes', name: 'nodes'}, {group: '', key: 'triangles', name: 'triangles'},
  {group: '', key: 'boundary_edges', name: 'boundary edges'},
  {group: 'smallest angle', key: 'interior_min', name: 'interior', digits: 2},
  {group: 'smallest angle', key: 'boundary_min', name: 'boundary', digits: 2},
  {group: 'angles ≤ 10°', key: 'interior_le_10', name: 'interior'},
  {group: 'angles ≤ 10°', key: 'boundary_le_10', name: 'boundary'},
  {group: 'largest', key: 'max', name: 'angle', digits: 1},
  {group: 'gradation', key: 'gradation', name: 'log₂', digits: 2},
  {group: 'intersection', key: 'intersection_mean', name: 'mean', digits: 2},
  {group: 'intersection', key: 'intersection_max', name: 'max'},
  {group: 'path depth', key: 'path_depth_mean', name: 'mean', digits: 1},
  {group: 'path depth', key: 'path_depth_max', name: 'max'},
  {group: 'node search', key: 'search_mean', name: 'mean', digits: 1},
  {group: 'node search', key: 'search_max', name: 'max'},
  {group: 'edge search', key: 'edge_search_mean', name: 'mean', digits: 1},
  {group: 'edge search', key: 'edge_search_max', name: 'max'},
];

// What the columns' headings leave open. Shown where there is such a column.
const kColumnNotes = [
  ['boundary_min', 'Boundary triangles have a node on the boundary, interior ones have none.'],
  ['gradation', 'Gradation: how often the longest edge halves down to the shortest.'],
  ['intersection_mean', 'Intersection: how many triangles of the level before a triangle meets.'],
  ['path_depth_mean', 'Path depth: edges on the path along which a node got its spacing.'],
  ['search_mean', 'Node search: nodes looked at to decide about a node.'],
  ['edge_search_mean', 'Edge search: nodes looked at by a node of the next level\u2019s boundary, '
      + 'so that none stays too close to its edges.'],
];

function renderColumnNotes({methods}, parent) {
  const has = key => methods.some(({levels}) => levels.some(
      ({statistics: s}) => s[key] !== null && s[key] !== undefined));
  const notes = kColumnNotes.filter(([key]) => has(key)).map(([, words]) => words);
  if (notes.length) parent.append(element('p', {class: 'legend'}, notes.join(' ')));
}

const cellText = (value, digits = 0) =>
    value === null || value === undefined ? '' : digits ? value.toFixed(digits) : count(value);

function tableHead(columns) {
  const groups = [];
  for (const {group} of columns) {
    if (groups.length && groups[groups.length - 1].group === group) ++groups[groups.length - 1].span;
    else groups.push({group, span: 1});
  }
  return element('thead', {},
      element('tr', {}, element('td'), ...groups.map(({group, span}) =>
          element('th', {colspan: span, scope: 'colgroup'}, group))),
      element('tr', {}, element('th', {scope: 'col'}, 'level'),
          ...columns.map(({name}) => element('th', {scope: 'col'}, name))));
}

// Returns the rows, one a level.
function renderTable(method, k, parent) {
  const columns = kColumns.filter(({key}) => method.levels.some(
      ({statistics: s}) => s[key] !== null && s[key] !== undefined));
  const rows = method.levels.map(({statistics}, level) => element('tr', {},
      element('th', {scope: 'row'}, String(level)),
      ...columns.map(({key, digits}) => element('td', {}, cellText(statistics[key], digits)))));
  const scrolled = {class: 'table', tabindex: '0', role: 'region', 'aria-label': `Levels, ${methodName(method)}`};
  parent.append(element('div', scrolled, element('table', {},
      element('caption', {}, methodMark(k), methodName(method)),
      tableHead(columns), element('tbody', {}, ...rows))));
  return rows;
}

function renderParameters(report) {
  const list = entries => element('dl', {}, ...entries.flatMap(
      ([name, value]) => [element('dt', {}, name), element('dd', {}, value)]));
  document.getElementById('parameters').append(
      element('div', {}, element('h3', {}, 'Input'), list(report.parameters)),
      ...report.methods.map((method, k) => element('div', {},
          element('h3', {}, methodMark(k), methodName(method)), list(method.parameters))));
}
