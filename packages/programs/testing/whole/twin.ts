import { draw, stream } from '@botgarten/numbers'
import type { Block, Host, HostBrain, Letter, Value } from '@botgarten/blocks'
import type { Program } from '../../types.ts'

/** What a block does, as plainly as can be: a generator that pauses where time or budget may end. */
export type Steps<T> = Generator<'block' | 'over' | 'tick', T, void>

/** Rule 17. */
export class Failure extends Error {
  readonly block: string
  readonly problem: string
  constructor(block: Block, problem: string) {
    super(problem)
    this.block = block.id
    this.problem = `problem.${problem}`
  }
}
/** Rule 22. */
export class Leaving extends Error {
  readonly how: 'loop' | 'pass'
  constructor(how: 'loop' | 'pass') {
    super(how)
    this.how = how
  }
}
/** Rule 26. */
export class Returning extends Error {
  readonly value: Value
  constructor(value: Value) {
    super('return')
    this.value = value
  }
}

/** What blocks mean: one that stands in a row, one that gives a value. */
export interface Meanings {
  execute(twin: WholeTwin, block: Block): Steps<void>
  valueOf(twin: WholeTwin, block: Block): Steps<Value>
}

interface Scope {
  readonly variables: Map<string, Value>
  /** Loops that are under way in it. */
  loops: number
}

const acting =
  /^(robActions_(motor|display|play|sayText|setLanguage|brickLight|NNstep)|actions_|mbed|robSensors_(?!get_)|robCommunication|ai_neural_network|ai_nn_input)/

/** Rule 3. */
const budget = 1000

/**
 * The whole language told again from semantics.md, by plain recursion over the blocks: no index, no frames. Slow and
 * obvious, for tests only. What belongs to maps and to groups has twins of its own.
 */
export class WholeTwin {
  ended = false
  problem: Failure | null = null
  lit: string | null = null
  acts = 0
  readonly host: Host
  readonly program: Program
  readonly letters: Letter[] = []
  readonly assertions: { passed: number; failed: [text: string, expected: string, got: string][] } = {
    passed: 0,
    failed: [],
  }
  readonly notes: string[] = []
  readonly net = {
    inputs: new Map<string, number>(),
    outputs: new Map<string, number>(),
    weights: new Map<string, number>(),
    biases: new Map<string, number>(),
  }
  compared: readonly [Value, Value] | null = null
  readonly #random
  readonly #scopes: Scope[] = [{ variables: new Map(), loops: 0 }]
  readonly #meanings: Meanings
  readonly #steps: Steps<void>
  #spent = 1

  constructor(program: Program, host: Host, meanings: Meanings, seed = 0) {
    this.#meanings = meanings
    this.program = program
    this.host = host
    this.#random = stream(seed, 'program')
    const [start, ...rows] = program.stacks[0]?.blocks ?? []
    this.#steps = this.#main(start, rows)
  }

  /** The variables of the program, for comparing. */
  get variables(): { readonly [name: string]: Value } {
    return Object.fromEntries(this.#scopes[0]!.variables)
  }

  *#main(start: Block | undefined, rows: readonly Block[]): Steps<void> {
    yield* this.rows(start?.statements?.ST)
    yield* this.rows(rows)
  }

