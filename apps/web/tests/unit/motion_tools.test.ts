import { describe, expect, it } from 'vitest'
import { energyAt, workOf } from '../../src/simulate/energy_now'
import { soundOf } from '../../src/simulate/sound'
import { turningAfter } from '../../src/simulate/turning'

/// x = exp(-g t) cos(w t) of a mass of 2 kg on a spring of 8 N/m.
const [m, k, g] = [2, 8, 0.1]
const w = Math.sqrt(k / m - g * g)
const t = Float64Array.from({ length: 2001 }, (_, i) => i / 100)
const x = t.map((s) => Math.exp(-g * s) * Math.cos(w * s))
const v = t.map((s) => Math.exp(-g * s) * (-g * Math.cos(w * s) - w * Math.sin(w * s)))
const energy = x.map((each, i) => (k * each * each + m * v[i]! * v[i]!) / 2)
const states = { t, x, v, energy }

describe('turning points', () => {
  it('are where the velocity changes sign, one half period apart', () => {
    const half = Math.PI / w
    const first = turningAfter(states, 0.1)!
    const second = turningAfter(states, first)!
    expect(second - first).toBeCloseTo(half, 3)
    expect(turningAfter(states, second)! - second).toBeCloseTo(half, 3)
    expect(turningAfter(states, 19.9)).toBeNull()
  })
  it('give the decrement from peak to peak', () => {
    const first = turningAfter(states, 0.1)!
    const other = turningAfter(states, turningAfter(states, first)!)!
    const at = (time: number) => x[Math.round(100 * time)]!
    expect(-Math.log(at(other) / at(first))).toBeCloseTo((g * 2 * Math.PI) / w, 2)
  })
})

describe('where the energy is', () => {
  it('adds up to what there was at the start', () => {
    const work = workOf(states, () => 0)
    for (const time of [0, 1.234, 10, 20]) {
      const now = energyAt(states, work, m, time)
      expect(now.kinetic + now.spring + now.lost).toBeCloseTo(energy[0]!, 10)
      expect(now.lost).toBeGreaterThanOrEqual(-1e-12)
    }
    expect(energyAt(states, work, m, 20).lost).toBeCloseTo(energy[0]! - energy.at(-1)!, 12)
  })
  it('counts what a drive has done', () => {
    // a constant force does F times the way
    const work = workOf(states, () => 3)
    expect(work.at(-1)).toBeCloseTo(3 * (x.at(-1)! - x[0]!), 12)
  })
})

describe('the sound of a motion', () => {
  it('is a tone of 220 Hz, without a click at its ends, and not too loud', () => {
    const samples = soundOf(states, (2 * Math.PI) / w)
    expect(samples.length / 22050).toBeCloseTo(20 / ((220 * 2 * Math.PI) / w), 3)
    expect(Math.max(...samples.map(Math.abs))).toBeLessThan(0.51)
    expect(Math.abs(samples[0]!) + Math.abs(samples.at(-1)!)).toBe(0)
    let crossings = 0
    for (let i = 1; i < samples.length; ++i) crossings += Number(samples[i - 1]! < 0 && samples[i]! >= 0)
    expect(Math.abs(crossings - (220 * samples.length) / 22050)).toBeLessThanOrEqual(1)
  })
})
