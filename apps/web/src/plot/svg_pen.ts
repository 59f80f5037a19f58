// A pen that writes SVG: what is seen, as a figure that can be printed at any size.
import { paintOf, pieces, sans, type Paint, type Pen } from './pen'

const short = (value: number): string => String(Math.round(value * 100) / 100)
function filled(fill: Paint): string {
  const { colour, opacity } = paintOf(fill)
  return ` fill="${colour}"${opacity < 1 ? ` fill-opacity="${short(opacity)}"` : ''}`
}
const safe = (text: string): string => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;')

let clips = 0 // of all figures: several stand in one printed page

/** `measure`: of a canvas, for the widths of texts. */
export function svgPen(measure: Pen['width']): Pen & { done(width: number, height: number, ground: string): string } {
  const parts: string[] = []
  function path(points: ArrayLike<number>): string {
    let text = ''
    let down = false
    for (let i = 0; i + 1 < points.length; i += 2) {
      const x = points[i]!
      const y = points[i + 1]!
      if (Number.isNaN(x) || Number.isNaN(y)) down = false
      else {
        text += `${down ? 'L' : 'M'}${short(x)} ${short(y)}`
        down = true
      }
    }
    return text
  }
  return {
    line(points, { colour, width, dash = [], round = true }) {
      const dashes = dash.length ? ` stroke-dasharray="${dash.join(' ')}"` : ''
      const cap = round && !dash.length ? ' stroke-linecap="round"' : ''
      parts.push(
        `<path d="${path(points)}" fill="none" stroke="${colour}" stroke-width="${width}" stroke-linejoin="round"${cap}${dashes}/>`,
      )
    },
    fill: (points, fill) => void parts.push(`<path d="${path(points)}Z"${filled(fill)}/>`),
    box(x, y, width, height, fill, edge, radius = 0) {
      const line = edge ? ` stroke="${edge}" stroke-width="1.5"` : ''
      parts.push(
        `<rect x="${short(x)}" y="${short(y)}" width="${short(width)}" height="${short(height)}" rx="${radius}"${filled(fill)}${line}/>`,
      )
    },
    dot(x, y, radius, fill, edge) {
      const line = edge ? ` stroke="${edge}" stroke-width="1.5"` : ''
      parts.push(`<circle cx="${short(x)}" cy="${short(y)}" r="${radius}" fill="${fill}"${line}/>`)
    },
    text(x, y, text, { colour, size, bold, align = 'left' }) {
      const anchor = { left: 'start', center: 'middle', right: 'end' }[align]
      const inner = pieces(text)
        .map((piece) => (piece.italic ? `<tspan font-style="italic">${safe(piece.text)}</tspan>` : safe(piece.text)))
        .join('')
      parts.push(
        `<text x="${short(x)}" y="${short(y + size * 0.35)}" font-size="${size}"${bold ? ' font-weight="700"' : ''} fill="${colour}" text-anchor="${anchor}" xml:space="preserve">${inner}</text>`,
      )
    },
    width: measure,
    within(x, y, width, height, draw) {
      const id = `frame${++clips}`
      parts.push(
        `<clipPath id="${id}"><rect x="${short(x)}" y="${short(y)}" width="${short(width)}" height="${short(height)}"/></clipPath><g clip-path="url(#${id})">`,
      )
      draw()
      parts.push('</g>')
    },
    done: (width, height, ground) =>
      `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" font-family="${safe(sans)}"><rect width="${width}" height="${height}" fill="${ground}"/>${parts.join('')}</svg>\n`,
  }
}
