import { existsSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'

import { read, start } from '../../src/core/core'
import type { Motions, Options } from '../../src/core/types'
import type { Run } from '../../src/simulate/curves'
import { coreOptions } from '../../src/simulate/options'
import { curvesOfBoth, modesOf, networkFile, runOfBoth, startOf, stateOfMode } from '../../src/simulate/second'
import { simulateDefaults, type SimulateState } from '../../src/simulate/state'

const two: SimulateState = {
  ...simulateDefaults, second: true, mass: 2, stiffness: 8, damping: 0.1, driveAmplitude: 0, position: 0.1, velocity: 0.05, step: 0.05, until: 20,
  secondMass: 3, secondStiffness: 5, coupling: 1.5, secondPosition: -0.04,
}

describe('normal modes', () => {
  it('hold in the equations of motion', () => {
    for (const s of [two, { ...two, coupling: 0 }, { ...two, coupling: -0.4 }, { ...two, secondMass: 2, secondStiffness: 8 }, { ...two, secondStiffness: 300 }])
      for (const { square, first, second } of modesOf(s)) {
        expect((s.stiffness + s.coupling) * first - s.coupling * second).toBeCloseTo(square * s.mass * first, 12)
        expect((s.secondStiffness + s.coupling) * second - s.coupling * first).toBeCloseTo(square * s.secondMass * second, 12)
        expect(Math.max(first, Math.abs(second))).toBe(1)
        expect(first).toBeGreaterThanOrEqual(0)
      }
  })
  it('of equal masses swing together, then against each other', () => {
    const [slow, fast] = modesOf({ ...two, secondMass: 2, secondStiffness: 8, coupling: 3 })
    expect([slow.first, slow.second, fast.first, fast.second].map((each) => each.toFixed(12))).toEqual(['1', '1', '1', '-1'].map((each) => Number(each).toFixed(12)))
    expect([slow.square, fast.square].map((each) => Math.round(each * 1e12) / 1e12)).toEqual([4, 7])
  })
  it('start alone from their shapes', () => {
    const modes = modesOf(two)
    const [one, other] = modes.map((_, i) => ({ ...two, ...startOf(modes[i]!, two) }))
    expect(Math.abs(stateOfMode(one!, modes[1]).position)).toBeLessThan(1e-6)
    expect(Math.abs(stateOfMode(other!, modes[0]).position)).toBeLessThan(1e-6)
    expect(Math.max(Math.abs(one!.position), Math.abs(one!.secondPosition))).toBe(0.1)
  })
})

it('the network file is what the program reads', () => {
  expect(networkFile({ ...two, driveAmplitude: 1 })).toBe(
    '[[mass]]\nname = "first"\nmass = "2 kg"\nposition = "0.1 m"\nvelocity = "0.05 m/s"\ndrive_amplitude = "1 N"\ndrive_frequency = "3 rad/s"\n\n' +
      '[[mass]]\nname = "second"\nmass = "3 kg"\nposition = "-0.04 m"\n\n' +
      '[[link]]\nto = "first"\nstiffness = "8 N/m"\ndamping = "0.1 kg/s"\n\n' +
      '[[link]]\nto = "second"\nstiffness = "5 N/m"\ndamping = "0.15000000000000002 kg/s"\n\n' +
      '[[link]]\nfrom = "first"\nto = "second"\nstiffness = "1.5 N/m"\n',
  )
})

const built = fileURLToPath(new URL('../../../../build/page/core.wasm', import.meta.url))
describe.skipIf(!existsSync(built))('both masses', async () => {
  const core = existsSync(built) ? await start(await WebAssembly.compile(readFileSync(built))) : undefined!
  const ask = (options: Options): Motions => {
    const answer = read<'motion'>(core.answer('motion', options))
    if (answer.status === 2) throw new Error(JSON.stringify(answer.document))
    return answer.document
  }
  const runBy = (s: SimulateState, method: string): Run => {
    const modes = modesOf(s)
    const [slow, fast] = modes.map((mode) => ({ ...ask(coreOptions(stateOfMode({ ...s, methods: [method] }, mode))).runs[0]!, between: null }))
    return runOfBoth(modes, [slow!, fast!])
  }

  // cromer simulate --network two.toml --method M --step 0.05 --until 20 (of the file above, with and without its drive): the last row
  const rows: [method: string, driven: boolean, x: number, v: number, x2: number, energy: number][] = [
    ['exact', false, 0.06871175872363178, -0.006958082004653336, -0.0005577277870805978, 0.022629760996719046],
    ['exact', true, 0.2463445429724731, -0.17034110583297066, -0.028507539607004972, 0.330664120572111],
    ['forward-euler', false, 0.7527700169514752, 0.14688257722345555, -0.10484459135335791, 2.871396375872846],
    ['forward-euler', true, 1.640393817928538, 0.4320235574647606, -0.27713096950611826, 13.919046174891287],
    ['euler-cromer', false, 0.06746437416900171, -0.013980872330083462, -0.0005968479384610328, 0.021953812138286913],
    ['euler-cromer', true, 0.24609785573577325, -0.14536319341626683, -0.028885341976669407, 0.3222878298794212],
    ['implicit-euler', false, 0.006884269288125884, 0.0018295141149746348, 0.0033127012527472133, 0.00024528935219703243],
    ['implicit-euler', true, 0.10262253261078914, -0.19466384523229538, -0.00563541290269478, 0.08934951164051874],
    ['verlet', false, 0.06865966115705786, -0.010195856651070137, -0.0005871369271899188, 0.022642852306885966],
    ['verlet', true, 0.24658401182539993, -0.17705782150531607, -0.028567843451808902, 0.33364815080417104],
    ['rk4', false, 0.068711712579196, -0.006950073375902938, -0.0005576785770210359, 0.022629647173567323],
    ['rk4', true, 0.24634401326056787, -0.17032400084832597, -0.028507422885903685, 0.33065685454798965],
    ['newmark', false, 0.06882568522230964, -0.00039314590956308036, -0.0004958829220119029, 0.022675192494879787],
    ['newmark', true, 0.24588733281026373, -0.1559799146229976, -0.02838998251273874, 0.32474224012906017],
    ['generalized-alpha', false, 0.06882593487701993, -2.9780511124524733e-05, -0.0004914004270195644, 0.02267623102882721],
    ['generalized-alpha', true, 0.2463427689428584, -0.15560787712083202, -0.02845884366266562, 0.32574619285329287],
    ['gauss-legendre4', false, 0.06871180652676506, -0.006956754680397005, -0.0005577290858345337, 0.022629779387368817],
    ['gauss-legendre4', true, 0.24634456903122498, -0.17033821372586763, -0.02850753970084147, 0.3306631786221535],
    ['heun', false, 0.06857740420505193, -0.020146012777200458, -0.0006886868959449233, 0.02287104208810165],
    ['heun', true, 0.24649296922730013, -0.19817810408542474, -0.02862387199458495, 0.34155746301211876],
    ['yoshida4', false, 0.06871238883818041, -0.006894639404299448, -0.0005575356755581887, 0.022629534567050864],
    ['yoshida4', true, 0.24634050503718238, -0.17020394727678861, -0.028506640685819352, 0.3306063971022194],
    ['implicit-midpoint', false, 0.06882568522230957, -0.000393145909563096, -0.0004958829220118753, 0.022675192494879738],
    ['implicit-midpoint', true, 0.246386488524488, -0.1564185303577914, -0.02846861896164533, 0.3261127725237276],
  ]
  it.each(rows)('move as the program’s network does: %s, driven %s', (method, driven, x, v, x2, energy) => {
    const { states } = runBy({ ...two, driveAmplitude: driven ? 1 : 0 }, method)
    const last = states.t.length - 1
    expect(states.t[last]).toBe(20)
    for (const [is, should] of [[states.x[last]!, x], [states.v[last]!, v], [states.x2![last]!, x2], [states.energy[last]!, energy]] as const)
      expect(Math.abs(is - should)).toBeLessThan(1e-11)
  })

  it('settle as the sum of their modes’ resonance curves says', () => {
    const s: SimulateState = { ...two, driveAmplitude: 1, driveFrequency: 1.7, damping: 1, until: 200, methods: ['exact'], position: 0, velocity: 0, secondPosition: 0 }
    const modes = modesOf(s)
    const found = modes.map((mode) => {
      const options = coreOptions({ ...stateOfMode(s, mode), driveAmplitude: s.driveAmplitude }).filter(([name]) => !['until', 'position'].includes(name))
      const answer = read<'resonance'>(core.answer('resonance', [...options, ['frequencies', '1.6:1.8:3']]))
      if (answer.status === 2) throw new Error(JSON.stringify(answer.document))
      return answer.document.curves
    })
    const { states } = runBy(s, 'exact')
    let most = 0
    for (let i = states.x.length - 400; i < states.x.length; ++i) most = Math.max(most, Math.abs(states.x[i]!))
    expect(curvesOfBoth(modes, found)[0]!.amplitude[1]! / most).toBeCloseTo(1, 2)
  })
})
