// A thread of a race: is told one heat at a time and answers with the records of its runs.
import { parentPort } from 'node:worker_threads'
import type { Heat } from './race.ts'
import { runLane } from './run.ts'
import type { Race } from './types.ts'

parentPort!.on('message', ({ race, heat: { lane, runs } }: { readonly race: Race; readonly heat: Heat }) =>
  parentPort!.postMessage(runs.map((run) => runLane(race, lane, run))),
)
