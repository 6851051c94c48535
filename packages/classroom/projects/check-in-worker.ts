import { Worker } from 'node:worker_threads'
import type { Checked, CheckProject } from './checked.ts'

/** A project of 5 MB takes a fraction of it on a Raspberry Pi. */
const longest = 5000

interface Answer {
  readonly id: number
  readonly checked: Checked | { readonly refused: string }
}

export interface Checker {
  readonly check: CheckProject
  readonly close: () => Promise<void>
}

interface Running {
  readonly worker: Worker
  /** It has loaded the parser: its time does not count. */
  readonly ready: Promise<unknown>
}

function startWorker(): Running {
  const worker = new Worker(new URL('./check-worker.ts', import.meta.url), {
    resourceLimits: { maxOldGenerationSizeMb: 192, maxYoungGenerationSizeMb: 4 },
  })
  // It does not keep the process running.
  worker.unref()
  return { worker, ready: new Promise((resolve) => worker.once('message', resolve)) }
}

/** What the worker answers; null where it broke or took too long. */
function asked(worker: Worker, question: { id: number; text: string }, limit: number) {
  return new Promise<Answer['checked'] | 'tooLong' | 'broken'>((resolve) => {
    const timer = AbortSignal.timeout(limit)
    const end = (result: Answer['checked'] | 'tooLong' | 'broken') => {
      timer.removeEventListener('abort', tooLong)
      worker.off('message', hear)
      worker.off('error', broken)
      resolve(result)
    }
    const hear = ({ id, checked }: Answer) => id === question.id && end(checked)
    const tooLong = () => end('tooLong')
    const broken = () => end('broken')
    timer.addEventListener('abort', tooLong)
    worker.on('message', hear)
    worker.on('error', broken)
    worker.postMessage(question)
  })
}

/** One worker that checks one project after the other; one that takes too long is refused, and the worker restarted. */
export function checkInWorker(limit = longest): Checker {
  let running: Running | null = null
  let last: Promise<unknown> = Promise.resolve()
  let count = 0

  async function once(text: string): Promise<Answer['checked']> {
    running ??= startWorker()
    const { worker, ready } = running
    await ready
    const answer = await asked(worker, { id: ++count, text }, limit)
    if (answer !== 'tooLong' && answer !== 'broken') return answer
    running = null
    await worker.terminate()
    // What broke it took more memory than a project may.
    return { refused: answer === 'broken' ? 'tooBig' : answer }
  }

  const check: CheckProject = (text) => {
    const next = last.then(() => once(text))
    last = next
    return next
  }
  return { check, close: async () => void (await running?.worker.terminate()) }
}
