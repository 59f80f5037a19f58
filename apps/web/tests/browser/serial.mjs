// A serial line in a real browser: socat makes a pseudo-terminal, values without times are written into one end, and
// it is unplugged and plugged in again while the page looks on.
// CROMER_PROGRAM=build/ci/cromer node tests/browser/serial.mjs
import assert from 'node:assert/strict'
import { spawn, spawnSync } from 'node:child_process'
import { closeSync, existsSync, openSync, writeSync } from 'node:fs'
import { mkdtemp, readFile, rm } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { check, finish, launch } from './harness.mjs'
import { measurePage, program, serve } from './served_page.mjs'

if (!program || spawnSync('socat', ['-V']).status !== 0) {
  console.log('skip  a serial line: no cromer program, or no socat')
  process.exit(0)
}
const folder = await mkdtemp(join(tmpdir(), 'cromer-serial-'))
const line = join(folder, 'tty')
const frequency = 1.5 // [Hz]
let cable, port
const plugIn = async () => {
  cable = spawn('socat', [`pty,raw,echo=0,link=${join(folder, 'sensor')}`, `pty,raw,echo=0,link=${line}`])
  for (let i = 0; i < 100 && !(existsSync(line) && existsSync(join(folder, 'sensor'))); ++i) await new Promise((done) => setTimeout(done, 20))
  port = openSync(join(folder, 'sensor'), 'w')
}
const unplug = async () => {
  const wire = port
  port = undefined
  closeSync(wire)
  const ended = new Promise((done) => cable.on('exit', done))
  cable.kill()
  await ended
}
/** A hundred values a second from the recording's start on: what nobody reads would wait within socat. */
let talks = false
const begin = performance.now()
let n = 0
const sensor = setInterval(() => {
  for (; n / 100 <= (performance.now() - begin) / 1000; ++n) {
    const t = n / 100
    if (talks && port !== undefined) writeSync(port, `${(20 + 5 * Math.exp(-0.02 * t) * Math.cos(2 * Math.PI * frequency * t)).toFixed(4)}\n`)
  }
}, 2)

await plugIn()
const { server, address } = await serve('--from', `serial:${line}`, '--heading', 'Distance (cm)', '-o', join(folder, 'swing.csv'))
const browser = await launch()
try {
  const { page, card, faults, numberIn } = await measurePage(browser, address)
  const live = (what) => page.locator(`[data-live=${what}]`)
  const atLeast = (count) =>
    page.waitForFunction((least) => Number(document.querySelector('[data-live=samples]')?.textContent.replace(/\D/g, '')) > least, count, { timeout: 30000 })
  await check('values without times are recorded, by the rate that is found', async () => {
    await page.getByRole('button', { name: 'Start recording' }).click()
    await page.getByRole('button', { name: 'Stop and open' }).waitFor()
    talks = true
    await atLeast(800)
    const times = await live('times').innerText()
    assert.match(times, /by the rate found, \d+\.\d+/)
    assert.ok(Math.abs(numberIn(times) - 100) < 0.2, times)
    const text = await live('frequency').innerText()
    // The plot goes with the samples: what it says of itself for those who do not see it names the frame's end.
    await atLeast(1200)
    const [, end] = (await card.locator('[role=img]').getAttribute('aria-label')).match(/to ([\d.]+)/) ?? []
    assert.ok(Number(end) > 11.5, `the plot ends at ${end} s`)
    assert.ok(Math.abs(numberIn(text) / frequency - 1) < 1e-3, text)
    if (process.env.CROMER_PICTURE) await page.screenshot({ path: process.env.CROMER_PICTURE })
  })
  await check('unplugged and plugged in again it goes on, and says so', async () => {
    const before = numberIn(await live('samples').innerText())
    await unplug()
    await card.locator('li', { hasText: `${line} is gone` }).waitFor({ timeout: 15000 })
    await page.waitForTimeout(1500)
    await plugIn()
    await card.locator('li', { hasText: `${line} is back after` }).waitFor({ timeout: 15000 })
    await atLeast(before + 500)
    await card.locator('li', { hasText: 'nothing for' }).waitFor({ timeout: 5000 })
    if (process.env.CROMER_PICTURE) await page.screenshot({ path: process.env.CROMER_PICTURE.replace('.png', '-back.png') })
  })
  await check('its file has it all, and its law fits across the gap', async () => {
    await page.getByRole('button', { name: 'Stop and open' }).click()
    await page.locator('.row', { hasText: 'swing.csv' }).waitFor({ timeout: 20000 })
    await page.locator('[data-quantity=frequency]').waitFor({ timeout: 60000 })
    const text = await page.locator('[data-quantity=frequency]').innerText()
    assert.ok(Math.abs(numberIn(text) / frequency - 1) < 1e-3, text)
    const written = await readFile(join(folder, 'swing.csv'), 'utf8')
    for (const said of ['Time (s),Distance (cm)', `# ${line} is gone`, `# ${line} is back after`, '# times: by the steady rate that was found, '])
      assert.ok(written.includes(said), said)
  })
  await check('nothing went wrong', async () => assert.deepEqual(faults, []))
} finally {
  clearInterval(sensor)
  await browser.close()
  server.kill()
  cable.kill()
  await rm(folder, { recursive: true, force: true })
}
finish()
