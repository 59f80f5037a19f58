// Equations, where Markdown has left their TeX.
for (const place of document.querySelectorAll('.arithmatex')) {
  const tex = place.textContent.trim()
  katex.render(tex.slice(2, -2), place, { displayMode: tex.startsWith('\\['), throwOnError: false })
}
