import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { afterAll, describe, expect, it } from 'vitest'
import { cardDocument } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { withWeights } from './weights.ts'
import { speak } from './words.ts'

const folder = mkdtempSync(join(tmpdir(), 'botgarten-weights-'))
afterAll(() => rmSync(folder, { recursive: true }))
speak('en')

let files = 0
function file(value: unknown): string {
  const path = join(folder, `${++files}.json`)
  writeFileSync(path, typeof value === 'string' ? value : JSON.stringify(value))
  return path
}

function opened(id: string, file: 'start' | 'solution' = 'start') {
  const { card, world } = content.card(id)!
  return cardDocument(world, card, content.program(id, file)!, 0)
}

const cards = content.cards.flatMap(({ id }) => {
  const [brain] = Object.values(content.program(id, 'solution')!.brains)
  return brain ? [{ id, weights: brain.weights }] : []
})

const whole = { eyeLeft: { wheelLeft: 1, wheelRight: 0 }, eyeRight: { wheelLeft: 0, wheelRight: 1 } }

describe('weights from a file', () => {
  it.each(cards)('$id takes those of its solution', ({ id, weights }) => {
    const [brain] = Object.values(withWeights(opened(id, 'solution'), file(weights)).brains)
    expect(brain!.weights).toEqual(weights)
  })

  it('a net with a hidden layer is among them', () => {
    expect(cards.find(({ id }) => id === 'either-or')?.weights).toHaveProperty(['hidden#1', 'lampGreen'])
  })

  it('biases may be set, and need not be', () => {
    const { brains } = withWeights(opened('friendship'), file({ ...whole, '#bias': { wheelLeft: 20 } }))
    expect(Object.values(brains)[0]!.weights['#bias']).toEqual({ wheelLeft: 20 })
  })

  it.each([
    [
      'half of them',
      { eyeLeft: { wheelLeft: 0.8 }, eyeRight: { wheelRight: 0.8 } },
      'does not name eyeLeft→wheelRight, eyeRight→wheelLeft. Write 0',
    ],
    [
      'those of another net',
      { ...whole, nose: { wheelLeft: 1 } },
      'names nose→wheelLeft, which the network does not have. Its links: eyeLeft→wheelLeft, eyeLeft→wheelRight,',
    ],
    ['a bias of an input', { ...whole, '#bias': { eyeLeft: 1 } }, 'names #bias→eyeLeft, which'],
    [
      'a link between outputs',
      { ...whole, wheelLeft: { wheelRight: 1 } },
      'names wheelLeft→wheelRight, which',
    ],
    ['words', { eyeLeft: { wheelLeft: 'big' } }, 'the weight of eyeLeft→wheelLeft is not a number'],
    [
      'a number beyond all numbers',
      '{"eyeLeft":{"wheelLeft":1e999}}',
      'the weight of eyeLeft→wheelLeft is not a number',
    ],
    ['a list', [1, 2], 'does not hold weights such as {"eyeLeft"'],
    ['names of every object', '{"__proto__":{"wheelLeft":1}}', 'names __proto__→wheelLeft, which'],
    ['no JSON', '{"eyeLeft"', 'cannot be read: it is not JSON'],
  ])('%s: refused by name', (_, content, sentence) => {
    expect(() => withWeights(opened('friendship'), file(content))).toThrow(sentence)
  })

  it('a long list of links ends with how many more there are', () => {
    const many = Object.fromEntries(Array.from({ length: 90 }, (_, index) => [`n${index}`, { wheelLeft: 1 }]))
    expect(() => withWeights(opened('friendship'), file({ ...whole, ...many }))).toThrow(
      'n5→wheelLeft and 84 more',
    )
  })

  it('a program without a network takes none', () => {
    expect(() => withWeights(opened('forward'), file(whole))).toThrow('no network')
  })
})
