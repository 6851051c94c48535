import { basename, dirname } from 'node:path'
import { learningIn } from '@botgarten/programs'
import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, it, test } from 'vitest'
import { content } from '../files.ts'
import { cardWords } from '../items/cardWords.ts'
import { gradeOf } from '../items/readability.ts'
import { missingIn } from '../items/resolve.ts'
import { embedsOf, nodesOf, shapeOf, wordsOf } from '../items/walk.ts'
import { readAlignment } from '../schema/alignment.ts'
import { readItemText } from '../schema/itemText.ts'
import type { Item, ItemNode } from '../schema/itemTypes.ts'
import { plainOf } from '../schema/markdown.ts'
import { readReferences } from '../schema/references.ts'
import { textOf, there as thereIn } from './there.ts'

const isWritten = (id: string, language: string) => textOf(content.itemFolder(id), `${language}.md`) !== ''
/** The words of an item as they stand in its folder. */
const itemText = (id: string, language: string) =>
  readItemText(textOf(content.itemFolder(id), `${language}.md`))

// Every item is held to the same rules merely because it is there.
const there = thereIn()
const alignment = content.alignment()
const competences = new Map(alignment.competences.map((one) => [one.id, one]))

/** What each card has learned, by its map. */
const tasks = new Map(
  content.cards.flatMap(({ id }) => {
    const { programs } = content.program(id, 'solution')!
    const outline = Object.values(programs).flatMap((program) => learningIn(program) ?? [])[0]
    if (!outline) return []
    const { map, start, goal, closed } = outline
    return [[map, { start, goal, closed: closed.map((road) => road.join('-')) }] as const]
  }),
)

/** Words that a page in German has another word for. */
const english =
  /\b(Button|Slider|Click|klicke?n? auf den Button|Play|Reset|Save|Load|Settings|Learning|Training|Agent|Reward|Exploration|Loop|Step|Episode(?!n?\b)|Worksheet|Handout|Feedback|Tool|Output|Input|Level|Team|Teamwork|Highlight|Basics|Task|Quiz|Puzzle|Link|Screen|Laptop)\b/

describe.each(content.items)('the item $kind/$id', (item) => {
  const written = content.languages.filter((language) => isWritten(item.id, language))
  const texts = written.map((language) => itemText(item.id, language))
  const pictures = new Set(content.picturesOf(item.id))

  it.each(completeLanguages)('is written in "%s"', (language) => {
    expect(written).toContain(language)
  })

  it('is of the kind of the folder above', () => {
    const level = /-([ac])$/.exec(item.id)?.[1]
    const folder = content.itemFolder(item.id)
    const own = level !== undefined && basename(folder) === level ? dirname(folder) : folder
    expect(basename(dirname(own))).toBe(item.kind)
  })

  it('has the same sections, lists, tables, pictures, embeds and links in every language', () => {
    for (const text of texts) expect(shapeOf(text)).toEqual(shapeOf(texts[0]!))
    for (const text of texts) expect(text.title).toMatch(/\S/)
  })

  it.each(written)('names nothing in "%s" that is not there', (language) => {
    expect(missingIn(itemText(item.id, language), there, pictures)).toEqual([])
  })

  it('sets the task of a map as its card does', () => {
    for (const embed of embedsOf(texts[0]!)) {
      if (embed.kind !== 'map' || embed.start === undefined) continue
      const { start, goal, closed = [] } = embed
      expect({ start, goal, closed }).toEqual(tasks.get(embed.id))
    }
  })

  it('uses all the pictures beside it', () => {
    // A picture of a screen is one for each language.
    const nodes = texts.flatMap((text) => [...nodesOf(text)])
    const used = nodes.flatMap((node) => (node.type === 'image' ? [node.file] : []))
    expect([...pictures].filter((file) => !used.includes(file))).toEqual([])
  })

  it('names competences of the frameworks, a plan those of the KMK too', () => {
    const named = item.competences.map((id) => competences.get(id)?.framework)
    const frameworks = ['ai4k12', 'unesco', ...(item.plan ? ['kmk'] : [])]
    expect(new Set(named)).toEqual(new Set(frameworks))
  })

  it('speaks German in German', () => {
    const text = itemText(item.id, 'de')
    // Links to elsewhere are names: they stay as they are.
    const names = [...nodesOf(text)].filter((node) => node.type === 'link' && node.href.startsWith('https:'))
    const words = names.reduce((all, name) => all.replace(plainOf(name), ''), wordsOf(text))
    expect(english.exec(words)?.[0]).toBeUndefined()
  })

  it.each(written)('is not harder to read in "%s" than a grade above its youngest reader', (language) => {
    if (item.audience === 'teachers') return
    // No lower bound: short sentences are wanted, and both formulas were made for grades from 4 and from 1 on.
    const grade = gradeOf(wordsOf(itemText(item.id, language), false), language)
    const { upTo } = item.harder?.[language] ?? { upTo: item.grades[0] + 1 }
    if (grade !== null) expect(grade).toBeLessThanOrEqual(upTo)
  })
})

