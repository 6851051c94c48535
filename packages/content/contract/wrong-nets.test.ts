import { weightOf, type Brain } from '@botgarten/learning/neural-network/brain'
import { sample } from '@botgarten/numbers/testing'
import { describe, expect, it } from 'vitest'
import type { CardProgram } from '../index.ts'
import { networkCards, solved } from './solved.ts'

// What children try first: every knob at 0, every knob at 1, everything the wrong way round.
const everywhere = (brain: Brain, weight: number) => changed(brain, (row) => row.map(() => weight))
const mirrored = (brain: Brain) => changed(brain, (row) => row.toReversed())

/** The brain with other numbers at each neuron's links to the layer behind it, in the order of that layer. */
function changed(brain: Brain, change: (row: readonly number[], from: string) => readonly number[]): Brain {
  const rows = brain.layers.slice(0, -1).flatMap((layer, at) =>
    layer.map(({ id }) => {
      const behind = brain.layers[at + 1]!
      const numbers = change(
        behind.map((to) => weightOf(brain.weights, id, to.id)),
        id,
      )
      return [id, Object.fromEntries(behind.map((to, k) => [to.id, numbers[k]!]))] as const
    }),
  )
  return { ...brain, weights: Object.fromEntries(rows) }
}

const wrongs: readonly (readonly [string, (brain: Brain) => Brain])[] = [
  ['all 0', (brain) => everywhere(brain, 0)],
  ['all 1', (brain) => everywhere(brain, 1)],
  ['mirrored', mirrored],
]

const withBrain = (change: (brain: Brain) => Brain) => (program: CardProgram) => ({
  ...program,
  brains: Object.fromEntries(Object.entries(program.brains).map(([id, brain]) => [id, change(brain)])),
})

/** Where it is right after all, and why. */
const right: { readonly [card: string]: { readonly [wrong: string]: string } } = {
  incognito: { 'all 1': 'both wheels get the same', mirrored: 'both wheels get the same' },
  caution: { mirrored: 'both wheels get the same' },
  'loud-distance': { 'all 1': 'there is one link', mirrored: 'there is one link' },
  interest: { mirrored: 'each colour still has a word of its own' },
  'either-or': { mirrored: 'the hidden neurons change places' },
  dodge: { mirrored: 'it still turns away before a wall, where it meets it from one side' },
}

/** Start poses from which what is right elsewhere is wrong. */
const wrongFrom: { readonly [card: string]: { readonly [wrong: string]: readonly number[] } } = {
  dodge: { mirrored: [1, 3] },
}

// Nets of the first robot: "if, then" has none.
const withNets = networkCards.filter((id) => solved(id).card.playground === 'network')

describe.each(withNets)('%s', (id) => {
  const { card } = solved(id)
  const starts = sample([...card.starts.keys()], 1)

  it.each(wrongs)('%s is refused from some start pose, unless it is right', (name, change) => {
    const { failures } = solved(id, withBrain(change))
    const refused = starts.filter((start) => failures(start, 1, {}).length > 0)
    const asked = wrongFrom[card.id]?.[name] ?? []
    if (right[card.id]?.[name]) expect(refused).toEqual(asked.filter((start) => starts.includes(start)))
    else expect(refused).toContain(0)
  })

  it('all 0 is refused from every start pose', () => {
    const { failures } = solved(
      id,
      withBrain((brain) => everywhere(brain, 0)),
    )
    expect(starts.filter((start) => failures(start, 1, {}).length === 0)).toEqual([])
  })
})

describe('Fear asks that the eyes decide', () => {
  const starts = solved('fear').card.starts.map((_, start) => start)
  const passing = (change: (brain: Brain) => Brain) => {
    const { failures } = solved('fear', withBrain(change))
    return starts.filter((start) => failures(start, 1, {}).length === 0)
  }

  // Each of these passes one of the start poses, the first pair all three, where only the way is looked at.
  const pairs = [
    [0.5, 0.6],
    [0.5, 0.4],
    [0.4, 0.5],
    [0.6, 0.3],
    [0.4, 0.45],
  ]
  it.each(sample(pairs, 1))(
    'both eyes alike, %d and %d, only ever turn Bo to one side: refused from every start pose',
    (...pair) => {
      expect(passing((brain) => changed(brain, () => pair))).toEqual([])
    },
  )

  it.each(['eyeLeft', 'eyeRight'])('so does %s alone', (eye) => {
    const alone = (brain: Brain) => changed(brain, (_, from) => (from === eye ? [0.4, 0.6] : [0, 0]))
    expect(passing(alone)).toEqual([])
  })

  it.each(sample([0.5, 0.7, 0.9], 1))(
    'crossed links of %d each are right from every start pose',
    (weight) => {
      const crossed = (brain: Brain) =>
        changed(brain, (_, from) => (from === 'eyeLeft' ? [0, weight] : [weight, 0]))
      expect(passing(crossed)).toEqual(starts)
    },
  )
})

it('the Rally drives its whole course from each start: every gate, and never white', () => {
  const { card, failures } = solved('rally')
  const lap = card.checks.find(({ kind }) => kind === 'laps')!
  expect(String(lap.numbers['gates']).split(',')).toHaveLength(8)
  expect(card.starts.map((_, start) => failures(start, 1, {}))).toEqual([[], [], []])
})
