// `cromer serve` as a process of its own, and its page in a browser.
import { spawn } from 'node:child_process'
import { existsSync } from 'node:fs'
import { resolve } from 'node:path'
import { file } from './harness.mjs'

const root = resolve(import.meta.dirname, '../../../..')
/** The program that CROMER_PROGRAM names, or the one that is built; undefined where there is none. */
export const program = [process.env.CROMER_PROGRAM, `${root}/build/ci/cromer`, `${root}/build/release/cromer`].find((path) => path && existsSync(path))

/** Serves the page at a free port. `address`: as it was printed first. */
export async function serve(...options) {
  const server = spawn(program, ['serve', '--page', file, '--port', '0', ...options], { stdio: ['ignore', 'pipe', 'pipe'] })
  const address = await new Promise((found, failed) => {
    let said = ''
    const hear = (text) => {
      said += text
      const url = said.match(/(http:\S+)\n/)
      if (url) found(url[1])
    }
    server.stdout.on('data', hear)
    server.stderr.on('data', hear)
    server.on('exit', () => failed(new Error(`serve ended: ${said}`)))
  })
  return { server, address }
}

/** The Measure page at an address; `faults` fills with errors and with requests to elsewhere. */
export async function measurePage(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, locale: 'en-GB', reducedMotion: 'reduce', ...options })
  const page = await context.newPage()
  const faults = []
  const { origin } = new URL(address)
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && faults.push(message.text()))
  page.on('pageerror', (error) => faults.push(error.stack))
  page.on('request', (request) => {
    if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(`${origin}/`)) faults.push(`request: ${request.url()}`)
  })
  await page.goto(address)
  await page.locator('header nav a').nth(1).click()
  await page.locator('.zone').waitFor()
  const card = page.locator('section.card', { has: page.locator('h2', { hasText: /^(Record live|Live aufnehmen)$/ }) })
  return { page, context, faults, card, numberIn: (text) => Number(text.replace(/[\u202f\u00a0]/g, '').match(/\d+(\.\d+)?/)[0]) }
}
