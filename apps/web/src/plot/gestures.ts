// Pointers, wheel and keys on a plot.
import type { Frame } from './curve'
import { pan, zoom, type View } from './view'

interface Target {
  frame(): Frame | null
  cursor(): number | null
  setView(view: View | null): void
  setCursor(x: number): void
}

const grip = 9 // [px] beside the cursor line where it is caught
const click = 4 // [px] a pointer may move and still have clicked

export class Gestures {
  private pointers = new Map<number, { x: number; y: number }>()
  private start: { x: number; y: number; frame: Frame; cursor: boolean; far: boolean } | null = null
  constructor(private target: Target) {}

  listen(canvas: HTMLElement): () => void {
    const end = new AbortController()
    const on = <K extends keyof HTMLElementEventMap>(type: K, act: (event: HTMLElementEventMap[K]) => void, passive = true) =>
      canvas.addEventListener(type, act, { signal: end.signal, passive })
    on('pointerdown', (event) => this.down(canvas, event))
    on('pointermove', (event) => this.move(event))
    on('pointerup', (event) => this.up(event))
    on('pointercancel', (event) => this.up(event))
    on('dblclick', () => this.target.setView(null))
    on('wheel', (event) => this.wheel(event), false)
    return () => end.abort()
  }

  private xOf(frame: Frame, px: number): number {
    return frame.x[0] + ((px - frame.left) / (frame.right - frame.left)) * (frame.x[1] - frame.x[0])
  }
  private down(canvas: HTMLElement, event: PointerEvent): void {
    const frame = this.target.frame()
    if (!frame) return
    const at = { x: event.offsetX, y: event.offsetY }
    this.pointers.set(event.pointerId, at)
    canvas.setPointerCapture(event.pointerId)
    const cursor = this.target.cursor()
    const caught = cursor !== null && Math.abs(frame.toX(cursor) - at.x) < (event.pointerType === 'touch' ? 22 : grip)
    // two fingers zoom: what they do is no click
    this.start = this.pointers.size > 1 ? { ...at, frame, cursor: false, far: true } : { ...at, frame, cursor: caught, far: false }
  }
  private move(event: PointerEvent): void {
    const before = this.pointers.get(event.pointerId)
    if (!before || !this.start) return
    const at = { x: event.offsetX, y: event.offsetY }
    const { frame } = this.start
    if (this.pointers.size === 2) {
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)![1]
      const [was, is] = [Math.hypot(before.x - other.x, before.y - other.y), Math.hypot(at.x - other.x, at.y - other.y)]
      const now = this.target.frame()
      if (now && is > 5) this.target.setView(zoom(now, (at.x + other.x) / 2, (at.y + other.y) / 2, was / is))
      this.pointers.set(event.pointerId, at)
      return
    }
    if (Math.hypot(at.x - this.start.x, at.y - this.start.y) > click) this.start.far = true
    if (this.start.cursor) this.target.setCursor(this.xOf(frame, at.x))
    else if (this.start.far) this.target.setView(pan(frame, at.x - this.start.x, at.y - this.start.y))
  }
  private up(event: PointerEvent): void {
    if (!this.pointers.delete(event.pointerId) || !this.start) return
    if (!this.start.far && event.type === 'pointerup') this.target.setCursor(this.xOf(this.start.frame, event.offsetX))
    const [left] = this.pointers.values()
    const frame = this.target.frame()
    // of two fingers the one that stays pans on from what both have made
    this.start = left && frame ? { ...left, frame, cursor: false, far: true } : null
  }
  private wheel(event: WheelEvent): void {
    const frame = this.target.frame()
    if (!frame) return
    event.preventDefault()
    const by = Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.005)
    this.target.setView(zoom(frame, event.offsetX, event.offsetY, by, event.shiftKey ? 'x' : undefined))
  }
  /** About the cursor, or the middle. */
  zoomIn(by = 0.5): void {
    const frame = this.target.frame()
    if (!frame) return
    const cursor = this.target.cursor()
    const x = cursor !== null ? frame.toX(cursor) : (frame.left + frame.right) / 2
    this.target.setView(zoom(frame, x, (frame.top + frame.bottom) / 2, by))
  }
  key(event: KeyboardEvent): void {
    const frame = this.target.frame()
    if (!frame || event.ctrlKey || event.metaKey || event.altKey) return
    const far = event.shiftKey ? 200 : 40
    const ways: Record<string, [number, number]> = {
      ArrowLeft: [far, 0], ArrowRight: [-far, 0], ArrowUp: [0, far], ArrowDown: [0, -far],
    }
    const way = ways[event.key]
    const cursor = this.target.cursor()
    const span = frame.x[1] - frame.x[0]
    if (way) this.target.setView(pan(frame, ...way))
    else if (event.key === '+' || event.key === '=') this.zoomIn(0.7)
    else if (event.key === '-' || event.key === '−') this.zoomIn(1 / 0.7)
    else if (event.key === '0') this.target.setView(null)
    else if (event.key === '[') this.target.setCursor((cursor ?? frame.x[1]) - span / 200)
    else if (event.key === ']') this.target.setCursor((cursor ?? frame.x[0]) + span / 200)
    else return
    event.preventDefault()
  }
}
