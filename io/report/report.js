// Puts the report together: one slider drives all pictures, charts and tables.
'use strict';

// The slider counts the levels of the method that has most of them.
function leadingMethod(methods) {
  return methods.reduce((best, method, k) =>
      method.levels.length > methods[best].levels.length ? k : best, 0);
}

class ReportPage {
  constructor(report) {
    this.report = report;
    this.tenths = sizeTenths(report);
    this.leader = leadingMethod(report.methods);
    this.view = new View(report);
    this.panels = report.methods.map((_, k) => new MeshPanel(report, this.view, k));
    renderLead(report, this.tenths, () => this.showWhy());
    renderParameters(report);
    this.rows = report.methods.map((method, k) => renderTable(method, k, document.getElementById('tables')));
    renderColumnNotes(report, document.getElementById('tables'));
    document.getElementById('panels').append(...this.panels.map(panel => panel.figure));
    this.addCharts();
    this.addLegend();
    this.connectControls();
    this.connectTheme();
    this.showDensePart();
    this.update();
  }

  addCharts() {
    this.charts = {
      kept: new ChartFigure('kept', 'Who stays'),
      angle: new ChartFigure('smallest_angle', 'Smallest angle'),
      size: new ChartFigure('nodes', 'Nodes'),
    };
    if (this.tenths.length === 0) delete this.charts.kept;
    document.getElementById('charts').append(...Object.values(this.charts).map(chart => chart.figure));
    this.charts.angle.draw(angleChart(this.report),
        [...this.methodNames(), 'solid: interior triangles, dashed: at the boundary']);
    this.charts.size.draw(sizeChart(this.report), [...this.methodNames(), 'on a logarithmic scale']);
  }

  // The methods with their marks, each with a word after its name.
  methodNames(words = () => '') {
    return this.report.methods.map((method, k) =>
        element('span', {class: 'key'}, methodMark(k), methodName(method) + words(k)));
  }

  addLegend() {
    const item = (name, words) => element('span', {},
        element('span', {class: 'face', style: `background: var(--${name})`}), words);
    document.getElementById('mesh-legend').append(
        item('below-10', 'triangles with an angle of at most 10° (ringed where they are tiny)'),
        item('below-20', 'at most 20°'),
        element('span', {class: 'screen-only'}, 'Drag to move; click, then scroll to zoom. Keys: arrows, +, \u2212, 0.'));
  }

  connectControls() {
    const on = (id, event, action) => document.getElementById(id).addEventListener(event, action);
    this.slider = document.getElementById('level');
    this.slider.max = this.report.methods[this.leader].levels.length - 1;
    this.slider.value = Math.min(2, this.slider.max);
    document.getElementById('match-label').hidden = this.report.methods.length < 2;
    for (const id of ['level', 'match', 'kept']) on(id, 'input', () => this.update());
    on('zoom-in', 'click', () => this.view.zoom(0.6));
    on('zoom-out', 'click', () => this.view.zoom(1 / 0.6));
    on('view-whole', 'click', () => this.view.show(this.view.whole));
    on('view-dense', 'click', () => this.showDensePart());
    on('view-finest', 'click', () => this.showFinestPart());
  }

  connectTheme() {
    const redraw = () => this.panels.forEach(panel => panel.draw());
    const paper = on => {
      if (on) document.documentElement.dataset.theme = 'paper';
      else delete document.documentElement.dataset.theme;
      redraw();
    };
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
    window.addEventListener('beforeprint', () => paper(true));
    window.addEventListener('afterprint', () => paper(false));
  }

  showDensePart() { this.view.show(boxOf(this.report.points, 0.1)); }

  showFinestPart() {
    const finest = finestView(this.tenths, this.report.points);
    if (finest) this.view.show(finest);
  }

  // The finest part of the input, where the methods choose most differently.
  showWhy() {
    this.slider.value = 0;
    document.getElementById('kept').checked = true;
    this.showFinestPart();
    this.update();
    document.getElementById('meshes').scrollIntoView();
  }

  // The level of each method that belongs to the slider's.
  shownLevels() {
    const {methods} = this.report, level = Number(this.slider.value);
    const nodes = methods[this.leader].levels[level].statistics.nodes;
    const match = document.getElementById('match').checked;
    return methods.map((method, k) => k === this.leader ? level :
        match ? nearestBySize(method, nodes) : Math.min(level, method.levels.length - 1));
  }

  update() {
    const levels = this.shownLevels(), showKept = document.getElementById('kept').checked;
    document.getElementById('level-text').textContent = `${this.slider.value} of ${this.slider.max}`;
    this.panels.forEach((panel, k) => panel.show(levels[k], showKept));
    this.rows.forEach((rows, k) => rows.forEach(
        (row, level) => row.classList.toggle('current', level === levels[k])));
    this.updateKeptChart(levels);
  }

  updateKeptChart(levels) {
    if (!this.charts.kept) return;
    const {methods} = this.report;
    const chart = keptChart(this.report, this.tenths,
        methods.map((method, k) => method.levels[levels[k]].geometry));
    this.charts.kept.draw(chart,
        ['share of the nodes of level 0 that are kept at ', ...this.methodNames(k => ` level ${levels[k]}`)]);
  }
}

new ReportPage(decodeReport(JSON.parse(document.getElementById('data').textContent)));
