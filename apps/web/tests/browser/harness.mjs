// Opens the built page from disk in Chromium and keeps account of what must not happen: errors and requests.
import { existsSync } from 'node:fs'
import { dirname, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { chromium } from 'playwright-core'

const here = dirname(fileURLToPath(import.meta.url))
export const file = process.env.CROMER_PAGE ?? resolve(here, '../../../../build/page/cromer-lab.html')
export const address = `file://${file}`
if (!existsSync(file)) throw new Error(`${file} is not there: run "npm run build" first`)

const options = [
  '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync',
]

export const launch = () => chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: options })

/** A page of its own profile, `watch` run in it before its own scripts; `faults` fills with console errors, exceptions and requests. */
export async function open(browser, { width = 1440, height = 900, hash = '', watch, ...others } = {}) {
  const context = await browser.newContext({
    viewport: { width, height }, locale: 'en-GB', reducedMotion: 'reduce', acceptDownloads: true, ...others,
  })
  const page = await context.newPage()
  if (watch) await page.addInitScript(watch)
  const faults = []
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && faults.push(message.text()))
  page.on('pageerror', (error) => faults.push(error.stack))
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) faults.push(`request: ${request.url()}`)
  })
  await page.goto(address + hash)
  await page.waitForFunction(() => document.querySelector('[data-drawn]'))
  return { page, context, faults }
}

let failed = 0
/** Runs one check; a failed one is told, and the others go on. */
export async function check(name, body) {
  try {
    await body()
    console.log(`ok    ${name}`)
  } catch (error) {
    ++failed
    console.log(`FAILS ${name}\n      ${String(error.stack ?? error).split('\n').slice(0, 4).join('\n      ')}`)
  }
}
export function finish() {
  console.log(failed ? `${failed} failed` : 'all passed')
  process.exitCode = failed ? 1 : 0
}
