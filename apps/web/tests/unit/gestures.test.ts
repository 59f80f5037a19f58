import { expect, it, vi } from 'vitest'

import type { Frame } from '../../src/plot/curve'
import { Gestures } from '../../src/plot/gestures'
import type { View } from '../../src/plot/view'

/// A plot of 100 x 100 px from 0 to 10 in both directions, and fingers on it.
function fingers() {
  let view: View = { x: [0, 10], y: [0, 10] }
  const frame = (): Frame => ({
    ...view, left: 0, right: 100, top: 0, bottom: 100,
    toX: (x: number) => ((x - view.x[0]) / (view.x[1] - view.x[0])) * 100,
    toY: (y: number) => 100 - ((y - view.y[0]) / (view.y[1] - view.y[0])) * 100,
  })
  const setCursor = vi.fn()
  const gestures = new Gestures({ frame, cursor: () => null, setCursor, setView: (next) => (view = next ?? view) })
  const on: Record<string, (event: object) => void> = {}
  const canvas = { addEventListener: (type: string, act: (event: object) => void) => (on[type] = act), setPointerCapture: () => {} }
  gestures.listen(canvas as unknown as HTMLElement)
  const finger = (type: string, pointerId: number, offsetX: number, offsetY = 50) => on[type]!({ type, pointerId, offsetX, offsetY, pointerType: 'touch' })
  return { finger, setCursor, width: () => view.x[1] - view.x[0], from: () => view.x[0] }
}

it('a tap sets the cursor', () => {
  const { finger, setCursor } = fingers()
  finger('pointerdown', 1, 30)
  finger('pointerup', 1, 30)
  expect(setCursor).toHaveBeenCalledExactlyOnceWith(3)
})

it('what two fingers have zoomed stays when one of them lifts, and moves with the other', () => {
  const { finger, setCursor, width, from } = fingers()
  finger('pointerdown', 1, 40)
  finger('pointerdown', 2, 60)
  finger('pointermove', 2, 80)
  expect(width()).toBeCloseTo(5, 9)
  const left = from()
  finger('pointerup', 2, 80)
  finger('pointermove', 1, 40)
  expect(width()).toBeCloseTo(5, 9)
  expect(from()).toBeCloseTo(left, 9)
  finger('pointermove', 1, 50)
  expect(width()).toBeCloseTo(5, 9)
  expect(from()).toBeCloseTo(left - 0.5, 9)
  finger('pointerup', 1, 50)
  expect(setCursor).not.toHaveBeenCalled()
})
