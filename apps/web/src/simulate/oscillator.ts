// The mass on its spring, left of the position plot, on the plot's own vertical axis.
import { lookOf, token } from '../look/curves'
import type { Decoration, Frame } from '../plot/curve'
import type { Pen } from '../plot/pen'

export interface Shown {
  x: number // of the mass [m], what it follows
  marks: { meaning: string; road: boolean; x: number }[] // where each method puts it
  force: number // now [N]
  forceMost: number
  forceName: string // beside the arrow
  forceText: string
  cursor: number // [s]
  shares: boolean // the plot's axis is the position
  scale: number // [m] that fill half the height where it does not
}

const spring = { turns: 11, width: 8 }

/** Where the mass is on the plot [px], and which position a height there stands for. */
export interface Place {
  middle: number
  y: number
  width: number
  height: number
  ceiling: number
  toY(x: number): number
  valueAt(y: number): number
}

/** `room`: width left of the axis that is the oscillator's own. */
export function placeOf(frame: Frame, shown: Pick<Shown, 'x' | 'shares' | 'scale'>, room: number): Place {
  const small = room < 140
  const [width, height] = small ? [52, 30] : [60, 34]
  const ceiling = frame.top - 6
  const high = frame.bottom - frame.top
  const centre = (frame.top + frame.bottom) / 2
  const toY = shown.shares ? frame.toY : (x: number) => centre - (x / shown.scale) * high * 0.3
  const valueAt = shown.shares
    ? (y: number) => frame.y[0] + ((frame.bottom - y) / high) * (frame.y[1] - frame.y[0])
    : (y: number) => ((centre - y) / (0.3 * high)) * shown.scale
  const wanted = Number.isFinite(shown.x) ? toY(shown.x) : toY(0)
  const y = Math.max(ceiling + 22 + height / 2, Math.min(frame.bottom - height / 2 + 6, wanted))
  return { middle: room / 2 - (small ? 6 : 8), y, width, height, ceiling, toY, valueAt }
}

export function oscillator(shown: Shown, room: number): Decoration {
  return (pen, frame) => {
    const small = room < 140
    const ink = token('ink')
    const { middle, y, toY, ceiling, ...box } = placeOf(frame, shown, room)
    const top = y - box.height / 2

    drawCeiling(pen, middle, ceiling, small ? 30 : 37, ink)
    drawSpring(pen, middle - 17, ceiling, top, ink)
    drawDamper(pen, middle + 17, ceiling, top, ink)
    if (shown.shares) drawLink(pen, frame, shown.cursor, middle + box.width / 2, y)
    pen.box(middle - box.width / 2, top, box.width, box.height, token('sunk'), ink, 4)
    pen.text(middle, y, '*m*', { colour: ink, size: 13, align: 'center' })
    const bars: number[] = []
    for (const mark of shown.marks) {
      const at = toY(mark.x)
      if (!(at >= frame.top - 8 && at <= frame.bottom + 8)) continue
      const { line: colour, width } = lookOf(mark.meaning, mark.road)
      const beside = middle + box.width / 2 + 8
      pen.line([beside, at, beside + 15, at], { colour, width: width > 3 ? 5 : 3, round: false })
      bars.push(at)
    }
    drawForce(pen, middle, y + box.height / 2 + 5, shown, room, bars)
  }
}

function drawCeiling(pen: Pen, x: number, y: number, half: number, ink: string): void {
  pen.line([x - half, y, x + half, y], { colour: ink, width: 1.6 })
  for (let at = x - half + 6; at <= x + half; at += 9) pen.line([at - 6, y, at, y - 6], { colour: ink, width: 1 })
}

function drawSpring(pen: Pen, x: number, from: number, to: number, ink: string): void {
  const ends = Math.min(8, (to - from) / 4)
  const points = [x, from, x, from + ends]
  const step = (to - from - 2 * ends) / (2 * spring.turns)
  for (let i = 0; i < 2 * spring.turns; ++i) points.push(x + (i % 2 ? -spring.width : spring.width), from + ends + (i + 0.5) * step)
  points.push(x, to - ends, x, to)
  pen.line(points, { colour: ink, width: 1.2 })
}

/** A cup that moves with the mass, a plunger that hangs from the ceiling. */
function drawDamper(pen: Pen, x: number, from: number, to: number, ink: string): void {
  const stroke = { colour: ink, width: 1.3 }
  const length = to - from
  const high = Math.min(42, length * 0.45)
  const cup = to - Math.min(14, length * 0.15)
  const plunger = Math.max(from + 6, cup - high * 0.55)
  pen.line([x, from, x, plunger], stroke)
  pen.line([x - 7, plunger, x + 7, plunger], { colour: ink, width: 3, round: false })
  pen.line([x - 9, cup - high, x - 9, cup, x + 9, cup, x + 9, cup - high], stroke)
  pen.line([x, cup, x, to], stroke)
}

/** From the mass to the curve at the cursor. */
function drawLink(pen: Pen, frame: Frame, cursor: number, from: number, y: number): void {
  if (cursor < frame.x[0] || cursor > frame.x[1]) return
  const points: number[] = []
  for (let x = from + 2; x < frame.toX(cursor); x += 5) points.push(x, y, Math.min(x + 2, frame.toX(cursor)), y, NaN, NaN)
  pen.line(points, { colour: token('text3'), width: 1, round: false })
}

/** Up is positive, as in the plot; its length is the force now. Its words keep clear of the methods' `bars`. */
function drawForce(pen: Pen, x: number, base: number, shown: Shown, room: number, bars: number[]): void {
  if (!(shown.forceMost > 0)) return
  const colour = token('line-drive')
  const length = (46 * shown.force) / shown.forceMost
  const sign = Math.sign(length)
  // an upward push is drawn from below the mass up to it, so that the spring stays visible
  const size = Math.abs(length)
  if (size > 2) {
    const [tail, head] = sign < 0 ? [base, base + size] : [base + size, base]
    const tip = Math.min(9, size)
    pen.line([x, tail, x, head + sign * tip], { colour, width: 3, round: false })
    pen.fill([x - 6, head + sign * tip, x + 6, head + sign * tip, x, head], colour)
  }
  const lettering = { colour: token('word-drive'), size: 11.5, bold: true }
  const [name, force] = [shown.forceName, shown.forceText]
  const lines = pen.width(`${name} ${force}`, lettering) < room - x - 8 ? [`${name} ${force}`] : [name, force]
  const high = 14 * lines.length
  let top = base + 6
  for (let tries = 0; tries < 5; ++tries) {
    const hit = bars.filter((bar) => bar > top - 3 && bar < top + high + 3)
    if (hit.length > 0) top = Math.max(...hit) + 4
  }
  lines.forEach((line, i) => pen.text(x + 11, top + 7 + 14 * i, line, lettering))
}
