import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { buffersOf, withBlocks } from '../../src/core/blocks'
import { open } from '../../src/core/core'

const built = fileURLToPath(new URL('../../../../build/page/core.wasm.gz', import.meta.url))

describe('blocks', () => {
  it('come back into their places', () => {
    const numbers = new Float64Array([1, 2, 3, 4])
    const document = withBlocks(
      { a: { block: [1, 2] }, list: [{ block: [0, 1] }, null], text: 'block' },
      numbers,
    )
    expect(document).toEqual({
      a: new Float64Array([2, 3]),
      list: [new Float64Array([1]), null],
      text: 'block',
    })
    expect(buffersOf(document)).toHaveLength(2)
  })
})

// ./dev page builds the core.
describe.skipIf(!existsSync(built))('core', async () => {
  const core = existsSync(built) ? await open(readFileSync(built)) : undefined!

  it('simulates', () => {
    const answer = core.answer('simulate', [
      ['stiffness', '4 N/m'],
      ['method', 'exact'],
      ['step', '10 ms'],
      ['until', '1 s'],
    ])
    if (answer.status !== 0) throw new Error(JSON.stringify(answer))
    const { t, x } = answer.document.runs[0]!.states
    expect(t).toHaveLength(101)
    expect(x[100]).toBeCloseTo(Math.cos(2), 12)
  })

  it('says what is wrong as the program does', () => {
    expect(core.answer('simulate', [['step', '-1']])).toEqual({
      status: 2,
      document: { message: '--step: it must be positive, not -1 s' },
    })
  })

  it('reads a quantity, and runs nothing for it', () => {
    expect(core.answer('quantity', [['step', '20 ms']])).toEqual({ status: 0, document: { step: 0.02 } })
    expect(core.answer('quantity', [['stiffness', '1e25 N/m']])).toEqual({ status: 0, document: { stiffness: 1e25 } })
    expect(core.answer('quantity', [['drive-frequency', '1 Hz']]).document).toEqual({ 'drive-frequency': 2 * Math.PI })
    expect(core.answer('quantity', [['mass', '-1']])).toMatchObject({ status: 2, document: { message: '--mass: it must be positive, not -1 kg' } })
    expect(core.answer('quantity', [['stiffness', '2,500']])).toMatchObject({ status: 2 })
  })

  it('asks for less where its memory ends, and goes on', () => {
    const answer = core.answer('simulate', [
      ['step', '1e-9'],
      ['until', '10'],
    ])
    expect(answer.status).toBe(2)
    expect(core.answer('effective', []).status).toBe(0)
  })
})
