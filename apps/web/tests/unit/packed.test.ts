import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { gzipSync } from 'node:zlib'
import { describe, expect, it } from 'vitest'

import { unlzma } from '../../src/core/lzma'
import { packed } from '../../src/core/pack'
import { moduleOf, sortedCode } from '../../src/core/streams'
import { bytesOf, textOf } from '../../src/core/text'

const built = (name: string) => fileURLToPath(new URL(`../../../../build/page/${name}`, import.meta.url))
const gzipped = (content: string | Uint8Array) => gzipSync(content, { level: 9 }).length

function noise(count: number): Uint8Array {
  let state = 7
  return Uint8Array.from({ length: count }, () => (state = (state * 48271) % 2147483647) >> 8)
}

describe('bytes as text', () => {
  it('come back', () => {
    const bytes = noise(300)
    for (let count = 0; count <= bytes.length; ++count) {
      const some = bytes.subarray(0, count)
      expect(Buffer.compare(bytesOf(textOf(some)), some)).toBe(0)
    }
  })

  it('end no script, and are hardly longer once gzipped', () => {
    const text = textOf(noise(200_000))
    expect(text).toMatch(/^[ -;=-~]*$/)
    expect(gzipped(text)).toBeLessThan(1.007 * 200_000)
  })
})

const section = (id: number, ...content: number[]) => [id, content.length, ...content]

/// A module with one function, of 200 bytes.
function moduleWith(code: number[]): Uint8Array<ArrayBuffer> {
  const nothing = Array(194 - code.length).fill(0x01)
  return new Uint8Array([
    0, 0x61, 0x73, 0x6d, 1, 0, 0, 0,
    ...section(1, 1, 0x60, 0, 0), ...section(3, 1, 0), ...section(4, 1, 0x70, 0, 0), ...section(5, 1, 0, 1),
    ...section(6, 1, 0x7f, 1, 0x41, 0, 0x0b),
    10, 0xcb, 0x01, 1, 0xc8, 0x01, 2, 2, 0x7f, 1, 0x7e, ...code, ...nothing, 0x0b,
    ...section(0, 1, 0x78, 1, 2, 3),
  ])
}

const everyKind = [
  0x41, 0xe4, 0x00, 0x21, 0, 0x42, 0x7f, 0x21, 2, 0x43, 1, 2, 3, 0x0b, 0x1a, 0x44, 1, 2, 3, 4, 5, 6, 7, 0x0b, 0x1a, // constants
  0x02, 0x40, 0x03, 0x40, 0x20, 0, 0x0e, 2, 0, 1, 1, 0x0b, 0x0b, 0x20, 0, 0x04, 0x40, 0x0c, 0, 0x05, 0x20, 0, 0x0d, 0, 0x0b, // jumps
  0x10, 0, 0x20, 0, 0x11, 0, 0, 0x23, 0, 0x24, 0, // calls, globals
  0x41, 0, 0x20, 0, 0x36, 2, 0x80, 0x01, 0x3f, 0, 0x40, 0, 0x1a, 0x41, 0, 0x41, 0, 0x41, 0, 0xfc, 11, 0, // memory
]
const vectors = [
  0x41, 0, 0xfd, 0, 4, 8, 0xfd, 12, ...noise(16), 0xfd, 13, ...Array(16).fill(0x0b), 0xfd, 33, 1, 0x1a,
  0x41, 0, 0x41, 0, 0xfd, 0, 4, 0, 0xfd, 84, 0, 0, 0x0b, 0x1a,
]

describe('sorted code', () => {
  it('comes back', () => {
    for (const code of [[], everyKind, vectors]) {
      const module = moduleWith(code)
      expect(WebAssembly.validate(module)).toBe(true)
      expect(Buffer.compare(moduleOf(sortedCode(module)), module)).toBe(0)
    }
  })

  it('says where it ends early', () => {
    const sorted = sortedCode(moduleWith(vectors))
    expect(() => moduleOf(sorted.subarray(0, sorted.length - 100))).toThrow(RangeError)
  })
})

describe.skipIf(!existsSync(built('core.wasm')))('the core', () => {
  it('comes back from its packing', () => {
    const core = readFileSync(built('core.wasm'))
    expect(Buffer.compare(moduleOf(unlzma(bytesOf(packed(core)))), core)).toBe(0)
  })
})

it.skipIf(!existsSync(built('cromer-lab.html')))('the page is at most 592 kB, gzipped', () => {
  expect(gzipped(readFileSync(built('cromer-lab.html')))).toBeLessThanOrEqual(592_000)
})
