// Opens the built page from disk in Chromium and keeps account of what must not happen: errors and requests.
import { existsSync, readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { dirname, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { chromium } from 'playwright-core'

const here = dirname(fileURLToPath(import.meta.url))
export const file = process.env.CROMER_PAGE ?? resolve(here, '../../../../build/page/cromer-lab.html')
export const address = `file://${file}`
if (!existsSync(file)) throw new Error(`${file} is not there: run "npm run build" first`)

/** The accessibility rules, to be evaluated in the page: its policy lets no script be added. */
export const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8')

const options = [
  '--headless', '--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync',
]

export const launch = () => chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: options })

/** A page of its own profile, `watch` run in it before its own scripts; `faults` fills with console errors, exceptions and requests. */
export async function open(browser, { width = 1440, height = 900, at = address, hash = '', watch, drawn = true, ...others } = {}) {
  const context = await browser.newContext({
    viewport: { width, height }, locale: 'en-GB', reducedMotion: 'reduce', acceptDownloads: true, ...others,
  })
  const page = await context.newPage()
  if (watch) await page.addInitScript(watch)
  const faults = []
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && faults.push(message.text()))
  page.on('pageerror', (error) => faults.push(error.stack))
  page.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url()) && !request.url().startsWith(at)) faults.push(`request: ${request.url()}`)
  })
  await page.goto(at + hash)
  if (drawn) await page.waitForFunction(() => document.querySelector('[data-drawn]'))
  else await page.locator('main').waitFor()
  return { page, context, faults }
}

/** Lets go of a file over the page. */
export async function drop(page, name, content) {
  const data = await page.evaluateHandle(([name, bytes]) => {
    const transfer = new DataTransfer()
    transfer.items.add(new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], name))
    return transfer
  }, [name, Buffer.from(content).toString('base64')])
  await page.dispatchEvent('main', 'dragover', { dataTransfer: data })
  await page.dispatchEvent('main', 'drop', { dataTransfer: data })
}

/** Nothing is being fitted. */
export async function settled(page, seconds = 90) {
  await page.waitForTimeout(350) // the settings rest for 160 ms before they are asked for
  await page.waitForFunction(() => document.querySelector('.fit') && !document.querySelector('.fit[aria-busy=true]'), null, { timeout: 1000 * seconds })
}

/** Run before the page's own scripts: answers of the core wait while `window.held` is a list. */
export const holdable = `window.Worker = class extends Worker {
  constructor(...all) {
    super(...all)
    this.addEventListener('message', (event) => {
      if (!window.held) return
      event.stopImmediatePropagation()
      window.held.push(() => this.dispatchEvent(new MessageEvent('message', { data: event.data })))
    })
  }
}`

/** Lets the core's answers through again, in their order. */
export const release = (page) =>
  page.evaluate(() => {
    const held = window.held
    window.held = undefined
    for (const answer of held) answer()
  })

/** Frames drawn while something is being fitted, `most` at most. */
export const framesWhileFitting = (page, most) =>
  page.evaluate((most) => new Promise((resolve) => {
    let frames = 0
    const tick = () => {
      if (!document.querySelector('.fit[aria-busy=true]') || ++frames === most) resolve(frames)
      else requestAnimationFrame(tick)
    }
    requestAnimationFrame(tick)
  }), most)

/** Saves a plot; what the file holds. */
export async function saved(page, name) {
  await page.getByRole('button', { name: 'Save figure or data' }).click()
  const [download] = await Promise.all([page.waitForEvent('download'), page.locator(`[data-save="${name}"]`).click()])
  return readFileSync(await download.path(), 'utf8')
}

/** Pixels of the page's curves in the middle of 9 × 9 dark ones, darker than 128: no line and no letter of the light theme
    is as thick. In the dark theme nothing is as black as 8. */
export const slabs = (page, darkest = 128) =>
  page.evaluate((darkest) =>
    [...document.querySelectorAll('[role=img] canvas')].reduce((sum, canvas) => {
      const { width, height } = canvas
      const copy = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true })
      copy.drawImage(canvas, 0, 0)
      const { data } = copy.getImageData(0, 0, width, height)
      // how many dark ones end at a pixel, in its row, and rows of nine of them in its column
      const down = new Uint16Array(width)
      for (let y = 0; y < height; ++y)
        for (let x = 0, run = 0; x < width; ++x) {
          const at = 4 * (y * width + x)
          const light = 255 - (data[at + 3] / 255) * (255 - (data[at] + data[at + 1] + data[at + 2]) / 3)
          run = light < darkest ? run + 1 : 0
          down[x] = run >= 9 ? down[x] + 1 : 0
          if (down[x] >= 9) ++sum
        }
      return sum
    }, 0),
  darkest)

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
