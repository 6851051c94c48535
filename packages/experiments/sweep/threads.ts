import { availableParallelism } from 'node:os'
import { Worker } from 'node:worker_threads'
import type { Row, Work } from './row.ts'

/** Rows of all pieces of work, in their order, worked out by so many threads. `done` hears how many are ready. */
export async function rowsOf(
  all: readonly Work[],
  threads = availableParallelism(),
  done: (count: number) => void = () => undefined,
): Promise<Row[]> {
  const rows: Row[] = []
  let next = 0
  let ready = 0
  const work = () =>
    new Promise<void>((finished, failed) => {
      const worker = new Worker(new URL('./worker.ts', import.meta.url))
      let mine = -1
      const give = () => {
        mine = next++
        if (mine < all.length) worker.postMessage(all[mine])
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
  await Promise.all(Array.from({ length: Math.min(threads, all.length) }, work))
  return rows
}
