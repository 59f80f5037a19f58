// The still layer of a plot: grid, axes, curves and their words.
import { lookOf, token } from '../look/curves'
import type { Axis, Curve, Frame, Limits } from './curve'
import { bent, everyPoint, firstFrom, lineOf, valueAtX } from './decimate'
import { drawDots } from './dots'
import { extentOf } from './extent'
import { spread } from './labels'
import type { Pen } from './pen'
import { tickText, ticksOf } from './ticks'

export interface Look {
  size: number // of ticks [px]
  labels: 'end' | 'inside' | 'none'
  phase: boolean // curves may go back in x
  faint: boolean // the last good picture behind an error
}

/** [px] between the dots of a method's steps, at least. */
const apart = 6

const named = (axis: Axis): string => (axis.unit ? `${axis.name} (${axis.unit})` : axis.name)
const looksOf = (curve: Curve) => lookOf(curve.meaning, curve.road ?? curve.meaning === 'exact')

export function drawAxes(pen: Pen, frame: Frame, x: Axis, y: Axis, look: Look): void {
  const { left, right, top, bottom } = frame
  const [ink2, grid, line] = [token('text2'), token('grid'), token('axis')]
  const xTicks = ticksOf(...frame.x, right - left < 180 ? 4 : 6)
  const yTicks = ticksOf(...frame.y, bottom - top < 160 ? 4 : 6)
  for (const value of xTicks.values) {
    const at = Math.round(frame.toX(value)) + 0.5
    pen.line([at, top, at, bottom], { colour: grid, width: 1 })
    pen.line([at, bottom, at, bottom + 4], { colour: line, width: 1 })
    pen.text(at, bottom + 13, tickText(value, xTicks.step), { colour: ink2, size: look.size, align: 'center' })
  }
  for (const value of yTicks.values) {
    const at = Math.round(frame.toY(value)) + 0.5
    const zero = Math.abs(value) < yTicks.step / 1e6
    pen.line([left, at, right, at], { colour: zero ? token('border') : grid, width: zero ? 0.8 : 1 })
    pen.line([left - 4, at, left, at], { colour: line, width: 1 })
    pen.text(left - 8, at, tickText(value, yTicks.step), { colour: ink2, size: look.size, align: 'right' })
  }
  pen.line([left + 0.5, top, left + 0.5, bottom + 0.5, right, bottom + 0.5], { colour: line, width: 1 })
  const size = look.size + 0.5
  const before = Math.max(2, left - Math.min(40, pen.width(named(y), { size }) / 2))
  pen.text(before, top - 14, named(y), { colour: ink2, size })
  pen.text(right, bottom + 29, named(x), { colour: ink2, size, align: 'right' })
}

/** Width that the ticks of `y` need left of the axis. */
export function ticksWidth(pen: Pen, frame: Frame, size: number): number {
  const { values, step } = ticksOf(...frame.y, frame.bottom - frame.top < 160 ? 4 : 6)
  return Math.max(...values.map((value) => pen.width(tickText(value, step), { size })), 12)
}

export function drawCurves(pen: Pen, frame: Frame, curves: Curve[], look: Look): void {
  const { left, right, top, bottom, toX, toY } = frame
  pen.within(left, top - 2, right - left + 2, bottom - top + 4, () => {
    const roads = curves.filter((curve) => looksOf(curve).width > 3)
    for (const curve of [...roads, ...curves.filter((each) => !roads.includes(each))]) {
      const { line, width, dash } = looksOf(curve)
      if (curve.dots) {
        drawDots(pen, frame, curve, line)
        continue
      }
      const { x, y } = curve.smooth && !look.phase ? bent(curve.x, curve.y, toX, ...frame.x) : curve
      const points = look.phase ? everyPoint(x, y, toX, toY) : lineOf(x, y, toX, toY, ...frame.x)
      const dashes = curve.dashed ? [6, 4] : dash
      pen.line(points, { colour: line, width: look.phase && width > 3 ? 3 : width, dash: dashes })
      if (curve.steps && apart * points.length <= 2 * (look.phase ? 2 * (right - left + bottom - top) : right - left))
        for (let i = 0; i < points.length; i += 2) pen.dot(points[i]!, points[i + 1]!, 2, line)
    }
  })
}

const noteOf = (curve: Curve, y: readonly [number, number]): string | undefined =>
  curve.note && (!curve.unbounded || leaves(curve, y)) ? curve.note : undefined
function leaves(curve: Curve, [least, most]: readonly [number, number]): boolean {
  const reaches = extentOf(curve.y)
  return !reaches.whole || reaches.least < least || reaches.most > most
}

/** The words that stand at the curves' ends, and the room they need at the right. */
export function endWords(pen: Pen, curves: Curve[], y: Limits, look: Look): number {
  if (look.labels !== 'end' || curves.length === 0) return 14
  const size = look.size + 1
  const widths = curves.map((curve) =>
    Math.max(pen.width(curve.name, { size, bold: true }), pen.width(noteOf(curve, y) ?? '', { size: look.size })),
  )
  return Math.max(...widths) + 12
}

/** Where the word of `curve` wants to stand: at its end; of one that grows at its last peak, or where it left. */
function wordHeight(frame: Frame, curve: Curve): number {
  const lastX = Math.min(curve.x.at(-1) ?? frame.x[1], frame.x[1])
  let y = valueAtX(curve.x, curve.y, lastX, curve.smooth)
  if (curve.unbounded)
    for (let i = firstFrom(curve.x, lastX - (lastX - frame.x[0]) / 8); i < curve.x.length && curve.x[i]! <= lastX; ++i)
      if (!(curve.y[i]! <= y)) y = curve.y[i]!
  return Math.max(frame.top + 8, Math.min(frame.bottom - 8, Number.isFinite(y) ? frame.toY(y) : frame.top))
}

export function drawWords(pen: Pen, frame: Frame, curves: Curve[], look: Look): void {
  if (look.labels === 'none') return
  const inside = look.labels === 'inside'
  const size = look.size + 1
  const words = curves
    .filter((curve) => !inside || curve.unbounded)
    .map((curve) => {
      const note = look.phase ? undefined : noteOf(curve, frame.y)
      return { curve, note, y: inside ? frame.top + 8 : wordHeight(frame, curve), height: note ? 30 : 15 }
    })
  for (const { curve, note, y } of spread(words, frame.top + 8, frame.bottom + 4)) {
    const text = look.phase && curve.note ? curve.note : curve.name
    const wide = Math.max(pen.width(text, { size, bold: true }), pen.width(note ?? '', { size: look.size }))
    const x = !inside ? frame.right + 8 : look.phase ? frame.right - wide : insideAt(frame, curve, wide)
    if (inside) pen.box(x - 3, y - 8, wide + 6, note ? 31 : 16, token('surface'), undefined, 3)
    pen.text(x, y, text, { colour: looksOf(curve).word, size, bold: true })
    if (note) pen.text(x, y + 15, note, { colour: token('text2'), size: look.size })
  }
}

/** Left of where the curve leaves the frame, else right of it: the word does not lie on it. */
function insideAt(frame: Frame, curve: Curve, wide: number): number {
  let leaves = frame.right
  for (let i = 0; i < curve.x.length; ++i)
    if (!(curve.y[i]! < frame.y[1] && curve.y[i]! > frame.y[0])) {
      leaves = frame.toX(curve.x[i]!)
      break
    }
  const before = Math.min(leaves, frame.right) - wide - 24
  return before > frame.left + 6 ? before : Math.min(leaves + 14, frame.right - wide)
}
