// SPDX-License-Identifier: MIT
// pixelmatch.mjs PACKAGE ROUNDS OPTIONS EXPECTED ACTUAL …: times pixelmatch without starting node again, on pictures that
// were read before. Prints a line of JSON for each pair.
import fs from 'fs';
import { createRequire } from 'module';
import { pathToFileURL } from 'url';

const [folder, rounds, options, ...files] = process.argv.slice(2);
const match = (await import(pathToFileURL(folder + '/index.js'))).default;
const { PNG } = createRequire(folder + '/package.json')('pngjs');
const read = (file) => PNG.sync.read(fs.readFileSync(file));
for (let i = 0; i < files.length; i += 2) {
  const [a, b] = [read(files[i]), read(files[i + 1])];
  const times = [];
  for (let round = 0; round < Number(rounds) + 2; ++round) {
    const start = process.hrtime.bigint();
    match(a.data, b.data, null, a.width, a.height, JSON.parse(options));
    times.push(Number(process.hrtime.bigint() - start) * 1e-9);
  }
  times.splice(0, 2); // it is compiled while it runs
  times.sort((x, y) => x - y);
  console.log(JSON.stringify({ decodedSeconds: times[times.length >> 1] }));
}
