// The plots on the page now: what can be saved as a figure or as data.
import type { Axis, Curve } from './curve'
import type { Pen } from './pen'

export interface ShownPlot {
  name: string
  element: HTMLElement
  draw(pen: Pen, width: number, height: number): void
  table(): { x: Axis; y: Axis; curves: Curve[] }
}

const shown = new Set<ShownPlot>()

/** Until the returned function is called. */
export function keepPlot(plot: ShownPlot): () => void {
  shown.add(plot)
  return () => shown.delete(plot)
}

/** Those that can be seen, in the page's order. */
export const shownPlots = (): ShownPlot[] =>
  [...shown]
    .filter((plot) => plot.element.offsetParent !== null)
    .sort((a, b) => (a.element.compareDocumentPosition(b.element) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1))
