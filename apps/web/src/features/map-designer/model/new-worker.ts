/** Where roads are tried while hands go on. */
export const newWorker = (): Worker =>
  new Worker(new URL('./tries-worker.ts', import.meta.url), { type: 'module' })
