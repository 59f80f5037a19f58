import { describe, expect, it } from 'vitest'

import { frameOf } from '../../src/plot/curve'
import { bands } from '../../src/plot/dots'

/** The band of a sine of `periods` over 360 columns: its outline's upper heights. */
function upper(periods: number): number[] {
  const count = 12_000
  const x = Float64Array.from({ length: count }, (_, i) => i / count)
  const y = x.map((at) => Math.sin(2 * Math.PI * periods * at))
  const [band] = bands(frameOf(0, 360, 0, 100, [0, 1], [-1, 1]), x, y, 0, count)
  return band!.slice(0, band!.length / 2).filter((_, i) => i % 2 === 1)
}

describe('the band of dense data', () => {
  it.each([130, 169, 300])('of %i periods is filled to their peaks', (periods) => {
    const inside = upper(periods).slice(2, -2)
    expect(Math.max(...inside)).toBeLessThan(8) // of 100 px
  })
  it('follows a slow swing', () => {
    const heights = upper(3)
    expect(Math.min(...heights)).toBeLessThan(1)
    expect(Math.max(...heights)).toBeGreaterThan(95)
  })
})
