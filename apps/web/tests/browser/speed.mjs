// Measures, and prints; only what is absurd fails: node tests/browser/speed.mjs
// Ready: from opening the file to the first curves drawn. Slider: from its input to the plot redrawn. Frames: while playing, five methods of 8000 steps.
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { gzipSync } from 'node:zlib'
import { address, check, file, finish, launch, open } from './harness.mjs'
import { parts, slide, watch } from './slide.mjs'

const browser = await launch()
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1]
const most = (values) => Math.max(...values)
const sum = (values) => values.reduce((a, b) => a + b, 0)
const ms = (value) => `${value.toFixed(1)} ms`

const html = await readFile(file, 'utf8')
const base64 = html.match(/[A-Za-z0-9+/=]{100000,}/)?.[0] ?? ''
console.log(`file ${html.length} bytes, gzipped ${gzipSync(html).length}; core ${Math.round(base64.length * 0.75)}; script and style gzipped ${gzipSync(html.replace(base64, '')).length}`)

await check('ready from disk', async () => {
  const times = []
  for (let i = 0; i < 5; ++i) {
    const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce' })
    const page = await context.newPage()
    await page.goto(address)
    await page.waitForFunction(() => /forward Euler/.test(document.querySelector('[role=img]')?.getAttribute('aria-label')))
    times.push(await page.evaluate(() => performance.now()))
    await context.close()
  }
  console.log(`      ready: median ${ms(median(times))}, most ${ms(most(times))}`)
  assert.ok(median(times) < 10_000)
})

for (const [what, hash] of [
  ['the page as it opens, four methods of 1000 steps', ''],
  ['five methods of 8000 steps', '#simulate?step=0.003125&methods=exact,forward-euler,euler-cromer,implicit-euler,rk4'],
])
  await check(`slider to painted: ${what}`, async () => {
    const { page, context } = await open(browser, { hash, watch })
    await page.waitForTimeout(1500)
    const moves = await slide(page, 60, 90)
    assert.ok(moves.length > 20, `${moves.length} of 60 moves were drawn`)
    const whole = moves.map((move) => sum(move.slice(1, 6)))
    console.log(`      slider: median ${ms(median(whole))}, most ${ms(most(whole))}, of ${moves.length} moves; before it ${parts[0]}: ${ms(median(moves.map((move) => move[0])))}`)
    console.log(`      ${parts.slice(1).map((part, i) => `${part} ${ms(median(moves.map((move) => move[i + 1])))}`).join(', ')}`)
    assert.ok(median(whole) < 1000)
    await context.close()
  })

await check('frames while playing five methods of 8000 steps', async () => {
  const { page, context } = await open(browser, {
    hash: '#simulate?step=0.003125&methods=exact,forward-euler,euler-cromer,implicit-euler,rk4', reducedMotion: 'no-preference',
  })
  await page.waitForTimeout(2000)
  const [frames, longest, work] = await page.evaluate(
    () =>
      new Promise((resolve) => {
        const begin = performance.now()
        let [frames, before, longest] = [0, begin, 0]
        requestAnimationFrame(function next(now) {
          ++frames
          longest = Math.max(longest, now - before)
          before = now
          if (now - begin < 4000) requestAnimationFrame(next)
          else resolve([(frames * 1000) / (now - begin), longest, 0])
        })
      }),
  )
  void work
  console.log(`      ${frames.toFixed(1)} frames a second, the longest ${ms(longest)}`)
  assert.ok(frames > 5)
  await context.close()
})

await browser.close()
finish()
