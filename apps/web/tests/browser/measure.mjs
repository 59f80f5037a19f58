// Measure in a real browser, on the built file from disk: node tests/browser/measure.mjs
import assert from 'node:assert/strict'
import { existsSync } from 'node:fs'
import { readFile } from 'node:fs/promises'
import { basename } from 'node:path'
import { fileURLToPath } from 'node:url'
import { flawed, longSwing, recordings, swingIn, twoRuns } from './dialects.mjs'
import { axe, check, drop, finish, framesWhileFitting, holdable, launch, open, release, saved, settled, slabs } from './harness.mjs'

const browser = await launch()

async function measure(options = {}) {
  const opened = await open(browser, options)
  await opened.page.locator('header nav a').nth(1).click()
  return opened
}
const value = (page, quantity) => page.locator(`[data-quantity=${quantity}]`).innerText()
const numberIn = (text) => Number(text.replace(/\u202f/g, '').match(/[\d.]+/)[0])
const faultless = async (page, what) => {
  await page.evaluate(axe)
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ['violations'] }))
  const serious = found.violations.filter((each) => ['serious', 'critical'].includes(each.impact))
  assert.deepEqual(serious.map((each) => `${each.id}: ${each.nodes[0].html.slice(0, 160)} ${each.nodes[0].failureSummary}`), [], what)
}

