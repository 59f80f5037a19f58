// All tests of the built page in Chromium, two files at a time, the longest first.
import { spawn } from 'node:child_process'
import { join } from 'node:path'

const suites = ['teach', 'simulate', 'second', 'truths', 'measure', 'agrees', 'drops', 'served', 'path', 'live', 'keys', 'print', 'policy', 'serial']
const failed = []

function run(suite) {
  return new Promise((done) => {
    const begin = Date.now()
    const child = spawn(process.execPath, [join(import.meta.dirname, `${suite}.mjs`)])
    let output = ''
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (text) => (output += text))
    child.on('close', (code) => {
      if (code !== 0) failed.push(suite)
      console.log(`${output}${suite}.mjs: ${code === 0 ? 'passed' : 'FAILED'} in ${Math.round((Date.now() - begin) / 1000)} s\n`)
      done()
    })
  })
}

async function oneAfterTheOther() {
  for (let suite = suites.shift(); suite; suite = suites.shift()) await run(suite)
}

await Promise.all([oneAfterTheOther(), oneAfterTheOther()])
if (failed.length > 0) {
  console.error(`failed: ${failed.join(', ')}`)
  process.exit(1)
}
