// A first-year's path, on the built file from disk: open, drop a logger's file, its law, the mass, the report printed:
// node tests/browser/path.mjs
import assert from 'node:assert/strict'
import { execFileSync, spawnSync } from 'node:child_process'
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { basename, join, resolve } from 'node:path'
import { inflateSync } from 'node:zlib'
import { check, drop, finish, launch, open, settled } from './harness.mjs'
import { program } from './served_page.mjs'

const shared = process.env.CROMER_DATA ?? resolve(import.meta.dirname, '../../../../../shared/data')
const loggers = [
  { file: join(shared, 'spring-disc-pasco/molla_dura_discopieno_0.1223kg.csv'), dialect: /PASCO/, mass: '122.3 ± 0.3 g', quantity: 'stiffness' },
  { file: join(shared, 'pendulum-phyphox/RawData_converted_from_xls.csv'), dialect: /phyphox/, quantity: 'angular_frequency' },
  { file: resolve(import.meta.dirname, '../../../../data/recording2.csv'), dialect: /plain|table/i, mass: '217.6 ± 0.3 g', quantity: 'stiffness' },
]
const browser = await launch()
const folder = mkdtempSync(join(tmpdir(), 'cromer-path-'))
const margin = { top: '15mm', bottom: '15mm', left: '15mm', right: '15mm' }
const paper = { width: 702, height: 1009 } // [px] what is left of an A4 page

/** Of a picture: the share of its pixels that are not nearly white, and how many of them lie at its left and right edges. */
const pixels = await (await browser.newContext()).newPage()
const seen = (png) =>
  pixels.evaluate(async (text) => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]))
    const { width, height } = image
    const copy = new OffscreenCanvas(width, height).getContext('2d')
    copy.drawImage(image, 0, 0)
    const { data } = copy.getImageData(0, 0, width, height)
    const light = (x, y) => [0, 1, 2].every((c) => data[4 * (y * width + x) + c] > 230)
    let [inked, left, right] = [0, 0, 0]
    for (let y = 0; y < height; ++y)
      for (let x = 0; x < width; ++x)
        if (!light(x, y)) {
          ++inked
          if (x === 0) ++left
          if (x === width - 1) ++right
        }
    return { inked: inked / (width * height), left, right }
  }, png.toString('base64'))

/** The lines and curves that a PDF draws. */
const strokes = (pdf) => {
  let count = 0
  for (let from = 0, at; (at = pdf.indexOf('stream', from)) >= 0; from = pdf.indexOf('endstream', at) + 9) {
    const begin = at + (pdf[at + 6] === 13 ? 8 : 7)
    try {
      const text = inflateSync(pdf.subarray(begin, pdf.indexOf('endstream', begin))).toString('latin1')
      count += (text.match(/ [lc]$/gm) ?? []).length
    } catch {
      // a picture or a font
    }
  }
  return count
}

const numbers = (page) => page.locator('[data-quantity]').evaluateAll((all) => Object.fromEntries(all.map((each) => [each.dataset.quantity, each.parentElement.innerText.replace(/\s+/g, ' ').trim()])))

