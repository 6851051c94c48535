import { gridOf, visitNear } from './grid.ts'
import { farApart, type ExampleFinding, type Table } from './types.ts'

/** In percent: readings nearer than this, wishes farther than that. */
const near = 8
const far = 40

/** Examples that do not fit others, the one that fits fewest first; each is named once. */
export function contradictions({ pairs }: Table): readonly ExampleFinding[] {
  const against = againstIn(pairs)
  const left = pairs.map((_, at) => against(at).length)
  const named = new Set<number>()
  const findings: ExampleFinding[] = []
  for (;;) {
    const worst = left.reduce((best, count, at) => (count > left[best]! ? at : best), 0)
    if (!(left[worst]! > 0)) return findings
    const others = against(worst).filter((at) => !named.has(at))
    named.add(worst)
    left[worst] = 0
    for (const at of others) left[at] = left[at]! - 1
    const isBlind = seesNothing(pairs[worst]!.inputs)
    findings.push({
      kind: isBlind ? 'blind' : 'contradiction',
      row: pairs[worst]!.row,
      others: others.map((at) => pairs[at]!.row),
    })
  }
}

/** Which other examples one stands against, in their order. Only those in the cells around it are compared. */
function againstIn(pairs: Table['pairs']) {
  const grid = gridOf(
    pairs.map(({ inputs }) => inputs),
    near,
  )
  return (at: number): readonly number[] => {
    const { inputs, outputs } = pairs[at]!
    const found: number[] = []
    visitNear(grid, inputs, (other) => {
      const { inputs: read, outputs: wished } = pairs[other]!
      if (farApart(inputs, read) < near && farApart(outputs, wished) > far) found.push(other)
    })
    return found.sort((a, b) => a - b)
  }
}

/** Nothing within reach, or everything dark. */
const seesNothing = (inputs: readonly number[]) =>
  inputs.every((value) => value === 100) || inputs.every((value) => value === 0)
