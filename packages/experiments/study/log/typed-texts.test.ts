import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { emptyBrain } from '@botgarten/learning/neural-network/brain'
import { cardConfig, type World } from '@botgarten/simulation'
import { beforeAll, expect, test } from 'vitest'
import { TypedTexts } from './typed-texts.ts'

beforeAll(() => addBlocks(expert))

const secret = 'Lena Sommer'
const block = (id: string, type: string, rest: object = {}) => ({ id, type, ...rest })
const number = block('n', 'math_number', { fields: { NUM: '30' } })
const program = {
  stacks: [
    {
      ...{ x: 0, y: 0 },
      blocks: [
        block('start', 'robControls_start', { comment: secret, data: secret }),
        block('say', 'robActions_sayText', {
          values: { OUT: block('t', 'text', { fields: { TEXT: secret } }) },
        }),
        block('set', 'variables_set', { fields: { VAR: secret }, values: { VALUE: number } }),
        block('get', 'variables_get', {
          fields: { VAR: secret },
          mutation: { attrs: { datatype: 'Number' } },
        }),
        block('call', 'robProcedures_callnoreturn', {
          mutation: { attrs: { name: secret }, args: [{ name: secret, type: 'Number' }] },
        }),
        block('far', 'robActions_motorDiff_on', {
          fields: { DIRECTION: 'FOREWARD' },
          values: { POWER: number },
        }),
        block('preset', 'robControls_wait_time', { values: { WAIT: { ...number, shadow: true } } }),
        block('alien', 'of_a_later_version', { fields: { WORDS: secret } }),
      ],
    },
  ],
  config: { stacks: [] },
  raw: { attributes: { description: secret } },
}
const world: World = {
  ...{ size: { width: 200, height: 200 }, floor: { asset: 'ab'.repeat(32) } },
  ...{ areas: [], lines: [], obstacles: [] },
  robots: [
    { id: 'bo', pose: { x: 1, y: 2, heading: 3 }, program: 'main', brain: secret, config: cardConfig },
  ],
}
const drive = { id: 'pad-1', by: 'pad', seed: 1, note: secret } as const
const brain = {
  ...emptyBrain,
  sets: { [secret]: { a: { b: 1 } } },
  examples: { version: 1 as const, inputs: [], outputs: [], drives: [drive], rows: [] },
}

test('nothing that a child has typed and no picture of its own is in what is written', () => {
  const texts = new TypedTexts()
  const { document, photo } = texts.document({ programs: { main: program }, world, brains: { net: brain } })
  const written = JSON.stringify(document)
  expect(written).not.toContain(secret)
  expect(written).not.toContain('abab')
  expect(photo).toBe(true)
  expect(document.world.floor).toEqual({ colour: '#FFFFFF' })
})

test('names still find each other and have as many letters; numbers and choices stay', () => {
  const texts = new TypedTexts()
  const { document } = texts.document({ programs: { main: program }, world, brains: { net: brain } })
  const word = texts.hide(secret)
  expect(word).toHaveLength(secret.length)
  const blocks = Object.fromEntries(document.programs['main']!.stacks[0]!.blocks.map((one) => [one.id, one]))
  expect([blocks['set']!.fields, blocks['get']!.fields]).toEqual([{ VAR: word }, { VAR: word }])
  expect(blocks['call']!.mutation).toEqual({ attrs: { name: word }, args: [{ name: word, type: 'Number' }] })
  expect(blocks['far']!.fields).toEqual({ DIRECTION: 'FOREWARD' })
  expect(blocks['far']!.values!['POWER']!.fields).toEqual({ NUM: '30' })
  expect(blocks['preset']!.values!['WAIT']!.shadow).toBe(true)
  expect(blocks['far']!.values!['POWER']).not.toHaveProperty('shadow')
  expect(document.world.robots[0]!.brain).toBe(word)
  expect(Object.keys(document.brains['net']!.sets)).toEqual([word])
})

test('different texts of one length are different words, as long as there are enough', () => {
  const texts = new TypedTexts()
  const words = new Set(Array.from({ length: 600 }, (_, at) => texts.hide(String(100 + at))))
  expect(words.size).toBe(600)
  expect(texts.hide('')).toBe('')
})
