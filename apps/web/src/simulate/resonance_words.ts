// The words on the resonance curve: the drive's line, each name at its peak with the amplitude at the drive, who never
// settles.
import { lookOf, token } from '../look/curves'
import type { Curve, Frame } from '../plot/curve'
import { valueAtX } from '../plot/decimate'
import { spread } from '../plot/labels'
import type { Pen } from '../plot/pen'

interface Words {
  /** The amplitude at the drive now, with as many digits; "" where there is none. */
  atDrive: (meaning: string, digits: number) => string
  unsettled: { meaning: string; name: string; why: string[] }[]
  at: number // drive now [rad/s]
  text: string
  drawn: boolean
  listed: boolean // the names stand in a list beside the plot
}

function peakOf(curve: Curve): { x: number; y: number } {
  let best = 0
  for (let i = 0; i < curve.y.length; ++i) if (curve.y[i]! > curve.y[best]!) best = i
  return { x: curve.x[best] ?? 0, y: curve.y[best] ?? 0 }
}

export function resonanceWords(words: Words): (pen: Pen, frame: Frame, curves: Curve[]) => void {
  return (pen, frame, curves) => {
    if (!words.drawn) return
    drawDrive(pen, frame, words, curves)
    if (!words.listed) drawNames(pen, frame, words, curves)
  }
}

function drawDrive(pen: Pen, frame: Frame, { at, text }: Words, curves: Curve[]): void {
  if (at < frame.x[0] || at > frame.x[1]) return
  const [colour, x] = [token('line-drive'), frame.toX(at)]
  pen.line([x, frame.top, x, frame.bottom], { colour, width: 1.5 })
  const wide = pen.width(text, { size: 12.5, bold: true })
  const left = x + 10 + wide > frame.right
  pen.text(left ? x - 10 : x + 10, frame.top + 16, text, { colour: token('word-drive'), size: 12.5, bold: true, align: left ? 'right' : 'left' })
  const first = curves.find((curve) => curve.meaning === 'exact') ?? curves[0]
  const y = first ? valueAtX(first.x, first.y, at) : NaN
  if (y <= frame.y[1]) pen.dot(x, frame.toY(y), 4.5, colour, token('surface'))
}

interface Name {
  y: number
  height: number // [px]
  draw(y: number): void
}

/** Each peak's name beside its curve; who never settles at the left, where names of peaks make room for it. */
function drawNames(pen: Pen, frame: Frame, { atDrive, unsettled }: Words, curves: Curve[]): void {
  const size = 12.5
  const [top, bottom] = [frame.top + 38, frame.bottom - 10]
  const peaks = curves.map((curve) => {
    const peak = peakOf(curve)
    const text = `${curve.name} ${atDrive(curve.meaning, frame.right - frame.left < 300 ? 3 : 4)}`.trim()
    return { curve, peak, text, wide: pen.width(text, { size, bold: true }), y: Math.max(frame.top + 40, frame.toY(peak.y) + 14), height: 16 }
  })
  type Peak = (typeof peaks)[number]
  /** Where all curves have come down to the word's height, left and right of its peak. */
  function endsAt({ peak }: Peak, y: number): [before: number, after: number] {
    let [before, after] = [frame.toX(peak.x), frame.toX(peak.x)]
    for (const curve of curves)
      for (let i = 0; i < curve.x.length; ++i) {
        if (frame.toY(curve.y[i]!) >= y + 10) continue
        before = Math.min(before, frame.toX(curve.x[i]!))
        after = Math.max(after, frame.toX(curve.x[i]!))
      }
    return [before, after]
  }
  function write({ curve, text, wide }: Peak, at: number, y: number): void {
    pen.box(at - 3, y - 8, wide + 6, 16, token('surface'), undefined, 3)
    pen.text(at, y, text, { colour: lookOf(curve.meaning, curve.road).word, size, bold: true })
  }
  /** Where its name begins right of the curves: 12 px from them, or 5 where there is no more. */
  const right = (each: Peak) => {
    const after = endsAt(each, each.y)[1]
    return Math.max(after + 5, Math.min(after + 12, frame.right - each.wide))
  }
  const placed = spread(peaks, top, bottom)
  const left: Name[] = unsettled.map(({ meaning, name, why }) => ({
    y: top,
    height: 20 + 15 * why.length,
    draw(y) {
      pen.text(frame.left + 8, y, name, { colour: lookOf(meaning).word, size, bold: true })
      why.forEach((line, i) => pen.text(frame.left + 8, y + 15 * (i + 1), line, { colour: token('text2'), size: 11.5 }))
    },
  }))
  for (const each of placed) {
    if (right(each) + each.wide <= frame.right) write(each, right(each), each.y)
    else
      left.push({
        y: each.y,
        height: each.height,
        draw: (y) => write(each, Math.max(frame.left + 3, Math.min(endsAt(each, y)[0] - 12 - each.wide, frame.right - each.wide - 2)), y),
      })
  }
  for (const { draw, y } of spread(left, top, bottom)) draw(y)
}
