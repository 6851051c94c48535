import { addBlocks, type Template } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { describe, expect, test } from 'vitest'
import { run, shown } from '../testing/run.ts'

addBlocks(learning)

const number = (value: number): Template => ({ type: 'math_number', fields: { NUM: String(value) } })
const collect: Template = { type: 'ai_sorting_collect', fields: { SENSORPORT: '1' } }
const find = (groups: number): Template => ({ type: 'ai_sorting_find', values: { GROUPS: number(groups) } })
const wait = (ms: number): Template => ({ type: 'robControls_wait_time', values: { WAIT: number(ms) } })
const group = (as: string): Template => ({ type: 'ai_sorting_group', fields: { AS: as, SENSORPORT: '1' } })
const near = (to: number): Template => ({
  type: 'ai_sorting_near',
  fields: { SENSORPORT: '1' },
  values: { GROUP: number(to) },
})
const name = (of: number, text: string): Template => ({
  type: 'ai_sorting_name',
  values: { GROUP: number(of), NAME: { type: 'text', fields: { TEXT: text } } },
})
const show = (out: Template): Template => ({
  type: 'robActions_display_text',
  values: { OUT: out, COL: number(0), ROW: number(0) },
})

// The recording robot reads red = tick, green = 2 · tick, blue = 255 in each tick.
const far = wait(1000)

describe('blocks of sorting', () => {
  test('groups are numbered in the order in which they were met', () => {
    expect(shown([collect, far, collect, find(2), show(group('NUMBER'))])).toEqual(['2'])
    expect(shown([far, collect, find(1), show(group('NUMBER'))])).toEqual(['1'])
  })

  test('a group has its number for a name until the program gives one', () => {
    expect(shown([collect, find(1), show(group('NAME'))])).toEqual(['1'])
    expect(shown([collect, find(1), name(1, 'Wiese'), show(group('NAME'))])).toEqual(['Wiese'])
    expect(shown([collect, find(1), name(1, 'Wiese'), find(1), show(group('NAME'))])).toEqual(['Wiese'])
    expect(shown([name(1, 'Wiese'), collect, find(1), show(group('NAME'))])).toEqual(['Wiese'])
  })

  test('how near is the straight way in steps of the colours', () => {
    // One second later: red 60, green 120 more.
    expect(shown([collect, find(1), far, show(near(1))])).toEqual([
      String(Number(Math.hypot(60, 120).toFixed(4))),
    ])
  })

  test.each([
    [[find(0)], 'problem.groupsFromTo'],
    [[collect, find(10)], 'problem.groupsFromTo'],
    [[collect, find(2)], 'problem.fewReadings'],
    [[find(1), show(group('NUMBER'))], 'problem.noGroupsYet'],
    [[show(group('NUMBER'))], 'problem.noGroupsYet'],
    [[collect, show(near(1))], 'problem.noGroupsYet'],
    [[name(10, 'x')], 'problem.noSuchGroup'],
    [[collect, find(1), name(2, 'x')], 'problem.noSuchGroup'],
    [[collect, find(1), show(near(0))], 'problem.noSuchGroup'],
    [[{ type: 'ai_sorting_collect', fields: { SENSORPORT: '2' } }], 'problem.nothingToRead'],
  ] as const)('stops with a word where it cannot go on: %#', (rows, problem) => {
    expect(run(rows).thread.problem).toMatchObject({ problem, stops: true })
  })

  test('a loop that collects for ever keeps the last four hundred readings', () => {
    const loop: Template = { type: 'robControls_loopForever', statements: { DO: [collect] } }
    const { sorting, problem } = run([loop], 1000).thread
    expect(problem).toBeNull()
    expect(sorting.readings).toHaveLength(400)
    expect(sorting.collected).toBeGreaterThan(900)
  })
})
