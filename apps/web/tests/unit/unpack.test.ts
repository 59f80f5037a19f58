import { crc32, deflateRawSync } from 'node:zlib'
import { describe, expect, it } from 'vitest'

import { unpack } from '../../src/core/unpack'

interface Held {
  name: string
  text: string
  deflated?: boolean
  locked?: boolean
  claimed?: number
}

/// An archive as loggers write them.
function archive(held: Held[]): Uint8Array {
  const locals: Buffer[] = []
  const records: Buffer[] = []
  let offset = 0
  for (const { name, text, deflated = true, locked = false, claimed } of held) {
    const plain = Buffer.from(text)
    const packed = deflated ? deflateRawSync(plain) : plain
    const local = Buffer.alloc(30)
    local.writeUInt32LE(0x04034b50, 0)
    local.writeUInt16LE(deflated ? 8 : 0, 8)
    local.writeUInt16LE(name.length, 26)
    const record = Buffer.alloc(46)
    record.writeUInt32LE(0x02014b50, 0)
    record.writeUInt16LE(locked ? 1 : 0, 8)
    record.writeUInt16LE(deflated ? 8 : 0, 10)
    record.writeUInt32LE(crc32(plain), 16)
    record.writeUInt32LE(packed.length, 20)
    record.writeUInt32LE(claimed ?? plain.length, 24)
    record.writeUInt16LE(name.length, 28)
    record.writeUInt32LE(offset, 42)
    locals.push(local, Buffer.from(name), packed)
    records.push(record, Buffer.from(name))
    offset += 30 + name.length + packed.length
  }
  const directory = Buffer.concat(records)
  const end = Buffer.alloc(22)
  end.writeUInt32LE(0x06054b50, 0)
  end.writeUInt16LE(held.length, 8)
  end.writeUInt16LE(held.length, 10)
  end.writeUInt32LE(directory.length, 12)
  end.writeUInt32LE(offset, 16)
  return new Uint8Array(Buffer.concat([...locals, directory, end]))
}

const table =
  'Time (s),Position (m)\n' +
  Array.from({ length: 200 }, (_, i) => `${i / 100},${Math.cos(i / 10)}\n`).join('')

describe('unpack', () => {
  it('stores what was deflated', async () => {
    const held = [
      { name: 'Raw Data.csv', text: table },
      { name: 'meta/device.csv', text: 'property,value\n', deflated: false },
    ]
    const stored = held.map((each) => ({ ...each, deflated: false }))
    expect(await unpack(archive(held))).toEqual(archive(stored))
  })

  it('hands other files on as they are', async () => {
    const text = new TextEncoder().encode(table)
    expect(await unpack(text)).toBe(text)
    expect(await unpack(new Uint8Array())).toHaveLength(0)
  })

  it('leaves locked entries to the core', async () => {
    const locked = archive([{ name: 'a.csv', text: table, locked: true }])
    expect(await unpack(locked)).toBe(locked)
  })

  it('does not inflate what claims to hold far more than its size, or holds more than it claims', async () => {
    const bomb = archive([{ name: 'a.csv', text: '0'.repeat(1_000_000) }])
    expect(await unpack(bomb)).toBe(bomb)
    const liar = archive([{ name: 'a.csv', text: table, claimed: 100 }])
    expect(await unpack(liar)).toBe(liar)
  })

  it('hands on what is cut off or damaged', async () => {
    const whole = archive([{ name: 'a.csv', text: table }])
    for (const length of [1, 30, 100, whole.length - 1]) {
      const part = whole.slice(0, length)
      expect(await unpack(part)).toBe(part)
    }
    const damaged = whole.map((byte, i) => (i > 40 && i < 80 ? byte ^ 0xff : byte))
    expect(await unpack(damaged)).toBe(damaged)
  })
})
