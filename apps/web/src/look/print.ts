// While it is printed the page is light, and what is folded up lies open.
import { looks } from '../state/looks.svelte'

const root = document.documentElement

export function watchPrint(): void {
  let opened: HTMLDetailsElement[] = []
  addEventListener('beforeprint', () => {
    root.dataset.theme = 'light'
    opened = [...document.querySelectorAll<HTMLDetailsElement>('details:not([open], .unprinted)')]
    for (const each of opened) each.open = true
  })
  addEventListener('afterprint', () => {
    root.dataset.theme = looks.theme
    for (const each of opened) each.open = false
  })
}
