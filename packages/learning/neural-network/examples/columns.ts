import { headOfRow, type Examples } from './types.ts'

/**
 * The table with a column for each of these neurons: those that are new get gaps in the rows before, those that are gone keep
 * their column. The same table where none is new.
 */
export function columnsFor(
  examples: Examples,
  inputs: readonly string[],
  outputs: readonly string[],
): Examples {
  const [newIn, newOut] = [missingIn(examples.inputs, inputs), missingIn(examples.outputs, outputs)]
  if (newIn.length + newOut.length === 0) return examples
  const end = headOfRow + examples.inputs.length
  const gaps = (ids: readonly string[]) => ids.map(() => null)
  return {
    ...examples,
    inputs: [...examples.inputs, ...newIn],
    outputs: [...examples.outputs, ...newOut],
    rows: examples.rows.map((row) => [
      ...[...row.slice(0, end), ...gaps(newIn)],
      ...[...row.slice(end), ...gaps(newOut)],
    ]),
  }
}

/** The table with 0 in every gap; the same one where there is none. */
export function withoutGaps(examples: Examples): Examples {
  const hasGap = (row: readonly unknown[]) => row.includes(null)
  if (!examples.rows.some(hasGap)) return examples
  const rows = examples.rows.map((row) => (hasGap(row) ? row.map((value) => value ?? 0) : row))
  return { ...examples, rows }
}

const missingIn = (columns: readonly string[], ids: readonly string[]) =>
  ids.filter((id) => !columns.includes(id))
