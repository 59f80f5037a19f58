// The page's own content policy, from disk and from a plain web server: node tests/browser/policy.mjs
import assert from 'node:assert/strict'
import { createHash } from 'node:crypto'
import { readFile } from 'node:fs/promises'
import { createServer } from 'node:http'
import { address, check, file, finish, launch, open } from './harness.mjs'

const html = await readFile(file, 'utf8')
const reached = []
const server = createServer((request, response) => {
  reached.push(request.url)
  if (request.url !== '/') return response.end() // the page asks whether something can be recorded
  response.writeHead(200, { 'content-type': 'text/html; charset=utf-8' }).end(html)
})
await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve))
const { port } = server.address()
const served = `http://127.0.0.1:${port}/`
const elsewhere = `http://localhost:${port}/` // another origin

await check('the page names its scripts by what they are, and nothing else', () => {
  const [before, policy] = html.match(/^([\s\S]*?)<meta http-equiv="Content-Security-Policy" content="([^"]*)"/)?.slice(1) ?? []
  assert.ok(policy, 'no policy')
  assert.doesNotMatch(before, /<(script|style|link)/)
  const parts = new Map(policy.split('; ').map((part) => [part.split(' ')[0], part.split(' ').slice(1).join(' ')]))
  for (const name of ['default-src', 'base-uri', 'form-action']) assert.equal(parts.get(name), "'none'", name)
  assert.equal(parts.get('worker-src'), 'blob:')
  const hashOf = (text) => `'sha256-${createHash('sha256').update(text).digest('base64')}'`
  const [[, script], [core], another] = html.matchAll(/<script[^>]*>([\s\S]*?)<\/script>/g)
  assert.match(core, /^<script type="text\/plain" id="core">[^<]*<\/script>$/)
  assert.equal(another, undefined)
  assert.equal(parts.get('script-src'), `${hashOf(script)} 'wasm-unsafe-eval'`)
  assert.doesNotMatch(policy, /'unsafe-(inline|eval)'|\*/)
})

const watch = () => {
  window.violations = []
  document.addEventListener('securitypolicyviolation', ({ effectiveDirective, blockedURI }) => window.violations.push(`${effectiveDirective} ${blockedURI}`))
}
const browser = await launch()
for (const [where, at] of [['disk', address], ['a server', served]]) {
  const { page, context, faults } = await open(browser, { at, watch, colorScheme: 'dark' })
  const violations = () => page.evaluate(() => window.violations.splice(0))
  await check(`from ${where} it works under it`, async () => {
    await page.waitForFunction(() => /forward Euler grows to/.test(document.querySelector('[role=img]').ariaLabel))
    await page.locator('[data-option=step]').focus()
    await page.keyboard.press('PageUp')
    for (const name of ['position.svg', 'energy.png', 'phase.csv']) {
      await page.getByRole('button', { name: 'Save figure or data' }).click()
      await Promise.all([page.waitForEvent('download'), page.locator(`[data-save="${name}"]`).click()])
    }
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')))
    assert.equal(await page.locator('.printed svg').count(), 4)
    await page.evaluate(() => dispatchEvent(new Event('afterprint')))
    await page.locator('header nav a').nth(1).click()
    await page.locator('.examples button').first().click()
    await page.locator('[data-quantity=stiffness]').waitFor({ timeout: 60000 })
    await page.getByRole('button', { name: 'Show simulations' }).click()
    await page.locator('.legend', { hasText: 'Euler-Cromer' }).waitFor({ timeout: 60000 })
    await page.locator('header nav a').nth(2).click()
    await page.locator('#step-title').waitFor()
    await page.getByRole('radio').nth(1).check()
    await page.getByRole('button', { name: 'Check answers' }).click()
    await page.locator('.foot .caption', { hasText: /\d/ }).waitFor({ timeout: 60000 })
    assert.deepEqual(await violations(), [])
    assert.deepEqual(faults, [])
  })
  await check(`from ${where} nothing foreign runs or is asked for`, async () => {
    const ran = await page.evaluate(async (elsewhere) => {
      window.ran = []
      const put = (name, fill) => {
        const element = document.createElement(name)
        fill(element)
        document.body.append(element)
        return element
      }
      put('script', (script) => (script.textContent = 'window.ran.push("inline")'))
      put('script', (script) => (script.src = 'data:text/javascript,window.ran.push("data")'))
      put('script', (script) => (script.src = URL.createObjectURL(new Blob(['window.ran.push("blob")'], { type: 'text/javascript' }))))
      put('div', (div) => (div.innerHTML = '<button onclick="window.ran.push(1)"></button>')).firstChild.click()
      put('a', (link) => (link.href = 'javascript:window.ran.push("link")')).click()
      put('img', (image) => (image.src = `${elsewhere}image`))
      put('iframe', (frame) => (frame.src = `${elsewhere}frame`))
      put('form', (form) => Object.assign(form, { action: `${elsewhere}form`, target: '_blank' })).submit()
      put('base', (base) => (base.href = elsewhere))
      await fetch(`${elsewhere}fetch`).then(() => window.ran.push('fetch'), () => {})
      await new Promise((resolve) => setTimeout(resolve, 300))
      return window.ran
    }, elsewhere)
    assert.deepEqual(ran, [])
    const refused = (await violations()).map((each) => each.split(' ')[0])
    for (const directive of ['script-src-elem', 'script-src-attr', 'img-src', 'frame-src', 'form-action', 'base-uri', 'connect-src'])
      assert.ok(refused.includes(directive), `${directive} is not among ${refused}`)
    assert.deepEqual(reached.filter((each) => !['/', '/api/status'].includes(each)), [])
  })
  await context.close()
}

await browser.close()
server.close()
finish()
