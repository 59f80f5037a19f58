// What part of a plot is seen: pan and zoom, all within reason.
import type { Frame, Limits } from './curve'

export interface View {
  x: Limits
  y: Limits
}

const zoomed = ([from, to]: Limits, about: number, by: number): Limits => [about - (about - from) * by, about + (to - about) * by]
const shifted = ([from, to]: Limits, by: number): Limits => [from + by, to + by]

/** By `by` (below 1: nearer) about a pixel. `only`: one axis. */
export function zoom(frame: Frame, px: number, py: number, by: number, only?: 'x' | 'y'): View {
  const x = frame.x[0] + ((px - frame.left) / (frame.right - frame.left)) * (frame.x[1] - frame.x[0])
  const y = frame.y[0] + ((frame.bottom - py) / (frame.bottom - frame.top)) * (frame.y[1] - frame.y[0])
  const held = (limits: Limits): boolean => limits[1] - limits[0] > 1e-9 * Math.max(1e-6, Math.abs(limits[0]), Math.abs(limits[1]))
  const next = {
    x: only === 'y' ? frame.x : zoomed(frame.x, x, by),
    y: only === 'x' ? frame.y : zoomed(frame.y, y, by),
  }
  return held(next.x) && held(next.y) ? next : { x: frame.x, y: frame.y }
}

/** By pixels: the paper follows the hand. */
export function pan(frame: Frame, dx: number, dy: number): View {
  return {
    x: shifted(frame.x, (-dx / (frame.right - frame.left)) * (frame.x[1] - frame.x[0])),
    y: shifted(frame.y, (dy / (frame.bottom - frame.top)) * (frame.y[1] - frame.y[0])),
  }
}
