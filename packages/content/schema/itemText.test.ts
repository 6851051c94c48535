import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { missingIn, type Nameable } from '../items/resolve.ts'
import { shapeOf } from '../items/walk.ts'
import { readItem } from './item.ts'
import { readItemText } from './itemText.ts'

const words = `# Wege

Vorher.

## Erste Folie

- eins
- **zwei**

::map{id=railway start=3 goal=1 closed=3-2,2-3}
::lines{count=2}

### Notes

Nur für dich.

## Zweite Folie

| Von | Nach |
| --- | --- |
| 3 | |

[Mehr](item:q-flow) und ![ein Bild](bild.svg)
`

const there: Nameable = {
  items: new Set(['q-flow']),
  cards: new Map([
    [
      'friendship',
      {
        ...{
          playground: 'network',
          starts: 3,
          files: new Set(['start', 'wrong/a']),
          nets: new Set(['start']),
        },
        blocks: new Map([['start', new Set(['forever'])]]),
      },
    ],
  ]),
  maps: new Map([['railway', { stations: 6, roads: new Set(['3-2', '2-3']) }]]),
  worlds: new Set(['rally']),
  sets: new Set(['vessels']),
  blocks: new Set(['ai_neural_network']),
  courses: new Set(['garden']),
  cages: new Set(['spinner']),
  questions: new Map([[2, new Set(['all-zero'])]]),
}

const missing = (embed: string) => missingIn(readItemText(`# Titel\n\n${embed}\n`), there, new Set())

describe('the words of an item', () => {
  it('are a title, what stands before the first slide, and slides with their notes', () => {
    const { title, lead, sections } = readItemText(words)
    expect([title, lead.length, sections.map((one) => one.title)]).toEqual([
      'Wege',
      1,
      ['Erste Folie', 'Zweite Folie'],
    ])
    expect(sections.map(({ notes }) => notes.length)).toEqual([1, 0])
    expect(sections[0]!.body.map(({ type }) => type)).toEqual(['list', 'embed', 'embed'])
  })

  it('hold embeds with their values as what they are', () => {
    const { body } = readItemText(words).sections[0]!
    expect(body[1]).toEqual({
      type: 'embed',
      embed: { kind: 'map', id: 'railway', start: 3, goal: 1, closed: ['3-2', '2-3'] },
    })
  })

  it('hold tables whose cells can be empty', () => {
    const [table] = readItemText(words).sections[1]!.body
    expect(table).toEqual({
      type: 'table',
      head: [[{ type: 'text', value: 'Von' }], [{ type: 'text', value: 'Nach' }]],
      rows: [[[{ type: 'text', value: '3' }], []]],
    })
  })

  it('have a shape that does not depend on the language, only on what stands there', () => {
    const english = words.replace('Vorher.', 'Before.').replace('eins', 'one').replace('Von', 'From')
    expect(shapeOf(readItemText(english))).toEqual(shapeOf(readItemText(words)))
    expect(shapeOf(readItemText(words.replace('- eins\n', '')))).not.toEqual(shapeOf(readItemText(words)))
  })

  it.each([
    ['Kein Titel', /first line/],
    ['# T\n\n::fly{id=a}', /Line 3.*fly/],
    ['# T\n\n::flow{id=k-means}', /Line 3.*q-learning/],
    ['# T\n\n::map{railway}', /Line 3.*must be "name=value"/],
    ['# T\n\n::map{id=railway start=drei}', /Line 3.*start/],
    ['# T\n\n::map{id=railway size=3}', /Line 3.*size/],
    ['# T\n\n::net{card=a file=../b}', /Line 3.*file/],
    ['# T\n\n| a | b |\n| --- | --- |\n| 1 |', /Line 3.*equally many/],
    ['# T\n\n| a |\n| 1 |', /Line 3.*---/],
    ['# T\n\n<script>', /Line 3.*not allowed/],
    ['# T\n\n[x](http://example.org)', /Line 3.*https/],
    ['# T\n\n[x](javascript:a)', /Line 3.*https/],
  ])('that are "%s" are refused with the place', (text, message) => {
    expect(() => readItemText(text)).toThrow(message)
  })

  it('never break the reader, whatever is written', () => {
    const line = fc.oneof(
      fc.string(),
      fc.constantFrom('::map{id=a}', '| a |', '| --- |', '## b', '### Notes', '- c', '> d', '::x{', '```'),
    )
    fc.assert(
      fc.property(fc.array(line), (lines) => {
        try {
          readItemText(['# T', ...lines].join('\n'))
        } catch (error) {
          expect(error).toBeInstanceOf(SyntaxError)
        }
      }),
      { seed: 9 },
    )
  })
})

