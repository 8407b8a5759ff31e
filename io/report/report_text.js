// The words: names, captions and the lead, which are made from the data.
'use strict';

const kMethodNames = {
  function: 'Function-based', mis: 'MIS-based', threshold: 'Threshold',
  'quasi-uniform': 'Quasi-uniform', quadtree: 'Quadtree', refinement: 'Refinement',
};
const kMethodIdeas = {
  function: 'gives every node a spacing that grows smoothly over the mesh, enlarges all spacings, '
      + 'and drops the nodes that stand closer than these ask. So it thins the mesh where it is '
      + 'finest, and levels it out.',
  mis: 'keeps a maximal independent set: of two neighbours never both. It asks who neighbours '
      + 'whom, not how far away, and so thins the mesh everywhere alike. Its grading stays, on '
      + 'ever fewer nodes, and becomes too steep for well-shaped triangles.',
  threshold: 'gives every node a spacing that grows smoothly over the mesh, and raises the least '
      + 'spacing allowed: it thins what is finer than that and leaves the rest as it is.',
  'quasi-uniform': 'asks for one spacing all over the mesh, larger at every level: it thins what is '
      + 'finer than that and leaves the rest as it is.',
  quadtree: 'lays a quadtree over the mesh, with small boxes where it is fine, and keeps few nodes a '
      + 'box; level by level it does without the smallest boxes.',
  refinement: 'starts from the few nodes that hold the shape of the domain and adds nodes of the input '
      + 'where triangles are too large or too thin.',
};

const methodName = ({method}) => kMethodNames[method] ?? method;
const count = n => n.toLocaleString('en-US');
const degrees = angle => angle === null ? 'none' : angle.toFixed(1) + '°';
const percent = share => (100 * share).toFixed(share > 0 && share < 0.095 ? 1 : 0) + '%';
const factor = x => '×' + count(Number(x.toPrecision(2)));

function element(tag, attributes = {}, ...children) {
  const result = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) result.setAttribute(name, value);
  result.append(...children);
  return result;
}

const seriesColour = k => `var(--series-${k % 4})`;

// A different mark for each series, so that colour is never the only sign.
function markSvg(k, x, y, colour, hollow) {
  const shapes = [
    '<circle r="3.6"/>', '<rect x="-3.4" y="-3.4" width="6.8" height="6.8"/>',
    '<path d="M0-4.6 4.4 3.4H-4.4Z"/>', '<path d="M0-5 5 0 0 5-5 0Z"/>',
  ];
  return `<g transform="translate(${x.toFixed(1)} ${y.toFixed(1)})" stroke="${colour}" stroke-width="1.6" `
      + `fill="${hollow ? 'var(--panel)' : colour}">${shapes[k % 4]}</g>`;
}

function methodMark(k) {
  const mark = element('span', {class: 'mark'});
  mark.innerHTML = `<svg viewBox="-7 -7 14 14" aria-hidden="true">${markSvg(k, 0, 0, seriesColour(k))}</svg>`;
  return mark;
}

function smallestAngle({statistics: s}) {
  const angles = [s.interior_min, s.boundary_min].filter(angle => angle !== null);
  return angles.length ? Math.min(...angles) : null;
}

// Longest over shortest edge.
const lengthRatio = ({statistics: s}) => s.gradation === null ? null : 2 ** s.gradation;

function levelCaption(method, number) {
  const level = method.levels[number];
  return `level ${number} · ${count(level.statistics.nodes)} nodes · `
      + `${count(level.statistics.triangles)} triangles · smallest angle ${degrees(smallestAngle(level))}`;
}

function nearestBySize(method, nodes) {
  const distance = level => Math.abs(Math.log(level.statistics.nodes / nodes));
  return method.levels.reduce(
      (best, level, l) => distance(level) < distance(method.levels[best]) ? l : best, 0);
}

// The levels that the lead compares, one of each method: of nearly equal size, near a twentieth of
// the input's.
function comparedLevels({methods}) {
  const [first] = methods, goal = first.levels[0].statistics.nodes / 20;
  const nodes = level => level.statistics.nodes;
  const candidates = first.levels.slice(Math.min(1, first.levels.length - 1)).map(
      level => methods.map(method => method.levels[nearestBySize(method, nodes(level))]));
  const cost = levels => levels.reduce(
      (sum, level) => sum + Math.abs(Math.log(nodes(level) / nodes(levels[0]))),
      Math.abs(Math.log(nodes(levels[0]) / goal)) / 2);
  return candidates.reduce((best, levels) => cost(levels) < cost(best) ? levels : best);
}