for (const { file, dialect, mass, quantity } of loggers) {
  const name = basename(file)
  if (!existsSync(file)) {
    console.log(`skip  ${name}: it is not there`)
    continue
  }
  // at night: what is printed is light all the same
  const { page, context, faults } = await open(browser, { colorScheme: 'dark', permissions: ['clipboard-read', 'clipboard-write'] })
  await check(`${name}: dropped, it has a law`, async () => {
    await page.getByRole('link', { name: 'Measure' }).click()
    await drop(page, name, readFileSync(file))
    await page.locator('.row', { hasText: name }).waitFor({ timeout: 30000 })
    assert.match(await page.locator('.row').innerText(), dialect)
    const first = page.locator(`[data-quantity=${mass ? 'frequency' : quantity}]`) // the swing may be wider than its law's well
    await first.waitFor({ timeout: 90000 })
    await settled(page, 180)
    assert.match(await first.innerText(), /\d±|\d\u00a0±\u00a0\d|\(\d+\)/)
  })
  if (mass)
    await check(`${name}: with its mass it has a spring constant`, async () => {
      assert.equal(await page.locator('[data-quantity=stiffness]').count(), 0)
      await page.getByRole('button', { name: 'change' }).click()
      await page.getByLabel('mass').fill(mass)
      await page.keyboard.press('Enter')
      await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 90000 })
      await settled(page, 180)
      await page.getByRole('button', { name: 'done' }).click()
      assert.match(await page.locator('[data-quantity=stiffness]').innerText(), /\d\u00a0±\u00a0\d[\d.]*\u00a0N\/m/)
    })
  await check(`${name}: the report by its command has the same law`, async () => {
    assert.ok(program, 'the program is not built')
    const law = await numbers(page)
    await page.getByRole('button', { name: 'Copy report command' }).click()
    const command = await page.evaluate(() => navigator.clipboard.readText())
    assert.match(command, /^cromer report .* -o report$/)
    writeFileSync(join(folder, name), readFileSync(file))
    const { status, stderr } = spawnSync(command.replace(/^cromer/, `"${program}"`), { shell: true, cwd: folder, encoding: 'utf8' })
    assert.equal(status, 0, stderr)
    const results = JSON.parse(readFileSync(join(folder, 'report/results.json')))
    let compared = 0
    for (const [key, text] of Object.entries(law)) {
      const found = results[`lab.${key}`]
      if (!found || /above/.test(text)) continue
      const [, digits] = text.replaceAll('−', '-').replaceAll('\u202f', '').match(/ (-?\d[\d.]*)/)
      const places = digits.split('.')[1]?.length ?? 0
      const factor = { 'g/s': 1e3, 'mg/s': 1e6, 'g/m': 1e3 }[text.match(/(mg|kg|g)\/[ms]/)?.[0]] ?? 1
      assert.ok(Math.abs(Number(digits) - found.value * factor) <= 0.51 * 10 ** -places, `${key}: "${text}", the program has ${found.value} ${found.unit}`)
      ++compared
    }
    assert.ok(compared >= 3, `${compared} numbers`)
    assert.equal(results[`lab.${quantity}`].value > 0, true)
  })
  await check(`${name}: its report is printed`, async () => {
    const onScreen = await numbers(page)
    const pdf = await page.pdf({ format: 'A4', margin, path: join(folder, 'report.pdf') })
    await page.setViewportSize(paper)
    await page.emulateMedia({ media: 'print' })
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
    // the numbers of the screen
    assert.deepEqual(await numbers(page), onScreen)
    if (mass) assert.ok((await page.locator('main').innerText()).includes(mass.replace(' g', '')))
    // figures that are drawn, on white, within the paper
    const figures = page.locator('.printed svg:visible')
    assert.ok((await figures.count()) >= 3)
    for (const figure of await figures.all()) {
      const { inked, left, right } = await seen(await figure.screenshot())
      assert.ok(inked > 0.005 && inked < 0.5, `${inked} of a figure is drawn`)
      assert.equal(left + right, 0, 'a figure is cut')
    }
    assert.ok(strokes(pdf) > 500, `the PDF has ${strokes(pdf)} strokes`)
    assert.ok((await seen(await page.screenshot({ fullPage: true }))).inked < 0.3, 'the ground is dark')
    // nothing to press, nothing beyond the edge
    const beyond = await page.evaluate((width) => {
      const shown = (each) => each.checkVisibility() && each.getClientRects().length > 0 && getComputedStyle(each).clipPath === 'none'
      const all = [...document.querySelectorAll('main *')].filter(shown)
      return {
        pressed: all.filter((each) => each.matches('button, select, input') && !each.closest('.choices')).map((each) => each.textContent.trim()),
        cut: all.filter((each) => each.getBoundingClientRect().right > width + 1 || (getComputedStyle(each).overflowX !== 'visible' && each.scrollWidth > each.clientWidth + 1)).map((each) => each.outerHTML.slice(0, 80)),
      }
    }, paper.width)
    assert.deepEqual(beyond, { pressed: [], cut: [] })
    // and as paper, where something can turn it into pixels
    try {
      execFileSync('pdftoppm', ['-png', '-r', '60', join(folder, 'report.pdf'), join(folder, 'sheet')], { stdio: 'ignore' })
    } catch {
      return
    }
    const first = ['sheet-1.png', 'sheet-01.png'].map((each) => join(folder, each)).find(existsSync)
    const { inked, left, right } = await seen(readFileSync(first))
    assert.ok(inked > 0.01 && inked < 0.3, `${inked} of the sheet is drawn`)
    assert.equal(left + right, 0, 'something is printed at the edge')
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

rmSync(folder, { recursive: true })
await browser.close()
finish()
