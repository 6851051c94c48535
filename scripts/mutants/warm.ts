import { fork, type ChildProcess } from 'node:child_process'
import { readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Answer, Request } from './runner.ts'

/** A first request reads all code. */
const FIRST = 240_000
/** A fault may make tests so many times as slow, or take so long, before it counts as an endless loop. */
const [SLOWER, LEAST] = [5, 60_000]

/** A warm Vitest that is started again when a fault has made it hang. */
export class Warm {
  readonly #copy: string
  #child: ChildProcess | null = null
  #isFirst = true
  /** How long the tests of this file took without a fault. */
  #took = 0

  constructor(copy: string) {
    this.#copy = copy
  }

  /** Asks about a file as it is: how long that takes says how long a fault may take. */
  async askFirst(request: Request): Promise<Answer | { readonly kind: 'timeout' }> {
    const began = performance.now()
    const answer = await this.#ask(request, FIRST)
    this.#took = performance.now() - began
    return answer
  }

  /** `timeout`: no answer came; the fault has been found by its endless loop. */
  ask(request: Request): Promise<Answer | { readonly kind: 'timeout' }> {
    return this.#ask(request, this.#isFirst ? FIRST : Math.max(LEAST, SLOWER * this.#took))
  }

  async #ask(request: Request, most: number): Promise<Answer | { readonly kind: 'timeout' }> {
    const child = this.#child ?? (await this.#start())
    const path = join(this.#copy, request.file)
    const before = readFileSync(path, 'utf8')
    const answer = await answerOf(child, request, most)
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
    const ready = await answerOf(child, null, FIRST)
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
