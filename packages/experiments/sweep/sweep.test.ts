import { gridMap } from '@botgarten/learning/q-learning'
import { describe, expect, it } from 'vitest'
import { csvOf, decayOf, pieceOf, rowsOf, settingsOf, thesisWork, type Job } from './index.ts'
import { rowOf } from './row.ts'

const { map, start, goal } = gridMap(['SFF', 'FWF', 'FFG'])
const job: Job = {
  task: { map, start: start, goal: goal, closed: [] },
  ...{ rules: 'standard', algorithm: 'q', moves: 400, episodes: 40, runs: 3, seed: 1 },
}
const settings = settingsOf({ alpha: [0.3, 0.5], gamma: [0.8], nu: [0.1], rho: [0.2, 0.9] })

describe('the settings of a sweep', () => {
  it('are all combinations, and the last list turns fastest', () => {
    expect(settings.map(({ alpha, rho }) => [alpha, rho])).toEqual([
      [0.3, 0.2],
      [0.3, 0.9],
      [0.5, 0.2],
      [0.5, 0.9],
    ])
  })

  it('name a decay only where there is one', () => {
    const one = { alpha: [1], gamma: [1], nu: [1], rho: [1] }
    const [constant, visits] = settingsOf({ ...one, alphaDecay: ['', 'visits'] })
    expect(Object.keys(constant!)).toEqual(['alpha', 'gamma', 'nu', 'rho'])
    expect(visits).toEqual({ ...constant, alphaDecay: 'visits' })
    expect([undefined, 'visits', '0.9'].map(decayOf)).toEqual([
      { kind: 'constant' },
      { kind: 'visits' },
      { kind: 'episodes', factor: 0.9 },
    ])
  })
})

describe('the rows of a sweep', () => {
  it('are the same on one thread, on two, and without any', async () => {
    const work = settings.map((setting) => ({ job, setting }))
    const done: number[] = []
    const rows = await rowsOf(work, 2, (count) => done.push(count))
    expect(rows).toEqual(settings.map((setting) => rowOf(job, setting)))
    expect(rows).toEqual(await rowsOf(work, 1))
    expect(done).toEqual([1, 2, 3, 4])
  })

  it('say what was found: every run finds the way of five stations on so small a grid', () => {
    const row = rowOf(job, settings[2]!)
    expect(row).toMatchObject({ runs: 3, foundShortest: 3, shortestAtEnd: 3, anyAtEnd: 3, learnedAtEnd: 3 })
    expect(row.medianFirst).toBeGreaterThanOrEqual(4)
  })

  it('of the parts, joined, are the whole table', () => {
    const rows = settings.map((setting) => rowOf(job, setting))
    const parts = [1, 2, 3].map((part) => csvOf(pieceOf(rows, { part, parts: 3 }), { part, parts: 3 }))
    expect(parts.join('')).toBe(csvOf(rows, { part: 1, parts: 1 }))
    expect(parts.join('').split('\n')[0]).toMatch(/^alpha,gamma,nu,rho,/)
    const cells = parts.map((part) =>
      part
        .trim()
        .split('\n')
        .map((line) => line.split(',').length),
    )
    // Six settings and nine results.
    expect(new Set(cells.flat())).toEqual(new Set([6 + 9]))
  })
})

describe('the grid of the thesis', () => {
  it('is 225 settings on each of three maps', () => {
    const work = thesisWork(() => map, { runs: 50, seed: 1 })
    expect(work).toHaveLength(675)
    expect(new Set(work.map((one) => one.map))).toEqual(new Set(['railway', 'forest', 'city']))
  })
})
