import {
  addBlocks,
  definitions,
  toolbox,
  blockFrom,
  type Block,
  type FieldLook,
  type Look,
  type ValueType,
} from '@botgarten/blocks'
import { learning, learningToolbox } from '@botgarten/blocks/packs/learning'
import type { Program } from '@botgarten/programs'
import * as Blockly from 'blockly/core'
import fc from 'fast-check'
import { afterEach, beforeAll, describe, expect, it } from 'vitest'
import { fits } from './fits.ts'
import { awaited, toProgram, toWorkspace } from './program.ts'
import { defineBlocks } from '../view/shape.ts'
import { defineUnknownBlocks } from './unknown.ts'
import { wordsIn } from '#words/message.ts'

addBlocks(learning, learningToolbox)
const empty: Program = { stacks: [], config: { stacks: [] } }
const workspaces: Blockly.Workspace[] = []

beforeAll(() => {
  defineBlocks(Object.values(definitions), { words: wordsIn('en'), locale: 'en' })
  defineUnknownBlocks()
})

afterEach(() => {
  for (const workspace of workspaces.splice(0)) workspace.dispose()
})

function open(program: Program): Blockly.Workspace {
  const workspace = new Blockly.Workspace()
  workspaces.push(workspace)
  toWorkspace(program, workspace)
  return workspace
}

const backAndForth = (program: Program) => toProgram(open(program), program)
const programOf = (...rows: readonly (readonly Block[])[]): Program => ({
  ...empty,
  stacks: rows.map((blocks, at) => ({ x: 20, y: 100 * at, blocks })),
})

// ---- random programs ----

type Shape = Look['shape']
const types = (shape: Shape) => Object.values(definitions).filter(({ look }) => look.shape === shape)

function fieldText(look: FieldLook): fc.Arbitrary<string> {
  switch (look.kind) {
    case 'number':
      return fc.constantFrom('0', '7', '-3', '0.5', '0.10', '1e2', '100000', 'x', '')
    case 'choice':
      return fc.constantFrom(...look.options.map(({ value }) => value), 'only-in-a-file')
    default:
      return fc.string()
  }
}

const fieldsOf = (look: Look) =>
  fc.record(Object.fromEntries(look.fields.map((field) => [field.name, fieldText(field)])))

const extras = fc.record(
  {
    comment: fc.string({ minLength: 1 }),
    data: fc.string(),
    hide: fc.array(fc.string(), { maxLength: 2 }),
    disabled: fc.constant(true as const),
    collapsed: fc.constant(true as const),
    inline: fc.boolean(),
    flags: fc.dictionary(fc.constantFrom('intask', 'movable'), fc.constantFrom('true', 'false')),
  },
  { requiredKeys: [] },
)

const unknown = fc.record({
  type: fc.constantFrom('robActions_fly', 'math_trig'),
  fields: fc.dictionary(fc.constantFrom('A', 'B'), fc.string()),
  values: fc.record(
    { DEEP: fc.constant({ type: 'math_number', fields: { NUM: '1' } }) },
    { requiredKeys: [] },
  ),
})

type Draft = Omit<Block, 'id'>

function blockOf(type: string, depth: number): fc.Arbitrary<Draft> {
  const { look } = definitions[type as keyof typeof definitions]
  return fc
    .tuple(fieldsOf(look), extras, depth > 0 ? childrenOf(look, depth - 1) : childless(look))
    .map(([fields, extra, children]) => ({
      type,
      ...(Object.keys(fields).length > 0 && { fields }),
      ...extra,
      ...children,
      ...mutationFor(look, fields, children),
    }))
}

type Children = Pick<Draft, 'values' | 'statements' | 'mutation'>
/** Kinds of list that a growing block can be: the faces it has. */
const listTypes = (look: Look) => fc.constantFrom(...Object.keys(look.faces?.of ?? {}))
const childless = (look: Look): fc.Arbitrary<Children> =>
  look.items
    ? listTypes(look).map((type) => ({ mutation: { attrs: { items: '1', list_type: type } } }))
    : fc.constant({})

function mutationFor(
  look: Look,
  fields: Record<string, string>,
  { mutation }: Children,
): Pick<Draft, 'mutation'> {
  const written = Object.entries(look.mutation ?? {}).map(([name, value]) => [
    name,
    typeof value === 'string' ? value : (fields[value.field] ?? ''),
  ])
  const attrs = { ...mutation?.attrs, ...(Object.fromEntries(written) as Record<string, string>) }
  return Object.keys(attrs).length > 0 ? { mutation: { attrs } } : {}
}

