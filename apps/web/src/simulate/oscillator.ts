// The mass on its spring, left of the position plot, on the plot's own vertical axis.
import { lookOf, token } from '../look/curves'
import type { Decoration, Frame } from '../plot/curve'
import type { Pen } from '../plot/pen'
import { forceLooks, type Force } from './forces'

export interface Body {
  x: number // of the mass [m], what it follows
  marks: { meaning: string; road: boolean; x: number }[] // where each method puts it
}

export interface Shown extends Body {
  second?: Body // right of the mass, joined to it
  forces: Force[]
  forceMost: number // [N] of the longest arrow
  cursor: number // [s]
  shares: boolean // the plot's axis is the position
  scale: number // [m] that fill half the height where it does not
  disc?: boolean // below the mass, in place of the damper
}

const spring = { width: 8, turns: (high: number) => (high < 160 ? 5 : 11) }

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

const apart = 13 // [px] from arrow to arrow
const sizeOf = (small: boolean): [width: number, height: number] => (small ? [52, 30] : [60, 34])

const betweenMasses = (small: boolean): number => (small ? 82 : 96) // [px] from middle to middle

/** Width left of the axis that the oscillator with so many arrows takes [px]. */
export const roomOf = (small: boolean, arrows: number, second = false): number =>
  (small ? 84 : 114) + (second ? betweenMasses(small) + (small ? 0 : 26) : Math.max(small ? 16 : 36, apart * arrows + 8))

/** `room`: width left of the axis that is the oscillator's own. `left`: of two masses the first. */
export function placeOf(frame: Frame, shown: Pick<Shown, 'x' | 'shares' | 'scale'>, room: number, small: boolean, left = false): Place {
  const [width, height] = sizeOf(small)
  const ceiling = frame.top - 6
  const high = frame.bottom - frame.top
  const centre = (frame.top + frame.bottom) / 2
  const toY = shown.shares ? frame.toY : (x: number) => centre - (x / shown.scale) * high * 0.3
  const valueAt = shown.shares
    ? (y: number) => frame.y[0] + ((frame.bottom - y) / high) * (frame.y[1] - frame.y[0])
    : (y: number) => ((centre - y) / (0.3 * high)) * shown.scale
  const wanted = Number.isFinite(shown.x) ? toY(shown.x) : toY(0)
  const y = Math.max(ceiling + 22 + height / 2, Math.min(frame.bottom - height / 2 + 6, wanted))
  return { middle: room - (small ? 56 : 83) - (left ? betweenMasses(small) : 0), y, width, height, ceiling, toY, valueAt }
}

export function oscillator(shown: Shown, room: number, small: boolean): Decoration {
  return (pen, frame) => {
    const first = drawBody(pen, frame, shown, shown, room, small, '*m*')
    if (shown.second) {
      const second = drawBody(pen, frame, shown, { ...shown.second, left: false }, room, small, '*m*₂')
      drawCoupling(pen, first.middle + first.width / 2, first.y, second.middle - second.width / 2, second.y, token('ink'))
    } else drawForces(pen, first.middle - first.width / 2, first.y, shown, small ? 30 : 38)
  }
}

/** One mass under its ceiling, joined to its curve. */
function drawBody(pen: Pen, frame: Frame, shown: Shown, body: Body & { left?: boolean }, room: number, small: boolean, name: string): Place {
  const left = body.left ?? shown.second !== undefined
  const place = placeOf(frame, { ...shown, x: body.x }, room, small, left)
  const ink = token('ink')
  const { middle, y, toY, ceiling, width, height } = place
  const top = y - height / 2

  drawCeiling(pen, middle, ceiling, small ? 30 : 37, ink)
  drawSpring(pen, shown.disc ? middle : middle - 17, ceiling, top, spring.turns(frame.bottom - frame.top), ink)
  if (shown.disc) drawDisc(pen, middle, y + height / 2, ink)
  else drawDamper(pen, middle + 17, ceiling, top, ink)
  if (shown.shares) drawLink(pen, frame, shown.cursor, room - (small ? 56 : 83) + width / 2, y)
  pen.box(middle - width / 2, top, width, height, token('sunk'), ink, 4)
  pen.text(middle, y, name, { colour: ink, size: 13, align: 'center' })
  for (const mark of body.marks) {
    const at = toY(mark.x)
    if (!(at >= frame.top - 8 && at <= frame.bottom + 8)) continue
    const { line: colour, width: thick } = lookOf(mark.meaning, mark.road)
    const beside = left ? middle - width / 2 - 23 : middle + width / 2 + 8
    pen.line([beside, at, beside + 15, at], { colour, width: thick > 3 ? 5 : 3, round: false })
  }
  return place
}

