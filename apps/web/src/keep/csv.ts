// A plot's data as CSV: one pair of columns for each curve, or one x for all where they share it.
import type { Axis, Curve } from '../plot/curve'

const quoted = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text)
const headOf = (axis: Axis): string => (axis.unit ? `${axis.plain} (${axis.unit})` : axis.plain)

function shared(curves: Curve[]): boolean {
  const [first, ...others] = curves
  return others.every(
    ({ x }) => x.length === first!.x.length && x.every((value, i) => value === first!.x[i]),
  )
}

/** Full precision, decimal points, as every reader takes them. */
export function csvOf(x: Axis, y: Axis, curves: Curve[]): string {
  if (curves.length === 0) return `${quoted(headOf(x))},${quoted(headOf(y))}\n`
  const one = shared(curves)
  const columns: { head: string; values: Float64Array }[] = []
  curves.forEach((curve, i) => {
    if (!one) columns.push({ head: `${curve.name}: ${headOf(x)}`, values: curve.x })
    else if (i === 0) columns.push({ head: headOf(x), values: curve.x })
    columns.push({ head: `${curve.name}: ${headOf(y)}`, values: curve.y })
  })
  const rows = Math.max(...columns.map((column) => column.values.length))
  const lines = [columns.map((column) => quoted(column.head)).join(',')]
  for (let i = 0; i < rows; ++i)
    lines.push(columns.map(({ values }) => (Number.isFinite(values[i]) ? String(values[i]) : '')).join(','))
  return lines.join('\n') + '\n'
}
