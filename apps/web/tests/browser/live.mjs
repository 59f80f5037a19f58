// Live recording in a real browser: `cromer serve` gives the page, a small server here plays the sensor.
// CROMER_PROGRAM=build/ci/cromer node tests/browser/live.mjs
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { existsSync } from 'node:fs'
import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { createServer } from 'node:net'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { axe, check, file, finish, launch, open } from './harness.mjs'
import { swingingSensor } from './sensor.mjs'

const program = resolve(process.env.CROMER_PROGRAM ?? fileURLToPath(new URL('../../../../build/ci/cromer', import.meta.url)))
if (!existsSync(program)) {
  console.log(`skip  live recording: ${program} is not there; name the program in CROMER_PROGRAM`)
  process.exit(0)
}

const { sensor, sockets, from, frequency } = await swingingSensor()

/** A port that was free a moment ago. */
async function freePort() {
  const probe = createServer()
  await new Promise((resolve) => probe.listen(0, '127.0.0.1', resolve))
  const { port } = probe.address()
  await new Promise((resolve) => probe.close(resolve))
  return port
}
const folder = await mkdtemp(join(tmpdir(), 'cromer-live-'))
const serve = async (...options) => {
  const port = await freePort()
  const server = spawn(program, ['serve', '--page', file, '--port', String(port), ...options], { stdio: ['ignore', 'pipe', 'pipe'] })
  let said = ''
  server.stdout.on('data', (text) => (said += text))
  server.stderr.on('data', (text) => (said += text))
  const address = `http://127.0.0.1:${port}/`
  for (let i = 0; i < 100; ++i) {
    if (server.exitCode !== null) throw new Error(said)
    if (await fetch(`${address}api/status`).then((answer) => answer.ok, () => false)) return { server, address }
    await new Promise((resolve) => setTimeout(resolve, 100))
  }
  server.kill()
  throw new Error(`cromer serve does not answer: ${said}`)
}

const { server, address } = await serve('--from', from, '-o', join(folder, 'swing.csv'))
const alone = await serve()
const browser = await launch()

/** The Measure page of a server. */
async function measure(at, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, locale: 'en-GB', reducedMotion: 'reduce', ...options })
  const page = await context.newPage()
  const faults = []
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && faults.push(message.text()))
  page.on('pageerror', (error) => faults.push(error.stack))
  page.on('request', (request) => {
    if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(at)) faults.push(`request: ${request.url()}`)
  })
  await page.goto(at)
  await page.locator('header nav a').nth(1).click()
  await page.locator('.zone').waitFor()
  return { page, context, faults }
}
const card = (page) => page.locator('section.card', { has: page.locator('h2', { hasText: /^(Record live|Live aufnehmen)$/ }) })
const live = (page, what) => page.locator(`[data-live=${what}]`)
const numberIn = (text) => Number(text.replace(/[\u202f\u00a0]/g, '').replace(',', '.').match(/[\d.]+/)[0])
const spoken = (page, sentence) =>
  page.waitForFunction((text) => document.querySelector('[aria-live=polite]').textContent.includes(text), sentence, { timeout: 10000 })
const faultless = async (page, what) => {
  await page.evaluate(axe)
  const found = await page.evaluate(() => axe.run(document, { resultTypes: ['violations'] }))
  const serious = found.violations.filter((each) => ['serious', 'critical'].includes(each.impact))
  assert.deepEqual(serious.map((each) => `${each.id}: ${each.nodes[0].html.slice(0, 160)}`), [], what)
}

