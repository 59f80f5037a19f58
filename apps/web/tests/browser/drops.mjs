// What people drop on Measure that is no tidy table, and what other programs write: node tests/browser/drops.mjs
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { existsSync } from 'node:fs'
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { dirname, join, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { deflateRawSync } from 'node:zlib'
import { recordings, zip } from './dialects.mjs'
import { check, finish, framesWhileFitting, launch, open } from './harness.mjs'

const folder = await mkdtemp(join(tmpdir(), 'cromer-drops-'))
const browser = await launch()
const { page, context, faults } = await open(browser)
await page.locator('header nav a').nth(1).click()
const devtools = await context.newCDPSession(page)

/** As from the desktop: files and folders by their paths. */
async function drop(...paths) {
  const data = { items: [], files: paths, dragOperationsMask: 1 }
  for (const type of ['dragEnter', 'dragOver', 'drop']) await devtools.send('Input.dispatchDragEvent', { type, x: 500, y: 400, data })
}
async function put(name, content) {
  const path = join(folder, name)
  await writeFile(path, content)
  return path
}
const row = (text) => page.locator('.row', { hasText: text }).waitFor({ timeout: 60000 })
const said = async () => {
  await page.getByRole('alert').waitFor({ timeout: 60000 })
  return page.getByRole('alert').innerText()
}
const frequency = async (expected, within) => {
  await page.locator('[data-quantity=frequency]').waitFor({ timeout: 90000 })
  await page.waitForFunction(() => !document.querySelector('[aria-busy=true]'), null, { timeout: 90000 })
  const text = (await page.locator('[data-quantity=frequency]').innerText()).replace(/\u202f/g, '')
  assert.ok(Math.abs(Number(text.match(/[\d.]+/)[0]) - expected) < within, text)
}
const [, , plain] = recordings.find(([, name]) => name === 'plain.csv')
const lines = plain.trim().split('\n').slice(1)

await check('Vernier Format 3 is read', async () => {
  const head = 'Vernier Format 3\r\nlab.cmbl 3/4/2020 12:00:00\r\nRun 1\r\nTime\tPosition\r\nt\tx\r\ns\tm\r\n\r\n'
  await drop(await put('format3.txt', `${head}${lines.join('\r\n').replaceAll(',', '\t')}\r\n`))
  await row(/format3\.txt[\s\S]*Vernier Format 3/)
  await frequency(1.5, 0.003)
})
for (const [name, bytes] of [
  ['utf16.csv', Buffer.from(`\ufeff${plain}`, 'utf16le')],
  ['utf16-unmarked.csv', Buffer.from(plain, 'utf16le')],
])
  await check(`UTF-16 is read: ${name}`, async () => {
    await drop(await put(name, bytes))
    await row(name)
    await frequency(1.5, 0.003)
  })
await check('a deflated phyphox archive is read', async () => {
  const data = `"Time (s)","Gyroscope x (rad/s)"\n${lines.join('\n')}\n`
  await drop(await put('phyphox.zip', zip([['Raw Data.csv', data], ['meta/device.csv', 'property,value\nversion,1\n']], deflateRawSync)))
  await row(/phyphox\.zip[\s\S]*phyphox ZIP/)
  await frequency(1.5, 0.003)
})
const here = dirname(fileURLToPath(import.meta.url))
const program = process.env.CROMER_PROGRAM ?? ['ci', 'release', 'dev'].map((preset) => resolve(here, `../../../../build/${preset}/cromer`)).find(existsSync)
if (!program) console.log('skip  what cromer simulate writes: no cromer is built')
else
  await check('what cromer simulate writes is read', async () => {
    const path = join(folder, 'run.csv')
    const law = ['--mass', '0.2 kg', '--stiffness', '17 N/m', '--damping', '0.01 kg/s', '--position', '3 cm']
    execFileSync(program, ['simulate', ...law, '--method', 'exact', '--method', 'euler-cromer', '--until', '20 s', '--quiet', '-o', path])
    await drop(path)
    await row(/run\.csv[\s\S]*Cromer/)
    await frequency(Math.sqrt(17 / 0.2 - 0.025 ** 2) / (2 * Math.PI), 1e-3)
    assert.equal(await page.getByLabel('Run', { exact: true }).locator('option').count(), 2)
  })

const open_ = 'last.csv'
await check('the recording that the bad ones must leave', async () => {
  await drop(await put(open_, plain))
  await row(open_)
  await frequency(1.5, 0.003)
})
for (const [name, bytes, message] of [
  ['empty.csv', '', /empty\.csv: the file is empty/],
  ['photo.jpg', Buffer.from(Array.from({ length: 40000 }, (_, i) => (Math.imul(i, 2654435761) >>> 13) & 255)), /photo\.jpg: this is a binary file/],
  ['table.xlsx', Buffer.concat([Buffer.from('PK\x03\x04'), Buffer.alloc(2000, 7)]), /table\.xlsx: this is a file of Excel's own/],
  ['notes.txt', 'a poem,\nno table\n', /notes\.txt: no rows of numbers/],
])
  await check(`refused: ${name}`, async () => {
    await drop(await put(name, bytes))
    await page.getByRole('alert').filter({ hasText: name }).waitFor()
    assert.match(await said(), message)
    await row(open_)
    await frequency(1.5, 0.003)
  })
await check('refused: a folder', async () => {
  await drop(folder)
  await page.getByRole('alert').filter({ hasText: 'folder' }).waitFor()
  assert.match(await said(), /If it is a folder, drop one of the files in it/)
  await row(open_)
})
await check('of two files the first is read, and it is said', async () => {
  await drop(await put('first.csv', plain), await put('second.csv', plain))
  await row('first.csv')
  assert.match(await said(), /second\.csv: one recording is open at a time, and that is first\.csv/)
  await frequency(1.5, 0.003)
})
await check('60 MB are read and fitted, and the page draws on meanwhile', async () => {
  const count = 2_400_000
  const path = join(folder, 'big.csv')
  const parts = ['Time (s),Position (m)\n']
  for (let i = 0; i < count; ++i) {
    const t = i / 1000
    parts.push(`${t.toFixed(6)},${(0.2 + 0.03 * Math.exp(-0.001 * t) * Math.cos(2 * Math.PI * 1.5 * t)).toFixed(9)}\n`)
  }
  await writeFile(path, parts.join(''))
  assert.ok((await readFile(path)).length > 50e6)
  await drop(path)
  await row(/big\.csv[\s\S]*2\s400\s000/)
  await page.locator('.fit[aria-busy=true]').waitFor()
  assert.equal(await framesWhileFitting(page, 10), 10)
  await frequency(1.5, 1e-4)
  assert.equal(await page.getByRole('alert').count(), 0)
})
await check('nothing went wrong', async () => assert.deepEqual(faults.filter((each) => !/^request: file/.test(each)), []))

await context.close()
await browser.close()
await rm(folder, { recursive: true })
finish()
