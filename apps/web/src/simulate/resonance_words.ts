// The words on the resonance curve: the drive's line, each peak with its height, who never settles.
import { lookOf, token } from '../look/curves'
import { significant, withUnit } from '../look/numbers'
import type { Curve, Frame } from '../plot/curve'
import { valueAtX } from '../plot/decimate'
import { spread } from '../plot/labels'
import type { Pen } from '../plot/pen'

interface Words {
  unit: string
  unsettled: { meaning: string; name: string; why: string[] }[]
  at: number // drive now [rad/s]
  text: string
  drawn: boolean
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
    let y = frame.top + 48
    for (const each of words.unsettled) {
      pen.text(frame.left + 8, y, each.name, { colour: lookOf(each.meaning).word, size: 12.5, bold: true })
      for (const line of each.why) pen.text(frame.left + 8, (y += 15), line, { colour: token('text2'), size: 11.5 })
      y += 20
    }
    drawPeaks(pen, frame, words, curves, y)
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

/** Right of each curve, at its peak's height; where that is too narrow in the left corner, from `corner` down. */
function drawPeaks(pen: Pen, frame: Frame, { unit }: Words, curves: Curve[], corner: number): void {
  const size = 12.5
  const labels = curves.map((curve) => {
    const peak = peakOf(curve)
    const text = `${curve.name} ${withUnit(significant(peak.y, 4), unit)}`
    return { curve, peak, text, y: Math.max(frame.top + 40, frame.toY(peak.y) + 14), height: 16 }
  })
  for (const { curve, peak, text, y } of spread(labels, frame.top + 38, frame.bottom - 10)) {
    // beside the curves where they have come down to the word's height
    let after = frame.toX(peak.x)
    for (const each of curves)
      for (let i = 0; i < each.x.length; ++i) if (frame.toY(each.y[i]!) < y + 10) after = Math.max(after, frame.toX(each.x[i]!))
    const wide = pen.width(text, { size, bold: true })
    const right = after + 5 + wide <= frame.right
    const [at, height] = right ? [Math.min(after + 12, frame.right - wide), y] : [frame.left + 8, corner]
    if (!right) corner += 16
    pen.box(at - 3, height - 8, wide + 6, 16, token('surface'), undefined, 3)
    pen.text(at, height, text, { colour: lookOf(curve.meaning, curve.road).word, size, bold: true })
  }
}
