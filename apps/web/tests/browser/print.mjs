// Printed pages as reports, from the dark page too, in both languages: node tests/browser/print.mjs
import assert from 'node:assert/strict'
import { check, finish, launch, open } from './harness.mjs'

const browser = await launch()
const margin = { top: '15mm', bottom: '15mm', left: '15mm', right: '15mm' }
/** What is left of an A4 page [px]; it has 680 of width, with which the page would take itself for a phone's. */
const paper = { width: 702, height: 1009 }

/** Sheets of paper, once printed. */
const sheets = async (page) =>
  (await page.pdf({ format: 'A4', margin })).toString('latin1').match(/\/Type\s*\/Page\b/g).length

/** What the page says of itself while it is printed. */
async function printed(page, body) {
  const size = page.viewportSize()
  await page.setViewportSize(paper)
  await page.emulateMedia({ media: 'print' })
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
  try {
    await body()
  } finally {
    await page.evaluate(() => dispatchEvent(new Event('afterprint')))
    await page.emulateMedia({ media: null })
    await page.setViewportSize(size)
  }
}
/** Light, whole figures one below the other, nothing to press, nothing wider than the paper. */
async function isReport(page, figures) {
  const seen = await page.evaluate((high) => {
    const shown = (each) => each.checkVisibility() && each.getClientRects().length > 0 && getComputedStyle(each).clipPath === 'none'
    const box = (each) => each.getBoundingClientRect()
    const all = [...document.querySelectorAll('.printed svg')].filter(shown)
    return {
      theme: document.documentElement.dataset.theme,
      figures: all.length,
      cut: all.filter((each) => box(each).bottom > box(each.closest('section')).bottom + 1 || box(each).height > high).length,
      // two figures share a line or stand apart, but none lies on another
      overlap: all.some((a, i) => all.slice(i + 1).some((b) => Math.min(box(a).right, box(b).right) - Math.max(box(a).left, box(b).left) > 1 && Math.min(box(a).bottom, box(b).bottom) - Math.max(box(a).top, box(b).top) > 1)),
      pressed: [...document.querySelectorAll('button, select, input[type=range], [role=slider]')].filter((each) => !each.closest('.choices, nav ol') && shown(each)).map((each) => each.textContent.trim() || each.ariaLabel),
      wide: document.documentElement.scrollWidth - innerWidth,
      canvases: [...document.querySelectorAll('canvas')].filter(shown).length,
    }
  }, paper.height)
  assert.deepEqual(seen, { theme: 'light', figures, cut: 0, overlap: false, pressed: [], wide: 0, canvases: 0 })
}
const fitted = async (page) => {
  await page.waitForTimeout(400)
  await page.waitForFunction(() => !document.querySelector('[aria-busy=true]'), null, { timeout: 90000 })
}

for (const [locale, words] of [
  ['en-GB', { title: /disc_12cm\.csv: the law of an oscillator/, k: /spring constant k/, answers: 'Check your answers' }],
  ['de-DE', { title: /disc_12cm\.csv: das Gesetz eines Schwingers/, k: /Federkonstante k/, answers: 'Antworten prüfen' }],
]) {
  const { page, context, faults } = await open(browser, { locale, colorScheme: 'dark' })
  await check(`a simulation is printed, ${locale}`, async () => {
    await printed(page, () => isReport(page, 4))
    assert.equal(await sheets(page), 2)
  })
  await page.locator('header nav a').nth(1).click()
  await page.locator('.examples button').first().click()
  await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 60000 })
  await fitted(page)
  await check(`a recording and its law are printed, ${locale}`, async () => {
    await printed(page, async () => {
      await isReport(page, 4)
      const text = await page.locator('main').innerText()
      assert.match(text, words.title)
      assert.match(text, words.k)
      assert.match(text, /217[.,]6 ± 0[.,]3 g/)
      assert.match(text, /cromer fit disc_12cm\.csv --mass/)
      assert.doesNotMatch(text, /drag the handles|Griffe/)
    })
    assert.equal(await sheets(page), 2)
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark')
  })
  await check(`with the second lab's simulations, ${locale}`, async () => {
    await page.locator('button[aria-pressed]').last().click()
    await fitted(page)
    await printed(page, () => isReport(page, 8))
    assert.equal(await sheets(page), 3)
  })
  await page.locator('header nav a').nth(2).click()
  await page.locator('.predict button').first().click()
  await check(`a step of a tour is printed, ${locale}`, async () => {
    await printed(page, async () => {
      await isReport(page, 1)
      assert.equal(await page.getByRole('heading', { name: words.answers, includeHidden: true }).isVisible(), false)
      assert.equal(await page.locator('nav li button').nth(6).isVisible(), true)
    })
    assert.equal(await sheets(page), 1)
  })
  await check(`answers are printed with lab two, ${locale}`, async () => {
    await page.getByRole('radio').nth(1).check()
    await printed(page, async () => assert.equal(await page.getByRole('heading', { name: words.answers, includeHidden: true }).isVisible(), true))
    assert.equal(await sheets(page), 2)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
  await context.close()
}

await browser.close()
finish()
