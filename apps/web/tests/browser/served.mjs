// The page as `cromer serve` gives it: under its content policy, from its own origin and nowhere else.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { existsSync } from 'node:fs'
import { resolve } from 'node:path'
import { check, file, finish, launch } from './harness.mjs'

const root = resolve(import.meta.dirname, '../../../..')
const program = [process.env.CROMER_PROGRAM, `${root}/build/ci/cromer`, `${root}/build/release/cromer`].find(
  (path) => path && existsSync(path),
)
if (!program) {
  console.log('skipped: no cromer program; build it, or name it in CROMER_PROGRAM')
  process.exit(0)
}

const server = spawn(program, ['serve', '--port', '0', '--page', file])
const address = await new Promise((found, failed) => {
  let said = ''
  const hear = (text) => {
    said += text
    const url = said.match(/http:\/\/[^\s]+/)
    if (url) found(url[0])
  }
  server.stdout.on('data', hear)
  server.stderr.on('data', hear)
  server.on('exit', () => failed(new Error(`serve ended: ${said}`)))
})
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
await browser.close()
server.kill('SIGINT')
finish()
