import { readFileSync } from 'node:fs'
import { bestOf, pointsOf } from '@botgarten/learning/k-means'
import { stream } from '@botgarten/numbers'
import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { columnsOf, onPlane, rawOf, readThings, type ThingSet } from '../things/index.ts'
import { wordsIn } from './there.ts'

function rowsOf(set: ThingSet, counting: readonly string[]): number[][] {
  const columns = columnsOf(set, counting)
  return set.things.map((thing) => columns.map((column) => onPlane(rawOf(set, thing, column), column)))
}

describe.each(content.sets.map((set) => [set.id, set] as const))('the set %s', (_, set) => {
  it('has a picture of every thing', () => {
    for (const { id } of set.things)
      expect(readFileSync(content.pictureOf(set.id, id), 'utf8')).toMatch(/^<svg /)
    expect(new Set(set.things.map(({ id }) => id)).size).toBe(set.things.length)
  })

  it.each(completeLanguages)('has all its words in "%s"', (language) => {
    const sorting = wordsIn(language, 'sorting')
    const options = set.features.flatMap((feature) => (feature.kind === 'choice' ? feature.options : []))
    expect(sorting['set']?.[set.id]).toMatch(/\S/)
    for (const { id } of set.features) expect(sorting['feature']?.[id]).toMatch(/\S/)
    for (const option of options) expect(sorting['option']?.[option]).toMatch(/\S/)
    for (const { kind } of set.things) expect(sorting['kind']?.[kind]).toMatch(/\S/)
  })

  it('lies on the plane, whichever features count', () => {
    for (const { id } of set.features)
      for (const value of rowsOf(set, [id]).flat()) expect(value >= 0 && value <= 10).toBe(true)
  })

  it('falls into other groups by another criterion', () => {
    const groupings = set.features.map(({ id }) => {
      const points = pointsOf(rowsOf(set, [id]))
      const { labels } = bestOf(points, 2, {
        ...{ starts: 10, init: '++', distance: 'euclidean' },
        stream: stream(1, 'test'),
      })
      return labels.map((label) => (label === labels[0] ? 'a' : 'b')).join('')
    })
    expect(new Set(groupings).size).toBeGreaterThan(1)
  })
})

const vessel = (values: ThingSet['things'][number]['values']) => ({ id: 'x', kind: 'cup', values })
const set = readThings({
  id: 'few',
  features: [
    { id: 'width', kind: 'number', unit: 'cm' },
    { id: 'colour', kind: 'colour' },
    { id: 'material', kind: 'choice', options: ['glass', 'clay'] },
  ],
  things: [
    vessel({ width: 4, colour: '#FF0000', material: 'glass' }),
    vessel({ width: 6, colour: '#FF8000', material: 'clay' }),
    vessel({ width: 5, colour: '#000000', material: 'clay' }),
  ],
})

describe('what is compared', () => {
  it('numbers span the plane', () => expect(rowsOf(set, ['width'])).toEqual([[0], [10], [5]]))

  it('colours are their red, green and blue', () => {
    expect(rowsOf(set, ['colour'])[1]).toEqual([10, (128 / 255) * 10, 0])
  })

  it('unlike options are a plane apart', () => {
    const [glass, clay, alike] = rowsOf(set, ['material'])
    expect(Math.hypot(glass![0]! - clay![0]!, glass![1]! - clay![1]!)).toBeCloseTo(10, 9)
    expect(clay).toEqual(alike)
  })

  it('only what counts', () => {
    expect(rowsOf(set, []).flat()).toEqual([])
    expect(columnsOf(set, ['colour', 'width']).map(({ feature }) => feature)).toEqual([
      'width',
      'colour',
      'colour',
      'colour',
    ])
  })
})

it.each([
  [{ width: 4, colour: '#FF0000' }],
  [{ width: '4', colour: '#FF0000', material: 'glass' }],
  [{ width: 4, colour: 'red', material: 'glass' }],
  [{ width: 4, colour: '#FF0000', material: 'wood' }],
])('a thing that does not fit its set is refused: %j', (values) => {
  expect(() => readThings({ ...set, things: [vessel(values as never), ...set.things] })).toThrow('feature')
})
