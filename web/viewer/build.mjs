// Makes dist/: the page with style and script inlined, and the policy to serve it with. The same
// sources give the same bytes.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const bundled = await build({
  entryPoints: ['src/main.js'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'utf8',
  legalComments: 'inline',
  write: false,
});
const script = bundled.outputFiles[0].text;
const style = readFileSync('src/style.css', 'utf8');
const licence = readFileSync('node_modules/three/LICENSE', 'utf8').replaceAll('--', '- -');

if (/<\/script|<!--/i.test(script)) throw new Error('the script would end its element');
const page = readFileSync('src/page.html', 'utf8')
  .replace('/* style */', () => style)
  .replace('/* script */', () => script)
  .replace('licence of three.js', () => `With three.js:\n\n${licence}`);

const hash = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
const policy = [
  "default-src 'none'",
  `script-src 'self' ${hash(script)}`,
  `style-src ${hash(style)}`,
  'img-src data: blob:',
  "base-uri 'none'",
  "form-action 'none'",
  "frame-ancestors 'none'",
].join('; ');

mkdirSync('dist', { recursive: true });
writeFileSync('dist/index.html', page);
writeFileSync('dist/policy.txt', policy);