// Levels of fewer nodes are shaped by the domain, whatever the method.
const kFewNodes = 50;

// The smallest angle of the triangles away from the boundary, over all coarser levels that are not
// too small.
function smallestInteriorAngle({levels}) {
  const angles = levels.slice(1).filter(({statistics: s}) => s.nodes >= kFewNodes)
      .map(({statistics: s}) => s.interior_min).filter(angle => angle !== null);
  return angles.length ? Math.min(...angles) : null;
}

// Whether the compared levels show what the two methods are known for.
function showsTheContrast({methods}, levels) {
  if (methods.map(({method}) => method).join() !== 'function,mis') return false;
  const [even, graded] = levels.map(lengthRatio);
  return even !== null && graded !== null && even < graded / 2;
}

const kTellingDegrees = 2;

function headline(report, levels) {
  if (showsTheContrast(report, levels)) {
    const [better, worse] = report.methods.map(smallestInteriorAngle);
    const anglesPay = better !== null && worse !== null && better > worse + kTellingDegrees;
    return 'Function-based coarsening evens the mesh out. Independent sets (MIS) keep its grading'
        + (anglesPay ? ', and the angles pay for it.' : '.');
  }
  const names = new Intl.ListFormat('en-GB').format(report.methods.map(methodName));
  return `${names} coarsening of ${count(report.methods[0].levels[0].statistics.nodes)} nodes`;
}

// How many times longer edges are in the coarsest tenth of the input than in the finest.
const spreadOf = tenths => tenths.length < 10 ? 1 : tenths[9].size / tenths[0].size;
const kNearlyUniform = 1.5;

const endsInThinTriangles = ({levels}) =>
    (levels[levels.length - 1].statistics.boundary_min ?? 180) <= 10;

function introduction({methods}, tenths) {
  const {nodes, triangles} = methods[0].levels[0].statistics;
  const spread = spreadOf(tenths);
  return `${methods.length > 1 ? 'All sequences start' : 'The sequence starts'} from the same mesh of `
      + `${count(nodes)} nodes and ${count(triangles)} triangles`
      + (spread > kNearlyUniform ? `; its edges are some ${factor(spread).slice(1)} times longer where it is coarse `
                        + 'than where it is fine. ' : ', nearly uniform in size. ')
      + 'Each level is a mesh on some of the nodes of the level before, down to the few that hold the '
      + 'shape of the domain. A solver that works on all levels wants few of them, without thin triangles.'
      + (methods.every(endsInThinTriangles) ? ' At the boundary of the last levels the shape of the '
                        + 'domain decides the angles, not the method.' : '');
}

function keptSentence(method, tenths) {
  const geometry = method.levels[1]?.geometry;
  if (!geometry || spreadOf(tenths) <= kNearlyUniform) return '';
  const shares = sharesKept(tenths, geometry);
  return ` Level 1 keeps ${percent(shares[0])} of the nodes where the mesh is finest, `
      + `${percent(shares[9])} where it is coarsest.`;
}

function methodCard(method, k, level, tenths) {
  const ratio = lengthRatio(level), number = method.levels.indexOf(level);
  const figure = (value, words) => element('div', {}, element('strong', {}, value), words);
  return element('section', {class: 'card', style: `border-top-color: ${seriesColour(k)}`},
      element('h2', {}, methodMark(k), methodName(method)),
      element('p', {}, `${kMethodIdeas[method.method] ?? 'made these levels.'}${keptSentence(method, tenths)}`),
      element('div', {class: 'figures'},
          figure(count(level.statistics.nodes), `nodes at level ${number}`),
          figure(ratio === null ? 'none' : factor(ratio), `longest : shortest edge at level ${number}`),
          figure(degrees(smallestInteriorAngle(method)),
                 `smallest angle off the boundary, all levels of ${kFewNodes} nodes or more`)));
}

// showWhy: called when the reader asks to see which nodes go.
function renderLead(report, tenths, showWhy) {
  const levels = comparedLevels(report);
  const button = element('button', {type: 'button', id: 'show-why'}, 'Show which nodes level 1 keeps');
  button.addEventListener('click', showWhy);
  document.getElementById('lead').append(
      element('p', {class: 'headline'}, headline(report, levels)),
      element('p', {}, introduction(report, tenths)),
      element('div', {class: 'cards'},
          ...report.methods.map((method, k) => methodCard(method, k, levels[k], tenths))));
  if (tenths.length) document.getElementById('lead').append(button);
}
