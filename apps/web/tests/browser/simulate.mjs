// Simulate and Keep in a real browser, on the built file from disk: node tests/browser/simulate.mjs
import assert from 'node:assert/strict'
import { readFile } from 'node:fs/promises'
import { axe, check, finish, launch, open } from './harness.mjs'

const browser = await launch()

/** What is seen: the plots' names and the panel, and how often each was drawn. */
const seen = (page) =>
  page.evaluate(() => ({
    text: [...document.querySelectorAll('[role=img]')].map((each) => each.getAttribute('aria-label')).join('\n'),
    panel: document.querySelector('.panel')?.textContent,
    drawn: [...document.querySelectorAll('[data-drawn]')].map((each) => Number(each.dataset.drawn)),
  }))
/** The page has nothing more to draw: for a third of a second nothing has changed. */
async function rest(page) {
  let [before, same] = ['', 0]
  for (let i = 0; i < 120 && same < 4; ++i) {
    await page.waitForTimeout(80)
    const now = JSON.stringify(await seen(page))
    same = now === before ? same + 1 : 0
    before = now
  }
}
/** Opens another link in the same page. */
async function go(page, hash) {
  await page.evaluate(
    (to) =>
      new Promise((resolve) => {
        addEventListener('hashchange', () => setTimeout(resolve, 50), { once: true })
        location.hash = to
      }),
    hash,
  )
  await rest(page)
}
/** The curves are there. */
const ready = (page) =>
  page.waitForFunction(() => / (ends at|grows to|endet bei|wächst auf) /.test(document.querySelector('[role=img]')?.getAttribute('aria-label')))
async function moves(page, act, what) {
  await rest(page)
  const before = await seen(page)
  await act()
  await rest(page)
  const after = await seen(page)
  assert.notDeepEqual([after.text, after.panel, after.drawn], [before.text, before.panel, before.drawn], `${what} moved nothing`)
}
const field = (page, option) => page.locator(`.slider:has([data-option="${option}"]) .field input`)
const slider = (page, option) => page.locator(`[data-option="${option}"]`)
const button = (page, name) => page.getByRole('button', { name })

{
  const silent = () => (window.Worker = class extends EventTarget { postMessage() {} terminate() {} })
  const { page, context } = await open(browser, { watch: silent })
  await check('before the core has answered nothing is said of the law', async () => {
    const said = await page.evaluate(() => [document.body.innerText, ...[...document.querySelectorAll('[aria-label]')].map((each) => each.ariaLabel)].join('\n'))
    assert.match(said, /Set resonance: …/)
    assert.deepEqual(said.match(/choose a method|no resonance|too much damping|∞|= 0\s/gi) ?? [], [])
  })
  await context.close()
}

