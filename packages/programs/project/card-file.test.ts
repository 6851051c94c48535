import fc from 'fast-check'
import { describe, expect, it } from 'vitest'
import { pathsIn, replaced } from '../testing/paths.ts'
import { project as everyPart } from '../testing/every-part.ts'
import {
  parseCardFile,
  parseProject,
  playedFrom,
  ProjectError,
  writeCardFile,
  type OwnCard,
  type Project,
} from '../index.ts'

const hints = ['Look.', 'Turn.', 'Stop.'] as const
const text = { title: 'Meet the crate', story: 'Bo is alone.', task: 'Bo comes near.', hints }
const card: OwnCard = {
  text: { en: text, de: { ...text, title: 'Triff die Kiste' } },
  starts: [{ x: 50, y: 50, heading: 90 }],
  checks: [
    { id: 'near', kind: 'near', numbers: { obstacle: 'square', cm: 8 }, seconds: 0 },
    { id: 'safe', kind: 'neverTouches', numbers: { obstacle: 'square', until: 'near' }, seconds: 5 },
    { id: 'corners', kind: 'visits', numbers: { points: '10 20, 30.5 40', cm: 9 }, seconds: 0 },
    { id: 'says', kind: 'says', numbers: { colour: '#00642E', others: '#FFFFFF,#000000' }, seconds: 1 },
    { id: 'dark', kind: 'led', numbers: { colour: '#B30006', lamp: '' }, seconds: 1 },
  ],
  ...{ grades: [3, 6], minutes: 20, blocks: { level: 'plain', families: ['control', 'network'] } },
}
const { programs, brains, world, assets } = everyPart
const project: Project = { botgarten: 3, name: 'Mine', programs, brains, world, assets, ownCard: card }
const file = () => JSON.parse(writeCardFile(project)) as { [part: string]: unknown }

function reasonOf(data: unknown): string {
  try {
    parseCardFile(typeof data === 'string' ? data : JSON.stringify(data))
    return 'accepted'
  } catch (error) {
    if (error instanceof ProjectError) return error.reason
    throw error
  }
}
const withPart = (path: string, value: unknown) => reasonOf(replaced(file(), path.split('.'), value))

describe('the file of a card', () => {
  it('says what it is, and comes back the same', () => {
    expect(file()).toMatchObject({ botgarten: 'card', version: 1 })
    expect(parseCardFile(writeCardFile(project))).toEqual(project)
  })

  it('holds solution and wrong answers for colleagues, and for children neither', () => {
    const start = { programs, brains: {} }
    const wrong = [{ name: 'Too fast', programs, brains }]
    const draft: Project = { ...project, ownCard: { ...card, draft: true, start, wrong } }
    expect(playedFrom(draft).ownCard).toEqual(card)
    expect(playedFrom(draft).brains).toEqual({})
    const whole = playedFrom(draft, true)
    expect(whole.ownCard).toEqual({ ...card, solution: { programs, brains }, wrong })
    expect(parseCardFile(writeCardFile(whole))).toEqual(whole)
  })
})

