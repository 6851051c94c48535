import type { FieldLook, Template } from '@botgarten/blocks'
import { faceOf, isBotBlock, type BotBlock } from './bot-block.ts'

type Choice = Extract<FieldLook, { kind: 'choice' }>

/** What a new line of a list comes with: one more of what stands in its last line, at the next free port. */
export function freshNeuron(list: BotBlock): Template | null {
  const preset = faceOf(list)?.items?.fresh
  if (!preset) return null
  const neurons = (list.extra.lines ?? []).map((line) => list.getInputTargetBlock(line)).filter(isBotBlock)
  const last = neurons.at(-1)
  if (!last) return preset
  const fields = Object.fromEntries(
    last.definition.look.fields.map(({ name }) => [name, String(last.getFieldValue(name))]),
  )
  const told = tellingField(last)
  if (told) {
    const same = neurons.filter(({ type }) => type === last.type)
    fields[told.name] = nextFree(
      told,
      same.map((neuron) => String(neuron.getFieldValue(told.name))),
    )
  }
  return { type: last.type, fields }
}

/** The choice in which neurons of one kind differ: their colour, else their port, else the first there is. */
function tellingField({ definition: { look, neuron } }: BotBlock): Choice | undefined {
  const choices = look.fields.filter((field) => field.kind === 'choice')
  const colour = typeof neuron?.colour === 'object' ? neuron.colour.field : undefined
  const name = colour ?? neuron?.port
  return choices.find((choice) => choice.name === name) ?? choices[0]
}

/** The first value after the last one that nobody uses; the one after it where all are used. */
function nextFree({ options }: Choice, used: readonly string[]): string {
  const values = options.map(({ value }) => value)
  const from = values.indexOf(used.at(-1) ?? '') + 1
  const after = [...values.slice(from), ...values.slice(0, from)]
  return after.find((value) => !used.includes(value)) ?? after[0] ?? ''
}
