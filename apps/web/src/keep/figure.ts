// A plot as a figure: SVG by the pen that writes it, PNG of twice the size.
import { canvasPen } from '../plot/pen'
import type { ShownPlot } from '../plot/shown'
import { svgPen } from '../plot/svg_pen'
import { token } from '../look/curves'

const figure = [760, 440] as const // [px]
const phase = [480, 440] as const
const sizeOf = (plot: ShownPlot): readonly [number, number] => (plot.name.endsWith('phase') ? phase : figure)

function scratch(width: number, height: number): CanvasRenderingContext2D {
  const canvas = document.createElement('canvas')
  ;[canvas.width, canvas.height] = [width, height]
  return canvas.getContext('2d')!
}

/** A figure is printed: always in the light colours. */
function inLight<T>(draw: () => T): T {
  const root = document.documentElement
  const before = root.dataset.theme
  root.dataset.theme = 'light'
  try {
    return draw()
  } finally {
    root.dataset.theme = before
  }
}

export const asSvg = (plot: ShownPlot, [width, height] = sizeOf(plot)): string =>
  inLight(() => {
    const pen = svgPen(canvasPen(scratch(1, 1)).width)
    plot.draw(pen, width, height)
    return pen.done(width, height, token('surface'))
  })

export const asPng = (plot: ShownPlot): Promise<Blob> =>
  inLight(() => {
    const [width, height] = sizeOf(plot)
    const context = scratch(2 * width, 2 * height)
    context.fillStyle = token('surface')
    context.fillRect(0, 0, 2 * width, 2 * height)
    context.scale(2, 2)
    plot.draw(canvasPen(context), width, height)
    return new Promise<Blob>((resolve, reject) =>
      context.canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error('no PNG'))), 'image/png'),
    )
  })
