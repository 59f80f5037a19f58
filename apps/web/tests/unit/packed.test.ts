import { execFileSync } from 'node:child_process'
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { afterAll, describe, expect, it } from 'vitest'

import { unpacked } from '../../src/core/packed'

const path = (relative: string) => fileURLToPath(new URL(relative, import.meta.url))
const built = path('../../../../build/page')
const folder = mkdtempSync(join(tmpdir(), 'cromer-pack-'))
afterAll(() => rmSync(folder, { recursive: true }))

function packed(bytes: Uint8Array): Uint8Array {
  const [from, to] = [join(folder, 'plain'), join(folder, 'packed')]
  writeFileSync(from, bytes)
  execFileSync('node', [path('../../pack/pack.mjs'), built, from, to])
  return readFileSync(to)
}

/// Copies from anywhere before, and noise, from where a module's code would be.
function mixture(count: number, heading: number[] = []): Uint8Array {
  const bytes = new Uint8Array(count)
  bytes.set(heading)
  let state = 7
  const next = (below: number) => (state = (state * 48271) % 2147483647) % below
  for (let at = heading.length; at < count;) {
    const length = Math.min(count - at, 1 + next(2 ** (1 + next(9))))
    const back = at > 0 && next(3) > 0 ? 1 + next(Math.min(at, 2 ** (1 + next(20)))) : 0
    for (let i = 0; i < length; ++i, ++at) bytes[at] = back ? bytes[at - back]! : next(256)
  }
  return bytes
}

/// Of a module whose code section claims to be endless.
const code = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 10, 0xff, 0xff, 0xff, 0xff, 7, 1, 0xff, 0xff, 0xff, 0xff, 7, 0]

// ./dev page builds the packer and the core.
describe.skipIf(!existsSync(join(built, 'pack.wasm')))('unpacked', () => {
  it('undoes the packing of anything, module or not', async () => {
    const all = [[], [5], new Uint8Array(100_000), mixture(300_000), mixture(300_000, code)]
    for (const bytes of all.map((each) => Uint8Array.from(each)))
      expect(Buffer.compare(await unpacked(packed(bytes)), bytes)).toBe(0)
  })

  it('undoes the packing of the core, which becomes small', async () => {
    const core = readFileSync(join(built, 'core.wasm'))
    const bytes = packed(core)
    expect(Buffer.compare(await unpacked(bytes), core)).toBe(0)
    expect(bytes.length).toBeLessThan(0.3 * core.length)
  })

  it('says where data are damaged', async () => {
    const bytes = packed(mixture(1000))
    await expect(unpacked(bytes.slice(0, 100))).rejects.toThrow()
    const claims = bytes.slice()
    new DataView(claims.buffer).setUint32(4 + new DataView(claims.buffer).getUint32(0, true), 0xffffffff, true)
    await expect(unpacked(claims)).rejects.toThrow(RangeError)
  })
})
