import type { ExampleFinding } from '@botgarten/learning/neural-network/examples'
import { language } from '#words/language.svelte.ts'
import { m } from '#words/message.ts'
import type { Training } from '../training.svelte.ts'
import { number, shortName } from './messages.ts'

/** Not more others are named than can be looked at. */
const mostNamed = 3

const listOf = (rows: readonly number[]) =>
  new Intl.ListFormat(language.locale, { type: 'conjunction' }).format(
    rows.slice(0, mostNamed).map((row) => `${row + 1}`),
  )

/** The rows that a question names, in the order of the table. */
export function rowsIn(finding: ExampleFinding): readonly number[] {
  if (!('row' in finding)) return []
  const others = 'others' in finding ? finding.others.slice(0, 2) : []
  return [finding.row, ...others].sort((a, b) => a - b)
}

/** What Piep asks about the examples, in a child's words. */
export function questionOf(finding: ExampleFinding, { inputs, outputs }: Training): string {
  switch (finding.kind) {
    case 'contradiction':
      return m['training.ask.contradiction']({ row: finding.row + 1, others: listOf(finding.others) })
    case 'blind':
      return m['training.ask.blind']({ row: finding.row + 1, others: listOf(finding.others) })
    case 'oddOne':
      return m['training.ask.oddOne']({ row: finding.row + 1 })
    case 'oneSided':
      return m['training.ask.oneSided']({ left: finding.left, right: finding.right })
    case 'neverSeen':
      return m['training.ask.neverSeen']({
        list: inputs
          .map((one, k) => `${shortName(one, inputs)} ${number(finding.readings[k] ?? 0, 0)}`)
          .join(', '),
      })
    case 'allAlike': {
      const layer = finding.isInput ? inputs : outputs
      const neuron = layer.find(({ id }) => id === finding.column)
      const facts = { name: neuron ? shortName(neuron, layer) : '', value: number(finding.value, 0) }
      return finding.isInput ? m['training.ask.alikeInput'](facts) : m['training.ask.alikeOutput'](facts)
    }
    case 'sleeping':
      return m['training.ask.sleeping']()
    case 'few':
      return finding.isMirrored
        ? m['training.ask.fewMirrored']({ rows: finding.rows, knobs: finding.knobs })
        : m['training.ask.few']({ rows: finding.rows, knobs: finding.knobs })
  }
}
