import { fork } from 'node:child_process'
import { fileURLToPath } from 'node:url'
import type { Traced } from './worker.ts'

/** A file that has not waited for so long never does. */
const patience = 2000

type Report = { readonly begun: number } | Traced

/**
 * What files told the robot, each in MicroPython; null for a file that never waits: its worker is ended.
 * @param ticks simulated time of a run
 */
export async function tracesOf(texts: readonly string[], ticks = 400): Promise<readonly (Traced | null)[]> {
  const traces: (Traced | null)[] = []
  while (traces.length < texts.length) {
    const stuck = await runFrom(
      { texts, from: traces.length, ticks },
      (trace) => void (traces[trace.index] = trace),
    )
    if (stuck !== null) traces[stuck] = null
  }
  return traces
}

/** Runs files from one on; gives the index of the one that never waits, null at the end. */
function runFrom(
  task: { readonly texts: readonly string[]; readonly from: number; readonly ticks: number },
  take: (trace: Traced) => void,
): Promise<number | null> {
  const worker = fork(fileURLToPath(new URL('./worker.ts', import.meta.url)), { execArgv: [] })
  worker.send(task)
  return new Promise((resolve, reject) => {
    let timer: ReturnType<typeof setTimeout> | undefined
    const end = (result: number | null) => {
      clearTimeout(timer)
      worker.once('exit', () => resolve(result)).kill('SIGKILL')
    }
    worker.on('error', reject)
    worker.on('message', (report: Report) => {
      clearTimeout(timer)
      if ('begun' in report) timer = setTimeout(() => end(report.begun), patience)
      else take(report)
      if ('index' in report && report.index === task.texts.length - 1) end(null)
    })
  })
}
