// Lengths on the screen over lengths in the page: of what lies in an enlarged page pointers tell the former.
export function zoomOf(element: HTMLElement): number {
  const { offsetWidth } = element
  return offsetWidth > 0 ? element.getBoundingClientRect().width / offsetWidth : 1
}