/** A spring between two heights. */
function drawCoupling(pen: Pen, fromX: number, fromY: number, toX: number, toY: number, ink: string): void {
  const turns = 4
  const at = (way: number) => [fromX + way * (toX - fromX), fromY + way * (toY - fromY)]
  const points = [fromX, fromY]
  for (let i = 0; i < 2 * turns; ++i) {
    const [x, y] = at(0.15 + (0.7 * (i + 0.5)) / (2 * turns))
    points.push(x!, y! + (i % 2 ? 5 : -5))
  }
  pen.line([...points, toX, toY], { colour: ink, width: 1.2 })
}

function drawCeiling(pen: Pen, x: number, y: number, half: number, ink: string): void {
  pen.line([x - half, y, x + half, y], { colour: ink, width: 1.6 })
  for (let at = x - half + 6; at <= x + half; at += 9) pen.line([at - 6, y, at, y - 6], { colour: ink, width: 1 })
}

function drawSpring(pen: Pen, x: number, from: number, to: number, turns: number, ink: string): void {
  const ends = Math.min(8, (to - from) / 4)
  const points = [x, from, x, from + ends]
  const step = (to - from - 2 * ends) / (2 * turns)
  for (let i = 0; i < 2 * turns; ++i) points.push(x + (i % 2 ? -spring.width : spring.width), from + ends + (i + 0.5) * step)
  points.push(x, to - ends, x, to)
  pen.line(points, { colour: ink, width: 1.2 })
}

/** Seen from its edge. */
function drawDisc(pen: Pen, x: number, from: number, ink: string): void {
  pen.line([x, from, x, from + 7], { colour: ink, width: 1.3 })
  pen.line([x - 34, from + 9, x + 34, from + 9], { colour: ink, width: 4, round: false })
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

/** Left of the mass, from a rod that is part of it. Up is positive, as in the plot; the largest force of the run is `longest`. */
function drawForces(pen: Pen, right: number, y: number, { forces, forceMost }: Shown, longest: number): void {
  if (forces.length === 0) return
  const left = right - apart * forces.length
  pen.line([left - 3, y, right, y], { colour: token('ink'), width: 2, round: false })
  forces.forEach(({ name, value }, i) => {
    const { symbol, dash, ...tokens } = forceLooks[name]!
    const [colour, word] = [token(tokens.colour), token(tokens.word)]
    const x = left + apart * (i + 0.5) - 3
    const size = forceMost > 0 && Number.isFinite(value) ? (longest * Math.abs(value)) / forceMost : 0
    const up = value < 0 ? 1 : -1
    const head = Math.min(8, size)
    if (size > 1) {
      pen.line([x, y, x, y + up * (size - head)], { colour, width: 3, dash, round: false })
      pen.fill([x - 4.5, y + up * (size - head), x + 4.5, y + up * (size - head), x, y + up * size], colour)
    }
    const at = y + up * (size + 9)
    pen.text(x - (symbol ? 6 : 3), at, '*F*', { colour: word, size: 11.5, bold: true })
    if (symbol) pen.text(x + 1, at + 3, `*${symbol}*`, { colour: word, size: 8.5, bold: true })
  })
}
