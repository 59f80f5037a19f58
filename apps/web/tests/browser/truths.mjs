// Nothing false on the page, on the built file from disk: node tests/browser/truths.mjs
import assert from 'node:assert/strict'
import { createServer } from 'node:http'
import { readFileSync } from 'node:fs'
import { address, check, drop, file, finish, launch, open, saved, settled, slabs } from './harness.mjs'

const browser = await launch()

/** One row for each 10 ms: time and what `of` gives at it, in metres. */
const recording = (seconds, of, heading = 'Time (s),Position (m)') => {
  const lines = [heading]
  for (let i = 0; i < 100 * seconds; ++i) lines.push([i / 100, ...[of(i / 100, i)].flat()].map((value) => (typeof value === 'number' ? Number(value.toPrecision(9)) : value)).join(','))
  return `${lines.join('\n')}\n`
}
/** The same each time, and without lines of its own (splitmix32). */
function noise(i, size = 3e-4) {
  let z = Math.imul(i + 1, 0x9e3779b9)
  z = Math.imul(z ^ (z >>> 16), 0x21f0aaad)
  z = Math.imul(z ^ (z >>> 15), 0x735a2d97)
  return (((z ^ (z >>> 15)) >>> 0) / 2 ** 32 - 0.5) * size
}
const measure = async (options) => {
  const opened = await open(browser, options)
  await opened.page.locator('header nav a').nth(1).click()
  return opened
}
const fitted = async (page, name, content) => {
  await drop(page, name, content)
  await page.locator('.row', { hasText: name }).waitFor({ timeout: 30000 })
  await settled(page, 120)
}
const panel = (page) => page.locator('.panel').innerText()
const go = async (page, hash) => {
  await page.goto(address + hash)
  await page.reload()
  await page.locator('main').waitFor()
  await page.waitForTimeout(1200)
}

