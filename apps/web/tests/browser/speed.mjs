// Measures, and prints; only what is absurd fails: node tests/browser/speed.mjs
// Ready: from opening the file to the first curves drawn. Slider: from its input to the plot redrawn. Frames: while playing, five methods of 8000 steps.
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { gzipSync } from 'node:zlib'
import { address, check, file, finish, launch, open } from './harness.mjs'

const browser = await launch()
const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1]
const most = (values) => Math.max(...values)
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

/** Times from the slider's input to the frame after the main plot was redrawn with the new curves. */
const slide = (page) =>
  page.evaluate(async () => {
    const plot = document.querySelector('[data-drawn]')
    const slider = document.querySelector('[data-option=damping]')
    const times = []
    for (let i = 0; i < 40; ++i) {
      const name = plot.getAttribute('aria-label')
      const begin = performance.now()
      const redrawn = new Promise((resolve) => {
        let said = false
        new MutationObserver((changes, observer) => {
          said ||= plot.getAttribute('aria-label') !== name
          if (!said || !changes.some((each) => each.attributeName === 'data-drawn')) return
          observer.disconnect()
          resolve()
        }).observe(plot, { attributes: true })
      })
      slider.value = String(300 + 5 * i)
      slider.dispatchEvent(new Event('input', { bubbles: true }))
      await redrawn
      times.push(performance.now() - begin)
      await new Promise((resolve) => setTimeout(resolve, 60))
    }
    return times
  })

for (const [what, hash] of [
  ['the page as it opens, four methods of 1000 steps', ''],
  ['five methods of 8000 steps', '#simulate?step=0.003125&methods=exact,forward-euler,euler-cromer,implicit-euler,rk4'],
])
  await check(`slider to redrawn: ${what}`, async () => {
    const { page, context } = await open(browser, { hash })
    await page.waitForTimeout(1500)
    const times = await slide(page)
    console.log(`      slider: median ${ms(median(times))}, most ${ms(most(times))}`)
    assert.ok(median(times) < 1000)
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
