// Small runs to look at, made by the program under test.
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const program = process.env.SABO_PROGRAM ?? 'sabo';

/** Ends an element of a page, if it is not escaped. */
export const roughTitle = 'A <b>rough</b> "valley" & </script><script>alert(1)</script> \u6ca2';

const sabo = (...words) => execFileSync(program, words, { encoding: 'utf8' });

/** Two short runs of the example, the second without its dam. */
export function makeRuns() {
  const folder = mkdtempSync(join(tmpdir(), 'sabo_e2e_'));
  const at = (name) => join(folder, name);
  sabo('new', 'yohutagawa', at('case'));
  const file = join(at('case'), 'case.toml');
  const original = readFileSync(file, 'utf8');
  const titled = original.replace(/^title *=.*$/m, () => `title = ${JSON.stringify(roughTitle)}`)
    .replace(/^output_interval *=.*$/m, 'output_interval = 1');
  writeFileSync(file, titled);
  const run = (name) => sabo('run', at('case'), '-o', at(name), '--spacing', '3', '--duration', '5',
    '--threads', '1');
  run('with');
  writeFileSync(file, titled.replace(/^\[\[structure\]\]$[^]*?(?=^\[\[section\]\]$)/m, ''));
  run('without');
  return {
    with: at('with'),
    without: at('without'),
    page: (name, query = '') => pathToFileURL(join(at(name), 'view', 'index.html')).href + query,
    remove: () => rmSync(folder, { recursive: true }),
  };
}

/** Starts `sabo view` and calls test(address). */
export async function withServer(words, test) {
  const server = spawn(program, ['view', '--no-browser', ...words], { stdio: ['ignore', 'pipe', 'inherit'] });
  try {
    const address = await new Promise((resolve, reject) => {
      let said = '';
      server.stdout.on('data', (data) => {
        said += data;
        const found = said.match(/http:\/\/127\.0\.0\.1:\d+\/\S*/);
        if (found) resolve(found[0]);
      });
      server.on('exit', (code) => reject(new Error(`sabo view ended with ${code}: ${said}`)));
    });
    await test(address);
  } finally {
    server.kill();
  }
}
