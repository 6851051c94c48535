import { heatsOf, resultOf, type LaneResult, type Race, type RunRecord } from '@botgarten/experiments/race'
import { newWorker } from './new-worker.ts'
import type { Answered, Asked } from './worker.ts'

/** Number of workers: a school laptop has two free cores. */
const WORKERS = 2

/** Two workers that share the heats of a race. One race at a time. */
export class Runners {
  #workers: readonly Worker[] = []

  /** @param done is called with the finished share of the race, 0..1 */
  run(race: Race, done: (share: number) => void): Promise<readonly LaneResult[]> {
    this.close()
    const heats = [...heatsOf(race)]
    const all = heats.length
    const records = race.lanes.map(() => [] as RunRecord[])
    let ready = 0
    return new Promise((resolve) => {
      const give = (worker: Worker) => {
        const heat = heats.shift()
        if (heat) worker.postMessage({ race, heat } satisfies Asked)
      }
      this.#workers = Array.from({ length: WORKERS }, () => {
        const worker = newWorker()
        worker.onmessage = ({ data: { heat, records: some } }: MessageEvent<Answered>) => {
          heat.runs.forEach((run, index) => (records[heat.lane - 1]![run - 1] = some[index]!))
          done(++ready / all)
          give(worker)
          if (ready === all) resolve(records.map((lane) => resultOf(lane, race.tries)))
        }
        give(worker)
        return worker
      })
    })
  }

  /** Ends the workers. The promise of a race that is still running stays pending. */
  close(): void {
    for (const worker of this.#workers) worker.terminate()
    this.#workers = []
  }
}
