// Copying text, also where a page from disk may not use the clipboard's own way.
import { toast } from '../state/notices.svelte'

/** Copies `text` and says `done`, or `failed` where the browser forbids it. */
export async function copyText(text: string, done: string, failed: string): Promise<void> {
  toast((await copied(text)) ? done : failed)
}

async function copied(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text)
    return true
  } catch {
    const area = document.createElement('textarea')
    area.value = text
    area.style.cssText = 'position: fixed; opacity: 0'
    document.body.append(area)
    const before = document.activeElement
    area.select()
    const done = document.execCommand('copy')
    area.remove()
    if (before instanceof HTMLElement) before.focus()
    return done
  }
}
