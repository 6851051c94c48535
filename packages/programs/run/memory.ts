import { draw } from '@botgarten/numbers'
import type {
  Assertion,
  Context,
  Host,
  HostBrain,
  Letter,
  Mail,
  Memory,
  NetMemory,
  Robot,
  SortingMemory,
  Teaching,
  Trying,
  Value,
} from '@botgarten/blocks'
import type { Scope, Thread } from '../types.ts'

const mostFailed = 100
const mostNotes = 100

/** What a block may touch: the host, and the thread's own memory. One object a machine, since it is asked for all the time. */
export class Running implements Context, Memory {
  robot!: Robot
  now = 0
  think!: Host['think']
  brain: ((id: string) => HostBrain | undefined) | undefined
  mail: Mail | undefined
  teaching: Teaching | undefined
  trying: Trying | undefined
  readonly networkId: string
  compared: readonly [Value, Value] | null = null
  #thread!: Thread
  readonly memory: Memory = this

  constructor(networkId: string) {
    this.networkId = networkId
  }

  /** Takes up what the host is at now. */
  take(thread: Thread, host: Host): void {
    this.#thread = thread
    this.robot = host.robot
    this.now = host.now
    this.think = host.think
    this.brain = host.brain
    this.mail = host.mail
    this.teaching = host.teaching
    this.trying = host.trying
  }

  get(name: string): Value | undefined {
    return this.#scopeOf(name)?.[name]
  }

  set(name: string, value: Value): boolean {
    const scope = this.#scopeOf(name)
    if (scope) scope[name] = value
    return scope !== undefined
  }

  make(name: string, value: Value): void {
    const { scopes } = this.#thread
    const top = scopes[scopes.length - 1]
    if (top) top[name] = value
  }

  /** Of the function that runs, else of the program; callers' variables are not seen. */
  #scopeOf(name: string): Scope | undefined {
    const { scopes } = this.#thread
    const top = scopes[scopes.length - 1]
    if (top && Object.hasOwn(top, name)) return top
    const program = scopes[0]
    return program && Object.hasOwn(program, name) ? program : undefined
  }

  random(): number {
    return draw(this.#thread.random)
  }

  assert(assertion: Assertion): void {
    const { assertions } = this.#thread
    if (assertion.passed) assertions.passed++
    else assertions.wrong++
    if (!assertion.passed && assertions.failed.length < mostFailed) assertions.failed.push(assertion)
  }

  debug(block: string, text: string): void {
    const { notes } = this.#thread
    notes.push({ block, text })
    if (notes.length > mostNotes) notes.shift()
  }

  net(): NetMemory {
    return this.#thread.net
  }

  letters(): Letter[] {
    return this.#thread.letters
  }

  sorting(): SortingMemory {
    return this.#thread.sorting
  }
}
