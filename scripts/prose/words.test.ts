import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, it } from 'vitest'
import { inHouse } from '../prepare/house.mjs'
import { passagesOf, type Passage } from './passages.ts'
import { matchesIn, matchesOf, rows, wordsIn } from './words.ts'

const passage = (text: string): Passage => ({ line: 1, text })
const rulesFor = (text: string) => matchesIn(passage(text), 'comments').map(({ rule }) => rule)

/** Comments drawn from other code, see `source` in the file. */
const sample = (name: string): Passage[] => {
  const file = inHouse('scripts', 'prose', 'testing', `${name}.json`)
  return (JSON.parse(readFileSync(file, 'utf8')) as { comments: string[] }).comments.map(passage)
}

/** The comments that Kysely publishes: its declarations and its modules. */
function kysely(): Passage[] {
  const folder = inHouse('node_modules', 'kysely', 'dist', 'esm')
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((path) => /\.(d\.ts|js)$/.test(path))
    .flatMap((path) => passagesOf(path, readFileSync(join(folder, path), 'utf8')))
}

const sum = (numbers: readonly number[]) => numbers.reduce((all, one) => all + one, 0)

/** Matches in 1,000 words. */
const rate = (passages: readonly Passage[]) =>
  (1000 * sum(passages.map((one) => matchesIn(one, 'comments').length))) / sum(passages.map(wordsIn))

describe('the rows of words.json', () => {
  it.each(rows)('$name: finds its example', ({ name, example }) => {
    expect(rulesFor(example)).toContain(name)
  })

  it.each(rows)('$name: accepts its counter-example', ({ name, counterExample }) => {
    expect(rulesFor(counterExample)).not.toContain(name)
  })

  it('have a name each', () => {
    expect(new Set(rows.map(({ name }) => name)).size).toBe(rows.length)
  })
})

describe('matches', () => {
  it('are found across lines, on the line of their first word', () => {
    expect(matchesOf('a.ts', 'let a\n// Loaded by\n// a tab; thrown\n// away later.')).toEqual([
      expect.objectContaining({ rule: 'thrown away', phrase: 'thrown\n away', line: 3 }),
    ])
  })

  it('are not counted in strings, code and names', () => {
    expect(matchesOf('a.ts', "const whatIsKept = 'somebody has thrown it away' // `somebody`")).toEqual([])
  })
})

describe('the rows together', () => {
  it('find at least 30 phrases per 1,000 words in the comments of Botgarten as they were', () => {
    expect(rate(sample('botgarten'))).toBeGreaterThanOrEqual(30)
  })

  it('find at most 0.3 phrases per 1,000 words in the comments of Kysely', () => {
    const passages = kysely()
    expect(sum(passages.map(wordsIn))).toBeGreaterThan(40_000)
    expect(rate(passages)).toBeLessThanOrEqual(0.3)
  })

  it('find at most 0.3 phrases per 1,000 words in the comments of Hono', () => {
    expect(rate(sample('hono'))).toBeLessThanOrEqual(0.3)
  })
})
