import { execFileSync } from 'node:child_process'
import { describe, expect, it } from 'vitest'

import { unlzma } from '../../src/core/lzma'

const lzma = (bytes: Uint8Array) =>
  new Uint8Array(execFileSync('xz', ['--format=lzma', '--lzma1=preset=9e,lc=4,lp=0,pb=0', '--stdout'], { input: bytes, maxBuffer: 1 << 28 }))

/// Lengths and distances of every size: copies from anywhere before, and noise.
function mixture(count: number): Uint8Array {
  const bytes = new Uint8Array(count)
  let state = 7
  const next = (below: number) => (state = (state * 48271) % 2147483647) % below
  for (let at = 0; at < count;) {
    const length = Math.min(count - at, 1 + next(2 ** (1 + next(9))))
    const back = at > 0 && next(3) > 0 ? 1 + next(Math.min(at, 2 ** (1 + next(20)))) : 0
    for (let i = 0; i < length; ++i, ++at) bytes[at] = back ? bytes[at - back]! : next(256)
  }
  return bytes
}

describe('unlzma', () => {
  it('undoes xz', () => {
    for (const bytes of [new Uint8Array([5]), new Uint8Array(100_000), mixture(1_000_000)])
      expect(Buffer.compare(unlzma(lzma(bytes)), bytes)).toBe(0)
  })

  it('says where data are damaged or end early', () => {
    const packed = lzma(mixture(100_000))
    expect(() => unlzma(packed.slice(0, packed.length >> 1))).toThrow(RangeError)
    expect(() => unlzma(packed.slice(0, 10))).toThrow(RangeError)
    expect(() => unlzma(new Uint8Array(1000).fill(0xff))).toThrow()
  })
})
