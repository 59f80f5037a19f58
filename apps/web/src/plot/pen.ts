// What plots are drawn with: a canvas on the screen, SVG in a saved figure. Both draw the same.
import { beside, thinned } from './thin'

export interface Stroke {
  colour: string
  width: number
  dash?: number[]
  round?: boolean
}
export interface Lettering {
  colour: string
  size: number
  bold?: boolean
  align?: 'left' | 'center' | 'right'
}

/** Opaque, or what is below shows through. A colour's text is never changed: builds write #ffffff as #fff. */
export type Paint = string | { colour: string; opacity: number }
export const paintOf = (paint: Paint): { colour: string; opacity: number } =>
  typeof paint === 'string' ? { colour: paint, opacity: 1 } : paint

/** Texts hold *variables* between stars: they become italic. y is the middle of the line. */
export interface Pen {
  line(points: ArrayLike<number>, stroke: Stroke): void
  fill(points: ArrayLike<number>, fill: Paint): void
  box(x: number, y: number, width: number, height: number, fill: Paint, edge?: string, radius?: number): void
  dot(x: number, y: number, radius: number, fill: string, edge?: string): void
  text(x: number, y: number, text: string, lettering: Lettering): void
  width(text: string, lettering: { size: number; bold?: boolean }): number
  within(x: number, y: number, width: number, height: number, draw: () => void): void
}

export const sans = '"Segoe UI", -apple-system, Roboto, "Noto Sans", Lato, system-ui, sans-serif'

export const pieces = (text: string): { text: string; italic: boolean }[] =>
  text.split('*').map((each, i) => ({ text: each, italic: i % 2 === 1 })).filter((each) => each.text !== '')

function fontOf(size: number, bold?: boolean, italic?: boolean): string {
  return `${italic ? 'italic ' : ''}${bold ? '700 ' : ''}${size}px ${sans}`
}

/** `text`, or as much of it as is not wider than `room`, and … */
export function cut(pen: Pen, text: string, room: number, lettering: { size: number; bold?: boolean }): string {
  let kept = text
  while (kept.length > 1 && pen.width(kept === text ? text : `${kept}…`, lettering) > room) kept = kept.slice(0, -1)
  return kept === text ? text : `${kept.trimEnd()}…`
}
const long = 100 // points of a line that is worth thinning
const unseen = 0.1 // of a pixel

/** Widths of texts measured before: most are asked again at every redraw. */
const widths = new Map<string, number>()
const mostWidths = 4000

export function canvasPen(context: CanvasRenderingContext2D): Pen {
  const c = context
  let font = ''
  /** Only where it changes: browsers read the whole of it anew. */
  function setFont(next: string): void {
    if (next !== font) c.font = font = next
  }
  function widthOf(text: string, next: string): number {
    const key = `${next} ${text}`
    const before = widths.get(key)
    if (before !== undefined) return before
    setFont(next)
    const { width } = c.measureText(text)
    if (widths.size > mostWidths) widths.clear()
    widths.set(key, width)
    return width
  }
  function trace(points: ArrayLike<number>): void {
    c.beginPath()
    let down = false
    for (let i = 0; i + 1 < points.length; i += 2) {
      const x = points[i]!
      const y = points[i + 1]!
      if (Number.isNaN(x) || Number.isNaN(y)) down = false
      else if (down) c.lineTo(x, y)
      else {
        c.moveTo(x, y)
        down = true
      }
    }
  }
  /** The shape traced last. */
  function paint(fill: Paint, edge?: string): void {
    const { colour, opacity } = paintOf(fill)
    const before = c.globalAlpha
    c.fillStyle = colour
    c.globalAlpha = before * opacity
    c.fill()
    c.globalAlpha = before
    if (!edge) return
    c.strokeStyle = edge
    c.lineWidth = 1.5
    c.setLineDash([])
    c.stroke()
  }
  const pen: Pen = {
    line(points, { colour, width, dash = [], round = true }) {
      const pixel = 1 / (c.getTransform().a || 1)
      const many = points.length >= 2 * long
      const line = many ? thinned(points, unseen * pixel) : points
      // Without a graphics card wide lines take browsers four times as long as lines of one pixel: two of those
      // side by side look the same.
      const twice = many && dash.length === 0 && width > pixel && width <= 2 * pixel && c.globalAlpha === 1
      const by = (width - 0.8 * pixel) / 2
      c.strokeStyle = colour
      c.lineWidth = twice ? pixel : width
      c.lineJoin = 'round'
      c.lineCap = round && dash.length === 0 ? 'round' : 'butt'
      c.setLineDash(dash)
      for (const each of twice ? [beside(line, by), beside(line, -by)] : [line]) {
        trace(each)
        c.stroke()
      }
    },
    fill(points, fill) {
      trace(points)
      paint(fill)
    },
    box(x, y, width, height, fill, edge, radius = 0) {
      c.beginPath()
      c.roundRect(x, y, width, height, radius)
      paint(fill, edge)
    },
    dot(x, y, radius, fill, edge) {
      c.beginPath()
      c.arc(x, y, radius, 0, 2 * Math.PI)
      paint(fill, edge)
    },
    text(x, y, text, { colour, size, bold, align = 'left' }) {
      c.fillStyle = colour
      c.textAlign = 'left'
      c.textBaseline = 'middle'
      let at = x - (align === 'left' ? 0 : pen.width(text, { size, bold }) / (align === 'right' ? 1 : 2))
      for (const piece of pieces(text)) {
        const next = fontOf(size, bold, piece.italic)
        setFont(next)
        c.fillText(piece.text, at, y)
        at += widthOf(piece.text, next)
      }
    },
    width(text, { size, bold }) {
      let sum = 0
      for (const piece of pieces(text)) sum += widthOf(piece.text, fontOf(size, bold, piece.italic))
      return sum
    },
    within(x, y, width, height, draw) {
      c.save()
      c.beginPath()
      // on whole pixels: a soft edge costs every line within a third of its time
      c.rect(Math.floor(x), Math.floor(y), Math.ceil(x + width) - Math.floor(x), Math.ceil(y + height) - Math.floor(y))
      c.clip()
      draw()
      c.restore()
      font = ''
    },
  }
  return pen
}
