import { inThreads } from '../threads.ts'
import type { Row, Work } from './row.ts'

/** Rows of all pieces of work, in their order, worked out by so many threads. `done` hears how many are ready. */
export const rowsOf = (
  all: readonly Work[],
  threads?: number,
  done?: (count: number) => void,
): Promise<Row[]> => inThreads(new URL('./worker.ts', import.meta.url), all, threads, done)