{
  const { page, faults, context } = await measure({ watch: holdable })
  await check('an empty page says what to do', async () => {
    assert.match(await page.locator('.zone h1').innerText(), /Drop a recording here/)
    assert.equal(await page.locator('.examples button').count(), 3)
    await faultless(page, 'empty')
  })
  await check('a bad file is refused with the core’s message', async () => {
    await drop(page, 'poem.txt', 'no table\njust words\n')
    await page.getByRole('alert').waitFor()
    assert.match(await page.getByRole('alert').innerText(), /could not be read.*poem\.txt: no rows of numbers/)
    assert.equal(await page.locator('.zone').count(), 1)
  })
  for (const [dialect, name, content] of recordings)
    await check(`${dialect}: ${name} is read and fitted`, async () => {
      await drop(page, name, content)
      await page.locator('.row', { hasText: name }).waitFor({ timeout: 20000 })
      assert.match(await page.locator('.row').innerText(), new RegExp(dialect, 'i'))
      await page.locator('[data-quantity=frequency]').waitFor({ timeout: 60000 })
      assert.ok(Math.abs(numberIn(await value(page, 'frequency')) - 1.5) < 0.003, await value(page, 'frequency'))
    })
  await check('a bad file leaves what is open', async () => {
    await drop(page, 'bad.csv', 'Time (s),Position (m)\n0,1\n0.1,2\n0.2,abc\n0.3,1\n')
    await page.getByRole('alert').waitFor()
    assert.match(await page.getByRole('alert').innerText(), /bad\.csv:4: .*abc/)
    assert.match(await page.locator('.row').innerText(), /latin\.csv/)
    await page.locator('[data-quantity=frequency]').waitFor()
  })
  await check('spikes and gaps are counted', async () => {
    await drop(page, 'flawed.csv', flawed)
    await page.locator('.row', { hasText: 'flawed.csv' }).waitFor()
    await page.locator('[data-quantity=frequency]').waitFor({ timeout: 60000 })
    assert.match(await page.locator('.row').innerText(), /1 spike set aside, 1 gap of 0\.70\u00a0s/)
  })
  await check('runs without times ask for the rate, then fit', async () => {
    await drop(page, 'runs.csv', twoRuns)
    await page.locator('#rate').waitFor()
    await page.locator('.fit ~ *, .bad').first().waitFor()
    await page.locator('#rate').fill('50')
    await page.keyboard.press('Enter')
    await page.locator('[data-quantity=frequency]').waitFor({ timeout: 60000 })
    await page.getByLabel('Run', { exact: true }).selectOption('2')
    await settled(page)
    assert.ok(Math.abs(numberIn(await value(page, 'frequency')) - 1.5) < 0.003)
  })
  await check('a pasted table is read', async () => {
    await page.evaluate((text) => {
      const data = new DataTransfer()
      data.setData('text', text)
      window.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true }))
    }, recordings[11][2])
    await page.locator('.row', { hasText: 'pasted.csv' }).waitFor()
    await page.locator('[data-quantity=frequency]').waitFor({ timeout: 60000 })
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  const { page, faults, context } = await measure()
  await check('the second lab’s story in a few clicks', async () => {
    await page.locator('.examples button').first().click()
    await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 60000 })
    await settled(page)
    assert.match(await value(page, 'stiffness'), /17\.040\u00a0±\u00a00\.023\u00a0N\/m/)
    assert.match(await page.locator('.panel').innerText(), /One decay rate is not enough\. It falls from 0\.01\d+ to 0\.00\d+ 1\/s/)
    assert.match(await page.locator('.panel').innerText(), /The mass limits k\./)
    await faultless(page, 'fitted')
  })
  await check('handles move by keys alone, one sample and ten', async () => {
    const start = page.getByRole('slider', { name: 'start of the free part' })
    await start.focus()
    await page.keyboard.press('ArrowRight')
    assert.equal(Number(await start.getAttribute('aria-valuenow')), 0.01)
    await page.keyboard.press('Shift+ArrowRight')
    assert.equal(Number(await start.getAttribute('aria-valuenow')), 0.11)
    const end = page.getByRole('slider', { name: 'end of the free part' })
    await end.focus()
    await page.keyboard.press('PageDown')
    assert.equal(Number(await end.getAttribute('aria-valuenow')), 114)
    await settled(page)
    assert.match(await page.locator('code').last().getAttribute('title'), /--from 0\.11 --to 114/)
    await page.getByRole('button', { name: 'Undo', exact: true }).click()
    assert.equal(Number(await end.getAttribute('aria-valuenow')), 120)
  })
  await check('handles follow the pointer', async () => {
    const start = page.getByRole('slider', { name: 'start of the free part' })
    const box = await start.boundingBox()
    await page.mouse.move(box.x + box.width / 2, box.y + 60)
    await page.mouse.down()
    await page.mouse.move(box.x + box.width / 2 + 100, box.y + 60, { steps: 6 })
    await page.mouse.up()
    assert.ok(Number(await start.getAttribute('aria-valuenow')) > 8)
  })
  await check('what is not used pales, and no dark slab lies on it', async () => {
    await settled(page)
    assert.equal(await slabs(page), 0)
    const svg = await saved(page, 'recording.svg')
    assert.match(svg, /fill-opacity="0\.5"/)
    for (const [, colour] of svg.matchAll(/(?:fill|stroke)="([^"]*)"/g)) assert.match(colour, /^(none|#[\da-f]{3}|#[\da-f]{6})$/)
  })
  await check('the page draws on while it waits for a fit, which can be superseded', async () => {
    const end = page.getByRole('slider', { name: 'end of the free part' })
    await end.focus()
    await page.evaluate(() => (window.held = []))
    for (let i = 0; i < 8; ++i) {
      await page.keyboard.press('PageDown')
      await page.waitForTimeout(250) // each rests long enough to be asked for
    }
    await page.locator('.fit[aria-busy=true]').waitFor()
    assert.equal(await framesWhileFitting(page, 20), 20)
    assert.equal(Number(await end.getAttribute('aria-valuenow')), 72)
    await release(page)
    await settled(page)
    assert.match(await page.locator('.caption', { hasText: 'Free part' }).innerText(), /72\.00/)
  })
  await check('another law can be chosen, and a bad mass says so', async () => {
    await page.locator('header select[aria-label="choose another"]').selectOption('viscous')
    await settled(page)
    assert.match(await page.locator('.panel').innerText(), /viscous, as you chose/)
    await page.getByRole('button', { name: 'change' }).click()
    await page.locator('[data-field=mass]').fill('217 parsnips')
    await page.keyboard.press('Enter')
    await page.locator('[data-field=mass][aria-invalid=true]').waitFor()
    await page.locator('[data-field=mass]').fill('0,2176 ± 0,0003 kg')
    await page.keyboard.press('Enter')
    await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 30000 })
  })
  await check('simulations of the law lie beside it', async () => {
    await page.locator('header select[aria-label="choose another"]').selectOption('viscous+drag')
    await settled(page)
    await page.getByRole('button', { name: 'Show simulations' }).click()
    await page.locator('.legend', { hasText: 'Euler-Cromer' }).waitFor({ timeout: 30000 })
    await settled(page)
    const [position, velocity, energy, phase] = await page.locator('.plots .plots [role=img]').evaluateAll((all) => all.map((each) => each.ariaLabel))
    assert.match(position, /^Displacement against time, .*exact law ends at .*forward Euler grows to .*Euler-Cromer ends at .*measured ends at/)
    assert.match(velocity, /^Velocity against time, .*forward Euler grows to .*measured ends at/)
    assert.match(energy, /^Energy against time, .*forward Euler grows to/)
    assert.match(phase, /^Velocity against displacement, /)
    assert.match(await page.locator('.plots').first().innerText(), /With one constant decay rate the amplitude at the end is off by [+−]/)
    await faultless(page, 'overlay')
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  const { page, faults, context } = await measure({ width: 390, height: 844, locale: 'de-DE', colorScheme: 'dark', hasTouch: true })
  await check('German, dark, on a phone', async () => {
    assert.match(await page.locator('.zone h1').innerText(), /Eine Aufnahme hier ablegen/)
    await page.locator('.examples button').nth(1).click()
    await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 60000 })
    await settled(page)
    assert.match(await value(page, 'stiffness'), /16,\d+\u00a0±/)
    assert.match(await page.locator('.panel').innerText(), /Eine Abklingrate genügt\./)
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'the page is wider than the phone')
    await faultless(page, 'phone')
  })
  await check('the core’s messages are German too', async () => {
    await drop(page, 'schlecht.csv', 'Zeit (s),Ort (m)\n0,1\n0.1,2\n0.2,abc\n0.3,1\n')
    await page.getByRole('alert').waitFor()
    assert.match(await page.getByRole('alert').innerText(), /schlecht\.csv:4: Spalte „Ort \(m\)“: „abc“ ist keine Zahl; bitte/)
    await page.getByRole('button', { name: 'ändern' }).click()
    await page.locator('[data-field=mass]').fill('217 Pastinaken')
    await page.keyboard.press('Enter')
    await page.locator('[data-field=mass][aria-invalid=true]').waitFor()
    assert.match(await page.locator('.fields .bad').innerText(), /die Einheit „Pastinaken“ ist unbekannt; erwartet wird eine Masse/)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

// A device of many processors fits in several workers: with the same result.
const panels = []
for (const processors of [1, 8]) {
  const watch = `window.workers = 0
    Object.defineProperty(navigator, 'hardwareConcurrency', { value: ${processors} })
    window.Worker = class extends Worker { constructor(...all) { super(...all); ++window.workers } }`
  const { page, faults, context } = await open(browser, { watch })
  await page.waitForFunction(() => window.workers === 3) // the page's first, resonance curves, stability limits
  await page.locator('header nav a').nth(1).click()
  await check(`the laws are compared with ${processors} processors`, async () => {
    const before = await page.evaluate(() => window.workers)
    await page.locator('.examples button').first().click()
    await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 60000 })
    await settled(page)
    panels.push(await page.locator('.panel').innerText())
    const workers = (await page.evaluate(() => window.workers)) - before
    assert.equal(workers, processors === 1 ? 1 : 3)
    assert.equal(panels.at(-1), panels[0])
    assert.deepEqual(faults, [])
  })
  await context.close()
}

