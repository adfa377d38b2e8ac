import { css, viridis } from './colours.js';

const font = "system-ui, -apple-system, 'Segoe UI', 'Noto Sans CJK JP', sans-serif";

/** The picture with title, time, names and legend as a PNG, handed to the browser as a download. */
export async function savePicture({ stage, labels, legend, lines, name }) {
  stage.draw(); // the canvas is only filled right after
  const { width, height } = stage.canvas;
  const scale = width / stage.width;
  const picture = document.createElement('canvas');
  [picture.width, picture.height] = [width, height];
  const c = picture.getContext('2d');
  c.drawImage(stage.canvas, 0, 0);
  c.scale(scale, scale);
  for (const { name: label, left, right, top, kind } of labels.placed) {
    c.fillStyle = kind === 'solid' ? '#8c1c13' : '#1f2933';
    c.strokeStyle = 'rgba(255, 255, 255, 0.9)';
    c.lineWidth = 3;
    c.font = `600 13px ${font}`;
    c.textAlign = 'center';
    c.strokeText(label, (left + right) / 2, top + 15);
    c.fillText(label, (left + right) / 2, top + 15);
  }
  drawDivider(c, stage);
  drawLines(c, lines);
  drawLegend(c, legend, stage);
  const blob = await new Promise((resolve) => { picture.toBlob(resolve, 'image/png'); });
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

function drawDivider(c, stage) {
  if (stage.views.length < 2) return;
  c.fillStyle = '#1f2933';
  c.fillRect(stage.views[1].from - 1, 0, 2, stage.height);
}

function card(c, left, top, width, height) {
  c.fillStyle = 'rgba(255, 255, 255, 0.88)';
  c.beginPath();
  c.roundRect(left, top, width, height, 8);
  c.fill();
}

function drawLines(c, lines) {
  const shown = lines.filter(Boolean);
  const fonts = shown.map((_, k) => `${k === 0 ? '700 18px' : '13px'} ${font}`);
  const width = Math.max(...shown.map((line, k) => { c.font = fonts[k]; return c.measureText(line).width; }));
  card(c, 12, 12, width + 24, 22 + 20 * shown.length);
  c.textAlign = 'left';
  shown.forEach((line, k) => {
    c.font = fonts[k];
    c.fillStyle = k === 0 ? '#1f2933' : '#3e4c59';
    c.fillText(line, 24, 38 + 20 * k);
  });
}

function drawLegend(c, legend, stage) {
  const [width, left, top] = [280, 28, stage.height - 56];
  card(c, 12, top - 28, width + 32, 72);
  c.font = `600 13px ${font}`;
  c.textAlign = 'left';
  c.fillStyle = '#1f2933';
  c.fillText(legend.heading, left, top - 9);
  const fill = c.createLinearGradient(left, 0, left + width, 0);
  viridis.forEach((colour, k) => fill.addColorStop(k / (viridis.length - 1), css(colour)));
  c.fillStyle = fill;
  c.fillRect(left, top, width, 14);
  c.fillStyle = '#1f2933';
  c.font = `12px ${font}`;
  c.textAlign = 'center';
  for (const { at, label } of legend.marksNow) c.fillText(label, left + at * width, top + 32);
}
