// Where an axis has its ticks: steps of 1, 2, 2.5 or 5 times a power of ten.
import { fixed, significant } from '../look/numbers'

export interface Ticks {
  values: number[]
  step: number
}

const near = 1e-9 // of a step: what rounding may put beside a tick

function ticksBy(step: number, from: number, to: number): number[] {
  const first = Math.ceil(from / step - near)
  const last = Math.floor(to / step + near)
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step)
}

/** The finest step with at most `most` ticks between the two; a coarser one where that has ticks at both ends. */
export function ticksOf(from: number, to: number, most: number): Ticks {
  const span = to - from
  if (!(span > 0) || !Number.isFinite(span)) return { values: [from], step: 1 }
  const power = 10 ** (Math.floor(Math.log10(span / most)) - 1)
  const atTick = (value: number, step: number) => Math.abs(value / step - Math.round(value / step)) < near * 1e3
  let finest: Ticks | undefined
  for (let size = power; ; size *= 10)
    for (const each of [1, 2, 2.5, 5]) {
      const step = each * size
      if (span / step > most + 1) continue
      const values = ticksBy(step, from, to)
      if (finest && values.length < 4) return finest
      if (values.length > most) continue
      if (atTick(from, step) && atTick(to, step)) return { values, step }
      finest ??= { values, step }
    }
}

/** `value` with as many places as the step has, and no more than four digits where that is enough. */
export function tickText(value: number, step: number): string {
  if (Math.abs(value) < step * near) return '0'
  const size = Math.max(Math.abs(value), step)
  if (size >= 1e5 || step < 1e-4) return significant(value, 2)
  const places = Math.max(0, -Math.floor(Math.log10(step) + near))
  const ofStep = Math.round(step * 10 ** places * 10) % 10 === 0 ? places : places + 1
  return fixed(value, ofStep)
}

/** Limits that hold both ends and begin and end at a tick. */
export function roundLimits(from: number, to: number, most = 6): [number, number] {
  if (!(to > from)) return from === 0 ? [-1, 1] : [from - Math.abs(from) / 2, from + Math.abs(from) / 2]
  const power = 10 ** (Math.floor(Math.log10((to - from) / most)) - 1)
  for (let size = power; ; size *= 10)
    for (const each of [1, 2, 2.5, 5]) {
      const step = each * size
      const first = Math.floor(from / step + near)
      const last = Math.ceil(to / step - near)
      if (last - first + 1 <= most) return [first * step, last * step]
    }
}