{
  const { page, faults, context } = await open(browser)
  await ready(page)
  await check('every slider moves something', async () => {
    for (const fold of await page.locator('summary').all()) await fold.click()
    const options = await page.locator('[data-option]').evaluateAll((all) => all.map((each) => each.dataset.option))
    assert.equal(options.length, 17)
    for (const option of options) {
      await slider(page, option).focus()
      await moves(page, () => page.keyboard.press('Shift+ArrowRight'), option)
    }
    await go(page, '#simulate?mass=1')
  })
  await check('every method can be switched off and on', async () => {
    await go(page, '#simulate?until=20')
    const closed = page.locator('details:not([open]) > summary')
    while ((await closed.count()) > 0) await closed.first().click()
    const boxes = page.locator('[data-method]')
    assert.equal(await boxes.count(), 13)
    for (let i = 0; i < 13; ++i) await moves(page, () => boxes.nth(i).click(), `method ${i}`)
  })
  await check('a field takes units, and keeps a bad value with the core’s message', async () => {
    await go(page, '#simulate?mass=3')
    await field(page, 'step').fill('20 ms')
    await page.keyboard.press('Enter')
    await page.waitForFunction(() => location.hash.includes('step=0.02'))
    assert.equal(await field(page, 'step').inputValue(), '0.0200')
    await field(page, 'mass').fill('217.6 g')
    await page.keyboard.press('Enter')
    await page.waitForFunction(() => location.hash.includes('mass=0.2176'))
    await field(page, 'damping').fill('1e-9')
    await page.keyboard.press('Enter')
    await page.waitForFunction(() => location.hash.includes('damping=1e-9'))
    await field(page, 'mass').fill('3 s')
    await page.keyboard.press('Enter')
    const described = await field(page, 'mass').and(page.locator('[aria-invalid=true]')).getAttribute('aria-describedby')
    assert.match(await page.locator(`#${described}`).textContent(), /expected a mass/)
    await field(page, 'mass').fill('-1')
    await page.keyboard.press('Enter')
    await page.waitForFunction(() => /positive/.test(document.querySelector('.message')?.textContent ?? ''))
    await page.keyboard.press('Escape')
    assert.equal(await page.locator('[aria-invalid]').count(), 0)
    await field(page, 'until').fill('1e9')
    await page.keyboard.press('Enter')
    await page.waitForFunction(() => /million/.test(document.querySelector('.message')?.textContent ?? ''))
    await page.keyboard.press('Escape')
  })
  await check('the mass is pulled, let go, and swings; by keys alone too', async () => {
    await go(page, '#simulate?damping=0.1&driveAmplitude=0&position=1&methods=exact')
    const mass = page.getByRole('slider', { name: 'mass: pull it, and let it go' })
    const at = () => page.evaluate(() => Number(new URLSearchParams(location.hash.split('?')[1]).get('position') ?? 0))
    const box = await mass.boundingBox()
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2]
    await page.waitForTimeout(1200) // the frame follows once a change rests
    const reach = Number(await mass.getAttribute('aria-valuemax'))
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x, y + 40, { steps: 4 })
    await rest(page)
    const plot = await page.locator('[data-drawn]').first().boundingBox()
    const pulled = await mass.getAttribute('aria-valuetext')
    // twice the reach lies on all but 68 px of the plot, as it was when the mass was taken hold of
    const down = 1 - Number(pulled.replace('−', '-').split('\u00a0')[0])
    assert.ok(Math.abs(down / ((2 * reach * 40) / (plot.height - 68)) - 1) < 0.05, `${pulled}, reach ${reach}, plot ${plot.height} px high`)
    await page.mouse.up()
    await page.waitForFunction(() => Number(document.querySelector('.read b').innerText.match(/[\d.]+/)[0]) > 0.2)
    assert.equal(Number((await at()).toPrecision(3)), Number(pulled.replace('−', '-').split('\u00a0')[0]))
    assert.equal(await page.getByRole('button', { name: 'Pause' }).count(), 1)
    await button(page, 'Undo').click()
    await rest(page)
    assert.equal(await at(), 1)
    await mass.focus()
    const before = await at()
    for (const key of ['ArrowDown', 'Shift+ArrowDown']) await page.keyboard.press(key)
    await rest(page)
    assert.ok((await at()) < before - 0.1, `${await at()}`)
    assert.equal(await page.getByRole('button', { name: 'Play' }).count(), 1)
    await page.keyboard.press('Enter')
    await page.getByRole('button', { name: 'Pause' }).click()
  })
  await check('two cursors read period and decrement, and energy goes from one place to another', async () => {
    await go(page, '#simulate?damping=0.2&driveAmplitude=0&position=1&stiffness=9&mass=1&methods=exact')
    await button(page, 'Back to the start').click()
    const turning = page.getByRole('button', { name: 'To the next turning point' })
    for (let i = 0; i < 2; ++i) await turning.click()
    await page.getByRole('button', { name: /^Second cursor/ }).click()
    for (let i = 0; i < 2; ++i) await turning.click()
    const [, time, ratio, decrement] = (await page.locator('.between').innerText()).match(/Δt = ([\d.]+)\u00a0s, ratio of the positions ([\d.]+), −ln of it ([\d.]+)/).map(Number)
    const period = (2 * Math.PI) / Math.sqrt(9 - 0.01)
    assert.ok(Math.abs(time / period - 1) < 4e-3, `${time}`)
    assert.ok(Math.abs(ratio - Math.exp(-0.1 * period)) < 1e-3, `${ratio}`)
    assert.ok(Math.abs(decrement - 0.1 * period) < 2e-3, `${decrement}`)
    const energies = (await page.locator('.bars b').allInnerTexts()).map((text) => Number(text.match(/[\d.]+/)[0]))
    assert.ok(energies[0] < 0.02 && Math.abs(energies[1] + energies[2] - 4.5) < 0.02, `${energies}`)
  })
  await check('what the second cursor reads follows the start', async () => {
    await go(page, '#simulate?damping=0.2&driveAmplitude=0&position=1&stiffness=9&mass=1&methods=exact')
    const second = page.getByRole('button', { name: /^Second cursor/ })
    const turning = page.getByRole('button', { name: 'To the next turning point' })
    if ((await second.getAttribute('aria-pressed')) === 'true') await second.click()
    await button(page, 'Back to the start').click()
    await turning.click()
    await second.click()
    const read = async () => (await page.locator('.between').innerText()).replaceAll('−', '-').match(/positions (-?[\d.]+)(, |$)/)
    const w = Math.sqrt(9 - 0.01)
    const x = (t, v) => Math.exp(-0.1 * t) * (Math.cos(w * t) + ((v + 0.1) / w) * Math.sin(w * t))
    const t = Math.PI / w
    await turning.click()
    const [, across, more] = await read()
    assert.ok(Math.abs(across - x(2 * t, 0) / x(t, 0)) < 0.003 && more === '', `${across}`) // no logarithm of what is negative
    await turning.click()
    await field(page, 'velocity').fill('2')
    await page.keyboard.press('Enter')
    await rest(page)
    const [, ratio] = await read()
    assert.ok(Math.abs(ratio - x(3 * t, 2) / x(t, 2)) < 0.003, `${ratio}`)
    await second.click()
  })
  await check('the forces on the mass add up to what accelerates it, and can be hidden', async () => {
    const read = (name) => page.locator(`[data-force="${name}"] b`).innerText().then((text) => Number(text.replace('−', '-').split('\u00a0')[0]))
    const shown = (t) =>
      page.locator('.bar input[type=range]').evaluate((range, to) => {
        range.step = 'any'
        range.value = String(to)
        range.dispatchEvent(new Event('input', { bubbles: true }))
        return new Promise((resolve) => requestAnimationFrame(() => resolve(Number(document.querySelector('.value b').textContent.replace('−', '-')))))
      }, t)
    await go(page, '#simulate?position=1&damping=0.5&cubic=2&friction=0.1&mass=2&methods=dormand-prince&step=0.02')
    for (const t of [0.4, 1.33, 7.2]) {
      const x = await shown(t)
      assert.ok(Math.abs((await read('spring')) + 9 * x + 2 * x ** 3) < 0.02, `spring at ${t} s`)
      assert.ok(Math.abs((await read('drive')) - Math.cos(3 * t)) < 0.006, `drive at ${t} s`)
      assert.equal(Math.abs(await read('friction')), 0.1)
      const all = await Promise.all(['spring', 'viscous', 'friction', 'drive'].map(read))
      assert.ok(Math.abs(all.reduce((a, b) => a + b) - (await read('sum'))) < 0.021, `${all} at ${t} s`)
      // m a by the positions of the neighbourhood
      const h = 0.05
      const [before, after] = [await shown(t - h), await shown(t + h)]
      await shown(t)
      assert.ok(Math.abs((2 * (before - 2 * x + after)) / h ** 2 - (await read('sum'))) < 0.8 + 0.05 * Math.abs(await read('sum')), `m a at ${t} s`)
    }
    const violet = () =>
      page.evaluate(() => {
        const canvas = document.querySelector('[data-drawn] > canvas')
        const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', { willReadFrequently: true })
        copy.drawImage(canvas, 0, 0)
        const { data } = copy.getImageData(0, 0, 170, canvas.height)
        let count = 0
        for (let i = 0; i < data.length; i += 4) count += Number(Math.abs(data[i] - 0x6a) + Math.abs(data[i + 1] - 0x55) + Math.abs(data[i + 2] - 0xc7) < 12 && data[i + 3] > 200)
        return count
      })
    await shown(2 * Math.PI / 3)
    const drawn = await violet()
    assert.ok(drawn > 10, `${drawn} pixels of the drive's arrow`)
    await button(page, 'Show the forces on the mass').click()
    await rest(page)
    assert.equal(await page.locator('[data-force]').count(), 0)
    assert.ok((await violet()) > drawn, 'alone the drive is drawn to its own scale')
    await page.keyboard.press('Enter')
    await rest(page)
    assert.equal(await page.locator('[data-force]').count(), 5)
  })
  await check('energies, forces and cursors say whose they are where the exact law is not shown', async () => {
    const whose = async () => {
      const second = page.getByRole('button', { name: /^Second cursor/ })
      if ((await second.getAttribute('aria-pressed')) !== 'true') await second.click()
      await page.waitForFunction(() => document.querySelector('.forces') && document.querySelector('.bars') && document.querySelector('.between'))
      return Promise.all(['.forces', '.bars', '.between'].map((each) => page.locator(each).innerText()))
    }
    await go(page, '#simulate?methods=implicit-euler,euler-cromer')
    for (const text of await whose()) assert.match(text, /^implicit Euler:/)
    await go(page, '#simulate?methods=implicit-euler,exact')
    for (const text of await whose()) assert.doesNotMatch(text, /Euler|exact/)
    await go(page, '#simulate?methods=rk4,exact&cubic=2')
    for (const text of await whose()) assert.match(text, /^Dormand-Prince:/)
    await page.getByRole('button', { name: /^Second cursor/ }).click()
  })
  await check('a phase plot in words ends where its motion does', async () => {
    const ends = (text) => [...text.matchAll(/(exact|implicit Euler|Euler-Cromer) ends at ([^ ]+?)\.?(?= |$)/g)].map((each) => each.slice(1, 3).join())
    const labels = () => page.locator('[role=img]').evaluateAll((all) => all.map((each) => each.ariaLabel))
    await go(page, '#simulate?quantity=velocity&driveAmplitude=0&position=1&methods=exact,implicit-euler,euler-cromer')
    const [velocity] = await labels()
    const phase = (await labels()).find((each) => each.startsWith('Velocity against position'))
    assert.equal(ends(velocity).length, 3, velocity)
    assert.deepEqual(ends(phase), ends(velocity))
  })
  await check('a link takes what the program takes, and says what it cannot', async () => {
    await go(page, '#simulate?damping=-0.1&driveAmplitude=0&position=1')
    assert.equal(await field(page, 'damping').inputValue(), '\u22120.100')
    assert.match((await page.locator('[role=img]').first().getAttribute('aria-label')), /exact (ends at|grows to)/)
    assert.equal(await page.locator('.toast').count(), 0)
    await go(page, '#simulate?mass=-1&until=20&friction=none')
    assert.equal(await page.locator('.toast').innerText(), 'Not possible in this link: mass=-1 (1 instead); friction=none (0 instead).')
  })
  await check('the energies of a driven motion stay readable beside what is lost', async () => {
    await go(page, '#simulate?position=0&damping=0.2&until=100&methods=exact')
    assert.match(await page.locator('.bars').innerText(), /^kinetic\s+[\d.]+ of 12\.\d\u00a0J\s+spring\s+[\d.]+ of 12\.\d\u00a0J\s+lost\s+[\d.]+ of [1-9]\d\d\u00a0J$/)
    await go(page, '#simulate?driveAmplitude=0&position=1&methods=exact')
    assert.match(await page.locator('.bars').innerText(), /^kinetic\s+[\d.]+ of 4\.50\u00a0J\s+spring\s+[\d.]+ of 4\.50\u00a0J\s+lost\s+[\d.]+ of 4\.50\u00a0J$/)
  })
  await check('an example is one choice and stays named until it is left, slow motion says how slow, a motion is heard', async () => {
    const example = page.getByLabel('examples')
    await example.selectOption('swing')
    await page.waitForFunction(() => location.hash.includes('mass=30'))
    assert.equal(await example.inputValue(), 'swing')
    await slider(page, 'mass').press('ArrowRight')
    await page.waitForFunction(() => !location.hash.includes('mass=30&'))
    assert.equal(await example.inputValue(), '')
    await example.selectOption('fork')
    await page.waitForFunction(() => location.hash.includes('stiffness=152900'))
    await rest(page)
    assert.equal(await example.inputValue(), 'fork')
    await page.getByLabel('Speed of play').selectOption('0.1')
    assert.match(await page.getByLabel('Speed of play').getAttribute('title'), /^0\.000\d+ times as fast as in reality$/)
    await page.getByLabel('Speed of play').selectOption('1')
    await page.getByRole('button', { name: 'Hear the motion' }).click()
    await page.getByRole('button', { name: 'Stop the sound' }).click()
    await page.getByRole('button', { name: 'Hear the motion' }).waitFor({ timeout: 3000 })
  })
  await check('critical damping and resonance are one click', async () => {
    await go(page, '#simulate?driveFrequency=1')
    await button(page, /Set resonance: 2.997/).click()
    await page.waitForFunction(() => location.hash.includes('driveFrequency=2.997'))
    await button(page, /Set critical damping: 6.00/).click()
    await page.waitForFunction(() => location.hash.includes('damping=6'))
  })
  await check('forward Euler is said to grow, and by how much', async () => {
    await go(page, '#simulate?until=26')
    const { panel, text } = await seen(page)
    assert.match(panel, /−0\.0125/)
    assert.match(panel, /grows by 2\.7\s%/)
    assert.match(panel, /0\.0222\ss it is stable/)
    assert.match(text, /forward Euler grows to/)
  })
  await check('a slider’s change is told politely', async () => {
    await slider(page, 'step').focus()
    await page.keyboard.press('ArrowRight')
    await page.waitForFunction(() => /forward Euler grows/.test(document.querySelector('[aria-live=polite].unseen').textContent))
  })
  await check('position, velocity, difference', async () => {
    for (const [name, axis] of [['Velocity', 'Velocity'], ['Difference from exact', 'Difference'], ['Position', 'Position']]) {
      await page.getByRole('radio', { name, exact: true }).check()
      await rest(page)
      assert.ok((await seen(page)).text.startsWith(axis), name)
    }
  })
  await check('without an exact solution Dormand-Prince stands in, by name', async () => {
    await go(page, '#simulate?cubic=2')
    assert.match((await seen(page)).panel, /Dormand-Prince \(reference\)/)
    assert.match((await seen(page)).text, /Dormand-Prince ends at/)
    await page.waitForFunction(() => /Steady amplitude[^\n]*Dormand-Prince ends at/.test([...document.querySelectorAll('[role=img]')].at(-1).getAttribute('aria-label')))
  })
  await check('the exact solution is smooth and read as such at any step, methods are dots at theirs', async () => {
    const saved = async (name) => {
      await button(page, 'Save figure or data').click()
      const [file] = await Promise.all([page.waitForEvent('download'), page.locator(`[data-save="${name}"]`).click()])
      return readFile(await file.path(), 'utf8')
    }
    const read = (t) =>
      page.locator('.bar input[type=range]').evaluate((range, to) => {
        range.step = 'any'
        range.value = String(to)
        range.dispatchEvent(new Event('input', { bubbles: true }))
        return new Promise((resolve) => requestAnimationFrame(() => resolve(document.querySelector('.value b').textContent)))
      }, t)
    await go(page, '#simulate?driveAmplitude=0&position=1&step=0.5&methods=exact,euler-cromer')
    const isRead = async (t, wanted) => {
      const text = await read(t)
      assert.ok(Math.abs(Number(text.replace('−', '-')) - wanted) < 0.00051, `${t} s: ${text}, not ${wanted}`)
    }
    const w = Math.sqrt(9 - 0.1 ** 2)
    const x = (t) => Math.exp(-0.1 * t) * (Math.cos(w * t) + (0.1 / w) * Math.sin(w * t))
    const v = (t) => (-9 / w) * Math.exp(-0.1 * t) * Math.sin(w * t)
    assert.equal(x(1.775).toFixed(3), '0.457')
    for (const t of [1.775, 0.25, 7.3, 24.9]) await isRead(t, x(t))
    const figure = await saved('position.svg')
    const points = (path) => path.match(/[ML]/g).length
    const [road] = figure.match(/<path d="[^"]*" fill="none" stroke="[^"]*" stroke-width="4"/)
    assert.ok(points(road) > 300, `${points(road)} points`)
    assert.equal(figure.match(/<circle[^>]* r="2"/g)?.length, 51)
    // data are those of the steps
    const rows = (await saved('position.csv')).trim().split('\n')
    assert.equal(rows.length, 52)
    assert.match(rows[0], /^time \(s\),exact: position \(m\),Euler-Cromer: position \(m\)$/)
    await page.getByRole('radio', { name: 'Velocity' }).check()
    await rest(page)
    await isRead(1.775, v(1.775))
    await go(page, '#simulate?driveAmplitude=0&position=1&step=0.05&methods=exact,euler-cromer')
    assert.equal((await saved('position.svg')).match(/<circle[^>]* r="2"/g), null)
  })
  await check('undo takes back one change after another', async () => {
    await go(page, '#simulate?until=24')
    await slider(page, 'mass').focus()
    await page.keyboard.press('PageUp')
    await page.getByRole('radio', { name: 'Velocity' }).check()
    await page.locator('[data-method=exact]').click()
    await page.waitForFunction(() => location.hash.includes('velocity') && location.hash.includes('mass') && location.hash.includes('methods'))
    await page.keyboard.press('Control+z')
    await page.waitForFunction(() => !location.hash.includes('methods'))
    await page.keyboard.press('Control+z')
    await button(page, 'Undo').click()
    await page.waitForFunction(() => location.hash === '#simulate?until=24')
  })
  await check('a link brings everything back', async () => {
    await field(page, 'damping').fill('0.05')
    await page.keyboard.press('Enter')
    await slider(page, 'step').focus()
    await page.keyboard.press('PageDown')
    await page.locator('[data-method=rk4]').evaluate((each) => each.closest('details').setAttribute('open', ''))
    await page.locator('[data-method=rk4]').click()
    await rest(page)
    await page.waitForTimeout(1200) // limits have come to rest
    const [link, before] = [page.url(), await seen(page)]
    const other = await open(browser, { hash: link.slice(link.indexOf('#')) })
    await ready(other.page)
    await page.waitForTimeout(1200)
    await rest(other.page)
    const after = await seen(other.page)
    assert.equal(after.text, before.text)
    assert.equal(after.panel, before.panel)
    assert.deepEqual(other.faults, [])
    await other.context.close()
  })
  await check('a link opened just before the page writes its address is not lost', async () => {
    const watch = () => {
      const later = window.setTimeout
      window.setTimeout = (then, after, ...others) => later(after === 250 ? (window.due = then) : then, after, ...others)
    }
    const other = await open(browser, { watch })
    await ready(other.page)
    await other.page.evaluate(() => {
      location.hash = '#simulate?until=3'
      window.due() // before the page hears of the link
    })
    await rest(other.page)
    assert.equal(Number(await field(other.page, 'until').inputValue()), 3)
    await other.page.waitForTimeout(400)
    assert.equal(await other.page.evaluate(() => location.hash), '#simulate?until=3')
    assert.deepEqual(other.faults, [])
    await other.context.close()
  })
  await check('figures and data are saved', async () => {
    for (const [name, test] of [
      ['position.svg', /^<svg[\s\S]*RK4[\s\S]*<\/svg>\n$/], ['position.csv', /^time \(s\),exact: position \(m\),/], ['phase.svg', /velocity/],
      ['resonance.csv', /^drive frequency \(rad\/s\),/], ['energy.png', /^.PNG/],
    ]) {
      await button(page, 'Save figure or data').click()
      const [file] = await Promise.all([page.waitForEvent('download'), page.locator(`[data-save="${name}"]`).click()])
      assert.equal(file.suggestedFilename(), `cromer-${name}`)
      const content = await readFile(await file.path())
      assert.match(content.toString('latin1').slice(0, 200_000), name.endsWith('svg') ? new RegExp(test.source) : test, name)
      assert.ok(content.length > 1000)
    }
  })
  await check('command, study file and link are copied', async () => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write'])
    const copied = async (name) => {
      await button(page, name).click()
      await page.waitForTimeout(150)
      return page.evaluate(() => navigator.clipboard.readText())
    }
    assert.match(await copied('Copy command'), /^cromer simulate --mass 1 .*--method rk4 --step /)
    assert.match(await copied('Copy study file'), /simulate = "run"[\s\S]*damping = "0\.05 kg\/s"/)
    assert.match(await copied('Copy link'), /cromer-lab\.html#simulate\?.*damping=0\.05/)
  })
  await check('plots pan, zoom and show all', async () => {
    const box = page.locator('[data-drawn]').first()
    const name = async () => (await seen(page)).text.split('\n')[0]
    const whole = await name()
    await box.focus()
    await page.keyboard.press('+')
    await rest(page)
    const near = await name()
    assert.notEqual(near, whole)
    await page.keyboard.press('ArrowRight')
    await rest(page)
    assert.notEqual(await name(), near)
    await page.keyboard.press('0')
    await rest(page)
    assert.equal(await name(), whole)
    const at = await box.boundingBox()
    await page.mouse.move(at.x + at.width * 0.6, at.y + at.height / 2)
    await page.mouse.wheel(0, -300)
    await rest(page)
    assert.notEqual(await name(), whole)
    await page.mouse.dblclick(at.x + at.width * 0.6, at.y + at.height / 3)
    await rest(page)
    assert.equal(await name(), whole)
  })
  await check('the numbers behind a plot can be read', async () => {
    await page.getByRole('button', { name: 'Show numbers' }).first().click()
    assert.ok((await page.locator('.numbers tbody tr').count()) > 50)
    await button(page, 'Close').click()
  })
  await check('a printed page is a report with figures in light', async () => {
    await page.emulateMedia({ media: 'print' })
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
    assert.equal(await page.locator('.printed svg').count(), 4)
    assert.ok(await page.getByText('A mass on a spring, simulated').isVisible())
    assert.equal(await page.locator('canvas').first().isVisible(), false)
    await page.evaluate(() => dispatchEvent(new Event('afterprint')))
    await page.emulateMedia({ media: 'screen' })
    assert.equal(await page.locator('.printed').count(), 0)
  })
  await check('no error, no request', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  const { page, faults, context } = await open(browser, { reducedMotion: 'no-preference' })
  await check('the mass moves by itself, and stands when told to', async () => {
    const time = () => page.locator('.read b').first().textContent()
    const first = await time()
    await page.waitForTimeout(400)
    assert.notEqual(await time(), first)
    await button(page, 'Pause').click()
    const held = await time()
    await page.waitForTimeout(300)
    assert.equal(await time(), held)
    await button(page, 'A tenth of a period on').click()
    assert.notEqual(await time(), held)
  })
  await check('with the keyboard alone', async () => {
    await page.locator('.skip').focus()
    const reached = ['Skip to the page']
    for (let i = 0; i < 70; ++i) {
      await page.keyboard.press('Tab')
      const [name, ring] = await page.evaluate(() => {
        const at = document.activeElement
        const shown = [at, at.closest('.field'), at.closest('label')].filter(Boolean)
        return [at.getAttribute('aria-label') ?? at.dataset.option ?? at.dataset.method ?? at.textContent.trim().slice(0, 30),
          at === document.body || shown.some((each) => getComputedStyle(each).outlineStyle !== 'none')]
      })
      assert.ok(ring, `no focus ring at ${name}`)
      reached.push(name)
    }
    const order = ['Skip to the page', 'Simulate', 'Copy link', 'mass', 'damping', 'step', 'exact', 'Play', 'Copy command']
    const places = order.map((name) => reached.findIndex((each) => each === name || each?.startsWith(name)))
    assert.ok(places.every((place, i) => place >= 0 && (i === 0 || place > places[i - 1])), `${order} at ${places}: ${reached}`)
  })
  await check('no error while playing', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  // What each worker is given to begin with.
  const starts = () => {
    window.starts = []
    const post = Worker.prototype.postMessage
    Worker.prototype.postMessage = function (message, ...others) {
      for (const what of ['packed', 'module']) if (what in message) window.starts.push(what)
      return post.call(this, message, ...others)
    }
  }
  const { page, faults, context } = await open(browser, { watch: starts })
  await check('the core is unpacked and compiled once, and handed to every other worker', async () => {
    await rest(page)
    await page.getByRole('link', { name: 'Measure' }).click()
    await page.locator('button', { hasText: /disc/i }).first().click()
    await page.waitForFunction(() => window.starts.length >= 4)
    const [first, ...others] = await page.evaluate(() => window.starts)
    assert.equal(first, 'packed')
    assert.deepEqual([...new Set(others)], ['module'])
    assert.deepEqual(faults, [])
  })
  await context.close()
}

for (const [width, height, theme, language] of [
  [1440, 900, 'light', 'en-GB'], [1440, 900, 'dark', 'de-DE'], [1000, 800, 'light', 'de-DE'], [390, 844, 'dark', 'en-GB'], [390, 844, 'light', 'de-DE'],
]) {
  const { page, faults, context } = await open(browser, { width, height, colorScheme: theme, locale: language })
  await ready(page)
  await rest(page)
  await check(`accessible, and nothing wider than the page: ${width} ${theme} ${language}`, async () => {
    assert.equal(await page.evaluate(() => document.documentElement.lang), language.slice(0, 2))
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'wider than the page')
    await page.evaluate(axe)
    const { violations } = await page.evaluate(() => window.axe.run())
    const serious = violations.filter((each) => ['serious', 'critical'].includes(each.impact))
    assert.deepEqual(serious.map((each) => `${each.id}: ${each.nodes.map((node) => node.html.slice(0, 120)).join(' | ')}`), [])
    assert.deepEqual(faults.filter((each) => !each.startsWith('request: file')), [])
  })
  if (width < 700 && language === 'en-GB')
    await check('on a phone: plots, sheet and tabs', async () => {
      for (const name of ['Energy', 'Phase', 'Resonance', 'Motion']) {
        await page.getByRole('radio', { name, exact: true }).check()
        await rest(page)
        assert.equal(await page.locator('[data-drawn]').count(), 1, name)
      }
      for (const name of ['Oscillator', 'Drive', 'Start', 'Method']) {
        await page.getByRole('radio', { name, exact: true }).check()
        const size = await page.locator('.sheet [data-option]').first().boundingBox()
        assert.ok(size.height >= 44, `${name}: ${size.height}`)
      }
      await moves(page, () => slider(page, 'step').press('PageUp'), 'step')
      // one choice of what is plotted, slow motion, both cursors
      assert.equal(await page.locator('.top').getByText('Position', { exact: true }).count(), 1)
      await page.getByLabel('Speed of play').selectOption('0.1')
      await page.getByRole('button', { name: /^Second cursor/ }).click()
      await button(page, 'To the next turning point').click()
      assert.match(await page.locator('.between').innerText(), /^From the second cursor: Δt = [1-9]?\d\.\d\d\u00a0s/)
      const few = await page.locator('.bar').evaluate((bar) => [...bar.querySelectorAll('button, select')].map((each) => each.getBoundingClientRect()).filter(({ width, height, right }) => width < 40 || height < 40 || right > innerWidth))
      assert.deepEqual(few, [], 'controls too small for a finger')
      await button(page, 'Show or hide the controls').click()
      assert.equal(await page.locator('.sheet [data-option]').count(), 0)
      await page.getByRole('link', { name: 'Measure' }).click()
      await page.waitForFunction(() => location.hash.startsWith('#measure'))
    })
  await context.close()
}

