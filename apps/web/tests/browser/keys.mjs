// Both tours by the keyboard alone, and answers as students type them: node tests/browser/keys.mjs
import assert from 'node:assert/strict'
import { address, check, finish, launch, open } from './harness.mjs'

const browser = await launch()
const { page, faults, context } = await open(browser)
await page.goto(`${address}#teach`)
await page.evaluate(() => (location.hash = '#teach'))
await page.locator('#step-title').waitFor()

const press = async (key, times = 1) => {
  for (let i = 0; i < times; ++i) await page.keyboard.press(key)
}
/** Tab until what has the focus matches; forwards, or back. */
async function tabTo(selector, key = 'Tab') {
  for (let i = 0; i < 140; ++i) {
    await page.keyboard.press(key)
    if (await page.evaluate((wanted) => document.activeElement?.matches(wanted), selector)) return
  }
  throw new Error(`no Tab reaches ${selector}`)
}
const title = () => page.locator('#step-title').innerText()
const reached = (seconds = 20) => page.locator('[data-goal=done]').waitFor({ timeout: 1000 * seconds })
const settled = async () => {
  await page.waitForTimeout(400)
  await page.waitForFunction(() => !document.querySelector('[aria-busy=true]'), null, { timeout: 90000 })
}
async function next() {
  await tabTo('.ways button:last-child')
  await press('Enter')
  // What follows begins at the new step's title.
  assert.equal(await page.evaluate(() => document.activeElement.id), 'step-title')
}
async function type(selector, text) {
  await tabTo(selector)
  await page.keyboard.press('Control+a')
  await page.keyboard.type(text)
  await press('Enter')
}
const answerOf = (question, i) => page.locator(`[data-question=${question}] input`).nth(i).inputValue()
async function answer(question, value, uncertainty) {
  const field = `[data-question=${question}] .field`
  await type(`${field}:first-child input`, value)
  if (uncertainty !== undefined) await type(`${field}:not(:first-child) input`, uncertainty)
}
async function checkAll(score) {
  await tabTo('.foot button')
  await press('Enter')
  await page.locator('.foot .caption', { hasText: score }).waitFor({ timeout: 60000 })
}
let reynolds = ''
const verdict = (question) => page.locator(`[data-question=${question}] .verdict`).innerText()

/** The second answer to what is expected of the step. */
async function predict() {
  await tabTo('.predict button:nth-of-type(2)')
  await press('Enter')
  assert.equal(await page.evaluate(() => document.activeElement.id), 'step-title')
}
await check('lab one by keys', async () => {
  await predict()
  await type('.control .field input', '1')
  await reached()
  for (const typed of ['3', '0.2', '2']) {
    await next()
    await predict()
    await type('.control .field input', typed)
    await reached()
  }
  await next()
  await predict()
  await tabTo('.control input[type=checkbox]')
  await press('Space')
  await reached()
  await next()
  await predict()
  await tabTo('.control input[type=range]')
  await press('ArrowLeft', 12)
  await reached()
  await next()
  await tabTo('.control button:not([disabled])')
  await press('Enter')
  await reached()
  assert.equal(await page.locator('nav ol .finished').count(), 7)
})
await check('lab two by keys, to its answers', async () => {
  await tabTo('nav[aria-label=Labs] input[type=radio]', 'Shift+Tab')
  await press('ArrowRight')
  assert.equal(await title(), 'Record')
  await tabTo('.control button')
  await press('Enter')
  await reached()
  await next()
  const [mass] = (await page.locator('.part').first().innerText()).match(/[\d.]+\u00a0±\u00a0[\d.]+\u00a0g/)
  await type('[data-field=mass]', mass)
  await type('[data-field=disc]', '11 cm')
  await reached()
  await settled()
  await next()
  await predict()
  await tabTo('[role=slider][data-end=from]')
  await press('PageUp', 5)
  await tabTo('[role=slider][data-end=to]')
  await press('PageDown', 10)
  await reached()
  await settled()
  const rate = await page.locator('.control b').first().innerText()
  await answer('rate', rate) // as the page writes it: 0.00951 ± 0.00012 1/s
  assert.match(await answerOf('rate', 0), /^0\.0\d+$/)
  assert.match(await answerOf('rate', 1), /^0\.0\d+$/)
  await tabTo('.ways button:last-child', 'Shift+Tab')
  await press('Enter')
  await predict()
  await tabTo('.control button')
  await press('Enter')
  await reached(90)
  await settled()
  const value = (quantity) => page.locator(`[data-quantity=${quantity}]`).innerText()
  await answer('frequency', await value('frequency')) // 1.408 398 8(9) Hz
  await answer('stiffness', (await value('stiffness')).replaceAll('.', ',')) // 17,040 ± 0,023 N/m
  await tabTo('.ways button:last-child', 'Shift+Tab')
  await press('Enter')
  await predict()
  await tabTo('.control button')
  await press('Enter')
  await reached(40)
  await settled()
  await next()
  await predict()
  await tabTo('.control button:nth-of-type(2)')
  await press('Enter')
  await reached(40)
  reynolds = (await value('reynolds')).match(/[\d.]+/)[0]
  await answer('reynolds', reynolds, '5')
  await tabTo('.ways button:last-child', 'Shift+Tab')
  await press('Enter')
  assert.equal(await title(), 'Write it up')
})
await check('the last answer, with its sign, from Measure', async () => {
  await tabTo('header nav a[href="#measure"]', 'Shift+Tab')
  await press('Enter')
  await tabTo('.plots button[aria-pressed]')
  await press('Enter')
  const sentence = page.locator('.caption', { hasText: 'With one constant decay rate' })
  await sentence.waitFor({ timeout: 60000 })
  const [off] = (await sentence.innerText()).match(/[+−][\d.]+\u00a0%/)
  await tabTo('header nav a[href="#teach"]', 'Shift+Tab')
  await press('Enter')
  await answer('off', off, '0.3 %')
  await checkAll('5 of 5 right')
  await reached()
})
await check('what is typed otherwise is answered, and undone', async () => {
  const frequency = await answerOf('frequency', 0)
  await answer('reynolds', '2,535', '5')
  await answer('frequency', '1.4 kHz', '0.1')
  await checkAll('3 of 5 right')
  assert.equal(await verdict('frequency'), 'no number')
  assert.match(await page.locator('[data-question=frequency]').innerText(), /Type a number in Hz\./)
  assert.match(await page.locator('[data-question=reynolds]').innerText(), /A comma or point is read as the decimal mark|Too small/)
  // Undo takes back one field after the other; a judged answer is judged no more once it is another.
  await press('Control+z', 2)
  assert.equal(await answerOf('frequency', 0), frequency)
  assert.equal(await verdict('frequency'), 'not answered')
  await press('Control+z')
  assert.equal(await answerOf('reynolds', 0), reynolds)
  await checkAll('5 of 5 right')
})
await check('nothing went wrong', async () => assert.deepEqual(faults, []))
await context.close()
await browser.close()
finish()
