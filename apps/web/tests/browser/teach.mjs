// Teach in a real browser, on the built file from disk: node tests/browser/teach.mjs
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { address, axe, check, finish, launch, open, slabs } from './harness.mjs'

const browser = await launch()

async function teach(hash = '', options = {}) {
  const opened = await open(browser, options)
  await opened.page.goto(`${address}#teach${hash}`)
  await opened.page.evaluate((to) => (location.hash = to), `#teach${hash}`)
  await opened.page.locator('#step-title').waitFor()
  return opened
}
const title = (page) => page.locator('#step-title').innerText()
/** What is under the words of a steady amplitude pales, it is not painted over. */
const noSlab = async (page) => {
  await page.waitForTimeout(300)
  assert.equal(await slabs(page), 0, await title(page))
}
const reached = (page, seconds = 20) => page.locator('[data-goal=done]').waitFor({ timeout: 1000 * seconds })
/** Nothing is shown before something is expected; then the goal waits. */
async function predict(page, choice = 1) {
  assert.equal(await page.locator('.middle canvas, .goal, .why h2').count(), 0)
  await page.locator('.predict button').nth(choice).click()
  await waiting(page)
  assert.equal(await page.locator('.why h2').count(), 0) // not before it has been seen
}
const waiting = (page) => page.locator('[data-goal=open]').waitFor()
const next = (page) => page.locator('.ways button').last().click()
const type = async (page, text) => {
  await page.locator('.control .field input').fill(text)
  await page.keyboard.press('Enter')
}
const settled = async (page) => {
  await page.waitForTimeout(400)
  await page.waitForFunction(() => !document.querySelector('[aria-busy=true]'), null, { timeout: 90000 })
}
const faultless = async (page, what) => {
  await page.evaluate(axe)
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ['violations'] }))
  const serious = found.violations.filter((each) => ['serious', 'critical'].includes(each.impact))
  assert.deepEqual(serious.map((each) => `${each.id}: ${each.nodes[0].html.slice(0, 160)} ${each.nodes[0].failureSummary}`), [], what)
}
const verdict = (page, question) => page.locator(`[data-question=${question}] .verdict`).innerText()
async function answer(page, question, value, uncertainty) {
  const fields = page.locator(`[data-question=${question}] input`)
  await fields.nth(0).fill(value)
  await fields.nth(1).fill(uncertainty)
}
async function checkAnswers(page, name = 'Check answers') {
  await page.getByRole('button', { name }).click()
  await page.locator('.foot .caption', { hasText: /\d/ }).waitFor({ timeout: 60000 })
  await page.waitForFunction(() => !document.querySelector('.foot button[disabled]'), null, { timeout: 60000 })
}
/// Value and ± as the page writes them, as plain numbers.
const pair = (text) => {
  const plain = text.replace(/\u202f/g, '')
  const brackets = plain.match(/([\d.]+)\((\d+)\)/)
  if (brackets) return [brackets[1], String(Number(brackets[2]) * 10 ** -brackets[1].split('.')[1].length)]
  return plain.match(/[\d.]+/g).slice(0, 2)
}

