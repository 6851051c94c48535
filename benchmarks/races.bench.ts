import { content } from '@botgarten/content/files'
import type { Lane, Race } from '@botgarten/experiments/race'
import { raceInThreads } from '@botgarten/experiments/race/threads'
import { median, ms, type Table } from './bench.ts'

const setting = { alpha: 0.5, gamma: 0.8, nu: 0.1 }
const lanes: readonly Lane[] = [
  { racer: 'q', ...setting, rho: 0.1 },
  { racer: 'q', ...setting, rho: 0.5 },
  { racer: 'q', ...setting, rho: 0.9 },
  { racer: 'q', ...setting, alpha: 0.1, rho: 0.1 },
  { racer: 'sarsa', ...setting, rho: 0.1 },
  { racer: 'sarsa', ...setting, rho: 0.5 },
  { racer: 'best', ...setting, rho: 0 },
  { racer: 'random', ...setting, rho: 0 },
]

const race: Race = {
  task: { map: content.mapFile('city')!.map, start: 0, goal: 15, closed: [[16, 15]] },
  ...{ lanes, tries: 10_000, runs: 30, seed: 1 },
}

interface Measured {
  readonly wall: number
  /** Of all threads together. */
  readonly processor: number
  readonly moves: number
}

async function measure(): Promise<Measured> {
  const [started, before] = [performance.now(), process.cpuUsage()]
  const results = await raceInThreads(race, 2)
  const { user, system } = process.cpuUsage(before)
  return {
    wall: performance.now() - started,
    processor: (user + system) / 1000,
    moves: results.reduce((sum, { bill, runs }) => sum + bill.moves * runs, 0),
  }
}

/** A race of eight on the City: how long its numbers take with two workers, curves, bands, ways and bills included. */
export default async function races(): Promise<Table> {
  const rounds: Measured[] = []
  for (let round = 0; round < 5; round++) rounds.push(await measure())
  const of = (name: keyof Measured) => median(rounds.map((round) => round[name]))
  return {
    title: 'A race of eight on the City',
    how: 'Eight learners, 30 runs of each, 10,000 tries a run; two workers; medians of five races.',
    columns: ['what', 'value', 'goal'],
    rows: [
      ['from start to the last number', ms(of('wall')), '≤ 2 s'],
      ['processor time of both workers', ms(of('processor')), '≤ 4 s'],
      ['half of it: two cores with nothing else to do', ms(of('processor') / 2), '≤ 2 s'],
      ['moves', `${(of('moves') / 1e6).toFixed(1)} M`, ''],
    ],
    notes: [
      'α 0.5, γ 0.8, ν 0.1: Q with ρ 0.1, 0.5, 0.9 and with α 0.1; SARSA with ρ 0.1, 0.5; always the best; dice alone.',
      'The first line also has what else the machine does; processor time has the start of two threads.',
    ],
  }
}
