import { expect, it } from 'vitest'
import { spokenPlot } from '../../src/plot/spoken'
import { shell } from '../../src/words/en/shell'

const [position, velocity, time] = [['position', 'm'], ['velocity', 'm/s'], ['time', 's']].map(([plain, unit]) => ({ name: plain!, plain: plain!, unit: unit! })) as [Axis, Axis, Axis]
type Axis = Parameters<typeof spokenPlot>[1]

it('says the last state of a curve that goes back', () => {
  const t = Float64Array.from({ length: 201 }, (_, i) => i / 20)
  const curve = { meaning: 'exact', name: 'exact', x: t.map((at) => Math.exp(-0.1 * at) * Math.cos(3 * at)), y: t.map((at) => -Math.exp(-0.1 * at) * 3 * Math.sin(3 * at)), smooth: true }
  // at 10 s: -3 e^-1 sin 30
  expect(spokenPlot(shell.plot, position, velocity, [-1, 1], [curve], true)).toBe('Velocity against position, \u22121.0 to 1.00\u00a0m. exact ends at 1.09\u00a0m/s.')
})

it('says where a curve leaves what is seen of the time', () => {
  const curve = { meaning: 'exact', name: 'exact', x: Float64Array.of(0, 1, 2, 3), y: Float64Array.of(0, 2, 4, 6) }
  expect(spokenPlot(shell.plot, time, position, [0, 2], [curve], false)).toContain('exact ends at 4.00\u00a0m.')
})