{
  const { page, faults, context } = await measure()
  await check('no story is told of a fit that the core doubts', async () => {
    await fitted(page, 'beats.csv', recording(60, (t, i) => 0.2 + 0.03 * Math.cos(9 * t) + 0.022 * Math.cos(9.35 * t) + noise(i)))
    assert.doesNotMatch(await page.locator('body').innerText(), /quote the law|One decay rate is enough|The mass limits/)
    await fitted(page, 'rising.csv', recording(60, (t, i) => 0.2 + 0.01 * Math.exp(0.02 * t) * Math.cos(9 * t) + noise(i)))
    assert.doesNotMatch(await page.locator('body').innerText(), /quote the law|One decay rate is enough|The mass limits/)
  })
  await check('two columns have their modes, with the truth in their intervals', async () => {
    const mode = (t, frequency, decay) => 0.03 * Math.exp(-decay * t) * Math.cos(2 * Math.PI * frequency * t)
    const carts = (t, i) => [mode(t, 0.8, 0.02) + mode(t, 1.3, 0.05) + noise(2 * i), 0.9 * mode(t, 0.8, 0.02) - mode(t, 1.3, 0.05) + noise(2 * i + 1)]
    await fitted(page, 'carts.csv', recording(40, carts, 'Time (s),Left (m),Right (m)'))
    const rows = page.locator('section', { hasText: 'The columns together: modes' }).locator('tbody tr')
    await rows.first().waitFor({ timeout: 60000 })
    const told = (await rows.allInnerTexts()).map((text) => text.replaceAll('\u202f', ''))
    assert.equal(told.length, 2)
    for (const [i, [frequency, decay, shape]] of [[0.8, 0.02, /1\.00 : 0\.90/], [1.3, 0.05, /(1\.00 : −|−1\.00 : |−0\.99 : |−0\.98 : )/]].entries()) {
      const [f, damping] = [...told[i].matchAll(/([\d.]+)\u00a0to ([\d.]+)/g)].map(([, low, high]) => [Number(low), Number(high)])
      const natural = Math.hypot(frequency, decay / (2 * Math.PI)) // what swings without damping
      assert.ok(f[0] <= natural && natural <= f[1] && f[1] - f[0] < 0.002, told[i])
      const ratio = (100 * decay) / (2 * Math.PI * natural)
      assert.ok(damping[0] <= ratio && ratio <= damping[1], told[i])
      assert.match(told[i], shape)
    }
    assert.match(await page.locator('section', { hasText: 'The columns together' }).locator('code').innerText(), /^cromer modes carts\.csv$/)
    // one column alone has none
    await fitted(page, 'alone.csv', recording(40, (t, i) => carts(t, i)[0]))
    assert.equal(await rows.count(), 0)
  })
  await check('one rate is said to be enough only where it hardly changes', async () => {
    // drag of 0.5 1/m and a rate of 0.01 1/s, 4 mm at 9 rad/s: from 0.0176 to 0.0147 1/s, which 30 s do not show
    const perAmplitude = (4 * 0.5 * 9) / (3 * Math.PI)
    const amplitude = (t) => (0.004 * 0.01 * Math.exp(-0.01 * t)) / (0.01 + perAmplitude * 0.004 * (1 - Math.exp(-0.01 * t)))
    await fitted(page, 'weak.csv', recording(30, (t, i) => 0.2 + amplitude(t) * Math.cos(9 * t) + noise(i, 5e-4)))
    await page.evaluate(() => (location.hash = '#measure?law=viscous'))
    await settled(page)
    const [, from, to, part] = (await panel(page)).match(/No change of the decay rate is seen\.\s+Between the amplitudes ([\d.]+)\u00a0mm and ([\d.]+)\u00a0mm it may still change by up to (\d+)\u00a0%/).map(Number)
    const rates = [from, to].map((mm) => 0.01 + (perAmplitude * mm) / 1000)
    assert.ok((200 * (rates[0] - rates[1])) / (rates[0] + rates[1]) < part, `${from} ${to} ${part}`)
    await fitted(page, 'steady.csv', recording(120, (t, i) => 0.2 + 0.03 * Math.exp(-0.02 * t) * Math.cos(9 * t) + noise(i)))
    assert.match(await panel(page), /One decay rate is enough\.\s+Between the amplitudes .* it changes by at most [\d.]+\u00a0% \(95\u00a0%\)/)
    await page.evaluate(() => (location.hash = '#measure'))
    await settled(page)
  })
  await check('a mass is asked for only where it gives forces', async () => {
    const asked = async () => (await panel(page)).includes('Give the mass')
    await fitted(page, 'metres.csv', recording(20, (t, i) => 0.2 + 0.03 * Math.exp(-0.02 * t) * Math.cos(9 * t) + noise(i)))
    assert.equal(await asked(), true)
    await fitted(page, 'degrees.csv', recording(20, (t, i) => 3 * Math.exp(-0.02 * t) * Math.cos(9 * t) + noise(i, 0.03), 'Time (s),Angle (deg)'))
    assert.equal(await asked(), false)
  })
  await check('the column used is shown after a second file', async () => {
    const two = (first, second) => recording(20, (t, i) => [0.2 + 0.03 * Math.cos(9 * t) + noise(i), 0.1 + 0.02 * Math.cos(9 * t) + noise(i + 7)], `Time (s),${first} (m),${second} (m)`)
    for (const [name, first, second] of [['one.csv', 'Position x', 'Position y'], ['two.csv', 'Position left', 'Position right'], ['three.csv', 'Position x', 'Position z']]) {
      await fitted(page, name, two(first, second))
      const column = page.getByLabel('Column used')
      assert.equal(await column.inputValue(), `${first} (m)`, name)
      assert.equal(await column.evaluate((select) => select.selectedOptions[0]?.text), `${first} (m)`, name)
    }
  })
  await check('where nothing was fitted there are no axes, no command and no pieces, but a way out', async () => {
    await fitted(page, 'noise.csv', recording(613, (_, i) => 0.2 + noise(i)))
    const alert = page.locator('.fit [role=alert]')
    assert.match(await alert.innerText(), /^There is no fit: ./)
    assert.equal(await page.locator('.fit canvas, .residual canvas, section[aria-label="Decay rate against amplitude"], code').count(), 0)
    assert.doesNotMatch(await page.locator('body').innerText(), /too short/)
    await fitted(page, 'part.csv', recording(40, (t, i) => 0.2 + (t < 20 ? 0.03 * Math.exp(-0.3 * t) * Math.cos(9 * t) : 0) + noise(i)))
    await page.locator('[data-quantity=frequency]').waitFor()
    await page.getByRole('slider', { name: 'start of the free part' }).focus()
    for (let i = 0; i < 14; ++i) await page.keyboard.press('PageUp')
    await settled(page)
    await alert.waitFor()
    await alert.getByRole('button', { name: 'Use all of it' }).click()
    await page.locator('[data-quantity=frequency]').waitFor({ timeout: 30000 })
  })
  await check('what the core says names no option of the program, and its numbers are typeset', async () => {
    const said = async () => {
      const text = await page.locator('main').innerText()
      return text.replace(/cromer (fit|compare) .*/g, '')
    }
    await drop(page, 'bad.csv', 'Time (s),Position (m)\n0,1\n0.1,2\n0.2,abc\n0.3,1\n')
    await page.locator('.above [role=alert]').waitFor()
    assert.match(await said(), /bad\.csv:4: .*abc.*mend the row in the file/)
    const files = {
      'cut.csv': recording(20, (t, i) => Math.min(0.215, 0.2 + 0.03 * Math.cos(9 * t)) + (i % 3 ? 0 : noise(i, 1e-6))),
      'jump.csv': recording(20, (t, i) => 0.2 + 0.03 * Math.exp(-0.05 * t) * Math.cos(9 * t) + (t > 10 ? 0.1 : 0) + noise(i)),
      'caught.csv': recording(20, (t, i) => 0.2 + (t < 12 ? 0.03 * Math.exp(-0.02 * t) * Math.cos(9 * t) : 0) + noise(i)),
      'driven.csv': recording(40, (t, i) => 0.2 + 0.01 * Math.cos(7 * t) + 0.03 * Math.exp(-0.2 * t) * Math.cos(9 * t) + noise(i)),
      'still.csv': recording(20, (_, i) => 0.2 + noise(i)),
      'wild.csv': recording(20, (t, i) => 0.2 + 0.03 * Math.exp(-0.01 * t) * Math.cos(9 * t) + (i === 700 ? 5 : 0) + noise(i)),
    }
    for (const [name, content] of Object.entries(files)) {
      await fitted(page, name, content)
      assert.doesNotMatch(await said(), /--[a-z]/, name)
      assert.doesNotMatch(await said(), /\de[+-]?\d/, name)
      assert.doesNotMatch(await said(), /\b(s|m|kg|Hz) \1\b/, name)
    }
  })
  await check('what can be done at once is a button', async () => {
    const command = () => page.locator('code').getAttribute('title')
    const rows = recording(20, (t, i) => 0.2 + 0.03 * Math.exp(-0.02 * t) * Math.cos(9 * t) + noise(i)).split('\n')
    rows[700] = '6.99,abc'
    await drop(page, 'words.csv', rows.join('\n'))
    await page.getByRole('button', { name: 'Skip bad rows' }).click()
    await page.locator('.row', { hasText: 'words.csv' }).waitFor()
    await settled(page)
    assert.match(await command(), /^cromer fit words\.csv --skip-bad-rows$/)
    await fitted(page, 'caught.csv', recording(20, (t, i) => 0.2 + (t < 12 ? 0.03 * Math.exp(-0.02 * t) * Math.cos(9 * t) : 0) + noise(i)))
    // what comes after the catch is left out unasked; who takes some of it in is offered to trim
    assert.match(await page.locator('main').innerText(), /as when a hand catches it: only what comes before/)
    assert.match(await command(), /^cromer fit caught\.csv$/)
    assert.match(await page.locator('.caption', { hasText: 'Free part' }).innerText(), /0\.00\u00a0s to 11\.\d\d\u00a0s/)
    await page.getByRole('slider', { name: 'end of the free part' }).focus()
    await page.keyboard.press('ArrowLeft')
    await settled(page)
    await page.getByRole('button', { name: 'Trim to the swing' }).click()
    await settled(page)
    assert.match(await command(), /^cromer fit caught\.csv --to (11|12)/)
    await fitted(page, 'steady.csv', recording(40, (t, i) => 0.2 + 0.03 * Math.cos(9 * t) + noise(i)))
    await page.getByRole('button', { name: 'It is driven' }).click()
    await settled(page)
    assert.match(await command(), /^cromer fit steady\.csv --drive-frequency auto$/)
    await page.getByRole('button', { name: 'It swings freely' }).click()
    await settled(page)
    assert.match(await command(), /^cromer fit steady\.csv$/)
  })
  await check('intervals are written in full', async () => {
    await page.locator('.row .tools').waitFor()
    await fitted(page, 'long.csv', recording(120, (t, i) => 0.2 + 0.03 * Math.exp(-0.01 * t) * Math.cos(8.849 * t) + noise(i)))
    const rows = await page.locator('.panel td.interval').allInnerTexts()
    assert.ok(rows.length > 2)
    for (const row of rows) assert.match(row.replaceAll('\u202f', ''), /^[−\d.]+\u00a0to [−\d.]+$/)
  })
  await check('a word that a first-year may not know is explained at the word', async () => {
    const interval = page.getByRole('button', { name: '95 % interval' })
    await interval.click()
    assert.match(await page.getByRole('tooltip').innerText(), /In 95 of 100 such recordings/)
    const { x, y, width, height } = await page.getByRole('tooltip').boundingBox()
    assert.ok(x >= 0 && y >= 0 && x + width <= 1440 && y + height <= 900, `${x} ${y} ${width} ${height}`)
    await page.keyboard.press('Escape')
    assert.equal(await page.getByRole('tooltip').count(), 0)
    await page.getByRole('button', { name: 'quality factor' }).focus()
    await page.keyboard.press('Enter')
    assert.match(await page.getByRole('tooltip').innerText(), /How many swings/)
    await page.keyboard.press('Tab')
    assert.equal(await page.getByRole('tooltip').count(), 0)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  const { page, faults, context } = await measure()
  await check('the file that a command names can be saved by that name', async () => {
    await page.locator('.examples button').nth(1).click()
    await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 60000 })
    await settled(page)
    const [, name] = (await page.locator('code').getAttribute('title')).match(/^cromer fit (\S+)/)
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: `Save ${name}` }).click()])
    assert.equal(download.suggestedFilename(), name)
    await fitted(page, 'mine.csv', recording(20, (t, i) => 0.2 + 0.03 * Math.cos(9 * t) + noise(i)))
    assert.equal(await page.getByRole('button', { name: 'Save mine.csv' }).count(), 0)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  const { page, faults, context } = await open(browser)
  await check('phase’s numbers pair each method’s own position and velocity', async () => {
    const [w, h] = [3, 0.02]
    await go(page, `#simulate?damping=0&driveAmplitude=0&stiffness=9&mass=1&position=1&velocity=0&step=${h}&until=3&methods=exact,forward-euler`)
    await page.locator('.plot', { hasText: 'Phase' }).getByRole('button', { name: 'Show numbers' }).click()
    const table = page.locator('.numbers')
    const heads = await table.locator('th').allInnerTexts()
    assert.equal(heads.length, 4, `${heads}`)
    const rows = await table.locator('tbody tr').evaluateAll((all) => all.map((row) => [...row.cells].map((cell) => Number(cell.innerText.replace('−', '-').replace(/\u202f×\u202f10.*/, 'e-9')))))
    const of = (name) => heads.findIndex((head) => head.includes(name))
    const energy = (row, at) => (w * row[at]) ** 2 + row[at + 1] ** 2
    rows.forEach((row, i) => {
      if (Number.isFinite(row[of('exact')])) assert.ok(Math.abs(energy(row, of('exact')) / w ** 2 - 1) < 2e-3, `exact, row ${i}: ${row}`)
      const grown = (1 + (w * h) ** 2) ** i
      if (Number.isFinite(row[of('forward')])) assert.ok(Math.abs(energy(row, of('forward')) / (grown * w ** 2) - 1) < 3e-3, `forward Euler, row ${i}: ${row}`)
    })
  })
  for (const [damping, at] of [[0.2, 2.7], [6, 2]])
    await check(`the resonance curve’s names have the amplitude at the drive, damping ${damping}`, async () => {
      await go(page, `#simulate?damping=${damping}&driveAmplitude=1&driveFrequency=${at}&stiffness=9&mass=1&methods=exact,implicit-euler`)
      const amplitude = 1 / Math.hypot(9 - at * at, damping * at)
      const [value, unit] = amplitude >= 0.1 ? [amplitude, 'm'] : [100 * amplitude, 'cm']
      const words = [...(await saved(page, 'resonance.svg')).matchAll(/>([^<]*)</g)].map(([, text]) => text)
      assert.ok(words.includes(`exact ${value.toPrecision(4)}\u00a0${unit}`), words.join(' | '))
    })
  await check('a typed unit stands alone', async () => {
    await go(page, '#simulate')
    const field = page.locator('.slider:has([data-option="until"]) .entry')
    await field.locator('input').fill('25 s')
    assert.equal(await field.locator('.unit').count(), 0)
    await page.keyboard.press('Escape')
    assert.equal(await field.locator('.unit').innerText(), 's')
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  const { page, faults, context } = await open(browser)
  await check('a class link from disk says where it leads, and a student has a number first', async () => {
    await go(page, '#teach?lab=two')
    await page.getByRole('button', { name: 'Make a class link' }).click()
    await page.getByLabel('Class', { exact: true }).fill('7F3A')
    await page.locator('.on-disk', { hasText: /open from a disk.*class 7F3A/ }).waitFor()
    await go(page, '#teach?lab=two&course=7F3A')
    const take = page.locator('.control button').first()
    assert.equal(await take.innerText(), 'Take your recording')
    assert.equal(await take.isDisabled(), true)
    assert.equal(await page.getByRole('button', { name: 'Check answers' }).isDisabled(), true)
    await page.locator('[data-field=student]').fill('19')
    await page.keyboard.press('Enter')
    await page.getByRole('button', { name: 'Take recording 7F3A-19' }).click()
    await page.locator('[data-goal=done]').waitFor()
    assert.match(await page.locator('.read').innerText(), /7F3A-19\.csv/)
  })
  await check('the recording of one’s own comes back after a reload', async () => {
    await page.locator('nav ol button').nth(1).click()
    await page.locator('[data-field=mass]').fill('217.6 ± 0.3 g')
    await page.keyboard.press('Enter')
    await page.waitForFunction(() => location.hash.includes('mass'))
    await page.reload()
    await page.locator('.read').waitFor({ timeout: 20000 })
    assert.match(await page.locator('.read').innerText(), /7F3A-19\.csv/)
    assert.equal(await page.locator('[data-field=mass]').inputValue(), '217.6 ± 0.3 g')
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  const server = createServer((_, answer) => answer.writeHead(200, { 'content-type': 'text/html; charset=utf-8' }).end(readFileSync(file))).listen(0, '127.0.0.1')
  await new Promise((done) => server.once('listening', done))
  const at = `http://127.0.0.1:${server.address().port}/lab.html`
  const { page, faults, context } = await open(browser, { at, hash: '#teach?lab=two', drawn: false })
  await check('a class link from a server is a QR code too', async () => {
    await page.getByRole('button', { name: 'Make a class link' }).click()
    await page.getByLabel('Class', { exact: true }).fill('7F3A')
    // of one moment: a longer link may be on its way
    const [path, box] = await page.getByRole('img', { name: 'The link as a QR code' }).evaluate((code) =>
      [code.querySelector('path').getAttribute('d'), code.getAttribute('viewBox')])
    // the three squares at its corners, two modules from the edge
    const modules = new Set(path.match(/M\d+ \d+/g))
    const size = Number(box.split(' ')[2])
    for (const [x, y] of [[2, 2], [size - 9, 2], [2, size - 9]]) for (let i = 0; i < 7; ++i) assert.ok(modules.has(`M${x + i} ${y}`) && modules.has(`M${x} ${y + i}`))
    assert.equal(await page.locator('.on-disk').count(), 0)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
  server.close()
}

for (const colorScheme of ['light', 'dark']) {
  const { page, faults, context } = await open(browser, { colorScheme })
  await check(`no slab lies on any step of both labs, ${colorScheme}`, async () => {
    for (const lab of ['one', 'two']) {
      await go(page, `#teach?lab=${lab}`)
      if (lab === 'two') await page.getByRole('button', { name: 'Take the practice recording' }).click()
      const steps = page.locator('nav ol button')
      for (let i = 0; i < (await steps.count()); ++i) {
        await steps.nth(i).click()
        while (await page.locator('.predict button').count()) await page.locator('.predict button').first().click()
        if (lab === 'two') await page.waitForFunction(() => !document.querySelector('[aria-busy=true]'), null, { timeout: 60000 })
        await page.waitForTimeout(700)
        assert.ok((await page.locator('[role=img] canvas').count()) > 0)
        assert.equal(await slabs(page, colorScheme === 'light' ? 128 : 8), 0, `lab ${lab}, step ${i + 1}`)
      }
    }
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

await browser.close()
finish()
