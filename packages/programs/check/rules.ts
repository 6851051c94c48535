import { optionFor } from '@botgarten/blocks'
import type { Block, CheckContext, Definition, FieldLook, Finding } from '@botgarten/blocks'
import { definitionOf, holesOf, outputOf, strangeInputs } from './places.ts'

type Said = Omit<Finding, 'block'>
type Rule = (block: Block, definition: Definition, sockets: CheckContext) => readonly Said[]

const stop = (name: string, facts?: Finding['facts']): Said => ({
  problem: `problem.${name}`,
  ...(facts && { facts }),
  stops: true,
})

const gaps: Rule = (block, definition) =>
  holesOf(block, definition)
    .filter(({ child, optional }) => !child && !optional)
    .map(({ input }) => stop('missingValue', { input }))

const sensors: Rule = (block, definition, sockets) => definition.check?.(block, sockets) ?? []

const parts: Rule = (block, definition) =>
  strangeInputs(block, definition).length > 0 ? [stop('unknownPart')] : []

const fields: Rule = (block, { look }) =>
  look.fields.flatMap((field) => fieldProblem(field, block.fields?.[field.name]))

function fieldProblem(look: FieldLook, value: string | undefined): readonly Said[] {
  if (value === undefined) return []
  switch (look.kind) {
    case 'number':
      return isNumber(value) ? [] : [stop('notANumber')]
    case 'choice':
      return isChoice(look, value) ? [] : [stop('unknownChoice')]
    case 'hidden':
      return look.name === 'MODE' && value !== look.preset ? [stop('unknownPart')] : []
    case 'name':
    case 'text':
      return []
  }
}

const isChoice = ({ options, numbers, own }: Extract<FieldLook, { kind: 'choice' }>, value: string) =>
  optionFor(options, value) !== undefined ||
  isWithin(numbers, value) ||
  // Which maps there are the block says itself.
  own === 'map'

const isWithin = (range: { readonly min: number; readonly max: number } | undefined, text: string) =>
  range !== undefined && isNumber(text) && Number(text) >= range.min && Number(text) <= range.max

const isNumber = (text: string) => text.trim() !== '' && Number.isFinite(Number(text))

const orderOfColours: Rule = (block, definition) => {
  if (block.type !== 'logic_compare') return []
  const kinds = holesOf(block, definition).map(({ child }) => child && kindOf(child))
  const [a, b] = kinds
  if (a && b && a !== 'any' && b !== 'any' && a !== b) return [stop('cannotCompare')]
  const ordered = !['EQ', 'NEQ'].includes(block.fields?.OP ?? 'EQ')
  if (ordered && kinds.includes('String')) return [stop('textsHaveNoOrder')]
  return ordered && kinds.includes('Colour') ? [stop('coloursHaveNoOrder')] : []
}

const kindOf = (block: Block) => {
  const definition = definitionOf(block)
  return definition ? outputOf(block, definition) : undefined
}

/** What is looked at of every block, in the order in which it is said. */
export const rules: readonly Rule[] = [gaps, fields, parts, sensors, orderOfColours]
