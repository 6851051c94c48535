import { fork, type ChildProcess } from 'node:child_process'
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Answer, Request } from './runner.ts'

/** Reading all code until the first test ends takes at most so long, ms. */
const STARTS = 240_000
/** Between two ends of tests, ms. A fault that takes longer is an endless loop, since a test itself may take 60 s. */
const SILENT = 150_000

/** A warm Vitest that is started again when a fault has made it hang. */
export class Warm {
  readonly #copy: string
  #child: ChildProcess | null = null

  constructor(copy: string) {
    this.#copy = copy
  }

  /** `timeout`: no answer came; the fault has been found by its endless loop. */
  async ask(request: Request): Promise<Answer | { readonly kind: 'timeout' }> {
    const child = this.#child ?? (await this.#start())
    const path = request.fault && join(this.#copy, request.fault.file)
    const before = path && readFileSync(path, 'utf8')
    const answer = await answerOf(child, request)
    if (answer.kind === 'timeout') {
      this.close()
      // A process that hangs cannot take its fault back itself.
      if (path && before !== null) writeFileSync(path, before)
    }
    return answer
  }

  async #start(): Promise<ChildProcess> {
    const script = join(this.#copy, 'scripts/mutants/runner.ts')
    const child = fork(script, [], {
      ...{ cwd: this.#copy, detached: true, execArgv: ['--disable-warning=ExperimentalWarning'] },
      env: { ...process.env, NO_COLOR: '1', VITEST: 'true', TEST: 'true', NODE_ENV: 'test' },
      stdio: ['ignore', 'ignore', 'inherit', 'ipc'],
    })
    this.#child = child
    const ready = await answerOf(child, null)
    if (ready.kind !== 'ready') throw new Error('Vitest does not start.')
    return child
  }

  close(): void {
    // With all the workers it has started.
    if (this.#child?.pid !== undefined) process.kill(-this.#child.pid, 'SIGKILL')
    this.#child = null
  }
}

function answerOf(
  child: ChildProcess,
  request: Request | null,
): Promise<Answer | { readonly kind: 'timeout' }> {
  return new Promise((resolve) => {
    const end = (answer: Answer | { readonly kind: 'timeout' }) => {
      clearTimeout(timer)
      child.off('message', hear).off('exit', lost)
      resolve(answer)
    }
    const lost = () => end({ kind: 'timeout' })
    let timer = setTimeout(lost, STARTS)
    const hear = (answer: Answer) => {
      if (answer.kind !== 'progress') return end(answer)
      clearTimeout(timer)
      timer = setTimeout(lost, SILENT)
    }
    child.on('message', hear).once('exit', lost)
    if (request) child.send(request)
  })
}
