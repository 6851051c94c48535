import {
  binds,
  definitions,
  isBlockType,
  plugged,
  whole,
  type Block,
  type Expression,
  type Facts,
  type Python,
  type PythonAt,
  type RobotPython,
  type ValueType,
} from '@botgarten/blocks'
import { definitionOf, outputOf } from '../check/places.ts'
import { rules } from '../check/rules.ts'
import { shapeOf } from '../run/shape-of.ts'
import type { Draft } from './draft.ts'
import { helper, isHelper } from './helpers.ts'
import { lessonIn } from './lesson.ts'
import { callNetwork } from './network.ts'
import { quote } from './quote.ts'
import { neuronPlace, runStep } from './steps.ts'
import { textIn } from './text.ts'
import { tryOn } from './try-on.ts'
import { callTable } from './trying.ts'
import type { Usage } from './usage.ts'

/** A statement that cannot be written: something is missing in it. */
class Gap extends Error {
  readonly block: string
  readonly problem: string
  readonly facts: Facts
  constructor(block: string, problem: string, facts: Facts = {}) {
    super(problem)
    this.block = block
    this.problem = problem
    this.facts = facts
  }
}

interface Loop {
  readonly endings: readonly string[]
}

/** Writes blocks into a draft. */
export class Writer {
  readonly draft: Draft
  readonly usage: Usage
  readonly #robot: (at: PythonAt) => RobotPython
  #loops: Loop[] = []

  constructor(draft: Draft, usage: Usage, robot: (at: PythonAt) => RobotPython) {
    this.draft = draft
    this.usage = usage
    this.#robot = robot
  }

  /** The blocks of a row, in their order. @param alone no loop goes round them: the body of a function. */
  rows(blocks: readonly Block[] = [], alone = false): void {
    const loops = this.#loops
    if (alone) this.#loops = []
    for (const block of blocks) if (block.disabled !== true) this.#statement(block)
    this.#loops = loops
  }

  /** Rows one step further in; `pass` where they are nothing. */
  inner(write: () => void): void {
    const { draft } = this
    const from = draft.lines.length
    draft.depth++
    write()
    if (draft.lines.slice(from).every(({ code }) => code.startsWith('#'))) draft.line('pass')
    draft.depth--
  }