{
  const { page, faults, context } = await measure()
  const opened = async (name, content) => {
    await drop(page, name, content)
    await page.locator('.row', { hasText: name }).waitFor({ timeout: 30000 })
    await page.locator('[data-quantity=frequency]').waitFor({ timeout: 90000 })
    await settled(page, 180)
  }
  const csv = async (plot) => (await saved(page, `${plot}.csv`)).trim().split('\n')
  const w = 2 * Math.PI * 1.5
  for (const [name, heading, unit, measured, displacement, amplitude, residual] of [
    ['g.csv', 'Time (s),Acceleration (g)', 1 / 9.80665, 'acceleration (m/s²)', 'mm', 30 / w ** 2, 'm/s²'],
    ['degrees.csv', 'Time (s),Gyroscope x (deg/s)', 180 / Math.PI, 'angular velocity (rad/s)', 'rad', 0.03 / w, 'rad/s'],
    ['speed.csv', 'Time (s),Velocity (cm/s)', 100, 'velocity (cm/s)', 'mm', 30 / w, 'mm/s'],
  ])
    await check(`a recording of ${heading.slice(9)} has the units of what is drawn`, async () => {
      await opened(name, swingIn(heading, 1, unit))
      for (const plot of ['recording', 'fit']) assert.match((await csv(plot))[0], new RegExp(`${measured.replace(/[()]/g, '\\$&')}`))
      const [, first] = (await csv('fit')).map((line) => line.split(',').map(Number))
      const scale = measured.includes('cm/s') ? 100 : 1
      assert.ok(Math.abs(first.at(-1)) < 0.031 * scale && Math.abs(first.at(-1)) > 1e-6 * scale, `${first}`)
      const heads = (await csv('decay-rate'))[0]
      assert.ok(heads.includes(`amplitude (${displacement})`), heads)
      const said = await page.locator('section[aria-label="Decay rate against amplitude"] .unseen').innerText()
      const largest = Number(said.match(/at amplitude ([\d.]+)/)[1])
      assert.ok(largest < amplitude && largest > 0.8 * amplitude, `${said}: ${amplitude}`)
      assert.ok((await page.locator('section[aria-label="The law of this oscillator"]').first().innerText()).includes(`\u00a0${residual}`), residual)
    })
  for (const [unit, times] of [['µs', 1e6], ['min', 1 / 60]])
    await check(`times in ${unit} are shown and cut in seconds`, async () => {
      await opened(`times_${times}.csv`, swingIn(`Time (${unit}),Position (cm)`, times, 100))
      const end = page.getByRole('slider', { name: 'end of the free part' })
      assert.equal(Number(await end.getAttribute('aria-valuenow')).toFixed(2), '23.98')
      assert.match(await page.locator('.caption', { hasText: 'Free part' }).innerText(), /0\.00\u00a0s to 23\.98\u00a0s/)
      assert.match(await page.locator('.row').innerText(), /1\u202f200 at 50\.000\u00a0Hz/)
      await end.focus()
      await page.keyboard.press('PageDown')
      await settled(page)
      assert.match(await page.locator('code').last().getAttribute('title'), /--to 22\.78/)
      assert.ok(Math.abs(numberIn(await value(page, 'frequency')) - 1.5) < 0.003)
      const rows = await csv('recording')
      assert.equal(rows.length, 1201)
      assert.equal(rows[0], 'time (s),measured: position (cm)')
    })
  await check('a second file takes the first one’s place, and Undo brings that back', async () => {
    const before = await page.locator('.row').first().innerText()
    await opened('second.csv', swingIn('Time (s),Position (cm)', 1, 100))
    await page.getByRole('status').getByRole('button', { name: 'Undo' }).click()
    await page.waitForFunction((text) => document.querySelector('.row')?.innerText === text, before)
    await settled(page)
    assert.match(await page.locator('code').last().getAttribute('title'), /--to 22\.78/)
  })
  await check('another column is taken by the core', async () => {
    const lines = swingIn('Time (s),Position x (cm)', 1, 100).trim().split('\n')
    await opened('two.csv', lines.map((line, i) => `${line},${i ? Number(line.split(',')[1]) * 2 : 'Position y (cm)'}`).join('\n'))
    const column = page.getByLabel('Column used')
    assert.equal(await column.inputValue(), 'Position y (cm)') // it swings further
    const largest = async () => Math.max(...(await csv('recording')).slice(1).map((line) => Number(line.split(',')[1])))
    const before = await largest()
    await column.selectOption('Position x (cm)')
    await settled(page)
    assert.ok(Math.abs(before / (await largest()) - 2) < 1e-9)
    assert.match(await page.locator('code').last().getAttribute('title'), /Position x/)
  })
  await check('the modes of one run are not shown of the next', async () => {
    let text = 'Time (s) Run #1,Position A (m) Run #1,Position B (m) Run #1,Time (s) Run #2,Position A (m) Run #2\n'
    for (let i = 0; i < 1000; ++i) {
      const t = i / 25, [slow, fast] = [5, 6].map((w) => Math.exp(-0.01 * t) * Math.cos(w * t))
      text += [t, slow + fast, slow - fast, t, slow].map((x) => x.toFixed(4)).join(',') + '\n'
    }
    await opened('runs.csv', text)
    await page.getByText('cromer modes runs.csv --run 1').waitFor({ timeout: 30000 })
    await page.locator('select[aria-label=Run]').selectOption('2')
    await settled(page)
    assert.equal(await page.getByText('cromer modes').count(), 0)
  })
  await check('200 000 samples are drawn and saved', async () => {
    await opened('long.csv', longSwing())
    for (let i = 0; i < 8; ++i) await page.getByRole('button', { name: 'Longer frame' }).click()
    await page.waitForTimeout(500)
    const frame = page.getByRole('slider', { name: 'frame that is shown larger' })
    assert.match(await frame.getAttribute('aria-valuetext'), /^0\.00 – 200\.00 s/)
    assert.deepEqual(faults, [])
    const rows = await csv('recording')
    assert.equal(rows.length, 200_001)
    const times = rows.slice(1).map((line) => Number(line.split(',')[0]))
    assert.ok(times.every((t, i) => t === i / 1000))
    await page.locator('section[aria-label=Recording]').getByRole('button', { name: 'Show numbers' }).click()
    assert.match(await page.locator('.numbers').innerText(), /200.?000/)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

const shared = process.env.CROMER_DATA ?? fileURLToPath(new URL('../../../../../shared/data/', import.meta.url))
const measured = [
  ['spring-disc-pasco/molla_dura_discopieno_0.1223kg.csv', 'PASCO Capstone, decimal comma', /1\.2\d+/],
  ['pendulum-tracker/8047.txt', 'Tracker', /0\.41\d+/],
  ['pendulum-phyphox/RawData_converted_from_xls.csv', 'phyphox', /\d/], // a hand moves it for its first second
  ['pendulum-plain/lab1_data.txt', 'plain', /\d/],
]
if (!existsSync(shared)) console.log(`skip  measured recordings: ${shared} is not there`)
else {
  const { page, faults, context } = await measure()
  for (const [file, dialect, frequency] of measured)
    await check(`measured: ${file}`, async () => {
      await drop(page, basename(file), await readFile(shared + file))
      await page.locator('.row', { hasText: basename(file) }).waitFor({ timeout: 20000 })
      assert.match(await page.locator('.row').innerText(), new RegExp(dialect))
      await settled(page)
      assert.match(await value(page, 'frequency'), frequency)
    })
  await check('a recording without a swing is not fitted, and it is said', async () => {
    await drop(page, 'train2.txt', await readFile(`${shared}seismometer-datastudio/train2.txt`))
    await page.locator('.row', { hasText: 'train2.txt' }).waitFor()
    await page.getByRole('alert').waitFor({ timeout: 60000 })
    assert.equal(await page.locator('[data-quantity]').count(), 0)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

await browser.close()
finish()
