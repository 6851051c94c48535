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

const missingIn = (columns: readonly string[], ids: readonly string[]) =>
  ids.filter((id) => !columns.includes(id))
