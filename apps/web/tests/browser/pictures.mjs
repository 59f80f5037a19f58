// Pictures of every view and state of the built page, to be looked at: node tests/browser/pictures.mjs [FOLDER] [--only=measure]
//
// FOLDER (build/pictures) gets NAME-WIDTH[-dark][-de].png, and NAME-print.pdf; with --only those whose name has that
// word. With --readme the README's two pictures are made instead.
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { flawed } from './dialects.mjs'
import { drop, launch, open, settled } from './harness.mjs'
import { swingingSensor } from './sensor.mjs'
import { program, serve } from './served_page.mjs'

const readme = process.argv.includes('--readme')
const folder = resolve(process.argv.slice(2).find((word) => !word.startsWith('--')) ?? join(import.meta.dirname, '../../../../build/pictures'))
const only = process.argv.find((word) => word.startsWith('--only='))?.slice(7) ?? ''
mkdirSync(folder, { recursive: true })

const swing = (of, seconds = 40) => `Time (s),Position (m)\n${Array.from({ length: 100 * seconds }, (_, i) => `${i / 100},${of(i / 100).toFixed(5)}`).join('\n')}\n`
const go = async (page, hash) => {
  await page.evaluate((to) => (location.hash = to), hash)
  await page.waitForTimeout(1500)
}
const measure = (page) => page.locator('header nav a').nth(1).click()
const example = async (page, which) => {
  await measure(page)
  await page.locator('.examples button').nth(which).click()
  await page.locator('[data-quantity]').first().waitFor({ timeout: 60000 })
  await settled(page, 120)
}
const dropped = async (page, name, content) => {
  await measure(page)
  await drop(page, name, content)
  await page.locator('.row', { hasText: name }).waitFor()
  await settled(page, 120)
}

let served
/** Of the page that a program serves, which records from a sensor. */
async function liveAddress() {
  served ??= { ...(await swingingSensor()), folder: mkdtempSync(join(tmpdir(), 'cromer-pictures-')) }
  served.serving ??= await serve('--from', served.from, '-o', join(served.folder, 'swing.csv'))
  return served.serving.address
}

