// How long the page takes to fit, beside the program: from the file given to the first law and to the last.
import { execFileSync } from 'node:child_process'
import { mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { open } from './harness.mjs'

const program = process.env.CROMER_PROGRAM
const sample = fileURLToPath(new URL('../../../../data/recording2.csv', import.meta.url))
const seconds = (ms) => `${(ms / 1000).toFixed(2)} s`

/** A second-lab recording of so many samples within two minutes. */
function made(samples, folder) {
  const path = join(folder, `${samples}.csv`)
  const law = '--mass 0.2176 --stiffness 17.04 --damping 0.000789 --drag 0.02043 --position 0.036 --until 120 --method rk4'
  const sensor = '--sensor-noise 0.0003 --sensor-resolution 0.0001 --sensor-offset 0.2 --seed 24'
  execFileSync(program, ['simulate', ...law.split(' '), '--step', String(120 / samples), ...sensor.split(' '), '--quiet', '-o', path])
  return path
}

async function timed(browser, path) {
  const { page, context } = await open(browser)
  await page.locator('header nav a').nth(1).click()
  await page.evaluate(() => {
    let before = performance.now()
    window.longestFrame = 0
    requestAnimationFrame(function next(now) {
      window.longestFrame = Math.max(window.longestFrame, now - before)
      before = now
      requestAnimationFrame(next)
    })
  })
  const begin = performance.now()
  await page.locator('input[type=file]').first().setInputFiles(path)
  await page.locator('[data-quantity=decay_rate]').first().waitFor({ timeout: 300_000 })
  const first = performance.now() - begin
  await page.waitForFunction(() => !document.querySelector('.fit[aria-busy=true]'), null, { timeout: 300_000 })
  const all = performance.now() - begin
  const frame = await page.evaluate(() => window.longestFrame)
  await context.close()
  return { first, all, frame }
}

export async function fits(browser, row) {
  const folder = mkdtempSync(join(tmpdir(), 'cromer-fits-'))
  try {
    const files = [['recording2.csv, 12,000 samples', sample]]
    if (program) files.push(['10^6 samples', made(1_000_000, folder)])
    for (const [what, path] of files) {
      const { first, all, frame } = await timed(browser, path)
      row(`fit of ${what}: first law shown`, seconds(first))
      let beside = ''
      if (program) {
        const begin = performance.now()
        execFileSync(program, ['fit', path, '--json', '--quiet'], { stdio: 'ignore' })
        const its = performance.now() - begin
        beside = `no goal; the program ${seconds(its)} (${(all / its).toPrecision(2)})`
      }
      row(`  all laws compared`, seconds(all), beside)
      row(`  the longest frame meanwhile`, seconds(frame))
    }
  } finally {
    rmSync(folder, { recursive: true })
  }
}