function childrenOf(look: Look, depth: number): fc.Arbitrary<Children> {
  if (look.items) return listOf(look, depth)
  const values = look.inputs.flatMap((input) =>
    input.kind === 'value' ? [[input.name, valueFor(input.accepts, depth)]] : [],
  )
  const statements = look.inputs.flatMap((input) =>
    input.kind === 'statements' ? [[input.name, rowOf(depth)]] : [],
  )
  return fc
    .tuple(
      fc.record(Object.fromEntries(values) as Record<string, fc.Arbitrary<Draft>>, { requiredKeys: [] }),
      fc.record(Object.fromEntries(statements) as Record<string, fc.Arbitrary<Draft[]>>, {
        requiredKeys: [],
      }),
    )
    .map(([values, statements]) => ({
      ...(Object.keys(values).length > 0 && { values: values as Block['values'] }),
      ...(Object.keys(statements).length > 0 && { statements: statements as unknown as Block['statements'] }),
    }))
}

const listOf = (look: Look, depth: number): fc.Arbitrary<Children> =>
  listTypes(look).chain((listType) =>
    fc
      .array(fc.option(valueFor(look.faces?.of[listType]?.items?.accepts ?? [], depth)), {
        minLength: 1,
        maxLength: 5,
      })
      .map((rows) => ({
        mutation: { attrs: { items: String(rows.length), list_type: listType } },
        ...(rows.some(Boolean) && {
          values: Object.fromEntries(
            rows.flatMap((row, at) => (row ? [[`ADD${at}`, row]] : [])),
          ) as Block['values'],
        }),
      })),
  )

const outputs = (look: Look) => [
  look.output ?? '',
  ...Object.values(look.faces?.of ?? {}).map(({ output }) => output),
]
const shadowNumber = fc.constant({ type: 'math_number', fields: { NUM: '5' }, shadow: true as const })

function valueFor(accepts: readonly string[], depth: number): fc.Arbitrary<Draft> {
  const fitting = types('value').filter(({ look }) =>
    outputs(look).some((output) => accepts.includes(output)),
  )
  const known = fc
    .oneof(...fitting.map(({ type }) => blockOf(type, depth)))
    .filter((draft) => fits(draft as Block, accepts as readonly ValueType[]))
  const shadows = accepts.includes('Number') ? [shadowNumber] : []
  return fc.oneof(
    { weight: 6, arbitrary: known },
    { weight: 1, arbitrary: unknown as fc.Arbitrary<Draft> },
    ...shadows,
  )
}

const statement = (depth: number) =>
  fc.oneof(...types('statement').map(({ type }) => blockOf(type, depth)), unknown)
const rowOf = (depth: number) =>
  fc.array(statement(depth) as fc.Arbitrary<Draft>, { minLength: 1, maxLength: 3 })
const hatRow = fc
  .tuple(blockOf('robControls_start', 0), fc.array(statement(2) as fc.Arbitrary<Draft>, { maxLength: 3 }))
  .map(([hat, row]) => [hat, ...row])
const loneValue = fc.oneof(...types('value').map(({ type }) => blockOf(type, 1))).map((draft) => [draft])

function withIds(drafts: readonly Draft[], fresh: () => string): Block[] {
  return drafts.map((draft) => ({
    ...draft,
    id: fresh(),
    ...(draft.values && {
      values: Object.fromEntries(
        Object.entries(draft.values).map(([name, child]) => [name, withIds([child], fresh)[0]!]),
      ),
    }),
    ...(draft.statements && {
      statements: Object.fromEntries(
        Object.entries(draft.statements).map(([name, row]) => [name, withIds(row, fresh)]),
      ),
    }),
  }))
}

const coordinate = fc.double({ min: -2000, max: 2000, noNaN: true }).map((number) => number + 0)

const programs: fc.Arbitrary<Program> = fc
  .array(fc.tuple(coordinate, coordinate, fc.oneof(hatRow, rowOf(2), loneValue)), { maxLength: 4 })
  .map((stacks) => {
    let count = 0
    const fresh = () => `block${count++}`
    return { ...empty, stacks: stacks.map(([x, y, drafts]) => ({ x, y, blocks: withIds(drafts, fresh) })) }
  })