  tick(): void {
    if (this.ended) return
    try {
      if (!this.#runsOut()) return
    } catch (failure) {
      if (!(failure instanceof Failure)) throw failure
      this.problem = failure
    }
    this.ended = true
    this.lit = null
    this.host.robot.stop()
    this.host.robot.tone(0, null)
  }

  /** Runs to the end of the tick. Did the program come to its end? */
  #runsOut(): boolean {
    for (;;) {
      const { done, value } = this.#steps.next()
      if (done) return true
      if (value === 'block') this.#spent += 1
      if (value === 'block' && this.#spent <= budget) continue
      this.#spent = this.#spent > budget ? 1 : 0
      return false
    }
  }

  /** Rule 27: what goes through a list costs more. */
  costs(entries: number): void {
    this.#spent += Math.floor(entries / 100)
  }

  *rows(rows: readonly Block[] = []): Steps<void> {
    for (const block of rows) {
      if (block.disabled === true) continue
      if (acting.test(block.type)) this.acts += 1
      this.lit = block.id
      yield 'block'
      yield* this.#meanings.execute(this, block)
    }
  }

  /** Rule 4: a pass of a loop that goes on. Where it left the loop, false. */
  *pass(rows: readonly Block[] | undefined, isLast = () => false): Steps<boolean> {
    const acts = this.acts
    const depth = this.#scopes.length
    const scope = this.#scopes[depth - 1]!
    scope.loops += 1
    try {
      yield* this.rows(rows)
    } catch (leaving) {
      if (!(leaving instanceof Leaving)) throw leaving
      if (leaving.how === 'loop') return false
    } finally {
      scope.loops -= 1
    }
    if (!isLast()) yield this.acts > acts ? 'tick' : 'block'
    return true
  }

  get isInLoop(): boolean {
    return this.#scopes.at(-1)!.loops > 0
  }

  *ask(block: Block, input: string): Steps<Value> {
    const child = block.values?.[input]
    if (!child || child.disabled === true) throw new Failure(block, 'missingValue')
    return yield* this.value(child)
  }

  *value(block: Block): Steps<Value> {
    if (acting.test(block.type)) this.acts += 1
    yield 'block'
    const value = yield* this.#meanings.valueOf(this, block)
    if (this.#spent > budget) yield 'over'
    return value
  }

  *number(block: Block, input: string): Steps<number> {
    return Number(yield* this.ask(block, input))
  }

  *list(block: Block, input: string): Steps<Value[]> {
    return (yield* this.ask(block, input)) as Value[]
  }

  *texts(block: Block, ...inputs: readonly string[]): Steps<readonly string[]> {
    const texts: string[] = []
    for (const input of inputs) texts.push((yield* this.ask(block, input)) as string)
    return texts
  }

  random(): number {
    return draw(this.#random)
  }

  // ---- rule 25

  #holder(name: string): Scope | undefined {
    return [this.#scopes.at(-1)!, this.#scopes[0]!].find(({ variables }) => variables.has(name))
  }

  get(block: Block, name: string): Value {
    const holder = this.#holder(name)
    if (!holder) throw new Failure(block, 'noSuchVariable')
    return holder.variables.get(name)!
  }

  set(block: Block, name: string, value: Value): void {
    const holder = this.#holder(name)
    if (!holder) throw new Failure(block, 'noSuchVariable')
    holder.variables.set(name, value)
  }

  make(name: string, value: Value): void {
    this.#scopes.at(-1)!.variables.set(name, value)
  }

  // ---- rule 26

  *call(block: Block): Steps<Value> {
    const args: Value[] = []
    for (let k = 0; k < (block.mutation?.args ?? []).length; k++) args.push(yield* this.ask(block, `ARG${k}`))
    const called = this.program.stacks
      .map(({ blocks }) => blocks[0]!)
      .find(({ type, fields }) => /_def/.test(type) && fields?.NAME === block.mutation?.attrs.name)
    if (!called) throw new Failure(block, 'noSuchFunction')
    if (this.#scopes.length > 500) throw new Failure(block, 'tooManyCalls')
    const parameters = called.statements?.ST ?? []
    this.#scopes.push({
      variables: new Map(parameters.map(({ fields }, k) => [fields!.VAR!, args[k]!])),
      loops: 0,
    })
    const value = yield* this.#body(called)
    this.#scopes.pop()
    if (this.#spent > budget) yield 'over'
    return value
  }

  *#body(called: Block): Steps<Value> {
    yield 'block'
    try {
      yield* this.rows(called.statements?.STACK)
      return called.type === 'robProcedures_defreturn' ? yield* this.ask(called, 'RETURN') : null
    } catch (returning) {
      if (!(returning instanceof Returning)) throw returning
      return returning.value
    }
  }

  get isInFunction(): boolean {
    return this.#scopes.length > 1
  }

  // ---- rule 37

  /** The oldest letter of a kind; waits for it. */
  *letter(kind: Letter['kind'], from: string | null): Steps<Letter> {
    for (;;) {
      const at = this.letters.findIndex(
        (letter) => letter.kind === kind && (from === null || letter.from === from),
      )
      if (at >= 0) return this.letters.splice(at, 1)[0]!
      yield 'tick'
    }
  }

  // ---- rule 38

  brain(block: Block): HostBrain {
    const brain = this.host.brain?.('')
    if (!brain) throw new Failure(block, 'noNetwork')
    return brain
  }

  /** Rule 5. */
  *wait(milliseconds: number): Steps<void> {
    for (let ticks = 0; ticks * 1000 < milliseconds * 60 - 1e-6; ticks++) yield 'tick'
  }
}
