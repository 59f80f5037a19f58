import { describe, expect, it } from 'vitest'
import { energyAt, scalesOf, workOf } from '../../src/simulate/energy_now'
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
    const work = workOf(states, null)
    for (const time of [0, 1.234, 10, 20]) {
      const now = energyAt(states, work, m, time, true)
      expect(now.kinetic + now.spring + now.lost).toBeCloseTo(energy[0]!, 10)
      expect(now.lost).toBeGreaterThanOrEqual(-1e-12)
    }
    expect(energyAt(states, work, m, 20, true).lost).toBeCloseTo(energy[0]! - energy.at(-1)!, 12)
  })
  it('is drawn to one scale where the spring could hold what is lost, else to two', () => {
    const free = scalesOf(states, workOf(states, null), m)
    expect(free.stored).toBeCloseTo(4, 2)
    expect(free.lost).toBe(free.stored)
    // what a drive puts in and damping takes out, again and again
    const fed = scalesOf(states, t.map((s) => 5 * s), m)
    expect(fed.stored).toBe(free.stored)
    expect(fed.lost).toBeCloseTo(energy[0]! + 100 - energy.at(-1)!, 10)
  })
  it('counts what a drive has done', () => {
    // a constant force does F times the way
    const work = workOf(states, () => 3)
    expect(work.at(-1)).toBeCloseTo(3 * (x.at(-1)! - x[0]!), 8)
  })
  it('loses nothing at resonance without damping', () => {
    // x = t sin(wt) / (2 w) under cos(wt), a mass of 1 kg, in steps as coarse as the page's
    const [omega, h] = [3, 0.025]
    const times = Float64Array.from({ length: 1001 }, (_, i) => i * h)
    const at = times.map((s) => (s * Math.sin(omega * s)) / (2 * omega))
    const speed = times.map((s) => (Math.sin(omega * s) + omega * s * Math.cos(omega * s)) / (2 * omega))
    const total = at.map((each, i) => (9 * each * each + speed[i]! ** 2) / 2)
    const driven = { t: times, x: at, v: speed, energy: total }
    const work = workOf(driven, (s) => Math.cos(omega * s))
    expect(Math.abs(energyAt(driven, work, 1, 25, true).lost) / total.at(-1)!).toBeLessThan(1e-6)
  })
})

describe('the sound of a motion', () => {
  const passages = (samples: Float32Array, from: number, to: number) => {
    let count = 0
    for (let i = Math.round(from * 22050) + 1; i < to * 22050; ++i) count += Number(samples[i - 1]! < 0 && samples[i]! >= 0)
    return count / (to - from)
  }
  it('has the position as its pitch, an octave up and down', () => {
    const still = { t: Float64Array.of(0, 2, 2.001, 4, 4.001, 6), x: Float64Array.of(0, 0, 1, 1, -1, -1) }
    const samples = soundOf(still, 1)
    expect(samples.length / 22050).toBeCloseTo(6, 3)
    expect(passages(samples, 0.5, 1.5)).toBeCloseTo(330, -1)
    expect(passages(samples, 2.5, 3.5)).toBeCloseTo(660, -1)
    expect(passages(samples, 4.5, 5.5)).toBeCloseTo(165, -1)
  })
  it('lasts as long as the motion is played, eight seconds at most, and has no click at its ends', () => {
    expect(soundOf(states, 10).length / 22050).toBeCloseTo(2, 3)
    const longest = soundOf(states, 0.1)
    expect(longest.length / 22050).toBeCloseTo(8, 3)
    expect(Math.max(...longest.subarray(0, 5000).map(Math.abs))).toBeLessThan(0.31)
    expect(Math.abs(longest[0]!) + Math.abs(longest.at(-1)!)).toBe(0)
  })
})