describe('what an item names and is not there', () => {
  it.each([
    ['::net{card=friends}', 'There is no card "friends".'],
    ['::net{card=friendship file=wrong/b}', 'The card "friendship" has no "wrong/b".'],
    ['::net{card=friendship file=wrong/a}', '"wrong/a" of "friendship" has no network.'],
    ['::program{card=friendship file=solution}', 'The card "friendship" has no "solution".'],
    ['::program{card=friendship only=halt}', '"start" of "friendship" has no block "halt".'],
    ['::program{card=friendship fold=halt}', '"start" of "friendship" has no block "halt".'],
    ['::robot{card=friends view=above}', 'There is no card "friends".'],
    ['::way{card=friendship}', 'The card "friendship" learns no way.'],
    ['::scene{card=friendship start=3}', 'The card "friendship" has no start pose 3.'],
    ['::map{id=moon}', 'There is no map "moon".'],
    ['::map{id=railway start=6}', '"railway" has no station 6.'],
    ['::map{id=railway closed=3-1}', '"railway" has no road 3-1.'],
    ['::world{id=moon}', 'There is no world "moon".'],
    ['::sort{set=spoons}', 'There is no set "spoons".'],
    ['::block{type=fly}', 'There is no block "fly".'],
    ['::race{course=moon}', 'There is no course "moon".'],
    ['::senses{show=poster only=spinner,unicorn}', 'There is no cage "unicorn".'],
    ['::questions{module=3}', 'Module 3 has no questions.'],
    ['::questions{module=2 only=all-zero,nobody}', 'Module 2 has no question "nobody".'],
    ['::qr{to=card:friends}', 'There is no card "friends".'],
    ['[x](item:nothing)', 'There is no item "nothing".'],
    ['![](a.svg)', 'The picture "a.svg" has no words.'],
    ['![a](a.svg)', 'There is no picture "a.svg".'],
  ])('%s is named', (embed, sentence) => expect(missing(embed)).toContain(sentence))

  it('is nothing where all is there', () => {
    expect(
      missing('::net{card=friendship}\n::map{id=railway start=5}\n::things{set=vessels cut=yes}'),
    ).toEqual([])
    expect(
      missing('::program{card=friendship only=forever}\n::program{card=friendship fold=forever}'),
    ).toEqual([])
  })
})

describe('item.json', () => {
  const good = {
    ...{ id: 'a', kind: 'sheet', audience: 'pupils', grades: [3, 4], minutes: 5, way: 'all' },
    ...{ social: 'alone', module: 0, paper: 'a4', competences: ['x'], unplugged: true },
  }

  it('is read', () => expect(readItem(good)).toEqual(good))

  it.each([
    ['kind', 'song'],
    ['grades', [5, 4]],
    // The longest way through school has 13 grades.
    ['grades', [3, 14]],
    ['competences', []],
    ['paper', 'a3'],
    ['module', 5],
    ['harder', { de: { upTo: 9, reason: 'so' } }],
    ['colour', 'red'],
  ])('is refused with %s %j', (key, value) => {
    expect(() => readItem({ ...good, [key]: value })).toThrow()
  })
})