for (const [width, height] of [[1440, 900], [1024, 768], [360, 740]]) {
  const { page, faults, context } = await open(browser, { width, height, locale: 'de-DE' })
  await ready(page)
  await check(`all methods have their place, ${width} wide in German`, async () => {
    await page.evaluate(() => {
      for (const each of document.querySelectorAll('.controls details')) each.open = true
      for (const each of document.querySelectorAll('.controls input[type=checkbox]')) if (!each.checked) each.click()
    })
    await rest(page)
    const seen = await page.evaluate(() => {
      const box = (query) => document.querySelector(query)?.getBoundingClientRect()
      const table = document.querySelector('.panel .table')
      return {
        rows: document.querySelectorAll('.panel tbody tr').length, cut: table.scrollWidth - table.clientWidth,
        // the numbers at the cursor stand below the plot, the list below the curve
        numbers: box('.read').top >= box('.card .plot .box').bottom - 1, wide: document.documentElement.scrollWidth - innerWidth,
        read: document.querySelectorAll('.read .value').length, hidden: document.querySelector('.read').scrollHeight - document.querySelector('.read').clientHeight,
        list: document.querySelectorAll('.resonance li').length,
        below: !box('.resonance ul') || box('.resonance ul').top >= box('.resonance .box').bottom - 1,
      }
    })
    assert.deepEqual(seen, { rows: 12, cut: 0, numbers: true, wide: 0, read: 13, hidden: 0, list: width < 700 ? 0 : 12, below: true })
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

await browser.close()
finish()
