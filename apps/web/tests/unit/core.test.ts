import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { withBlocks } from '../../src/core/blocks'
import { compile, read, start } from '../../src/core/core'
import type { Options, Task } from '../../src/core/types'

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
  })
})

// ./dev page builds the core.
describe.skipIf(!existsSync(built))('core', async () => {
  const core = existsSync(built) ? await start(await compile(readFileSync(built))) : undefined!
  const ask = <T extends Task>(task: T, options: Options) => read<T>(core.answer(task, options))

  it('simulates', () => {
    const answer = ask('simulate', [
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

  it('gives the motions of a simulation without the rest of its document', () => {
    const options: Options = [
      ['stiffness', '4'],
      ['damping', '0.1'],
      ['method', 'exact'],
      ['method', 'forward-euler'],
      ['step', '1'],
      ['until', '2000'],
    ]
    const [whole, motions] = [ask('simulate', options), ask('motion', options)]
    if (whole.status === 2 || motions.status === 2) throw new Error('refused')
    expect(motions.document.runs.map((run) => run.states)).toEqual(whole.document.runs.map((run) => run.states))
    // the second ends where it left the numbers, with the same times so far
    const [first, second] = motions.document.runs
    expect(second!.status).toBe('not_finite')
    expect(second!.states.t.length).toBeLessThan(first!.states.t.length)
    expect(second!.states.t.byteOffset).toBe(first!.states.t.byteOffset)
    motions.document.runs.forEach((run, i) => {
      const { parameters, final, ...others } = whole.document.runs[i]!
      expect(run).toMatchObject({ drive_frequency: parameters.drive_frequency, energy_at_end: final.energy })
      for (const name of ['method', 'step', 'until', 'effective', 'stable', 'stability_limit', 'energy_factor_per_cycle'] as const)
        expect(run[name]).toEqual(others[name])
    })
  })

  it('says what is wrong as the program does', () => {
    expect(ask('simulate', [['step', '-1']])).toEqual({
      status: 2,
      document: { message: '--step: it must be positive, not -1 s' },
    })
  })

  it('reads a quantity, and runs nothing for it', () => {
    expect(ask('quantity', [['step', '20 ms']])).toEqual({ status: 0, document: { step: 0.02 } })
    expect(ask('quantity', [['stiffness', '1e25 N/m']])).toEqual({ status: 0, document: { stiffness: 1e25 } })
    expect(ask('quantity', [['drive-frequency', '1 Hz']]).document).toEqual({ 'drive-frequency': 2 * Math.PI })
    expect(ask('quantity', [['mass', '-1']])).toMatchObject({ status: 2, document: { message: '--mass: it must be positive, not -1 kg' } })
    expect(ask('quantity', [['stiffness', '2,500']])).toMatchObject({ status: 2 })
  })

  it('asks for less where its memory ends, and goes on', () => {
    const answer = ask('simulate', [
      ['step', '1e-9'],
      ['until', '10'],
    ])
    expect(answer.status).toBe(2)
    expect(ask('effective', []).status).toBe(0)
  })
})
