// What plots are drawn with: a canvas on the screen, SVG in a saved figure. Both draw the same.

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

/** Texts hold *variables* between stars: they become italic. y is the middle of the line. */
export interface Pen {
  line(points: ArrayLike<number>, stroke: Stroke): void
  fill(points: ArrayLike<number>, colour: string): void
  box(x: number, y: number, width: number, height: number, fill: string, edge?: string, radius?: number): void
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

export function canvasPen(context: CanvasRenderingContext2D): Pen {
  const c = context
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
  function paint(fill: string, edge?: string): void {
    c.fillStyle = fill
    c.fill()
    if (!edge) return
    c.strokeStyle = edge
    c.lineWidth = 1.5
    c.setLineDash([])
    c.stroke()
  }
  const pen: Pen = {
    line(points, { colour, width, dash = [], round = true }) {
      trace(points)
      c.strokeStyle = colour
      c.lineWidth = width
      c.lineJoin = 'round'
      c.lineCap = round && dash.length === 0 ? 'round' : 'butt'
      c.setLineDash(dash)
      c.stroke()
    },
    fill(points, colour) {
      trace(points)
      c.fillStyle = colour
      c.fill()
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
        c.font = fontOf(size, bold, piece.italic)
        c.fillText(piece.text, at, y)
        at += c.measureText(piece.text).width
      }
    },
    width(text, { size, bold }) {
      let sum = 0
      for (const piece of pieces(text)) {
        c.font = fontOf(size, bold, piece.italic)
        sum += c.measureText(piece.text).width
      }
      return sum
    },
    within(x, y, width, height, draw) {
      c.save()
      c.beginPath()
      c.rect(x, y, width, height)
      c.clip()
      draw()
      c.restore()
    },
  }
  return pen
}
