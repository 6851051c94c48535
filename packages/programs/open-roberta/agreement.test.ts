import type { Block } from '@botgarten/blocks'
import fc from 'fast-check'
import * as v from 'valibot'
import { expect, it } from 'vitest'
import { programSchema } from '../project/schema-program.ts'
import type { Program } from '../types.ts'
import { readOpenRoberta, writeOpenRoberta } from './index.ts'

/** What a project's file can say and Open Roberta never would. */
const odd = [
  ...['', ' ', 'a b', 'a"b', '<', '&', '1', '-', 'é', '🤖', '\0', '\uD800', '\r\n', ':', 'a:b', 'xml:lang'],
  ...['xmlns', 'xmlns:a', 'xmlns:xml', 'type', 'id', 'shadow', 'inline', 'true', 'false', 'ev3', 'mbot'],
  ...['robottype', 'comment', 'comment.w', 'comment.', 'comment.a b', 'error', 'error.', 'warning.x', 'hide'],
  ...[
    'hide.A',
    'under.A',
    'repetitions',
    'urn:y',
    'http://de.fhg.iais.roberta.blockly',
    'DO0',
    'IF0',
    'toString',
  ],
]
const types = [
  'math_number',
  'robControls_if',
  'robControls_ifElse',
  'robControls_start',
  'text',
  'a b',
  'nobody',
]
const text = fc.oneof({ weight: 3, arbitrary: fc.constantFrom(...odd) }, fc.string({ unit: 'binary' }))
const key = fc.oneof({ weight: 2, arbitrary: fc.constantFrom('A', 'B', 'IF0', 'DO0', 'ELSE') }, text)
const texts = fc.dictionary(key, text, { maxKeys: 3, noNullPrototype: true })
const maybe = <Value>(arbitrary: fc.Arbitrary<Value>) => fc.option(arbitrary, { nil: undefined, freq: 2 })

const shadow = JSON.stringify({ id: 's', type: 'text', shadow: true, fields: { TEXT: 'x' } })

const { block } = fc.letrec<{ block: Block }>((tie) => ({
  block: fc
    .record({
      id: fc.uuid(),
      type: fc.oneof(fc.constantFrom(...types), text),
      fields: maybe(texts),
      mutation: maybe(
        fc.record({
          attrs: texts,
          args: maybe(fc.array(fc.record({ name: text, type: text }), { maxLength: 2 })),
        }),
      ),
      values: maybe(fc.dictionary(key, tie('block'), { maxKeys: 2, noNullPrototype: true })),
      statements: maybe(
        fc.dictionary(key, fc.array(tie('block'), { maxLength: 2 }), { maxKeys: 2, noNullPrototype: true }),
      ),
      comment: maybe(text),
      data: maybe(text),
      hide: maybe(fc.array(text, { maxLength: 2 })),
      disabled: maybe(fc.boolean()),
      inline: maybe(fc.boolean()),
      shadow: maybe(fc.boolean()),
      flags: maybe(
        fc.oneof(
          texts,
          texts.map((flags) => ({ ...flags, 'under.A': shadow })),
        ),
      ),
    })
    .map((whole) => defined(whole) as Block),
}))

const defined = (value: unknown): unknown =>
  Array.isArray(value)
    ? value.map(defined)
    : typeof value === 'object' && value !== null
      ? Object.fromEntries(
          Object.entries(value).flatMap(([name, part]) =>
            part === undefined ? [] : [[name, defined(part)]],
          ),
        )
      : value

const number = fc.oneof(
  fc.integer({ min: -2000, max: 2000 }),
  fc.double({ noNaN: true, noDefaultInfinity: true }),
)
const stacks = fc.array(fc.record({ x: number, y: number, blocks: fc.array(block, { maxLength: 3 }) }), {
  maxLength: 2,
})
const program = fc
  .record({
    stacks,
    config: fc.record({ stacks }),
    raw: maybe(fc.record({ attributes: texts, config: maybe(texts), root: maybe(texts) })),
  })
  .map((whole) => defined(whole) as Program)
  .filter((whole) => v.is(programSchema, whole))

it('whatever a project may hold is written so that it is read again, and stays as it is then', () => {
  fc.assert(
    fc.property(program, (given) => {
      const once = readOpenRoberta(writeOpenRoberta(given))
      expect(readOpenRoberta(writeOpenRoberta(once))).toEqual(once)
    }),
    { seed: 15, numRuns: 400 },
  )
})

/** Blocks that are nested as deep as the file of a project may be. */
const nested = (levels: number, around: (inner: Block, id: string) => Block): Program => {
  let inner: Block = { id: 'n', type: 'math_number' }
  for (let level = 0; level < levels; level++) inner = around(inner, `b${level}`)
  return { stacks: [{ x: 0, y: 0, blocks: [inner] }], config: { stacks: [] } }
}

it.each([
  [
    'loops',
    190,
    (inner: Block, id: string) => ({ id, type: 'robControls_loopForever', statements: { DO: [inner] } }),
  ],
  ['values', 290, (inner: Block, id: string) => ({ id, type: 'logic_negate', values: { BOOL: inner } })],
  [
    'choices',
    190,
    (inner: Block, id: string) => ({ id, type: 'robControls_ifElse', statements: { DO0: [inner] } }),
  ],
] as const)('%s may be nested as deep as in a project', (_what, levels, around) => {
  const deep = nested(levels, around)
  expect(v.is(programSchema, deep)).toBe(true)
  expect(readOpenRoberta(writeOpenRoberta(deep))).toMatchObject({ stacks: deep.stacks })
})