try {
  {
    const { page, faults, context } = await measure(address)
    await check('the source is named, and nothing is recorded yet', async () => {
      await card(page).waitFor()
      assert.ok((await card(page).innerText()).includes(from))
      assert.equal(await live(page, 'samples').count(), 0)
    })
    await check('a recording is started, and its samples are counted', async () => {
      await page.getByRole('button', { name: 'Start recording' }).click()
      await spoken(page, 'Recording into swing.csv has begun.')
      await page.waitForFunction(() => Number(document.querySelector('[data-live=samples]')?.textContent) > 50, null, { timeout: 15000 })
      await card(page).locator('[data-drawn]').waitFor()
    })
    await check('its frequency is shown live, with its ±', async () => {
      await page.waitForFunction(() => Number(document.querySelector('[data-live=samples]')?.textContent) > 500, null, { timeout: 30000 })
      const text = await live(page, 'frequency').innerText()
      assert.match(text, /±|\(\d+\)/)
      assert.ok(Math.abs(numberIn(text) - frequency) < 0.003, text)
      if (process.env.CROMER_PICTURE) await page.screenshot({ path: process.env.CROMER_PICTURE })
      await faultless(page, 'recording')
    })
    await check('a lost connection is told, and that it is back', async () => {
      for (const socket of sockets) socket.destroy()
      await card(page).locator('li', { hasText: 'is gone' }).waitFor({ timeout: 15000 })
      await card(page).locator('li', { hasText: 'is back after' }).waitFor({ timeout: 15000 })
    })
    await check('stopped, it is opened, and its law appears', async () => {
      await page.getByRole('button', { name: 'Stop and open' }).click()
      await page.locator('.row', { hasText: 'swing.csv' }).waitFor({ timeout: 20000 })
      await page.locator('[data-quantity=frequency]').waitFor({ timeout: 60000 })
      assert.ok(Math.abs(numberIn(await page.locator('[data-quantity=frequency]').innerText()) - frequency) < 0.05)
      await page.getByRole('button', { name: 'Start recording' }).waitFor()
    })
    await check('nothing went wrong', async () => assert.deepEqual(faults, []))
    await context.close()
  }
  {
    const { page, faults, context } = await measure(address, { viewport: { width: 390, height: 844 }, locale: 'de-DE', colorScheme: 'dark', hasTouch: true })
    await check('a second one, in German on a phone, is its own file', async () => {
      await page.getByRole('button', { name: 'Aufnahme beginnen' }).click()
      await page.getByRole('button', { name: 'Beenden und öffnen' }).waitFor()
      await page.waitForFunction(() => Number(document.querySelector('[data-live=samples]')?.textContent) > 300, null, { timeout: 30000 })
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'the page is wider than the phone')
      if (process.env.CROMER_PICTURE) await page.screenshot({ path: process.env.CROMER_PICTURE.replace('.png', '-phone.png') })
      await faultless(page, 'phone')
      await page.getByRole('button', { name: 'Beenden und öffnen' }).click()
      await page.locator('.row', { hasText: 'swing-2.csv' }).waitFor({ timeout: 20000 })
      await page.locator('[data-quantity=frequency]').waitFor({ timeout: 60000 })
      const text = await page.locator('[data-quantity=frequency]').innerText()
      assert.ok(Math.abs(numberIn(text) - frequency) < 0.005, text)
    })
    await check('nothing went wrong', async () => assert.deepEqual(faults, []))
    await context.close()
  }
  {
    const { page, faults, context } = await measure(address)
    const length = page.getByLabel('Length')
    await check('a length that is no time is refused beside its field', async () => {
      for (const [typed, said] of [['5 kg', /kg/], ['0', /positive/], ['-3 s', /positive/], ['soon', /soon/]]) {
        await length.fill(typed)
        await page.getByRole('button', { name: 'Start recording' }).click()
        await card(page).locator('[role=alert]', { hasText: said }).waitFor({ timeout: 5000 })
        assert.equal(await length.getAttribute('aria-invalid'), 'true', typed)
      }
      assert.equal((await (await fetch(`${address}api/status`)).json()).running, false)
    })
    await check('a recording of a given length ends by itself, and is opened', async () => {
      await length.fill('3000 ms')
      await length.press('Enter')
      if (process.env.CROMER_PICTURE) await page.screenshot({ path: process.env.CROMER_PICTURE.replace('.png', '-length.png') })
      await page.waitForFunction(() => /\d of 3\u00a0s$/.test(document.querySelector('[data-live=duration]')?.textContent ?? ''), null, { timeout: 10000 })
      await page.locator('.row', { hasText: 'swing-3.csv' }).waitFor({ timeout: 20000 })
      await page.getByRole('button', { name: 'Start recording' }).waitFor()
      assert.equal(await live(page, 'samples').innerText(), '301')
    })
    await check('nothing went wrong', async () => assert.deepEqual(faults, []))
    await context.close()
  }
  await check('without a source there is no card', async () => {
    const { page, faults, context } = await measure(alone.address)
    await page.waitForTimeout(500)
    assert.equal(await card(page).count(), 0)
    assert.deepEqual(faults, [])
    await context.close()
  })
  await check('from disk nothing is asked', async () => {
    const { page, faults, context } = await open(browser)
    await page.locator('header nav a').nth(1).click()
    await page.locator('.zone').waitFor()
    await page.waitForTimeout(500)
    assert.equal(await card(page).count(), 0)
    assert.deepEqual(faults, [])
    await context.close()
  })
} finally {
  await browser.close()
  server.kill()
  alone.server.kill()
  for (const socket of sockets) socket.destroy()
  sensor.close()
  await rm(folder, { recursive: true, force: true })
}
finish()
