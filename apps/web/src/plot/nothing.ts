// An empty plot says what to do.
import { token } from '../look/curves'
import type { Frame } from './curve'
import type { Pen } from './pen'

export function drawNothing(pen: Pen, frame: Frame, text: string, size: number): void {
  const middle = { x: (frame.left + frame.right) / 2, y: frame.top + 0.4 * (frame.bottom - frame.top) }
  pen.text(middle.x, middle.y, text, { colour: token('text2'), size: size + 1.5, align: 'center' })
}
