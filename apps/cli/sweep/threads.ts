import { availableParallelism } from 'node:os'
import { Worker } from 'node:worker_threads'
import type { Setting } from './grid.ts'
import type { Job, Row } from './runs.ts'

/** Rows of all settings, in their order, worked out by so many threads. `done` hears how many are ready. */
export async function rowsOf(
  job: Job,
  settings: readonly Setting[],
  threads = availableParallelism(),
  done: (count: number) => void = () => undefined,
): Promise<Row[]> {
  const rows: Row[] = []
  let next = 0
  let ready = 0
  const work = () =>
    new Promise<void>((finished, failed) => {
      const worker = new Worker(new URL('./worker.ts', import.meta.url), { workerData: job })
      let mine = -1
      const give = () => {
        mine = next++
        if (mine < settings.length) worker.postMessage(settings[mine])
        else void worker.terminate().then(() => finished())
      }
      worker.on('error', failed)
      worker.on('message', (row: Row) => {
        rows[mine] = row
        done(++ready)
        give()
      })
      give()
    })
  await Promise.all(Array.from({ length: Math.min(threads, settings.length) }, work))
  return rows
}
