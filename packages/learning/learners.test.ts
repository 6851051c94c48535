import { mkdirSync, mkdtempSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { stream } from '@botgarten/numbers'
import { describe, expect, test } from 'vitest'
import type { ParameterSchema } from './parameters.ts'
import { learnerFolders, learnerIn, missingIn, withoutCommand } from './testing/contract.ts'

const seeded = (seed: number) => stream(seed, 'learn/contract')

/** Values that a parameter must not have. */
function outside(schema: ParameterSchema): unknown[] {
  if ('enum' in schema) return ['', 'other', 1, null]
  if ('oneOf' in schema) return ['constant', null, {}, { kind: 'other' }, ...schema.oneOf.flatMap(inKind)]
  const { type, minimum, maximum } = schema
  return [
    ...[NaN, Infinity, -Infinity, '1', null, minimum - 1],
    ...(maximum === undefined ? [] : [maximum + 1e-9]),
    ...(type === 'integer' ? [minimum + 0.5] : []),
  ]
}

/** The values at the edges of what it may have. */
function inside(schema: ParameterSchema): unknown[] {
  if ('enum' in schema) return [...schema.enum]
  if ('oneOf' in schema)
    return schema.oneOf.flatMap(({ properties }) =>
      Object.entries(properties).reduce<object[]>(
        (all, [name, own]) => all.flatMap((one) => inside(own).map((value) => ({ ...one, [name]: value }))),
        [{}],
      ),
    )
  return schema.maximum === undefined ? [schema.minimum] : [schema.minimum, schema.maximum]
}

function inKind({ properties }: Extract<ParameterSchema, { oneOf: unknown }>['oneOf'][number]): object[] {
  const { kind, ...others } = properties
  const start = { kind: kind && 'enum' in kind ? kind.enum[0] : '' }
  return [
    { ...start, surplus: 1 },
    ...Object.entries(others).flatMap(([name, own]) => [
      start,
      ...outside(own).map((value) => ({ ...start, [name]: value })),
    ]),
  ]
}

test.each(learnerFolders())('%s has a model.md, a test, an example and an index', (folder) => {
  expect(missingIn(folder)).toEqual([])
})

test('a folder without them is not taken for a learner: each is named', () => {
  const root = mkdtempSync(join(tmpdir(), 'learning-'))
  mkdirSync(join(root, 'guessing'))
  expect(learnerFolders(root)).toEqual(['guessing'])
  expect(missingIn('guessing', root)).toEqual(['index.ts', 'model.md', 'testing/example.ts', 'a test'])
  writeFileSync(join(root, 'guessing/guessing.test.ts'), '')
  writeFileSync(join(root, 'guessing/index.ts'), '')
  expect(missingIn('guessing', root)).toEqual(['model.md', 'testing/example.ts'])
  expect(withoutCommand(['q', 'guess'], { q: 1 })).toEqual(['guess'])
})

test('there are learners, and no two have one name', async () => {
  const all = await Promise.all(learnerFolders().map(learnerIn))
  const names = all.map(({ learner }) => learner.name)
  expect(names.length).toBeGreaterThan(1)
  expect(new Set(names).size).toBe(names.length)
})

describe.each(learnerFolders())('%s', async (folder) => {
  const { learner, example } = await learnerIn(folder)
  const { parameters, data, steps } = example
  const begin = (seed = 1) => learner.begin(parameters, data, seeded(seed))
  /** What a state is worth comparing by. */
  const textOf = (state: unknown) => JSON.stringify(learner.save(state))
  const advance = (state: unknown, count: number, trace?: (trace: unknown) => void) => {
    for (let step = 0; step < count; step++) learner.step(state, trace)
  }

  test('learns something, and another seed is another run', () => {
    const [one, other] = [begin(1), begin(2)]
    const before = textOf(one)
    advance(one, steps)
    advance(other, steps)
    expect(textOf(one)).not.toBe(before)
    expect(textOf(other)).not.toBe(textOf(one))
  })

  test('the same seed is the same run, step by step, whether it is traced or not', () => {
    const [plain, traced] = [begin(), begin()]
    const traces: unknown[] = []
    for (let step = 0; step < steps; step++) {
      learner.step(plain)
      learner.step(traced, (trace) => traces.push(trace))
      expect(textOf(traced)).toBe(textOf(plain))
    }
    expect(traces.length).toBeGreaterThan(10)
    expect(traces.length).toBeLessThanOrEqual(steps)
  })

  test('a trace is plain data that later steps do not change', () => {
    const state = begin()
    const traces: { readonly trace: unknown; readonly text: string }[] = []
    advance(state, steps, (trace) => traces.push({ trace, text: JSON.stringify(trace) }))
    for (const { trace, text } of traces) {
      expect(JSON.stringify(trace)).toBe(text)
      expect(JSON.parse(text)).toEqual(trace)
    }
  })

  test('saved as text and restored at any step it goes on bit for bit, traces and all', () => {
    const state = begin()
    for (let at = 0; at < steps; at++) {
      const saved: unknown = JSON.parse(textOf(state))
      const [copy, again] = [begin(7), begin()]
      // A restored state forgets all that it did before.
      advance(copy, at % 13)
      learner.restore(copy, saved)
      learner.restore(again, saved)
      const [one, other]: unknown[][] = [[], []]
      advance(copy, 12, (trace) => one!.push(trace))
      advance(again, 12, (trace) => other!.push(trace))
      expect(one).toEqual(other)
      expect(textOf(copy)).toBe(textOf(again))
      learner.step(state)
      learner.restore(copy, saved)
      learner.step(copy)
      expect(textOf(copy)).toBe(textOf(state))
    }
  })

  test('what was saved stays as it is while the state goes on', () => {
    const state = begin()
    advance(state, 3)
    const saved = learner.save(state)
    const text = JSON.stringify(saved)
    advance(state, steps)
    expect(JSON.stringify(saved)).toBe(text)
  })

  test('every value that the schema names is taken, up to its edges', () => {
    for (const [name, own] of Object.entries(learner.parameters.properties))
      for (const value of inside(own)) {
        const state = learner.begin({ ...parameters, [name]: value }, data, seeded(1))
        advance(state, 20)
        expect(textOf(state)).not.toContain('null,null')
      }
  })

  test('parameters outside the schema are refused by their name', () => {
    const refused = (odd: object) => expect(() => learner.begin(odd, data, seeded(1)))
    for (const [name, own] of Object.entries(learner.parameters.properties))
      for (const value of outside(own))
        refused({ ...parameters, [name]: value }).toThrow(
          expect.objectContaining({ name: 'RangeError', message: expect.stringContaining(name) as string }),
        )
    refused({ ...parameters, surplus: 1 }).toThrow('There is no parameter surplus.')
    for (const name of learner.parameters.required)
      refused({ ...parameters, [name]: undefined }).toThrow(`${name} is missing.`)
  })
})
