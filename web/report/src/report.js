// Replaces the drawn charts of the report by ones that give values under the pointer. Without
// scripts, and on paper, the drawn ones stay.
import uPlot from 'uplot';

const HEIGHT = 340;
const font = () => `12px ${getComputedStyle(document.body).fontFamily}`;

// Six digits at most; what lies in a gap has no value.
function shown(value) {
  if (value == null) return '–';
  return String(Number(value.toPrecision(6))).replace('-', '\u2212');
}

// One list of x for all series, as uPlot wants it; series with stations of their own are joined.
function aligned(series) {
  const first = series[0].x;
  const isShared = series.every((s) => s.x.length === first.length && s.x.every((x, i) => x === first[i]));
  if (isShared) return [first, ...series.map((s) => s.y)];
  return uPlot.join(series.map((s) => [s.x, s.y]));
}

// Horizontal lines at values to compare with, and works and sections at their stations.
function drawMarks(chart, u) {
  const { ctx } = u;
  const ratio = devicePixelRatio;
  const text = (label, x, y, align) => {
    ctx.textAlign = align;
    ctx.lineWidth = 3 * ratio;
    ctx.strokeStyle = '#ffffff';
    ctx.setLineDash([]);
    ctx.strokeText(label, x, y);
    ctx.fillText(label, x, y);
  };
  const line = (x1, y1, x2, y2, width, dash, colour) => {
    ctx.lineWidth = width * ratio;
    ctx.strokeStyle = colour;
    ctx.setLineDash(dash.map((d) => d * ratio));
    ctx.beginPath();
    ctx.moveTo(x1, y1);
    ctx.lineTo(x2, y2);
    ctx.stroke();
  };
  ctx.save();
  ctx.font = `${12 * ratio}px ${getComputedStyle(document.body).fontFamily}`;
  ctx.fillStyle = '#1f2933';
  const { left, top, width, height } = u.bbox;
  for (const { y, label } of chart.references) {
    const at = u.valToPos(y, 'y', true);
    line(left, at, left + width, at, 1.2, [6, 4], '#52606d');
    text(label, left + width - 4 * ratio, at - 5 * ratio, 'right');
  }
  chart.marks.forEach(({ x, label, low, high }, k) => {
    const at = u.valToPos(x, 'x', true);
    if (at < left || at > left + width) return;
    line(at, top, at, top + height, 1, [2, 3], '#52606d');
    if (low != null) line(at, u.valToPos(low, 'y', true), at, u.valToPos(high, 'y', true), 5, [], '#c1121f');
    const isRight = at > left + 0.7 * width;
    text(label, at + (isRight ? -4 : 4) * ratio, top + (12 + 14 * (k % 3)) * ratio, isRight ? 'right' : 'left');
  });
  ctx.restore();
}

function optionsOf(chart, width) {
  const axis = (label, size) => ({
    label, size, labelSize: 22, labelFont: font(), font: font(), stroke: '#52606d',
    grid: { stroke: '#e4e7eb', width: 1 }, ticks: { stroke: '#9aa5b1', width: 1 },
    values: (u, ticks) => ticks.map((t) => (t == null ? '' : shown(t))),
  });
  // Zero and the lines to compare with are part of the picture, as they are in the drawn one.
  const range = (u, low, high) => {
    const extra = chart.references.map((r) => r.y);
    for (const mark of chart.marks) if (mark.low != null) extra.push(mark.high);
    if (chart.hasZero) extra.push(0);
    return uPlot.rangeNum(Math.min(low ?? 0, ...extra), Math.max(high ?? 1, ...extra), 0.05, true);
  };
  return {
    width, height: HEIGHT, title: chart.title,
    scales: { x: { time: false }, y: { range } },
    axes: [axis(chart.x, 30), axis(chart.y, 62)],
    cursor: { drag: { x: true, y: false }, points: { size: 7 } },
    legend: { markers: { width: 3, dash: (u, k) => (chart.series[k - 1]?.dash.length ? 'dashed' : 'solid') } },
    series: [
      { label: chart.x, value: (u, v) => shown(v) },
      ...chart.series.map((s) => ({
        label: s.name, stroke: s.colour, width: 2, dash: s.dash, spanGaps: true,
        points: { show: s.hasMarkers, size: 7, fill: s.colour },
        paths: s.hasLine ? undefined : () => null,
        value: (u, v) => shown(v),
      })),
    ],
    hooks: { draw: [(u) => drawMarks(chart, u)] },
  };
}

function enliven(figure) {
  const chart = JSON.parse(figure.querySelector('script').textContent);
  if (!chart.series.some((s) => s.x.length > 1)) return;
  const place = document.createElement('div');
  place.className = 'live';
  figure.prepend(place);
  const plot = new uPlot(optionsOf(chart, figure.clientWidth), aligned(chart.series), place);
  new ResizeObserver(() => plot.setSize({ width: figure.clientWidth, height: HEIGHT })).observe(figure);
  figure.classList.add('is-live');
}

for (const figure of document.querySelectorAll('figure.chart')) {
  try {
    enliven(figure);
  } catch (error) {
    console.error(error); // the drawn chart stays
  }
}
document.documentElement.dataset.ready = 'true';