{
  const { page, faults, context } = await teach()
  await check('lab one from start to end', async () => {
    assert.equal(await title(page), 'A mass on a spring')
    await predict(page)
    assert.match(await page.locator('.middle').innerText(), /You expect: just as long\./)
    await type(page, '1 m')
    await reached(page)
    assert.match(await page.locator('.middle').innerText(), /As you expected\. Just as long[\s\S]*Why does a swing take 2\.09 s/)
    for (const [name, typed] of [
      ['Push it at its own rhythm', '3'],
      ['Add damping', '0.2 kg/s'],
      ['Move away from resonance', '2 rad/s'],
    ]) {
      await next(page)
      assert.equal(await title(page), name)
      await predict(page, 0)
      await type(page, typed)
      await reached(page)
      assert.match(await page.locator('.middle').innerText(), /You expected: /)
      await noSlab(page)
    }
    await next(page)
    await predict(page)
    await page.getByRole('checkbox', { name: 'implicit Euler' }).check()
    await reached(page)
    await noSlab(page)
    await next(page)
    await predict(page)
    await type(page, '20 ms')
    await reached(page)
    await next(page)
    await page.locator('.control td', { hasText: '1.667' }).waitFor()
    const values = await page.locator('.control td').allInnerTexts()
    assert.deepEqual(values.map((each) => each.split('\u00a0')[0]), ['2.094', '1.667', '0.1992', '0.7846', '0.0222'])
    await noSlab(page)
    await page.getByRole('button', { name: 'Copy the table' }).click()
    await reached(page)
    assert.equal(await page.locator('nav ol .finished').count(), 7)
    await faultless(page, 'lab one')
  })
  await check('the place is kept in the address', async () => {
    await page.waitForTimeout(500)
    assert.match(page.url(), /one=7/)
    assert.match(page.url(), /doneOne=1,2,3,4,5,6,7/)
    const other = await teach(page.url().split('#teach')[1])
    assert.equal(await title(other.page), 'Write it up')
    assert.equal(await other.page.locator('nav ol .finished').count(), 7)
    await other.context.close()
  })
  await check('a step is done by keys alone', async () => {
    await page.locator('nav ol button').nth(2).focus()
    await page.keyboard.press('Enter')
    assert.equal(await title(page), 'Add damping')
    const slider = page.locator('[data-option=damping]')
    await slider.focus()
    await page.keyboard.press('End')
    assert.equal(await slider.getAttribute('aria-valuetext'), '0.500 kilograms per second')
    await page.keyboard.press('Control+z')
    assert.match(await slider.getAttribute('aria-valuetext'), /^0\.00/)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

{
  const { page, faults, context } = await teach()
  let link = ''
  await check('a class link holds the class and no truth', async () => {
    await page.getByRole('button', { name: 'Make a class link' }).click()
    await page.getByLabel('Class', { exact: true }).fill('7F3A')
    link = await page.locator('[data-field=class-link]').inputValue()
    assert.equal(link.split('#')[1], 'teach?lab=two&course=7F3A')
  })
  await context.close()
  const own = await teach(link.split('#teach')[1])
  const lab = own.page
  await check('lab two from start to end with a recording of one’s own', async () => {
    await lab.locator('[data-field=student]').fill('19')
    await lab.keyboard.press('Enter')
    await lab.locator('.part', { hasText: '7F3A-19' }).waitFor()
    const about = await lab.locator('.part').first().innerText()
    const [, mass] = about.match(/([\d.]+\u00a0±\u00a0[\d.]+\u00a0g)/)
    const [, disc] = about.match(/disc of ([\d.]+\u00a0cm)/)
    assert.equal(await title(lab), 'Record')
    await waiting(lab)
    await lab.getByRole('button', { name: 'Take recording 7F3A-19' }).click()
    await reached(lab)
    await next(lab)
    await waiting(lab)
    await lab.locator('[data-field=mass]').fill(mass)
    await lab.locator('[data-field=disc]').fill(disc)
    await lab.keyboard.press('Enter')
    await reached(lab)
    await next(lab)
    await waiting(lab)
    for (const [name, key, times] of [['start of the free part', 'PageUp', 5], ['end of the free part', 'PageDown', 10]]) {
      await lab.getByRole('slider', { name }).focus()
      for (let i = 0; i < times; ++i) await lab.keyboard.press(key)
    }
    await reached(lab)
    await settled(lab)
    const rate = pair(await lab.locator('.control b').first().innerText())
    await answer(lab, 'rate', ...rate)
    await next(lab)
    await waiting(lab)
    await lab.locator('.control button').click()
    await reached(lab, 90)
    const value = async (quantity) => pair(await lab.locator(`[data-quantity=${quantity}]`).innerText())
    await answer(lab, 'frequency', ...(await value('frequency')))
    await answer(lab, 'stiffness', ...(await value('stiffness')))
    await next(lab)
    await waiting(lab)
    await lab.getByRole('button', { name: 'viscous', exact: true }).click()
    await reached(lab, 40)
    await next(lab)
    await waiting(lab)
    await lab.getByRole('button', { name: 'viscous + drag' }).click()
    await reached(lab, 40)
    const reynolds = await value('reynolds')
    assert.deepEqual(reynolds, ['2120.0', '0.9'])
    await answer(lab, 'reynolds', ...reynolds)
    await next(lab)
    await answer(lab, 'off', '50', '1')
    await checkAnswers(lab)
    assert.deepEqual(
      await Promise.all(['frequency', 'stiffness', 'rate', 'reynolds', 'off'].map((each) => verdict(lab, each))),
      ['right', 'right', 'right', 'right', 'not yet'],
    )
    await faultless(lab, 'lab two')
  })
  await check('the last answer is found in Measure', async () => {
    await lab.locator('header nav a').nth(1).click()
    await lab.getByRole('button', { name: 'Show simulations' }).click()
    const sentence = lab.locator('.caption', { hasText: 'With one constant decay rate' })
    await sentence.waitFor({ timeout: 60000 })
    const off = (await sentence.innerText()).match(/[\d.]+/)[0]
    await lab.locator('header nav a').nth(2).click()
    await answer(lab, 'off', off, '0.1')
    await checkAnswers(lab)
    await reached(lab)
    assert.match(await lab.locator('.foot').innerText(), /5 of 5 right/)
  })
  await check('what is not right yet says why', async () => {
    const k = await lab.locator('[data-question=stiffness] input').first().inputValue()
    const re = await lab.locator('[data-question=reynolds] input').first().inputValue()
    const f = await lab.locator('[data-question=frequency] input').first().inputValue()
    await answer(lab, 'stiffness', k, '0.0001')
    await answer(lab, 'reynolds', re, '')
    await answer(lab, 'frequency', String(2 * Math.PI * Number(f)), '0.001')
    await answer(lab, 'off', 'much', '1')
    await checkAnswers(lab)
    assert.equal(await verdict(lab, 'stiffness'), 'right, ± too small')
    assert.equal(await verdict(lab, 'reynolds'), '± missing')
    assert.equal(await verdict(lab, 'frequency'), 'not yet')
    assert.equal(await verdict(lab, 'off'), 'no number')
    assert.match(await lab.locator('[data-question=frequency]').innerText(), /Is this ω in rad\/s/)
    assert.match(await lab.locator('.foot').innerText(), /1 of 5 right/)
    assert.ok(!/wrong/i.test(await lab.locator('main').innerText()))
  })
  await check('a part is opened in Measure', async () => {
    await answer(lab, 'rate', '1', '0.001')
    await checkAnswers(lab)
    await lab.getByRole('button', { name: 'Open this part in Measure' }).click()
    await lab.locator('.row', { hasText: '7F3A-19.csv' }).waitFor({ timeout: 20000 })
    assert.equal(await lab.getByRole('slider', { name: 'start of the free part' }).getAttribute('aria-valuenow'), '30')
  })
  await check('nothing went wrong', async () => assert.deepEqual([...faults, ...own.faults], []))
  await own.context.close()
}

for (const width of [390, 820, 1280]) {
  const { page, faults, context } = await teach('?lab=two', { width, height: 844, locale: 'de-DE', colorScheme: width === 390 ? 'dark' : 'light' })
  await check(`German, ${width} wide`, async () => {
    assert.equal(await title(page), 'Aufnehmen')
    await page.getByRole('button', { name: 'Aufnahme Übungsaufnahme nehmen' }).click()
    await reached(page)
    await next(page)
    await page.locator('[data-field=mass]').fill('277,2 ± 0,3 g')
    await page.locator('[data-field=disc]').fill('11 cm')
    await page.keyboard.press('Enter')
    await reached(page)
    await settled(page)
    await page.locator('nav ol button').nth(3).click()
    await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 60000 })
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'the page is wider than the window')
    await faultless(page, `German ${width}`)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

/// Thirty where CROMER_CLASS is "all": each key takes a second or two.
const size = process.env.CROMER_CLASS === 'all' ? 30 : 3
{
  const { page, faults, context } = await teach('?lab=two')
  let answers = []
  await check(`a teacher makes a class, and reads the key of ${size}`, async () => {
    await page.getByRole('button', { name: 'Make a class link' }).click()
    await page.getByLabel('Class', { exact: true }).fill('9C')
    await page.getByLabel('Students, numbered from 1 to').fill(String(size))
    await page.getByRole('button', { name: 'Answer key' }).click()
    await page.waitForFunction((size) => document.querySelectorAll('[data-table=key] tbody tr').length === size, size, { timeout: 20000 * size })
    answers = await page.locator('[data-table=key] tbody tr').evaluateAll((rows) => rows.map((row) => [...row.querySelectorAll('td')].map((cell) => cell.innerText)))
    assert.equal(new Set(answers.map(String)).size, size)
    await page.getByRole('button', { name: 'Close the table' }).click()
    await page.getByRole('button', { name: 'Close', exact: true }).click()
  })
  await check(`${size} hand-ins are one table, with who is right and what is missing`, async () => {
    const questions = ['frequency', 'stiffness', 'rate', 'reynolds', 'off']
    const files = answers.map((row, i) => {
      const given = Object.fromEntries(row.map((text, j) => {
        const [value, uncertainty] = pair(text)
        return [questions[j], { value, uncertainty }]
      }))
      if (i === 1) given.rate = { value: '', uncertainty: '' }
      if (i === 2) given.stiffness.value = String(Number(given.stiffness.value) * 1000)
      return { cromer: 'hand-in', version: 1, name: `Student ${i + 1}`, course: '9c', student: ` ${i + 1}`, answers: given, fit: { law: 'viscous+drag', parameters: {} }, link: '' }
    })
    const data = await page.evaluateHandle((files) => {
      const transfer = new DataTransfer()
      for (const [i, file] of files.entries()) transfer.items.add(new File([JSON.stringify(file)], `hand-in-${i}.json`))
      transfer.items.add(new File(['{}'], 'other.json'))
      return transfer
    }, files)
    await page.dispatchEvent('main', 'drop', { dataTransfer: data })
    await page.waitForFunction((size) => document.querySelectorAll('[data-table=hand-ins] tbody tr').length === size && !document.querySelector('[aria-busy=true]'), size, { timeout: 20000 * size })
    const rows = await page.locator('[data-table=hand-ins] tbody tr').evaluateAll((all) => all.map((row) => row.innerText.replace(/\s+/g, ' ')))
    assert.match(rows[0], /Student 1 .* 5\/5 /)
    assert.match(rows[1], /Student 2 .* 4\/5 .*not answered/)
    assert.match(rows[2], /Student 3 .* 4\/5 .*not yet/)
    assert.match(await page.getByRole('alert').innerText(), /no hand-in: other\.json/)
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save as CSV' }).click()])
    const csv = readFileSync(await download.path(), 'utf8').trim().split('\n')
    assert.equal(csv.length, size + 1)
    assert.match(csv[1], /^Student 1,9c, 1,5,/)
    await faultless(page, 'marking')
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}
{
  const { page, faults, context } = await teach('?lab=two&course=9C&student=1&values=1.4;17;0.01;2000;5&uncertainties=0.1;1;0.01;100;1')
  await check('a student hands in one file', async () => {
    await page.locator('[data-field=name]').fill('Grace')
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save the hand-in' }).click()])
    assert.equal(download.suggestedFilename(), 'hand-in-9C-1.json')
    const file = JSON.parse(readFileSync(await download.path(), 'utf8'))
    assert.deepEqual([file.name, file.course, file.student, file.answers.stiffness], ['Grace', '9C', '1', { value: '17', uncertainty: '1' }])
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

await browser.close()
finish()
