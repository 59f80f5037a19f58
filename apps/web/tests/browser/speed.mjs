// How fast and how large the page is, as a table with the goals: node tests/browser/speed.mjs
// CROMER_PROGRAM names the program, whose fits are timed beside the page's. Only what is absurd fails.
import assert from 'node:assert/strict'
import { cpus } from 'node:os'
import { readFile } from 'node:fs/promises'
import { gzipSync } from 'node:zlib'
import { fits } from './fit_speed.mjs'
import { address, file, launch, open } from './harness.mjs'
import { parts, slide, watch } from './slide.mjs'

const browser = await launch()
const sorted = (values) => [...values].sort((a, b) => a - b)
const median = (values) => sorted(values)[values.length >> 1]
const tenth = (values) => sorted(values)[Math.floor(values.length / 10)]
const most = (values) => Math.max(...values)
const sum = (values) => values.reduce((a, b) => a + b, 0)
const ms = (value) => `${value.toFixed(1)} ms`
const kB = (bytes) => `${(bytes / 1000).toFixed(0)} kB`

const row = (work, figure, beside = '') => console.log(`${work.padEnd(52)} ${figure.padStart(10)}   ${beside}`)
console.log(`The page in Chromium ${browser.version()}, drawn without a graphics card; ${cpus()[0].model}, ${new Date().toISOString().slice(0, 10)}\n`)
row('work', 'page', 'goal; more')

async function ready() {
  const times = []
  for (let i = 0; i < 5; ++i) {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce' })
    const page = await context.newPage()
    await page.goto(address)
    await page.waitForFunction(() => /forward Euler/.test(document.querySelector('[role=img]')?.getAttribute('aria-label')))
    times.push(await page.evaluate(() => performance.now()))
    await context.close()
  }
  row('ready: from opening the file to the first curves', ms(median(times)), `1000 ms; most ${ms(most(times))} of ${times.length}`)
  assert.ok(median(times) < 10_000)
}

const runs = [
  ['four methods of 1000 steps', '', '16.7 ms'],
  ['five methods of 8000 steps', '#simulate?step=0.003125&methods=exact,forward-euler,euler-cromer,implicit-euler,rk4', '33.3 ms'],
]
async function slider([what, hash, goal]) {
  const { page, context } = await open(browser, { hash, watch })
  await page.waitForTimeout(1500)
  const moves = await slide(page, 60, 90)
  assert.ok(moves.length > 20, `${moves.length} of 60 moves were drawn`)
  const whole = moves.map((move) => sum(move.slice(1, 6)))
  row(`slider to painted, ${what}`, ms(median(whole)), `${goal}; a tenth below ${ms(tenth(whole))}, most ${ms(most(whole))}`)
  parts.forEach((part, i) => i > 0 && row(`  ${part}`, ms(median(moves.map((move) => move[i])))))
  assert.ok(median(whole) < 1000)
  await context.close()
}

async function frames() {
  const { page, context } = await open(browser, { hash: runs[1][1], reducedMotion: 'no-preference' })
  await page.waitForTimeout(2000)
  const [rate, longest] = await page.evaluate(
    () =>
      new Promise((resolve) => {
        const begin = performance.now()
        let [frames, before, longest] = [0, begin, 0]
        requestAnimationFrame(function next(now) {
          ++frames
          longest = Math.max(longest, now - before)
          before = now
          if (now - begin < 4000) requestAnimationFrame(next)
          else resolve([(frames * 1000) / (now - begin), longest])
        })
      }),
  )
  row('frames a second, playing five methods of 8000 steps', rate.toFixed(1), `60; the longest ${ms(longest)}`)
  assert.ok(rate > 5)
  await context.close()
}

async function size() {
  const html = await readFile(file, 'utf8')
  const [core] = html.match(/<script type="text\/plain"[^<]*/)
  const size = (text) => gzipSync(text, { level: 9 }).length
  row('size, gzipped', kB(size(html)), `592 kB; core ${kB(size(core))}, script and style ${kB(size(html.replace(core, '')))}`)
}

await ready()
for (const run of runs) await slider(run)
await frames()
await size()
await fits(browser, row)
await browser.close()