  #statement(block: Block): void {
    const { draft } = this
    const takeBack = draft.mark()
    this.#begin(block)
    if (block.comment) draft.comment(block.comment)
    try {
      this.#checked(block, 'statement')
      this.#write(block, this.#pythonOf(block), 'statement')
    } catch (error) {
      if (!(error instanceof Gap)) throw error
      takeBack()
      this.#gapLine(block, error)
    }
  }

  /** What a function gives back. */
  result(block: Block): void {
    this.#begin(block)
    try {
      this.draft.line(`return ${this.at(block, 'statement').value('RETURN')}`)
    } catch (error) {
      if (!(error instanceof Gap)) throw error
      this.#gapLine(block, error)
    }
  }

  #begin(block: Block): void {
    this.draft.pending = new Set([block.id])
    this.draft.before = []
  }

  #gapLine(block: Block, gap: Gap): void {
    const { draft } = this
    draft.pending = new Set([block.id, gap.block])
    draft.before = []
    const text = draft.gap(gap.block, gap.problem, gap.facts)
    if (draft.input.gaps === false) draft.comment(text)
    else draft.line(`raise NotImplementedError(${quote(text)})`)
  }

  #pythonOf(block: Block): Python {
    if (!isBlockType(block.type)) throw new Gap(block.id, 'problem.unknownBlock')
    return definitions[block.type].python
  }

  /** What a child is told to change first is a gap. */
  #checked(block: Block, place: 'statement' | 'value'): void {
    const definition = definitionOf(block)
    if (!definition) throw new Gap(block.id, 'problem.unknownBlock')
    if (shapeOf(block, definition.look) !== place) throw new Gap(block.id, 'problem.wrongKind')
    const [finding] = rules
      .flatMap((rule) => rule(block, definition, this.draft.input.config))
      .filter(({ stops }) => stops)
    if (finding) throw new Gap(block.id, finding.problem, finding.facts)
    const strange = this.usage.problemOf(block)
    if (strange) throw new Gap(block.id, strange.problem, strange.facts)
  }

  #write(block: Block, python: Python, place: 'statement' | 'value'): Expression | undefined {
    if (typeof python === 'function') return python(this.at(block, place)) ?? undefined
    return 'missing' in python ? this.missing(block, python.missing, place) : undefined
  }

  /** What is plugged into an input. */
  expression(block: Block, input: string): Expression {
    const child = plugged(block, input) ?? this.usage.written(block, input)
    if (!child) throw new Gap(block.id, 'problem.missingValue', { input })
    this.draft.pending.add(child.id)
    this.#checked(child, 'value')
    return this.#write(child, this.#pythonOf(child), 'value') ?? whole('None')
  }

  /** @see PythonAt.alone */
  #alone(
    { statements }: Block,
    input: string,
    types: readonly string[],
    attempt: (inner: PythonAt) => unknown,
  ): PythonAt | null {
    const [only, ...more] = (statements?.[input] ?? []).filter(({ disabled }) => disabled !== true)
    if (!only || more.length > 0 || only.comment || !types.includes(only.type)) return null
    const { draft } = this
    const takeBack = draft.tryOut()
    try {
      this.#checked(only, 'statement')
      attempt(this.at(only, 'statement'))
    } catch (error) {
      if (error instanceof Gap) return null
      throw error
    } finally {
      takeBack()
    }
    draft.pending = new Set([only.id])
    return this.at(only, 'statement')
  }

  missing(block: Block, key: string, place: 'statement' | 'value'): Expression {
    const { draft } = this
    const text = draft.note(block.id, `python.missing.${key}`)
    if (place === 'statement') draft.commentOnce(text)
    else draft.before.push(text)
    return place === 'statement' ? whole('') : this.#nothingOf(block)
  }

  /** A value that stands where the brick has none. */
  #nothingOf(block: Block): Expression {
    const kind = this.kindOf(block)
    if (kind.startsWith('Array_')) return whole('[]')
    if (kind === 'Colour') return whole(this.at(block, 'value').robot.colour('#585858'))
    return whole(({ Number: '0', String: '""', Boolean: 'False' } as Record<string, string>)[kind] ?? 'None')
  }

  kindOf(block: Block): ValueType | 'any' {
    const definition = definitionOf(block)
    return (definition && outputOf(block, definition)) ?? 'any'
  }

  #loop(at: PythonAt, head: string, input: string, last: readonly string[]): void {
    const { draft } = this
    const acts = this.usage.acts(at.block)
    const endings = [...last, ...(acts ? [at.robot.wait('10')] : [])]
    const ids = new Set(draft.pending)
    draft.line(head)
    this.inner(() => {
      this.#loops.push({ endings })
      this.rows(at.block.statements?.[input])
      this.#loops.pop()
      draft.pending = ids
      for (const ending of endings) draft.line(ending)
    })
  }

  /** A block with all that it may ask for. */
  at(block: Block, place: 'statement' | 'value'): PythonAt {
    const { draft, usage } = this
    const at: PythonAt = {
      block,
      robot: undefined as never,
      field: (name, preset = '') => block.fields?.[name] ?? preset,
      expression: (input) => this.expression(block, input),
      value: (input, least = binds.any) => bracketed(this.expression(block, input), least),
      kind: (input) => {
        const child = plugged(block, input) ?? usage.written(block, input)
        return child ? this.kindOf(child) : 'any'
      },
      text: (input, least = binds.any) => bracketed(textIn(at, input), least),
      quote,
      line: (code) => draft.line(code),
      comment: (text) => draft.comment(text),
      inner: (write) => this.inner(write),
      body: (input) => this.rows(block.statements?.[input]),
      alone: (input, types, attempt) => this.#alone(block, input, types, attempt),
      rows: (head, input) => {
        const ids = new Set(draft.pending)
        draft.line(head)
        this.inner(() => this.rows(block.statements?.[input]))
        draft.pending = ids
      },
      loop: (head, input, last = []) => this.#loop(at, head, input, last),
      endings: () => this.#loops.at(-1)?.endings ?? at.gap('problem.notInLoop'),
      counts: (name) => usage.counts(block, name),
      from: (module, name) => draft.import(moduleOf(draft.input.dialect, module), name),
      call: (name, ...args) => `${isHelper(name) ? helper(at, draft, name) : name}(${args.join(', ')})`,
      variable: (name) => draft.names.of(`variable ${name}`, name),
      func: (name) => draft.names.of(`function ${name}`, name),
      fresh: (name) => draft.names.fresh(name),
      as: (other) => this.#write(other, this.#pythonOf(other), place),
      missing: (key) => this.missing(block, key, place),
      gap: (problem, facts) => {
        throw new Gap(block.id, problem, facts)
      },
      learner: lessonIn(draft) !== undefined,
      network: () => callNetwork(this, at),
      table: () => callTable(this, at),
      tryOn: () => tryOn(this, at),
      step: () => runStep(this, at),
      neuron: (what, ...names) => neuronPlace(this, at, what, names),
      sorting: (what) => draft.names.of(`sorting ${what}`, what),
    }
    ;(at as { robot: RobotPython }).robot = this.#robot(at)
    return at
  }
}

const bracketed = ({ code, binds: how }: Expression, least: number) => (how < least ? `(${code})` : code)

/** Pybricks calls its own modules by MicroPython's names. */
const moduleOf = (dialect: string, module: 'math' | 'random') =>
  dialect === 'ev3dev2' ? module : `u${module}`
