// The layer that moves: cursor line, a dot on every curve, decorations.
import { lookOf, token } from '../look/curves'
import type { Curve, Decoration, Frame } from './curve'
import { valueAtX } from './decimate'
import type { Pen } from './pen'

export function drawMoving(
  pen: Pen, frame: Frame, curves: Curve[], cursor: number | null, moving: Decoration | undefined, knob: boolean,
): void {
  const { left, right, top, bottom } = frame
  if (cursor !== null && curves.length > 0 && cursor >= frame.x[0] && cursor <= frame.x[1]) {
    const at = frame.toX(cursor)
    const ink = token('ink')
    pen.line([at, top, at, bottom], { colour: ink, width: 1 })
    if (knob) pen.fill([at, bottom - 1, at + 6, bottom + 5, at + 6, bottom + 15, at - 6, bottom + 15, at - 6, bottom + 5], ink)
    const surface = token('surface')
    pen.within(left - 6, top - 6, right - left + 12, bottom - top + 12, () => {
      if (!knob) return
      for (const curve of curves) {
        if (curve.dots) continue
        const y = valueAtX(curve.x, curve.y, cursor, curve.smooth)
        if (!(y >= frame.y[0] && y <= frame.y[1])) continue
        pen.dot(at, frame.toY(y), 4.5, lookOf(curve.meaning, curve.road).line, surface)
      }
    })
  }
  moving?.(pen, frame, curves)
}