const states = {
  simulate: async (page) => page.waitForTimeout(1500),
  'simulate-nonlinear': (page) => go(page, '#simulate?cubic=20&drag=0.1'),
  'simulate-forces': async (page) => {
    await go(page, '#simulate?position=1&friction=0.2&drag=0.3&driveAmplitude=2')
    const tool = (name) => page.getByRole('button', { name })
    await tool(/^(Second cursor|Zweiter Zeiger)/).click()
    for (let i = 0; i < 2; ++i) await tool(/^(To the next turning point|Zum nächsten Umkehrpunkt)/).click()
    await page.waitForTimeout(1200)
  },
  'simulate-no-method': (page) => go(page, '#simulate?methods='),
  'simulate-critical': (page) => go(page, '#simulate?damping=6'),
  'measure-empty': measure,
  'measure-refused': async (page) => {
    await measure(page)
    await drop(page, 'words.csv', 'Time (s),Position (m)\n0,1\n0.1,2\n0.2,abc\n0.3,1\n')
    await page.getByRole('alert').waitFor()
  },
  'measure-loading': async (page) => {
    await measure(page)
    await page.locator('.examples button').first().click()
    await page.locator('.row').first().waitFor()
    await page.waitForTimeout(60)
  },
  'measure-failed': (page) => dropped(page, 'still.csv', swing((t) => 0.2 + 0.0003 * Math.sin(1e4 * t * t))),
  'measure-fitted': (page) => example(page, 0),
  'measure-overlay': async (page) => {
    await example(page, 0)
    await page.locator('.plots button', { hasText: /simulations|Simulationen/ }).first().click()
    await page.locator('.legend').first().waitFor({ timeout: 60000 })
    await settled(page, 120)
  },
  'measure-doubted': (page) => dropped(page, 'beats.csv', swing((t) => 0.2 + 0.03 * Math.cos(9 * t) + 0.022 * Math.cos(9.35 * t) + 0.0002 * Math.sin(1e4 * t * t))),
  'measure-long-name': (page) => dropped(page, `${'a_very_long_name_of_a_recording_'.repeat(4)}of_the_second_group.csv`, swing((t) => 0.2 + 0.03 * Math.exp(-0.05 * t) * Math.cos(9 * t) + 0.0002 * Math.sin(1e4 * t * t))),
  'measure-several': async (page) => {
    await dropped(page, 'first.csv', swing((t) => 0.2 + 0.03 * Math.exp(-0.05 * t) * Math.cos(9 * t) + 0.0002 * Math.sin(1e4 * t * t)))
    await page.evaluate((texts) => {
      const files = new DataTransfer()
      texts.forEach((text, i) => files.items.add(new File([text], `${['second', 'third'][i]}.csv`)))
      document.querySelector('main').dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }))
    }, [8, 10].map((w) => swing((t) => 0.2 + 0.03 * Math.exp(-0.05 * t) * Math.cos(w * t) + 0.0002 * Math.sin(1e4 * t * t))))
    await page.locator('.row', { hasText: 'second.csv' }).waitFor()
    await settled(page, 120)
  },
  'measure-caught': (page) => dropped(page, 'caught.csv', swing((t) => 0.2 + (t < 30.3 ? 0.03 * Math.exp(-0.03 * t) * Math.cos(9 * t) : 0) + 0.0002 * Math.sin(1e4 * t * t))),
  'measure-flawed': (page) => dropped(page, 'flawed.csv', flawed),
  'measure-mass': async (page) => {
    await dropped(page, 'swing.csv', swing((t) => 0.2 + 0.03 * Math.exp(-0.05 * t) * Math.cos(9 * t) + 0.0002 * Math.sin(1e4 * t * t)))
    await page.locator('.given button').last().click()
    await page.locator('[data-field=mass]').fill('217 parsnips')
    await page.keyboard.press('Enter')
    await page.locator('[data-field=mass][aria-invalid=true]').waitFor()
  },
  'measure-word': async (page) => {
    await example(page, 0)
    await page.locator('h2 button').first().click()
  },
  ...(program && {
    'measure-live': async (page) => {
      await page.goto(await liveAddress())
      await measure(page)
      const start = page.getByRole('button', { name: /^(Start recording|Aufnahme beginnen)$/ })
      await page.locator('.zone').waitFor()
      if (await start.count()) await start.click()
      await page.locator('[data-live=frequency]').waitFor({ timeout: 60000 })
    },
  }),
  'teach-asks': (page) => go(page, '#teach?lab=one'),
  'teach-one': (page) => go(page, '#teach?lab=one&one=3&expected=1:1,2:1,3:1&driveAmplitude=1&driveFrequency=3&damping=0.2'),
  'teach-wall': (page) => go(page, '#teach?lab=one&one=6&expected=1:1,2:1,3:1,4:2,5:1,6:0&driveAmplitude=1&driveFrequency=3&damping=0.2&step=0.025&methods=exact,forward-euler&projector=true'),
  'teach-two': async (page) => {
    await go(page, '#teach?lab=two')
    await page.locator('.control button').first().click()
    await page.locator('.read').waitFor()
  },
  'teach-making': async (page) => {
    await go(page, '#teach?lab=two')
    await page.locator('.teachers button').first().click()
  },
  'teach-class': (page) => go(page, '#teach?lab=two&course=7F3A'),
}
const looks = [
  ...[390, 800, 1440, 1920].map((width) => ({ width })),
  { width: 1440, colorScheme: 'dark' },
  { width: 1440, locale: 'de-DE' },
  { width: 390, colorScheme: 'dark', locale: 'de-DE' },
]

const browser = await launch()
const take = async (name, look, reach, path, options = {}) => {
  const { width, ...others } = look
  const { page, context } = await open(browser, { width, height: width < 700 ? 844 : 900, ...others })
  await reach(page)
  await page.waitForTimeout(300)
  await page.screenshot({ path, ...options })
  await context.close()
}
if (readme) {
  const images = resolve(import.meta.dirname, '../../../../docs/images')
  await take('simulate', { width: 1440 }, states.simulate, join(images, 'page-simulate.png'))
  await take('measure', { width: 1440 }, states['measure-fitted'], join(images, 'page-measure.png'))
  await browser.close()
  process.exit()
}
const asked = ([name]) => name.includes(only)
for (const [name, reach] of Object.entries(states).filter(asked))
  for (const look of looks) {
    const { width, colorScheme, locale } = look
    const file = [name, width, colorScheme, locale?.slice(0, 2)].filter(Boolean).join('-')
    await take(name, look, reach, join(folder, `${file}.png`), { fullPage: true })
    console.log(join(folder, `${file}.png`))
  }
for (const [name, reach] of [['simulate', states.simulate], ['measure-fitted', states['measure-fitted']], ['measure-overlay', states['measure-overlay']], ['measure-failed', states['measure-failed']], ['teach-two', states['teach-two']]].filter(asked)) {
  const { page, context } = await open(browser, { colorScheme: 'dark' })
  await reach(page)
  await page.emulateMedia({ media: 'print' })
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
  await page.pdf({ path: join(folder, `${name}-print.pdf`), format: 'A4' })
  console.log(join(folder, `${name}-print.pdf`))
  await context.close()
}
await browser.close()
if (served) {
  served.serving.server.kill()
  served.sensor.close()
  for (const socket of served.sockets) socket.destroy()
  rmSync(served.folder, { recursive: true })
}
