import { readdirSync, readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import type { Table } from '@botgarten/messages'
import { completeLanguages, wordsOf } from '@botgarten/messages/folder'
import { addBlocks, definitions } from '../index.ts'
import { expert } from '../packs/expert/index.ts'
import { partOf, parts } from './index.ts'

addBlocks(expert)

const read = (path: string) => readFileSync(new URL(path, import.meta.url), 'utf8')
const toolboxes = read('../../programs/testing/open-roberta/toolbox.txt').split('####').slice(1)
const typesOf = (toolbox: string) => [
  ...new Set([...toolbox.matchAll(/^\s*- ([a-z]\w+)/gm)].map(([, type]) => type!)),
]
const toolbox = (name: string) => typesOf(toolboxes.find((text) => text.includes(`ev3.${name}.xml`))!)

const languages = completeLanguages.map((language) => wordsOf(language))
const message = (words: Table, key: string): unknown => words[key]

describe('Open Roberta’s toolboxes', () => {
  it.each(['program.toolbox.beginner', 'program.toolbox.expert'])('%s: every block is known here', (name) => {
    expect(toolbox(name).length).toBeGreaterThan(40)
    expect(toolbox(name).filter((type) => !Object.hasOwn(definitions, type))).toEqual([])
  })

  it('configuration: every block is a part, and there is no other but the brick', () => {
    expect(toolbox('configuration.toolbox')).toHaveLength(12)
    expect(['robBrick_EV3-Brick', ...toolbox('configuration.toolbox')].sort()).toEqual(
      parts.map(({ type }) => type).sort(),
    )
  })
})

it('every part has a file that is called like it', () => {
  const files = readdirSync(new URL('.', import.meta.url)).filter((file) => file.startsWith('robBrick_'))
  expect(files.sort()).toEqual(parts.map(({ type }) => `${type}.ts`).sort())
})

/** Fields that the given files show at each block of a configuration (`block-schema.md`). */
const schema: { readonly [type: string]: readonly string[] } = {
  'robBrick_EV3-Brick': ['WHEEL_DIAMETER', 'TRACK_WIDTH'],
  robBrick_motor_big: ['MOTOR_REGULATION', 'MOTOR_REVERSE', 'MOTOR_DRIVE'],
  robBrick_motor_middle: ['MOTOR_REGULATION', 'MOTOR_REVERSE'],
}
/** All values that Open Roberta's own blocks offer. */
const values: { readonly [field: string]: readonly string[] } = {
  MOTOR_REGULATION: ['TRUE', 'FALSE'],
  MOTOR_REVERSE: ['OFF', 'ON'],
  MOTOR_DRIVE: ['NONE', 'LEFT', 'RIGHT'],
}

describe.each(parts.map((part) => [part.type, part] as const))('%s', (type, { fields, words, example }) => {
  it('has its fields with all their values, each with words', () => {
    expect(fields.map(({ name }) => name)).toEqual(schema[type] ?? [])
    for (const field of fields) {
      if (field.kind !== 'choice') continue
      expect(field.options.map(({ value }) => value)).toEqual(values[field.name])
      for (const option of field.options)
        for (const language of languages) expect(message(language, option.words!), option.words!).toBeTruthy()
    }
  })

  it('has a name and one sentence of help of at most 15 words', () => {
    for (const language of languages) {
      expect(message(language, words.name)).toBeTypeOf('string')
      const help = String(message(language, words.help))
      expect(help).toMatch(/^[A-ZÄÖÜ][^.]*\.$/)
      expect(help.split(/\s+/).length).toBeLessThanOrEqual(15)
    }
  })

  it('has an example of blocks that are known, around it', () => {
    const plugged = Object.values(example.plugged).map((template) => template.type)
    expect(type === 'robBrick_EV3-Brick' || plugged.includes(type)).toBe(true)
    expect(plugged.every((one) => partOf(one) !== undefined)).toBe(true)
    expect(example.program.every((one) => Object.hasOwn(definitions, one.type))).toBe(true)
  })
})
