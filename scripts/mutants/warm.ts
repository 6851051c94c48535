import { fork, type ChildProcess } from 'node:child_process'
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Answer, Request } from './runner.ts'

/** The first request of a process reads all code; later ones only what has changed. */
const patience = { first: 240_000, later: 60_000 }

/** A warm Vitest that is started again when a fault has made it hang. */
export class Warm {
  readonly #copy: string
  #child: ChildProcess | null = null
  #isFirst = true

  constructor(copy: string) {
    this.#copy = copy
  }

  /** `timeout`: no answer came; the fault has been found by its endless loop. */
  async ask(request: Request): Promise<Answer | { readonly kind: 'timeout' }> {
    const child = this.#child ?? (await this.#start())
    const path = join(this.#copy, request.file)
    const before = readFileSync(path, 'utf8')
    const answer = await answerOf(child, request, this.#isFirst ? patience.first : patience.later)
    this.#isFirst = false
    if (answer.kind === 'timeout') {
      this.close()
      // A process that hangs cannot take its fault back itself.
      writeFileSync(path, before)
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
    this.#isFirst = true
    const ready = await answerOf(child, null, patience.first)
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
  most: number,
): Promise<Answer | { readonly kind: 'timeout' }> {
  return new Promise((resolve) => {
    const end = (answer: Answer | { readonly kind: 'timeout' }) => {
      clearTimeout(timer)
      child.off('message', end).off('exit', lost)
      resolve(answer)
    }
    const lost = () => end({ kind: 'timeout' })
    const timer = setTimeout(lost, most)
    child.once('message', end).once('exit', lost)
    if (request) child.send(request)
  })
}
