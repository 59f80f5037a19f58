// A second mass in Simulate, and the tour of two pendulums in Teach, in a real browser: node tests/browser/second.mjs
import assert from 'node:assert/strict'
import { axe, check, finish, launch, open } from './harness.mjs'

const browser = await launch()
const button = (page, name) => page.getByRole('button', { name })
const values = (page) => page.evaluate(() => Object.fromEntries(new URLSearchParams(location.hash.split('?')[1] ?? '')))
const said = (page, text) =>
  page.waitForFunction((text) => new RegExp(text).test(document.querySelector('[role=img]')?.getAttribute('aria-label')), text)

{
  const { page, faults, context } = await open(browser, { hash: '#simulate?driveAmplitude=0&damping=0&position=0.1&methods=exact,euler-cromer&until=60' })
  await check('a second mass is put there by one click, and can be pulled', async () => {
    await said(page, 'exact')
    await button(page, 'Add a second mass').click()
    await said(page, 'second mass')
    await page.waitForFunction(() => location.hash.includes('second=true'))
    const [first, second] = [page.getByRole('slider', { name: 'mass: pull it, and let it go', exact: true }), page.getByRole('slider', { name: 'second mass: pull it, and let it go' })]
    const [one, two] = [await first.boundingBox(), await second.boundingBox()]
    assert.ok(one.x + one.width < two.x, 'the masses stand beside one another')
    const [x, y] = [two.x + two.width / 2, two.y + two.height / 2]
    await page.mouse.move(x, y)
    await page.mouse.down()
    await page.mouse.move(x, y + 30, { steps: 4 })
    await page.mouse.up()
    await page.waitForFunction(() => Number(new URLSearchParams(location.hash.split('?')[1]).get('secondPosition')) < 0)
    assert.equal((await values(page)).position, '0.1')
    await button(page, 'Undo').click()
    await page.waitForFunction(() => !new URLSearchParams(location.hash.split('?')[1]).has('secondPosition'))
    await first.focus()
    await page.keyboard.press('ArrowUp')
    await page.waitForFunction(() => Number(new URLSearchParams(location.hash.split('?')[1]).get('position')) > 0.1)
  })
  await check('a normal mode starts by one click: both keep one rhythm', async () => {
    await page.evaluate(() => (location.hash = '#simulate?second=true&driveAmplitude=0&damping=0&position=0.1&methods=exact&until=60&coupling=3.5'))
    await said(page, 'second mass')
    await button(page, /^Start in the fast mode: 4/).click()
    await page.waitForFunction(() => new URLSearchParams(location.hash.split('?')[1]).get('secondPosition') === '-0.1')
    await button(page, /^Start in the slow mode: 3/).click()
    await page.waitForFunction(() => new URLSearchParams(location.hash.split('?')[1]).get('secondPosition') === '0.1')
    await button(page, /^Start the first alone/).click()
    await page.waitForFunction(() => !new URLSearchParams(location.hash.split('?')[1]).has('secondPosition'))
    await page.getByText('Fast mode, 4').click()
    await page.getByText('Second mass', { exact: true }).click()
    await page.waitForFunction(() => location.hash.includes('quantity=second'))
    await said(page, 'first mass')
  })
  await check('what a method makes of each mode is said', async () => {
    await page.evaluate(() => (location.hash = '#simulate?second=true&driveAmplitude=0&damping=0.2&position=0.1&methods=exact,implicit-euler&coupling=3.5'))
    const rate = () => page.locator('.panel tbody b').first().innerText()
    await page.getByText('Slow mode, 3').click()
    await page.waitForFunction(() => document.querySelector('.panel tbody b'))
    const slow = await rate()
    await page.getByText('Fast mode, 4').click()
    await page.waitForFunction((before) => document.querySelector('.panel tbody b').innerText !== before, slow)
    assert.ok(Number(await rate()) > Number(slow), `${await rate()} against ${slow}`)
  })
  await check('its terminal command has its network file, and it goes away again', async () => {
    assert.match(await page.locator('.command code').first().innerText(), /--network two\.toml/)
    await button(page, 'Copy network file').waitFor()
    await button(page, 'Remove the second mass').click()
    await page.waitForFunction(() => !location.hash.includes('second=true'))
    await button(page, 'Copy study file').waitFor()
  })
  await check('with two masses nothing breaks the rules of accessibility', async () => {
    await button(page, 'Add a second mass').click()
    await said(page, 'second mass')
    await page.evaluate(axe)
    const found = await page.evaluate(async () => (await window.axe.run()).violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`))
    assert.deepEqual(found, [])
  })
  assert.deepEqual(faults, [])
  await context.close()
}

{
  const { page, faults, context } = await open(browser, { hash: '#teach?lab=three' })
  await check('the tour of two pendulums: each step reaches its goal', async () => {
    const goals = [['firstStart', 0.1], ['secondStart', 0.1], ['secondStart', -0.1], ['joint', 1], ['secondSpring', 12]]
    for (const [i, [, value]] of goals.entries()) {
      await page.locator('.slider .field input').first().fill(String(value))
      await page.keyboard.press('Enter')
      await page.waitForFunction(() => document.querySelector('[data-goal=done]'))
      await said(page, 'second mass')
      assert.equal(await page.locator('.why').count(), 1)
      await page.locator('li button').nth(i + 1).click()
      await page.waitForFunction((step) => location.hash.includes(`three=${step}`), i + 2)
    }
    await page.locator('.control input[type=checkbox]').check()
    await page.waitForFunction(() => document.querySelector('[data-goal=done]'))
    await said(page, 'mplicit Euler|first mass')
  })
  assert.deepEqual(faults, [])
  await context.close()
}
await browser.close()
finish()
