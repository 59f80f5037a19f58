// Language and theme: of the browser, until chosen; kept where the browser allows it.
import { useComma } from '../look/numbers'

export type Language = 'en' | 'de'
export type Theme = 'light' | 'dark'

function kept(key: string): string | null {
  try {
    return localStorage.getItem(key)
  } catch {
    return null
  }
}
function keep(key: string, value: string): void {
  try {
    localStorage.setItem(key, value)
  } catch {
    // a page from disk may be forbidden to keep anything: it then lasts as long as the page
  }
}

const languageAtFirst = (): Language =>
  (kept('cromer-language') ?? navigator.language).startsWith('de') ? 'de' : 'en'
/** Where the system sets the colours, curves must suit its ground. */
const forced = matchMedia('(forced-colors: active)')
const chosenTheme = (): string | null => (forced.matches ? null : kept('cromer-theme'))
const darkAtFirst = (): boolean =>
  (chosenTheme() ?? (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light')) === 'dark'

/** Read anywhere. `plain`: motion is to be reduced. */
export const looks = $state({
  language: languageAtFirst(),
  theme: (darkAtFirst() ? 'dark' : 'light') as Theme,
  plain: matchMedia('(prefers-reduced-motion: reduce)').matches,
  /// [px] of the page, which is the window's over `zoom`.
  width: innerWidth,
  zoom: 1,
})

function show(): void {
  document.documentElement.dataset.theme = looks.theme
  document.documentElement.lang = looks.language
  useComma(looks.language === 'de')
}

export function setTheme(theme: Theme): void {
  looks.theme = theme
  keep('cromer-theme', theme)
  show()
}
export function setLanguage(language: Language): void {
  looks.language = language
  keep('cromer-language', language)
  show()
}
/// Everything larger, for a wall; kept where it was chosen on the page itself.
export function setProjector(on: boolean, chosen = true): void {
  if (chosen) keep('cromer-projector', String(on))
  projecting = on
  measureWidth()
}
export const wantsProjector = (): boolean => kept('cromer-projector') === 'true'
let projecting = false
function measureWidth(): void {
  const on = projecting && innerWidth >= 1000
  looks.zoom = !on ? 1 : innerWidth >= 1700 ? 1.6 : 1.4
  looks.width = innerWidth / looks.zoom
  const { style, dataset } = document.documentElement
  style.setProperty('--zoom', String(looks.zoom))
  if (on) dataset.projector = 'on'
  else delete dataset.projector
}

export const isPhone = (): boolean => looks.width < 700

export function watchLooks(): void {
  show()
  addEventListener('resize', measureWidth)
  matchMedia('(prefers-reduced-motion: reduce)').addEventListener('change', (event) => (looks.plain = event.matches))
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', (event) => {
    if (chosenTheme() === null) looks.theme = event.matches ? 'dark' : 'light'
    show()
  })
}
