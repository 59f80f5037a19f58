// One toast at a time, and the one polite sentence for screen readers after 500 ms of rest.
export const notices = $state({ toast: null as { text: string; undo?: () => void } | null, spoken: '' })

export function toast(text: string, undo?: () => void): void {
  notices.toast = { text, undo }
}

let rest = 0
/** Says `text` once input has rested for 500 ms; a newer sentence takes its place. */
export function say(text: string): void {
  clearTimeout(rest)
  rest = window.setTimeout(() => (notices.spoken = text), 500)
}
