import { describe, expect, it } from 'vitest'
import { addBlocks, blockFrom, type Template } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { timed } from '@botgarten/numbers/testing/processor'
import { check, indexProgram, runThread, startThread, type Program } from '../index.ts'
import { block, calculate, number, repeat, forever } from '../testing/build.ts'
import { nextTick, recordingRobot } from '../testing/recording-robot.ts'

addBlocks(expert)

function programOf(...stacks: readonly (readonly Template[])[]): Program {
  let count = 0
  const plant = (template: Template) => blockFrom(template, () => `b${count++}`)
  return { stacks: stacks.map((rows) => ({ x: 0, y: 0, blocks: rows.map(plant) })), config: { stacks: [] } }
}

/** Runs; no tick may take longer than a second of the processor. */
function run(program: Program, ticks = 300) {
  const recording = recordingRobot()
  const index = indexProgram(program)
  const thread = startThread(index)
  let slowest = 0
  while (!thread.ended && recording.tick < ticks) {
    const { seconds } = timed(() => runThread(thread, index, recording.context))
    slowest = Math.max(slowest, seconds)
    nextTick(recording)
  }
  return { thread, slowest }
}

const start = (...variables: Template[]): Template => ({
  type: 'robControls_start',
  mutation: { attrs: { declare: 'true' } },
  statements: { ST: variables },
})
const variable = (name: string, type: string, value: Template): Template =>
  block('robGlobalVariables_declare', { VAR: name, TYPE: type }, { VALUE: value })
const get = (name: string, type = 'Number'): Template => ({
  ...block('variables_get', { VAR: name }),
  mutation: { attrs: { datatype: type } },
})
const set = (name: string, value: Template): Template => ({
  ...block('variables_set', { VAR: name }, { VALUE: value }),
  mutation: { attrs: { datatype: 'Number' } },
})
const call = (name: string): Template => ({
  type: 'robProcedures_callnoreturn',
  mutation: { attrs: { name }, args: [] },
})
const make = (name: string, ...rows: Template[]): Template =>
  block('robProcedures_defnoreturn', { NAME: name }, {}, { STACK: rows })
const listOf = (entries: number): Template => ({
  ...block('robLists_repeat', { LIST_TYPE: 'Number' }, { ITEM: number(7), NUM: number(entries) }),
  mutation: { attrs: { list_type: 'Number' } },
})
const work = (OP: string, list: Template): Template => block('math_on_list', { OP }, { LIST: list })

describe('what a program may not do', () => {
  it('a function that calls itself for ever stops with a word, at the call', () => {
    const program = programOf([start(), call('again')], [make('again', call('again'))])
    const { thread, slowest } = run(program)
    expect(thread.problem).toMatchObject({ problem: 'problem.tooManyCalls', facts: { name: 'again' } })
    expect(thread.frames).toEqual([])
    expect(slowest).toBeLessThan(1)
  })

  it('two functions that call each other for ever stop, too', () => {
    const { thread } = run(programOf([start(), call('a')], [make('a', call('b'))], [make('b', call('a'))]))
    expect(thread.problem?.problem).toBe('problem.tooManyCalls')
  })

  it('of two functions of one name the first is called', () => {
    const program = programOf([start(), call('a')], [make('a', block('first'))], [make('a', block('second'))])
    const { block: called } = indexProgram(program).functions.get('a')!
    expect(called.block).toBe(program.stacks[1]!.blocks[0])
  })

  it('a list of a million is refused with a word', () => {
    const { thread } = run(programOf([start(variable('xs', 'Array_Number', listOf(1_000_000)))]))
    expect(thread.problem).toMatchObject({ problem: 'problem.listTooLong', facts: { most: 10_000 } })
  })

  it('a list that grows for ever stops at ten thousand entries', () => {
    const grow: Template = {
      ...block(
        'robLists_setIndex',
        { MODE: 'INSERT', WHERE: 'LAST' },
        { LIST: get('xs', 'Array_Number'), TO: number(1) },
      ),
      mutation: { attrs: { at: 'false' } },
    }
    const { thread, slowest } = run(
      programOf([start(variable('xs', 'Array_Number', listOf(0))), forever(grow)]),
      3000,
    )
    expect(thread.problem?.problem).toBe('problem.listTooLong')
    expect(slowest).toBeLessThan(1)
  })

  it('a text that doubles for ever stops at ten thousand letters', () => {
    const twice = block('robText_join', {}, { ADD0: get('t', 'String'), ADD1: get('t', 'String') })
    const doubled = { ...twice, mutation: { attrs: { items: '2' } } }
    const { thread } = run(
      programOf([start(variable('t', 'String', block('text', { TEXT: 'Bo' }))), forever(set('t', doubled))]),
    )
    expect(thread.problem?.problem).toBe('problem.textTooLong')
  })

  it('working through long lists without end takes no tick longer than a second', () => {
    const rows = ['MEDIAN', 'STD_DEV', 'SUM'].map((OP) => set('x', work(OP, get('xs', 'Array_Number'))))
    const program = programOf([
      start(variable('x', 'Number', number(0)), variable('xs', 'Array_Number', listOf(10_000))),
      forever(...rows),
    ])
    const { thread, slowest } = run(program, 60)
    expect(thread.problem).toBeNull()
    expect(slowest).toBeLessThan(1)
  })

  it('a number that grows for ever stops with a word', () => {
    const program = programOf([
      start(variable('x', 'Number', number(2))),
      repeat(number(3000), set('x', calculate('MULTIPLY', get('x'), get('x')))),
    ])
    expect(run(program).thread.problem?.problem).toBe('problem.tooBigNumber')
  })

  it('an expression of ten thousand brackets is refused at the bracket that is too deep', () => {
    const deep = `${'('.repeat(10_000)}1${')'.repeat(10_000)}`
    const program = programOf([
      start(variable('x', 'Number', block('robActions_eval_expr', { EXPRESSION: deep, TYPE: 'Number' }))),
    ])
    expect(check(program, { sensors: {} })).toMatchObject([{ problem: 'problem.cannotRead', stops: true }])
    expect(run(program).thread.problem?.problem).toBe('problem.missingValue')
  })
})
