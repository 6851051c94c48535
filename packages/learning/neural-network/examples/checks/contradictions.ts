import { farApart, type ExampleFinding, type Table } from './types.ts'

/** In percent: readings nearer than this, wishes farther than that. */
const near = 8
const far = 40

/** Examples that do not fit others, the one that fits fewest first; each is named once. */
export function contradictions({ pairs }: Table): readonly ExampleFinding[] {
  const against = pairs.map(() => [] as number[])
  for (let a = 0; a < pairs.length; a++)
    for (let b = a + 1; b < pairs.length; b++)
      if (
        farApart(pairs[a]!.inputs, pairs[b]!.inputs) < near &&
        farApart(pairs[a]!.outputs, pairs[b]!.outputs) > far
      ) {
        against[a]!.push(b)
        against[b]!.push(a)
      }
  const left = against.map((others) => others.length)
  const named = new Set<number>()
  const findings: ExampleFinding[] = []
  for (;;) {
    const worst = left.reduce((best, count, at) => (count > left[best]! ? at : best), 0)
    if (!(left[worst]! > 0)) return findings
    const others = against[worst]!.filter((at) => !named.has(at))
    named.add(worst)
    left[worst] = 0
    for (const at of others) left[at] = left[at]! - 1
    const isBlind = seesNothing(pairs[worst]!.inputs)
    const { row } = pairs[worst]!
    findings.push({
      kind: isBlind ? 'blind' : 'contradiction',
      row,
      others: others.map((at) => pairs[at]!.row),
    })
  }
}

/** Nothing within reach, or everything dark. */
const seesNothing = (inputs: readonly number[]) =>
  inputs.every((value) => value === 100) || inputs.every((value) => value === 0)