/** Everybody's, and what nobody may know who wrote. */
const nameless = ['evaluation-poster', 'my-code']

test('what pupils write on has a line for name, class and date', () => {
  const written = content.items.filter(({ id, audience, kind }) => {
    if (audience !== 'pupils' || !['worksheet', 'sheet', 'kit', 'observation'].includes(kind)) return false
    const nodes = [...nodesOf(itemText(id, 'en'))]
    const isRoom = (node: ItemNode) =>
      node.type === 'embed' && ['lines', 'field', 'trials'].includes(node.embed.kind)
    const isEmpty = (node: ItemNode) =>
      node.type === 'table' && node.rows.some((row) => row.filter(({ length }) => length === 0).length > 0)
    return nodes.some((node) => isRoom(node) || isEmpty(node))
  })
  const named = ({ id }: Item) => embedsOf(itemText(id, 'en')).some(({ kind }) => kind === 'name')
  expect(written.length).toBeGreaterThan(40)
  expect(written.filter((item) => !named(item)).map(({ id }) => id)).toEqual(nameless)
})

describe.each(content.cards)('the card $id', ({ id }) => {
  it.each(completeLanguages)(
    'is not harder to read in "%s" than a grade above its youngest reader',
    (language) => {
      const { card, text } = content.card(id)!
      expect(gradeOf(cardWords(text[language]!), language)).toBeLessThanOrEqual(card.grades[0] + 1)
    },
  )
})

describe('the printed set', () => {
  const ids = content.cards.filter(({ bed }) => bed === 'network').map(({ id }) => id)
  const embeds = (item: string) => embedsOf(itemText(item, 'de'))

  it('has both sides of every network card, in their order', () => {
    const printed = embeds('network-cards').flatMap((one) =>
      one.kind === 'card' ? [`${one.id} ${one.side}`] : [],
    )
    expect(printed).toEqual(ids.flatMap((id) => [`${id} front`, `${id} back`]))
  })

  it('has the solution of every network card, in their order', () => {
    const solved = embeds('solutions-network').flatMap((one) =>
      one.kind === 'program' && one.file === 'solution' ? [one.card] : [],
    )
    expect(solved).toEqual(ids)
  })
})

describe('slides', () => {
  const all = content.items.filter(({ kind }) => kind === 'slides')
  /** A deck of one lesson is called after it: `slides-four-brains` of `lesson-four-brains`. */
  const isOfLesson = ({ id }: Item) => id.startsWith('slides-')
  const decks = all.map((item) => ({ ...item, slides: isOfLesson(item) ? [5, 8] : [12, 18] }))

  it('are four decks, one a module', () => {
    expect(all.filter((item) => !isOfLesson(item)).map(({ module }) => module)).toEqual([1, 2, 3, 4])
  })

  it.each(all.filter(isOfLesson))('$id is named in the plan of its lesson', ({ id }) => {
    const prepared = [...nodesOf(itemText(id.replace('slides-', 'lesson-'), 'en'))]
    expect(prepared.map((node) => node.type === 'link' && node.href)).toContain(`item:${id}`)
  })

  it.each(decks)('$id: $slides.0 to $slides.1 slides, each with notes', ({ id, slides: [least, most] }) => {
    for (const language of completeLanguages) {
      const { sections } = itemText(id, language)
      expect(sections.length).toBeGreaterThanOrEqual(least!)
      expect(sections.length).toBeLessThanOrEqual(most!)
      expect(sections.filter(({ notes }) => notes.length === 0).map(({ title }) => title)).toEqual([])
    }
  })
})

