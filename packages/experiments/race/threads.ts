import { inThreads } from '../threads.ts'
import { heatsOf } from './race.ts'
import { refuseLanes } from './refuse.ts'
import { resultOf } from './result.ts'
import type { LaneResult, Race, RunRecord } from './types.ts'

/** `raceOf`, worked out by so many threads. `done` hears how many of how many parts are ready. */
export async function raceInThreads(
  race: Race,
  threads?: number,
  done: (count: number, all: number) => void = () => undefined,
): Promise<readonly LaneResult[]> {
  refuseLanes(race)
  const heats = heatsOf(race)
  const records = await inThreads<{ race: Race; heat: (typeof heats)[number] }, RunRecord[]>(
    new URL('./worker.ts', import.meta.url),
    heats.map((heat) => ({ race, heat })),
    threads,
    (count) => done(count, heats.length),
  )
  return race.lanes.map((_, index) =>
    resultOf(
      heats.flatMap(({ lane }, heat) => (lane === index + 1 ? records[heat]! : [])),
      race.tries,
    ),
  )
}
