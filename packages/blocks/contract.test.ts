import { readdirSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { formsOf, type Table } from '@botgarten/messages'
import { completeLanguages, filesIn, ownTableOf } from '@botgarten/messages/folder'
import { addBlocks, definitions, isBlockType, knowMaps, mapIn, toolbox as plainToolbox } from './index.ts'
import { blocks as core } from './packs/core/blocks.ts'
import { blocks as ofExpert } from './packs/expert/blocks.ts'
import { expert, expertToolbox as toolbox } from './packs/expert/index.ts'
import { blocks as ofLearning } from './packs/learning/blocks.ts'
import { packs } from './packs/packs.ts'
import { withRest } from './toolbox.ts'
import type { BlockType, Definition, Look, Pack, Template } from './index.ts'

addBlocks(expert)

/** What a language says itself, of the cards' blocks and of the expert pack. */
const ownWordsOf = (language: string): Table =>
  Object.assign({}, ...filesIn().map((file) => ownTableOf(file, language))) as Table

// Every map that has a name may be chosen. That each map has one, and each name a map, content's contract tests say.
const names = Object.keys(ownWordsOf('en')).filter((key) => key.startsWith('choice.MAP_'))
knowMaps({ maps: names.map((key) => mapIn(key.slice('choice.'.length))), stations: {} })

const languages = completeLanguages.map((language) => [language, ownWordsOf(language)] as const)

const message = (words: Table, key: string): string | undefined => words[key] && formsOf(words[key]).join(' ')

const placeholders = (text: string) => [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name ?? '')

/** In every language: the message, and the same placeholders in each. */
function expectMessage(key: string, names?: readonly string[]) {
  for (const [language, words] of languages) {
    const text = message(words, key)
    expect(text, `${key} in ${language}`).toBeTruthy()
    if (names) expect(placeholders(text ?? '').sort(), `${key} in ${language}`).toEqual([...names].sort())
  }
}

const families = [
  ...['control', 'action', 'sensors', 'logic', 'math', 'text', 'lists', 'variables', 'functions', 'messages'],
  ...['network', 'q-learning', 'sorting'],
]
const files = families.flatMap((family) =>
  readdirSync(new URL(family, import.meta.url))
    .filter((file) => !file.endsWith('.test.ts'))
    .map((file) => ({ family, type: file.replace(/\.ts$/, '') })),
)

describe('the folders', () => {
  it('hold every block of the table, one file each, and nothing else', () => {
    expect(files.map(({ type }) => type).sort()).toEqual(Object.keys(definitions).sort())
  })

  it.each(files)('$family/$type is named as its type and lies in its family', ({ family, type }) => {
    expect(isBlockType(type)).toBe(true)
    expect(definitions[type as BlockType].type).toBe(type)
    expect(definitions[type as BlockType].look.category).toBe(family)
  })

  it.each(files)('$family/$type is brought by the pack it names', async ({ family, type }) => {
    const { [type]: definition } = (await import(`./${family}/${type}.ts`)) as { [type: string]: Definition }
    const tables: { readonly [P in Pack]: { readonly [type: string]: Definition } } = {
      core,
      learning: ofLearning,
      expert: ofExpert,
    }
    expect(packs[type as BlockType], 'npm run blocks').toBe(definition?.pack)
    for (const [pack, table] of Object.entries(tables))
      expect(table[type], pack).toBe(pack === definition?.pack ? definition : undefined)
  })

  it('are all that the packs have', () => {
    expect(files.map(({ type }) => type).sort()).toEqual(Object.keys(packs).sort())
  })

  it('know no block by a name that every object has', () => {
    expect(['toString', 'constructor', '__proto__'].filter(isBlockType)).toEqual([])
  })
})

/** What the rows must have a place for: visible fields, named inputs, the icon. */
function parts({ fields, inputs, icon }: Look): string[] {
  return [
    ...fields.filter(({ kind }) => kind !== 'hidden').map(({ name }) => name),
    ...inputs.map(({ name }) => name),
    ...(icon ? ['ICON'] : []),
  ]
}

const all = Object.values(definitions).map((definition: Definition) => [definition.type, definition] as const)
/** As they are until the expert pack is loaded. */
const plain = Object.values(core).flatMap((definition: Definition) =>
  definition.expertLook ? [[`${definition.type} of the cards`, definition] as const] : [],
)

describe.each([...all, ...plain])('%s', (_type, { look, words, neuron, example }) => {
  it('has a name and one sentence of help of at most 15 words', () => {
    expectMessage(words.name, [])
    expectMessage(words.help, [])
    for (const [, language] of languages) {
      const help = message(language, words.help) ?? ''
      expect(help.split(/\s+/).length).toBeLessThanOrEqual(15)
      expect(help).toMatch(/^[A-ZÄÖÜ].*\.$/)
    }
  })

  it('has a place in its rows for every part, once', () => {
    const [, english] = languages[0]!
    const inRows = look.rows.flatMap((key) => placeholders(message(english, key) ?? ''))
    expect(inRows.sort()).toEqual(parts(look).sort())
    for (const key of look.rows) expectMessage(key, placeholders(message(english, key) ?? ''))
  })

  it('writes what its fields say into its mutation, in the shape its inputs need', () => {
    const { fields, inputs, branches, mutation = {} } = look
    for (const { when } of inputs)
      if (when && 'field' in when) expect(fields.map(({ name }) => name)).toContain(when.field)
    for (const said of Object.values(mutation))
      if (typeof said === 'object' && 'is' in said) {
        const field = fields.find(({ name }) => name === said.field)
        const values = field?.kind === 'choice' ? field.options.map(({ value }) => value) : []
        for (const value of said.is) expect(values).toContain(value)
      }
    if (branches) expect(inputs.map(({ name }) => name)).toContain(`${branches.value}0`)
  })

  it('has presets that are among its options, and words for each option', () => {
    for (const field of look.fields) {
      if (field.kind !== 'choice') continue
      const values = field.options.map(({ value }) => value)
      expect(values).toContain(field.preset)
      expect(new Set(values).size).toBe(values.length)
      for (const { words } of field.options) if (words !== null) expectMessage(words, [])
    }
  })

  it('writes its colours as #RRGGBB in upper case', () => {
    for (const field of look.fields) {
      if (field.kind !== 'choice') continue
      for (const { dot, value } of field.options) {
        if (dot !== undefined) expect(dot).toMatch(/^#[0-9A-F]{6}$/)
        if (value.startsWith('#')) expect(value).toBe(dot)
      }
    }
  })

  it('gives a value exactly if it is a value block', () => {
    expect(look.output !== undefined).toBe(look.shape === 'value')
    if (look.also) expect([look.shape, look.also.shape]).toEqual(['value', 'statement'])
  })

  it('has faces for every value that tells them apart, the first as it shows itself', () => {
    if (!look.faces) return
    const { by, of } = look.faces
    expect(Object.values(of)[0]?.output).toBe(look.output)
    if ('field' in by) {
      const field = look.fields.find(({ name }) => name === by.field)
      const values = field?.kind === 'choice' ? field.options.map(({ value }) => value) : []
      expect(Object.keys(of)).toEqual(values)
    }
    for (const face of Object.values(of)) if (face.items) expectMessage(face.items.add, [])
  })

  it('has mutations that follow fields of its own', () => {
    const names = look.fields.map(({ name }) => name)
    for (const said of Object.values(look.mutation ?? {}))
      if (typeof said === 'object') expect(names).toContain(said.field)
  })

  it('labels its neuron with its fields', () => {
    if (!neuron) return
    const visible = look.fields.filter(({ kind }) => kind !== 'hidden').map(({ name }) => name)
    // A sensor's port is named only where sensors of its kind have two.
    const named = neuron.sensor ? visible.filter((name) => name !== neuron.port) : visible
    expectMessage(neuron.label, named)
    expectMessage('neuron.port', ['label', 'port'])
    if (neuron.port !== undefined) expect(visible).toContain(neuron.port)
    if (typeof neuron.colour === 'object') expect(visible).toContain(neuron.colour.field)
    expect(look.output).toBe(neuron.layer === 'input' ? 'InputNode' : 'OutputNode')
  })

  it('has an example that begins with a start block', () => {
    expect(example[0]?.type).toBe('robControls_start')
  })

  it('has an example that chooses among the options of its blocks', () => {
    for (const { type, fields = {} } of example.flatMap(templates))
      for (const field of isBlockType(type) ? definitions[type].look.fields : []) {
        const value = fields[field.name]
        if (field.kind === 'choice' && value !== undefined)
          expect(
            field.options.map((option) => option.value),
            `${type}.${field.name}`,
          ).toContain(value)
      }
  })
})

const templates = (template: Template): Template[] => [
  template,
  ...Object.values(template.values ?? {}).flatMap(templates),
  ...Object.values(template.statements ?? {}).flatMap((rows) => rows.flatMap(templates)),
]

describe('the toolbox', () => {
  const entries = toolbox.flatMap(({ blocks }) => blocks)

  it('offers every block', () => {
    const offered = new Set(entries.flatMap(templates).map(({ type }) => type))
    const elsewhere = all.flatMap(([type, { outsideToolbox }]) => (outsideToolbox ? [type] : []))
    expect([...offered, ...elsewhere].sort()).toEqual(Object.keys(definitions).sort())
  })

  it('offers a bump as something that costs, and a way as something that is paid', () => {
    const coins = entries.filter(({ type }) => type === 'ai_try_pay').map(({ fields }) => fields)
    expect(coins.find((one) => one?.['WHAT'] === 'BUMP')?.['COINS']).toMatch(/^-[1-9]/)
    expect(coins.find((one) => one?.['WHAT'] === 'AHEAD')?.['COINS']).toMatch(/^[1-9]/)
  })

  it('offers a block without a preset at the end of its family', () => {
    const fresh = { ...core.robActions_play_tone, type: 'fresh' }
    const rows = withRest(plainToolbox, { ...core, fresh })
    expect(rows.find(({ category }) => category === 'action')?.blocks.at(-1)).toEqual({ type: 'fresh' })
    expect(withRest(plainToolbox, { ...core, fresh: { ...fresh, outsideToolbox: 'old' } })).toEqual(
      plainToolbox,
    )
  })

  it('shows a beginner comparing beside the blocks that ask for it, and no row of logic for it alone', () => {
    const typesIn = (wanted: string) =>
      plainToolbox.find(({ category }) => category === wanted)?.blocks.map(({ type }) => type)
    expect(typesIn('control')?.slice(-3)).toEqual(['robControls_if', 'robControls_ifElse', 'logic_compare'])
    expect(typesIn('logic')).toBeUndefined()
    expect(toolbox.find(({ category }) => category === 'logic')?.blocks[0]?.type).toBe('logic_compare')
    expect(
      toolbox.find(({ category }) => category === 'control')?.blocks.map(({ type }) => type),
    ).not.toContain('logic_compare')
  })

  it.each(languages)(
    'has no row that is called like the button that starts Bo, in %s',
    (_language, words) => {
      const names = toolbox.map(({ category }) => message(words, `category.${category}`))
      expect(names).not.toContain(message(words, 'lab.start'))
      expect(new Set(names).size).toBe(names.length)
    },
  )

  it('has words for each category, in the order of the folders', () => {
    expect(toolbox.map(({ category }) => category)).toEqual(families.filter((name) => name !== 'variables'))
    for (const { category } of toolbox) expectMessage(`category.${category}`, [])
  })

  it.each(entries.flatMap(templates).map((template) => [template.type, template] as const))(
    'presets of %s are fields it has, with values they may have',
    (type, { fields = {}, values = {} }) => {
      const { look } = definitions[type as BlockType]
      for (const [name, value] of Object.entries(fields)) {
        const field = look.fields.find((candidate) => candidate.name === name)
        expect(field, `${type}.${name}`).toBeDefined()
        if (field?.kind === 'choice') expect(field.options.map((option) => option.value)).toContain(value)
      }
      const inputs = [...look.inputs.map(({ name }) => name), ...(look.items ? ['ADD0', 'ADD1', 'ADD2'] : [])]
      for (const name of Object.keys(values)) expect(inputs).toContain(name)
    },
  )
})

describe('the words', () => {
  const keys = [...new Set(languages.flatMap(([, words]) => Object.keys(words)))]
  const namesIn = (some: readonly string[]) => [
    ...new Set(some.flatMap((key) => /^block\.(\w+)\./.exec(key)?.[1] ?? [])),
  ]

  it('belong to blocks that are there', () => {
    expect(namesIn(keys).sort()).toEqual(Object.keys(definitions).sort())
    const inExpert = namesIn(Object.keys(ownTableOf('expert', 'en')))
    expect(inExpert.filter((type) => !(type in expert))).toEqual([])
  })

  it('use every choice', () => {
    const used = all.flatMap(([, { look }]) =>
      look.fields.flatMap((field) =>
        field.kind === 'choice' ? field.options.map(({ words }) => words) : [],
      ),
    )
    // A value that is none of the options is named by the nearest one: "almost red".
    used.push('choice.almost')
    const there = keys.filter((key) => key.startsWith('choice.'))
    expect(there.filter((key) => !used.includes(key))).toEqual([])
  })
})