describe('a program on the workspace', () => {
  it('comes back block for block, field for field', () => {
    fc.assert(
      fc.property(programs, (program) => {
        expect(backAndForth(program)).toEqual(program)
      }),
      { numRuns: 200 },
    )
  })

  it('shows a block of an unknown type by its name, in the style of unknown blocks', () => {
    const fly: Block = { id: 'odd', type: 'robActions_fly', fields: { HEIGHT: '3' }, comment: 'hui' }
    const program = programOf([{ id: 'start', type: 'robControls_start' }, fly])
    const workspace = open(program)
    const block = workspace.getBlockById('odd')!
    expect([block.getFieldValue('NAME'), block.getStyleName()]).toEqual(['robActions_fly', 'unknown'])
    expect(toProgram(workspace, program).stacks[0]!.blocks[1]).toEqual(fly)
  })

  it('is read completely while its last rows are still loading', () => {
    const stop = (id: string): Block => ({ id, type: 'robActions_motorDiff_stop' })
    const wait: Block = { id: 'wait', type: 'robControls_wait_time' }
    const workspace = open(programOf([wait, stop('a')], [stop('alone')]))
    awaited.set(workspace, new Map([['wait', [stop('b'), stop('c')]]]))
    expect(toProgram(workspace, empty).stacks.map(({ blocks }) => blocks.map(({ id }) => id))).toEqual([
      ['wait', 'a', 'b', 'c'],
      ['alone'],
    ])
  })

  it('is written as its file has it if a sensor block has no fields or no mutation', () => {
    const type = 'robSensors_touch_getSample'
    const rows: readonly Block[] = [
      { id: 'bare', type, mutation: { attrs: { mode: 'PRESSED' } } },
      { id: 'plain', type, fields: { MODE: 'PRESSED', SENSORPORT: '1' } },
    ]
    const program = programOf(...rows.map((block) => [block]))
    expect(backAndForth(program)).toEqual(program)
  })

  it('has no rows in a block without a list', () => {
    const workspace = open(empty)
    workspace.newBlock('robActions_motorDiff_stop', 'stop')
    workspace.newBlock('ai_easy_list', 'list')
    const blocks = toProgram(workspace, empty).stacks.flatMap(({ blocks }) => blocks)
    expect(blocks.map(({ mutation }) => mutation?.attrs['items'])).toEqual([undefined, '1'])
  })

  it('comes back frozen to its leaves', () => {
    const program = backAndForth(programOf([{ id: 'a', type: 'math_number', fields: { NUM: '1' } }]))
    expect(Object.isFrozen(program.stacks[0]!.blocks[0]!.fields)).toBe(true)
  })

  it('keeps the configuration and the attributes of its file', () => {
    const program = {
      ...empty,
      config: { stacks: [{ x: 1, y: 2, blocks: [] }] },
      raw: { attributes: { tags: 'x' } },
    }
    expect(backAndForth(program)).toEqual(program)
  })

  it.each(toolbox.flatMap(({ blocks }) => blocks).map((template) => [template.type, template]))(
    'shows %s of the toolbox whole',
    (_type, template) => {
      let count = 0
      const block = blockFrom(template, () => `block${count++}`)
      expect(backAndForth(programOf([block])).stacks[0]!.blocks).toEqual([block])
    },
  )
})

describe('a program that does not fit together', () => {
  const number = (id: string): Block => ({ id, type: 'math_number', fields: { NUM: '1' } })
  const stop = (id: string): Block => ({ id, type: 'robActions_motorDiff_stop' })
  const start = (id: string): Block => ({ id, type: 'robControls_start' })
  const ids = (program: Program) => program.stacks.map(({ blocks }) => blocks.map(({ id }) => id))

  it('loses no block: what cannot hang in a row lies beside it', () => {
    const program = backAndForth(
      programOf([start('a'), stop('b'), number('c'), stop('d'), start('e'), stop('f')]),
    )
    expect(ids(program)).toEqual([['a', 'b', 'd'], ['e', 'f'], ['c']])
  })

  it('loses no block: what is plugged into the wrong input lies beside it', () => {
    const wait: Block = { id: 'wait', type: 'robControls_wait_time', values: { WAIT: stop('inside') } }
    expect(ids(backAndForth(programOf([wait])))).toEqual([['wait'], ['inside']])
  })

  it('keeps a row of a list that the mutation does not count', () => {
    const neuron: Block = { id: 'n', type: 'ai_nn_output_node_sound' }
    const list: Block = {
      id: 'l',
      type: 'ai_easy_list',
      mutation: { attrs: { list_type: 'OutputNode' } },
      values: { ADD2: neuron },
    }
    const [block] = backAndForth(programOf([list])).stacks[0]!.blocks
    expect(block).toEqual({ ...list, mutation: { attrs: { list_type: 'OutputNode', items: '3' } } })
  })
})
