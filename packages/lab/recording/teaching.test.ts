import { addBlocks, type Block } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { beforeAll, describe, expect, it } from 'vitest'
import { block, forever, labWith, net, program } from '../testing/scene.ts'
import type { Lab } from '../types.ts'

beforeAll(() => addBlocks(learning))

const number = (id: string, value: number) => block(id, 'math_number', { fields: { NUM: String(value) } })
const practise = (id: string, rounds: number) =>
  block(id, 'ai_nn_practise', { values: { ROUNDS: number(`${id}R`, rounds) } })
const remember = (id: string) => block(id, 'ai_nn_remember')
const on = (id: string, power: number) =>
  block(id, 'robActions_motorDiff_on', {
    fields: { DIRECTION: 'FOREWARD' },
    values: { POWER: number(`${id}P`, power) },
  })
const wait = block('wait', 'robControls_wait_time', { values: { WAIT: number('ms', 100) } })
const show = (id: string, out: Block) =>
  block(id, 'robActions_display_text', {
    values: { OUT: out, COL: number(`${id}C`, 0), ROW: number(`${id}R`, 0) },
  })
const error = block('error', 'ai_nn_error')
const forget = (id: string, what: string) => block(id, 'ai_nn_forget', { fields: { WHAT: what } })

const brainOf = (lab: Lab) => lab.document().brains['net']!
const started = (...rows: Block[]) => {
  const lab = labWith(program(...rows))
  lab.start()
  return lab
}

describe('blocks that teach', () => {
  it('remember what the network reads and the motors do, all in the drive of this run', () => {
    const lab = started(on('slow', 20), remember('r1'), on('fast', 60), remember('r2'), wait, forever(net()))
    lab.advance(3)
    const { drives, rows } = brainOf(lab).examples!
    expect(drives.map(({ id, by }) => [id, by])).toEqual([['program-1', 'program']])
    expect(rows.map((row) => row.slice(8))).toEqual([
      [20, 20],
      [60, 60],
    ])
  })

  it('practise in exactly one tick, whatever the rounds: the weights are there when the next begins', () => {
    const weightsAfter = (rounds: number) => {
      const lab = started(
        on('go', 40),
        remember('r'),
        practise('p', rounds),
        on('on', 80),
        wait,
        forever(net()),
      )
      lab.advance(1)
      const { practice, weights } = brainOf(lab)
      expect(lab.view().robots[0]!.motors['C']).toBe(40)
      expect(practice).toMatchObject({ round: rounds, settings: { rounds } })
      lab.advance(1)
      expect(lab.view().robots[0]!.motors['C']).toBe(80)
      expect(lab.view().tick).toBe(2)
      return weights['eyeLeft']!['wheelLeft']!
    }
    expect(weightsAfter(1)).not.toBe(weightsAfter(200))
  })

  it('practise in parts to the same weights and the same run, and again by going back', () => {
    const rows = [
      on('go', 40),
      remember('r'),
      practise('p', 300),
      forever(net(), show('s', error), practise('p2', 5)),
    ]
    const whole = started(...rows)
    whole.advance(90)
    const parts = started(...rows)
    let calls = 0
    for (; parts.view().tick < 90; calls++) parts.advance(1, 7)
    expect(calls).toBeGreaterThan(150)
    expect(brainOf(parts)).toEqual(brainOf(whole))
    expect(parts.hash()).toBe(whole.hash())
    const after = brainOf(whole)
    whole.goTo(45)
    whole.goTo(10)
    for (let tick = 10; tick < 90; tick++) whole.step('tick')
    expect(whole.view().brains['net']).toEqual(after)
    expect(whole.hash()).toBe(parts.hash())
  })

  it('let a hand that turns a knob meanwhile come after', () => {
    const turned = (examples?: number) => {
      const lab = started(on('go', 40), remember('r'), practise('p', 300), wait, forever(net()))
      lab.advance(1, examples)
      lab.setWeight('net', 'eyeLeft', 'wheelLeft', 0.25)
      lab.advance(20)
      lab.goTo(0)
      lab.goTo(15)
      expect(lab.view().brains['net']!.weights['eyeLeft']!['wheelLeft']).toBe(0.25)
      return brainOf(lab)
    }
    expect(turned(3)).toEqual(turned())
  })

  it('let a row that a hand writes after a tick come after its practice', () => {
    const weightsOf = (isWritten: boolean) => {
      const lab = started(on('go', 40), remember('r'), practise('p', 300), wait, forever(net()))
      lab.pause()
      lab.step('tick')
      const row = { ...{ robot: 'bo', network: 'net', others: {} }, wheels: { left: -90, right: 90 } }
      if (isWritten) lab.remember({ ...row, drive: { id: 'hand-1', by: 'hand', seed: 1 } })
      lab.resume()
      lab.advance(20)
      expect(brainOf(lab).examples!.rows).toHaveLength(isWritten ? 2 : 1)
      return brainOf(lab).weights
    }
    expect(weightsOf(true)).toEqual(weightsOf(false))
  })

  it('say the error with rows and weights of their own tick', () => {
    const lab = started(
      on('go', 40),
      remember('r'),
      show('s1', error),
      practise('p', 400),
      wait,
      show('s2', error),
      wait,
      forever(net()),
    )
    const shown = () => Number(lab.view().robots[0]!.display[0])
    lab.advance(1)
    const before = shown()
    lab.advance(20)
    expect(before).toBeGreaterThan(0.5)
    expect(shown()).toBeLessThan(0.1)
  })

  it('forget the examples, or what was practised', () => {
    const lab = started(
      on('go', 40),
      remember('r'),
      forget('f1', 'PRACTICE'),
      wait,
      forget('f2', 'EXAMPLES'),
      forever(net()),
    )
    lab.advance(1)
    expect(brainOf(lab).weights).toEqual({})
    expect(brainOf(lab).examples!.rows).toHaveLength(1)
    lab.advance(20)
    expect(brainOf(lab).examples).toBeUndefined()
  })

  it.each([
    ['no examples', [practise('p', 5), forever(net())], 'noExamples'],
    ['no error without examples', [show('s', error), forever(net())], 'noExamples'],
    ['no network', [remember('r')], 'nothingToTeach'],
  ])('stop where there is %s', (_, rows, problem) => {
    const lab = started(...rows)
    lab.advance(2)
    expect(lab.view().problem?.problem).toBe(`problem.${problem}`)
  })
})
