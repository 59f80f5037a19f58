// Measured data: ink dots; where they are dense a band from least to most per pixel column.
import type { Curve, Frame } from './curve'
import { firstFrom } from './decimate'
import type { Pen } from './pen'

const perColumn = 0.9 // more dots than this on each pixel column are a band

export function drawDots(pen: Pen, frame: Frame, { x, y }: Curve, colour: string): void {
  const begin = Math.max(0, firstFrom(x, frame.x[0]) - 1)
  const end = Math.min(x.length, firstFrom(x, frame.x[1]) + 1)
  if (end - begin <= perColumn * (frame.right - frame.left)) {
    for (let i = begin; i < end; ++i) if (Number.isFinite(y[i]!)) pen.dot(frame.toX(x[i]!), frame.toY(y[i]!), 1.3, colour)
    return
  }
  // Not as dark as single dots: what lies on it has to be seen.
  for (const band of bands(frame, x, y, begin, end)) pen.fill(band, { colour, opacity: 0.42 })
}

/** Heights of an outline [x, y, x, y, …] as far out as those beside them. */
function smoothed(outline: number[], out: (...heights: number[]) => number): number[] {
  return outline.map((value, i) => (i % 2 === 0 ? value : out(outline[i - 2] ?? value, value, outline[i + 2] ?? value)))
}

/** Whether the data turn so often that a period has three columns or less: then single columns miss its peaks. */
function isFast(top: number[]): boolean {
  let peaks = 0
  for (let i = 3; i + 2 < top.length; i += 2) if (top[i]! < top[i - 2]! && top[i]! <= top[i + 2]!) ++peaks
  return 3 * peaks > top.length / 2
}

/** Closed outlines, parted at gaps. */
export function bands(frame: Frame, x: Float64Array, y: Float64Array, begin: number, end: number): number[][] {
  const found: number[][] = []
  let top: number[] = []
  let under: number[] = []
  function close(): void {
    if (isFast(top)) [top, under] = [smoothed(top, Math.min), smoothed(under, Math.max)]
    if (top.length > 0) {
      const back: number[] = []
      for (let i = under.length - 2; i >= 0; i -= 2) back.push(under[i]!, under[i + 1]!)
      found.push([...top, ...back])
    }
    top = []
    under = []
  }
  let before: [least: number, most: number] | null = null
  for (let i = begin; i < end; ) {
    const column = Math.round(frame.toX(x[i]!))
    let least = Infinity
    let most = -Infinity
    for (; i < end && Math.round(frame.toX(x[i]!)) === column; ++i) {
      const value = y[i]!
      if (value < least) least = value
      if (value > most) most = value
    }
    if (least > most) {
      close()
      before = null
      continue
    }
    // joined to the column before it, so that steep lines have no holes
    const low = before ? Math.min(least, before[1]) : least
    const high = before ? Math.max(most, before[0]) : most
    before = [least, most]
    top.push(column, frame.toY(high) - 0.7)
    under.push(column, frame.toY(low) + 0.7)
  }
  close()
  return found
}
