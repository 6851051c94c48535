import type { Asked, Report } from './sleep.ts'

/** Who hears of a night. */
export interface Ears {
  readonly hear: (report: Report) => void
  /** Nothing more comes of it. */
  readonly fail: () => void
}

/** Lets a robot learn in a worker. Returns how to wake it up. */
export function inWorker(asked: Asked, { hear, fail }: Ears): () => void {
  try {
    const worker = new Worker(new URL('./night-worker.ts', import.meta.url), { type: 'module' })
    worker.onerror = worker.onmessageerror = () => {
      worker.terminate()
      fail()
    }
    worker.onmessage = ({ data }: MessageEvent<Report>) => {
      if (data.table) worker.terminate()
      hear(data)
    }
    worker.postMessage(asked)
    return () => worker.terminate()
  } catch {
    fail()
    return () => {}
  }
}
