import { Worker } from 'node:worker_threads'
import type { Checked, CheckProject } from './checked.ts'
import { FairQueue, type Turn } from '../fair-queue.ts'

/** A project of 5 MB takes a fraction of it on a Raspberry Pi. */
const longest = 5000
/** Longer texts are checked by a worker of their own: a program of 5 MB takes half a second, and small ones do not wait for it. */
const large = 1_000_000
/** Ms after its last project until that worker is stopped: it takes some 30 MB. */
const idle = 60_000

/** Of projects that no pupil sends. */
const ofTeacher: Turn = { class: '', pupil: '' }

interface Answer {
  readonly id: number
  readonly checked: Checked | { readonly refused: string }
}

export interface Checker {
  readonly check: CheckProject
  readonly close: () => Promise<void>
}

type Size = 'small' | 'large'

interface Running {
  readonly worker: Worker
  /** It has loaded the parser: its time does not count. */
  readonly ready: Promise<unknown>
}

function startWorker(size: Size): Running {
  const worker = new Worker(new URL('./check-worker.ts', import.meta.url), {
    workerData: size,
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

interface Lane {
  readonly check: (text: string, turn: Turn) => Promise<Answer['checked']>
  readonly close: () => Promise<void>
}

/**
 * One worker that checks one project after the other; one that takes too long is refused, and the worker restarted. The worker
 * for large projects stops after a minute without one.
 * @param limit of one project, ms
 */
function laneOf(size: Size, limit: number): Lane {
  const queue = new FairQueue()
  let running: Running | null = null
  let count = 0

  async function stop() {
    const worker = running?.worker
    running = null
    await worker?.terminate()
  }

  async function once(text: string): Promise<Answer['checked']> {
    const id = ++count
    running ??= startWorker(size)
    const { worker, ready } = running
    await ready
    const answer = await asked(worker, { id, text }, limit)
    if (size === 'large')
      AbortSignal.timeout(idle).addEventListener('abort', () => void (count === id && stop()))
    if (answer !== 'tooLong' && answer !== 'broken') return answer
    await stop()
    // What broke it took more memory than a project may.
    return { refused: answer === 'broken' ? 'tooBig' : answer }
  }

  return { check: (text, turn) => queue.run(turn, () => once(text)), close: stop }
}

/** Checks projects in workers: small ones in one, large ones in another. In each of them classes take turns. */
export function checkInWorker(limit = longest): Checker {
  const lanes = { small: laneOf('small', limit), large: laneOf('large', limit) }
  return {
    check: (text, turn = ofTeacher) => lanes[text.length > large ? 'large' : 'small'].check(text, turn),
    close: async () => {
      await Promise.all([lanes.small.close(), lanes.large.close()])
    },
  }
}
