// The page says what the program says, on the built file from disk: node tests/browser/agrees.mjs
//
// Fifty laws of Simulate and twenty recordings of Measure; the numbers are read off the page, and are due to half a unit
// of the last digit that it shows.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, join, resolve } from 'node:path'
import { recordings } from '../equality/recordings.mjs'
import { simulations } from '../equality/simulations.mjs'
import { check, drop, finish, launch, open, settled } from './harness.mjs'
import { program } from './served_page.mjs'

const plain = (text) => text.replaceAll('−', '-').replaceAll('\u202f', '').replaceAll('\u00a0', ' ')
const factors = { m: 1, cm: 1e-2, mm: 1e-3, µm: 1e-6, nm: 1e-9 }

/** The first number of a text, and half a unit of its last digit. */
function shown(text) {
  const [, digits, power] = plain(text).match(/([-+]?\d[\d.]*)(?:×10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?/)
  const scale = power ? 10 ** Number([...power].map((c) => (c === '⁻' ? '-' : '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(c))).join('')) : 1
  // Zeros at the end of a whole number may be rounded ones: 910 of 912 ± 110.
  const rounded = digits.includes('.') || Number(digits) === 0 ? 0 : digits.match(/0*$/)[0].length
  const places = digits.split('.')[1]?.length ?? -rounded
  return { value: Number(digits) * scale, half: 0.5 * 10 ** -places * scale }
}
/** `share`: what the two may differ by before they are rounded. */
function agree(text, value, what, factor = 1, share = 1e-9) {
  const { value: seen, half } = shown(text)
  const off = Math.abs(seen * factor - value)
  assert.ok(off <= half * factor * (1 + 1e-6) + share * Math.abs(value), `${what}: "${text}", the program has ${value}`)
}

const keys = { 'drive-amplitude': 'driveAmplitude', 'drive-frequency': 'driveFrequency', method: 'methods' }
const onPage = ({ options }) => {
  const known = new Set(['mass', 'stiffness', 'damping', 'drag', 'friction', 'cubic', 'position', 'velocity', 'step', 'until', ...Object.keys(keys)])
  return options.every(([name]) => known.has(name))
}
/** As the program starts it: its own start where none is given. */
const hashOf = (options, { x, v }) => {
  const values = { damping: '0', driveAmplitude: '0', position: String(x[0]), velocity: String(v[0]), ...Object.fromEntries(options.map(([name, value]) => [keys[name] ?? name, value])) }
  return `#simulate?${new URLSearchParams(values)}`
}

/** The plot in words, once it has been the same for a third of a second. */
async function rested(page) {
  let [before, same] = ['', 0]
  while (same < 4) {
    await page.waitForTimeout(80)
    const now = await page.locator('[role=img]').first().getAttribute('aria-label')
    same = now === before ? same + 1 : 0
    before = now
  }
  return before
}

if (!program) console.log('skip  the page beside the program: it is not built')
else {
  const folder = mkdtempSync(join(tmpdir(), 'cromer-agrees-'))
  const browser = await launch()
  {
    const { page, faults, context } = await open(browser)
    const cases = simulations().filter(onPage).slice(0, 50)
    assert.equal(cases.length, 50)
    await check('fifty laws of Simulate have the numbers of the program', async () => {
      let [ends, dampings] = [0, 0]
      for (const { name, options } of cases) {
        const file = join(folder, 'run.json')
        spawnSync(program, ['simulate', '--quiet', '-o', file, ...options.map(([option, value]) => `--${option}=${value}`)])
        const run = JSON.parse(readFileSync(file)).runs[0]
        const about = (until) => Math.abs(Number(document.querySelector('[role=img]').ariaLabel.match(/ to ([\d.]+)\u00a0s\./)?.[1]) / until - 1) < 0.006
        // on a busy machine the page may write its last state to the address after this one is
        for (let tries = 0, there = false; !there; ++tries) {
          await page.evaluate((hash) => (location.hash = hash), hashOf(options, run.states))
          there = await page.waitForFunction(about, run.until, { timeout: 4000 }).then(() => true, () => false)
          assert.ok(there || tries < 5, `${name} is not shown`)
        }
        const label = plain(await rested(page))
        const end = label.match(/ ends at ([-\d.×⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+) (m|cm|mm|µm)\b/)
        const last = run.states.x.at(-1)
        if (end && Math.abs(last) > 1e-9) {
          ++ends
          agree(end[1], last, `${name}, end`, factors[end[2]], 1e-6)
        }
        const row = page.locator('.panel tbody tr').first()
        if (run.effective?.decay_rate == null || run.method === 'exact' || (await row.count()) === 0) continue
        const cells = await row.locator('td b').allInnerTexts()
        if (cells[0] === '–') continue
        ++dampings
        agree(cells[0], run.effective.decay_rate, `${name}, damping`)
        assert.equal(await row.locator('.grows').count(), run.stable === false ? 1 : 0, `${name}, stable`)
      }
      assert.ok(ends > 30 && dampings > 8, `${ends} ends, ${dampings} dampings`)
    })
    await check('nothing went wrong', async () => assert.deepEqual(faults, []))
    await context.close()
  }
  {
    const { page, faults, context } = await open(browser)
    await page.locator('header nav a').nth(1).click()
    const units = { 'N/m': 1, 'kg/s': 1, 'g/s': 1e-3, 'kg/m': 1, 'g/m': 1e-3, N: 1, mN: 1e-3, Hz: 1, '1/s': 1, 'rad/s': 1, '1/m': 1 }
    const files = recordings(program, resolve(import.meta.dirname, '../../../../data'), folder)
    await check(`${files.length} recordings of Measure have the laws and numbers of the program`, async () => {
      let [laws, numbers] = [0, 0]
      for (const { name, bytes } of files) {
        const path = join(folder, `${name}.csv`)
        writeFileSync(path, bytes)
        const answer = spawnSync(program, ['fit', path, '--json', '--quiet'], { encoding: 'utf8', maxBuffer: 1 << 28 })
        await drop(page, basename(path), bytes)
        if (answer.status === 2) {
          await page.locator('.bad', { hasText: 'could not be read' }).waitFor()
          continue
        }
        await page.locator('.row', { hasText: basename(path) }).waitFor({ timeout: 30000 })
        await settled(page, 180)
        const theirs = JSON.parse(answer.stdout)
        const rows = await page.locator('[data-quantity]').evaluateAll((all) => all.map((cell) => [cell.dataset.quantity, cell.innerText]))
        assert.equal(rows.length > 0, theirs.status === 'converged', `${basename(path)}: ${theirs.status}`)
        laws += rows.length > 0
        for (const [quantity, text] of rows) {
          const found = theirs.parameters[quantity] ?? theirs.derived[quantity]
          const unit = plain(text).match(/[^\d.)±×⁻⁰¹²³⁴⁵⁶⁷⁸⁹ -][^\d]*$/)?.[0].trim() ?? ''
          if (!found || !(unit === '' || unit in units)) continue
          ++numbers
          agree(text.split('±')[0], found.value, `${basename(path)}, ${quantity}`, units[unit] ?? 1, 1e-4 * Math.abs(found.standard_error / found.value))
        }
      }
      assert.ok(laws >= 15 && numbers >= 40, `${laws} laws, ${numbers} numbers`)
    })
    await check('nothing went wrong', async () => assert.deepEqual(faults, []))
    await context.close()
  }
  await browser.close()
  rmSync(folder, { recursive: true })
}
finish()
