import { describe, expect, it } from 'vitest'
import { hashOf, nameOf, newCourse, numbersOf, seedOf } from '../../src/teach/seed'
import { recordingOptions, truthOf } from '../../src/teach/truth'

describe('a seed', () => {
  it('is the same everywhere', () => {
    // FNV-1a of "" is its offset basis; the finalizer of 0x811c9dc5 is worked out with 64-bit integers.
    const finalized = (start: bigint) => {
      const low = 0xffffffffn
      let h = start
      h = ((h ^ (h >> 16n)) * 0x85ebca6bn) & low
      h = ((h ^ (h >> 13n)) * 0xc2b2ae35n) & low
      return Number(h ^ (h >> 16n))
    }
    expect(hashOf('')).toBe(finalized(0x811c9dc5n))
    expect(hashOf('a')).toBe(finalized(0xe40c292cn)) // published FNV-1a of "a"
    expect(hashOf('foobar')).toBe(finalized(0xbf9cf968n)) // and of "foobar"
  })
  it('forgives blanks and case, and tells students apart', () => {
    expect(seedOf('7f3a', ' 19 ')).toBe(seedOf('7F3A', '19'))
    expect(seedOf('7F3A', 'Jörg')).toBe(seedOf('7F3A', 'Jo\u0308rg'))
    expect(seedOf('A1', '2')).not.toBe(seedOf('A', '12'))
    const seeds = new Set(Array.from({ length: 500 }, (_, i) => seedOf('7F3A', String(i + 1))))
    expect(seeds.size).toBe(500)
  })
  it('gives numbers that are spread evenly', () => {
    const next = numbersOf(1)
    const counts = new Array<number>(10).fill(0)
    for (let i = 0; i < 10000; ++i) counts[Math.floor(next() * 10)]!++
    for (const count of counts) expect(Math.abs(count - 1000)).toBeLessThan(120)
  })
  it('names the recording', () => {
    expect(nameOf('7f3a', ' 19')).toBe('7F3A-19')
    expect(newCourse(numbersOf(3))).toMatch(/^[2-9A-Z]{4}$/)
  })
})

describe('the truth', () => {
  it('lies in the ranges of the lab for every student', () => {
    for (let i = 0; i < 300; ++i) {
      const truth = truthOf(seedOf('7F3A', String(i)))
      expect(truth.massRead).toBeGreaterThanOrEqual(0.18)
      expect(truth.massRead).toBeLessThanOrEqual(0.28)
      expect(Math.abs(truth.mass - truth.massRead)).toBeLessThanOrEqual(truth.massUncertainty)
      expect(truth.stiffness).toBeGreaterThanOrEqual(12)
      expect(truth.stiffness).toBeLessThanOrEqual(20)
      const own = truth.damping / (2 * truth.mass)
      const swing = Math.sqrt(truth.stiffness / truth.mass) * truth.start
      const drag = (4 * truth.drag * swing) / (3 * Math.PI * truth.mass)
      expect(drag).toBeGreaterThan(2 * own) // else one rate would nearly do
    }
  })
  it('differs from student to student and stays what it was', () => {
    expect(truthOf(seedOf('7F3A', '1'))).toEqual(truthOf(seedOf('7F3A', '1')))
    expect(truthOf(seedOf('7F3A', '1')).stiffness).not.toBe(truthOf(seedOf('7F3A', '2')).stiffness)
  })
  it('makes a recording of 12001 samples', () => {
    const options = new Map(recordingOptions(truthOf(5)))
    expect(options.get('until')).toBe('120 s')
    expect(options.get('every')).toBe('10')
  })
})
