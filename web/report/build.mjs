// Bundles script and style into dist/, and the hash of the script for the page's security policy.
import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const result = await build({
  entryPoints: ['src/report.js', 'src/report.css'],
  outdir: 'dist',
  bundle: true,
  minify: true,
  charset: 'utf8',
  target: 'es2020',
  legalComments: 'none',
  write: false,
});
mkdirSync('dist', { recursive: true });
for (const { path, contents } of result.outputFiles) {
  const isScript = path.endsWith('.js');
  // Of the library, whose licence wants to be in every copy.
  const licence = `/* uPlot\n${readFileSync('node_modules/uplot/LICENSE', 'utf8')}*/\n`;
  const text = licence + new TextDecoder().decode(contents).trim();
  // Inside a page the end tags would end them.
  if (/<\/(script|style)/i.test(text)) throw new Error(`${path} holds an end tag`);
  writeFileSync(path, text);
  if (isScript) writeFileSync(`${path}.sha256`, createHash('sha256').update(text).digest('base64'));
}