/** How each framework numbers what it names. */
const numbering = {
  ai4k12: /^[1-5](-[A-D](-(i|ii|iii|iv|v|vi))?)?$/,
  unesco: /^4\.[1-3]\.[1-4]$/,
  kmk: /^[1-6]\.[1-6]$/,
} as const

describe('the alignment', () => {
  it('names every module and every card, and nothing that is not there', () => {
    expect(Object.keys(alignment.modules)).toEqual(['1', '2', '3', '4'])
    expect(Object.keys(alignment.cards).sort()).toEqual([...there.cards.keys()].sort())
    const named = [...Object.values(alignment.modules), ...Object.values(alignment.cards)].flat()
    expect(named.filter((id) => !competences.has(id))).toEqual([])
  })

  it('says of every lesson what it shows, in every language', () => {
    const plans = content.items.flatMap(({ id, plan }) => (plan ? [id] : []))
    expect(Object.keys(alignment.lessons).toSorted()).toEqual(plans.toSorted())
    for (const shows of Object.values(alignment.lessons))
      expect(Object.keys(shows)).toEqual(expect.arrayContaining([...completeLanguages]))
  })

  it('has every competence once, by name in every language, numbered as its framework does, with a source', () => {
    expect(competences.size).toBe(alignment.competences.length)
    for (const { framework, ref, name } of alignment.competences) {
      expect(ref).toMatch(numbering[framework])
      expect(Object.keys(name)).toEqual(expect.arrayContaining([...completeLanguages]))
      expect(alignment.sources[framework]?.address).toMatch(/^https:/)
    }
  })

  it('was looked up, number by number, where the framework is published or quoted in full', () => {
    const places =
      /^https:\/\/(ai4k12\.org|github\.com\/touretzkyds\/ai4k12|doi\.org|unesdoc\.unesco\.org|rlp\.schule|igs-lengede\.de|brockhaus\.de)\//
    const at = alignment.competences.map(({ checked }) => (checked === 'not checked' ? checked : checked.at))
    expect(at.filter((one) => !places.test(one))).toEqual([])
  })

  it('refuses a competence that does not say where it was looked up', () => {
    const [{ checked: _, ...unmarked }, ...others] = alignment.competences as [
      (typeof alignment.competences)[0],
    ]
    expect(() => readAlignment({ ...alignment, competences: [unmarked, ...others] })).toThrow('checked')
  })
})

describe('what others made', () => {
  const references = content.references()
  const addresses = references.map(({ address }) => address)

  it('stands once in the list of references, with a mark', () => {
    expect(new Set(addresses).size).toBe(addresses.length)
    const [{ checked: _, ...unmarked }] = references as [(typeof references)[0]]
    expect(() => readReferences([unmarked])).toThrow('checked')
    expect(() => readReferences([{ ...unmarked, checked: 'surely' }])).toThrow()
  })

  it.each(completeLanguages)('is in that list wherever an item leads to it, in %s', (language) => {
    const links = content.items.flatMap(({ id }) =>
      [...nodesOf(itemText(id, language))].flatMap((node) =>
        node.type === 'link' && node.href.startsWith('https:') ? [node.href] : [],
      ),
    )
    expect(links.length).toBeGreaterThan(5)
    expect(links.filter((link) => !addresses.includes(link))).toEqual([])
  })
})