describe('a card is refused, and a child is told why', () => {
  it.each([
    ['{', 'notJson'],
    ['null', 'notACard'],
    ['{"botgarten":1}', 'notACard'],
    ['{"botgarten":"card","version":2}', 'newerCard'],
    ['{"botgarten":"card","version":"1"}', 'notACard'],
    ['{"botgarten":"card","version":1}', 'notACard'],
    ['{"botgarten":"card","version":1,"__proto__":{"version":1}}', 'notACard'],
  ])('%s: %s', (text, reason) => expect(reasonOf(text)).toBe(reason))

  it.each<[what: string, path: string, value: unknown, reason: string]>([
    ['tags', 'card.text.en.story', 'Bo <img src=x onerror=alert(1)>', 'cardTags'],
    ['a tag that ends', 'card.text.en.hints.1', '</script >', 'cardTags'],
    ['a comment', 'card.text.en.title', '<!-- x', 'cardTags'],
    ['an unknown kind of check', 'card.checks.0.kind', 'explodes', 'cardCheck'],
    ['a word of every object as a kind', 'card.checks.0.kind', 'constructor', 'cardCheck'],
    ['a check about examples', 'card.checks.0.kind', 'learned', 'cardCheck'],
    ['a huge number', 'card.checks.0.numbers.cm', 1e300, 'cardNumbers'],
    ['a number below 0', 'card.checks.0.numbers.cm', -8, 'cardNumbers'],
    ['a number in words', 'card.checks.0.numbers.cm', '8', 'cardNumbers'],
    ['a thing that is not there', 'card.checks.0.numbers.obstacle', 'moon', 'cardNumbers'],
    ['a check that is not there', 'card.checks.1.numbers.until', 'never', 'cardNumbers'],
    ['places outside the world', 'card.checks.2.numbers.points', '10 20, 900 40', 'cardNumbers'],
    ['places that are none', 'card.checks.2.numbers.points', '10 20; drop table', 'cardNumbers'],
    ['a colour that no sensor knows', 'card.checks.4.numbers.colour', '#123456', 'cardNumbers'],
    ['a run of a day', 'card.checks.1.seconds', 86_400, 'cardNumbers'],
    ['more numbers than the kind has', 'card.checks.0.numbers.other', 1, 'cardNumbers'],
    ['a start outside the world', 'card.starts.0.x', 201, 'cardNumbers'],
    ['grades backwards', 'card.grades', [6, 3], 'cardNumbers'],
    ['no task', 'card.text.en.task', ' ', 'cardWords'],
    ['no words at all', 'card.text', {}, 'cardWords'],
    ['a language that is begun', 'card.text.de.hints.2', '', 'cardWords'],
    ['words that are a number', 'card.text.en.title', 7, 'cardWords'],
    ['no checks', 'card.checks', [], 'cardWords'],
    ['one id twice', 'card.checks.1.id', 'near', 'notACard'],
    ['a title longer than the paper', 'card.text.en.title', 'x'.repeat(41), 'notACard'],
    ['no places', 'card.starts', [], 'notACard'],
    ['a thousand places', 'card.starts', Array(1000).fill(card.starts[0]), 'notACard'],
    ['a family of blocks that is not there', 'card.blocks.families', ['bombs'], 'notACard'],
    ['a draft', 'card.draft', true, 'notACard'],
    ['a wrong answer without the robot’s program', 'card.wrong', [{ name: 'x', programs: {}, brains: {} }], 'notACard'],
    ['a picture from elsewhere', 'world.floor.asset', 'https://example.org/x.png', 'notACard'],
    ['a program that is none', 'programs.main', 'alert(1)', 'notACard'],
  ])('%s', (_, path, value, reason) => expect(withPart(path, value)).toBe(reason)) // prettier-ignore

  it.each([-1, 10_001, '5'])('a goal at x = %j, which is no place of any world', (x) => {
    const goal = { x, y: 20, cm: 9, after: '' }
    expect(withPart('card.checks.0', { id: 'near', kind: 'arrives', numbers: goal, seconds: 1 })).toBe(
      'cardNumbers',
    )
  })

  it.each(['__proto__', 'constructor', 'prototype'])('a key %s, wherever it is', (key) => {
    const whole = writeCardFile(project)
    for (const part of ['"numbers":{', '"text":{', '"brains":{', '"card":{'])
      expect(reasonOf(whole.replace(part, `${part}"${key}":{"x":1},`))).toBe('notACard')
  })

  it('a file of 6 MB', () => {
    expect(reasonOf(`{"botgarten":"card","version":1,"name":"${'x'.repeat(6_000_000)}"}`)).toBe('tooBig')
  })

  const paths = pathsIn(JSON.parse(writeCardFile(project))).filter(([name]) => name === 'card')
  const values = [
    null,
    0,
    -1,
    1e308,
    '',
    'x',
    '<b>',
    '__proto__',
    [],
    {},
    true,
    [[]],
    { x: 1 },
    '😀'.repeat(9000),
  ]

  it('whatever stands in it: it is refused as a card, or what it says is whole', () => {
    fc.assert(
      fc.property(fc.constantFrom(...paths), fc.constantFrom(...values), (path, value) => {
        const changed = JSON.stringify(replaced(file(), path, value))
        const reason = reasonOf(changed)
        expect(['accepted', 'notACard', 'cardTags', 'cardCheck', 'cardNumbers', 'cardWords']).toContain(
          reason,
        )
        if (reason === 'accepted') {
          const read = parseCardFile(changed)
          expect(parseCardFile(writeCardFile(read))).toEqual(read)
        }
      }),
      { numRuns: 500 },
    )
  })
})

it('a project keeps its card while somebody takes things out of its world', () => {
  const emptied = { ...project, world: { ...world, obstacles: [] } }
  expect(parseProject(emptied)).toEqual(emptied)
  expect(reasonOf(writeCardFile(emptied))).toBe('cardNumbers')
})
