// A plot in words, from what is seen. `phase`: its curves may go back in x.
import { significant, withUnit } from '../look/numbers'
import { capital } from '../words/said'
import type { Words } from '../words/words.svelte'
import type { Axis, Curve, Limits } from './curve'
import { valueAtX } from './decimate'
import { extentOf } from './extent'

export function spokenPlot(w: Words['shell']['plot'], x: Axis, y: Axis, limits: Limits, curves: Curve[], phase: boolean): string {
  const value = (v: number, axis: Axis) => withUnit(significant(v, 3), axis.unit)
  const said = curves.slice(0, 6).map((curve) => {
    if (curve.unbounded) return w.grows(curve.name, value(extentOf(curve.y).size, y))
    const last = phase ? (curve.y.at(-1) ?? NaN) : valueAtX(curve.x, curve.y, Math.min(limits[1], curve.x.at(-1) ?? 0), curve.smooth)
    return Number.isFinite(last) ? w.ends(curve.name, value(last, y)) : ''
  })
  return [w.against(capital(y.plain), x.plain, significant(limits[0], 2), value(limits[1], x)), ...said].filter(Boolean).join(' ')
}
