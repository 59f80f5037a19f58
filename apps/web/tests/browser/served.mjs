// The page as `cromer serve` gives it: under its content policy, from its own origin and nowhere else.
import assert from 'node:assert/strict'
import { mkdtemp, rm } from 'node:fs/promises'
import { createServer } from 'node:net'
import { tmpdir } from 'node:os'
import { join, resolve } from 'node:path'
import { check, finish, launch } from './harness.mjs'
import { measurePage, program, serve } from './served_page.mjs'

const root = resolve(import.meta.dirname, '../../../..')
if (!program) {
  console.log('skipped: no cromer program; build it, or name it in CROMER_PROGRAM')
  process.exit(0)
}

const { server, address } = await serve()
const browser = await launch()
const page = await (await browser.newContext({ locale: 'en-GB', reducedMotion: 'reduce' })).newPage()
const faults = []
page.on('console', (message) => ['error', 'warning'].includes(message.type()) && faults.push(message.text()))
page.on('pageerror', (error) => faults.push(error.stack))
page.on('request', (request) => {
  if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(address)) faults.push(request.url())
})

await check('opens and simulates', async () => {
  await page.goto(address)
  await page.waitForFunction(() => /forward Euler/.test(document.querySelector('[role=img]')?.getAttribute('aria-label')))
})
await check('fits a dropped recording', async () => {
  await page.goto(`${address}#`)
  await page.getByText('Measure', { exact: true }).first().click()
  await page.setInputFiles('input[type=file]', `${root}/data/recording1.csv`)
  await page.locator('[data-quantity=frequency]').waitFor({ timeout: 60_000 })
})
await check('nothing else is served', async () => {
  for (const path of ['etc/passwd', '../../etc/passwd', 'api/recordings/x.csv'])
    assert.notEqual((await page.request.get(address + path)).status(), 200)
})
await check('nothing went wrong', () => assert.deepEqual(faults, []))

// At another address, as a teacher gives it to a class: with a token, recording and all.
{
  let n = 0
  const sensor = createServer((socket) => {
    const begin = performance.now()
    n = 0
    const timer = setInterval(() => {
      for (; n / 100 <= (performance.now() - begin) / 1000; ++n)
        socket.write(`${(n / 100).toFixed(2)} ${Math.cos((2 * Math.PI * 1.5 * n) / 100).toFixed(6)}\n`)
    }, 10)
    socket.on('error', () => {})
    socket.on('close', () => clearInterval(timer))
  })
  await new Promise((done) => sensor.listen(0, '127.0.0.1', done))
  const folder = await mkdtemp(join(tmpdir(), 'cromer-token-'))
  const options = ['--address', '0.0.0.0', '--from', `tcp:127.0.0.1:${sensor.address().port}`, '-o', join(folder, 'class.csv')]
  const lab = await serve(...options)
  const other = await serve(...options.slice(0, 2))
  const { origin, searchParams } = new URL(lab.address)
  await check('the printed address is one that others can open', async () => {
    assert.match(lab.address, /^http:\/\/(?!0\.0\.0\.0)\d+\.\d+\.\d+\.\d+:\d+\/\?token=[0-9a-f]{32}$/)
  })
  await check('without its token, or with another, a page says what is missing, and nothing is kept', async () => {
    for (const wrong of ['', '/?token=', `/?token=${'0'.repeat(32)}`, new URL(other.address).search]) {
      const context = await browser.newContext({ locale: 'en-GB' })
      const stranger = await context.newPage()
      const answer = await stranger.goto(origin + wrong)
      assert.equal(answer.status(), 401)
      await stranger.getByRole('heading', { name: 'The address is not complete' }).waitFor()
      assert.deepEqual(await context.cookies(), [])
      assert.equal((await context.request.get(`${origin}/api/status`)).status(), 401)
      assert.equal((await context.request.post(`${origin}/api/record`)).status(), 401)
      await context.close()
    }
  })
  const { page: student, context, card, faults: trouble, numberIn } = await measurePage(browser, lab.address)
  await check('with it the page records, stops, and fits', async () => {
    const [cookie] = await context.cookies()
    assert.equal(cookie.value, searchParams.get('token'))
    assert.ok(cookie.httpOnly && cookie.sameSite === 'Strict')
    await student.getByRole('button', { name: 'Start recording' }).click()
    await student.waitForFunction(() => Number(document.querySelector('[data-live=samples]')?.textContent) > 400, null, { timeout: 30000 })
    await student.getByRole('button', { name: 'Stop and open' }).click()
    await student.locator('.row', { hasText: 'class.csv' }).waitFor({ timeout: 20000 })
    await student.locator('[data-quantity=frequency]').waitFor({ timeout: 60000 })
    const text = await student.locator('[data-quantity=frequency]').innerText()
    assert.ok(Math.abs(numberIn(text) - 1.5) < 0.003, text)
  })
  await check('the cookie lasts: the address without the token then opens it too', async () => {
    await student.goto(`${origin}/`)
    await card.waitFor({ state: 'attached' }).catch(() => {})
    await student.locator('header nav a').nth(1).click()
    await card.waitFor()
  })
  await check('two labs at one address stay apart', async () => {
    const beside = await context.newPage()
    await beside.goto(other.address)
    await beside.locator('header nav a').nth(1).waitFor()
    await beside.close()
    await student.goto(lab.address.replace(/\?.*/, ''))
    await student.locator('header nav a').nth(1).click()
    await card.waitFor()
  })
  await check('nothing went wrong there', () => assert.equal(trouble.join('; '), ''))
  await context.close()
  for (const each of [lab, other]) each.server.kill('SIGINT')
  sensor.close()
  await rm(folder, { recursive: true, force: true })
}
await browser.close()
server.kill('SIGINT')
finish()
