import { addBlocks, blockFrom, toolbox, type Template } from '@botgarten/blocks'
import { learning, learningToolbox } from '@botgarten/blocks/packs/learning'
import type { Document } from '@botgarten/lab'
import { readMap } from '@botgarten/maps'
import { addRoad, addStation, emptyMap, writeMap } from '@botgarten/maps/own'
import { cardConfig, paintFloor, type World } from '@botgarten/simulation'
import { describe, expect, test } from 'vitest'
import { outcomeOf, type Asked } from './outcome.ts'

addBlocks(learning, learningToolbox)
const templates = toolbox.flatMap(({ blocks }) => blocks)
const template = (type: string) => templates.find((one) => one.type === type)!
const value = (number: number): Template => ({ type: 'math_number', fields: { NUM: String(number) } })

/** One robot in the middle of an empty floor, with these rows below its start. */
function documentOf(...rows: readonly Template[]): Document {
  let next = 0
  const blocks = [template('robControls_start'), ...rows].map((row) => blockFrom(row, () => `b${next++}`))
  const world: World = {
    ...{ size: { width: 400, height: 400 }, floor: { colour: '#FFFFFF' } },
    ...{ areas: [], lines: [], obstacles: [] },
    robots: [
      { id: 'bo', pose: { x: 200, y: 200, heading: 0 }, program: 'main', brain: '', config: cardConfig },
    ],
  }
  return {
    programs: { main: { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } } },
    ...{ brains: {}, world },
  }
}

function happens(
  observe: Extract<Asked, { seconds: number }>['observe'],
  ...rows: readonly Template[]
): string {
  const document = documentOf(...rows)
  return outcomeOf({ observe, seconds: 1 }, { kind: 'lab', document, floor: paintFloor(document.world) })
}

const motor = (port: string): Template => ({
  ...template('robActions_motor_on'),
  ...{ fields: { MOTORPORT: port }, values: { POWER: value(30) } },
})
/** At the end of a program its motors stop. */
const goesOn = template('robControls_loopForever')
const tone = (hertz: number): Template => ({
  ...template('robActions_play_tone'),
  values: { FREQUENCE: value(hertz), DURATION: value(100) },
})

describe('at the end of a second a robot', () => {
  test('stops where both motors do, and drives where one of them turns', () => {
    expect(happens('meets')).toBe('stops')
    expect(happens('meets', motor('B'), goesOn)).toBe('drives')
    expect(happens('meets', motor('C'), goesOn)).toBe('drives')
  })

  test('has sounded higher, lower, or the same: the silence after it is no tone', () => {
    expect(happens('tone')).toBe('silent')
    expect(happens('tone', tone(300), tone(600))).toBe('higher')
    expect(happens('tone', tone(600), tone(300))).toBe('lower')
    expect(happens('tone', tone(300))).toBe('same')
  })
})

test('the way that the only robot learns from a station to the next is these two', () => {
  const stations = [{ x: 200, y: 200 }, { x: 700, y: 200 }].reduce(addStation, emptyMap('two')) // prettier-ignore
  const map = readMap(writeMap(addRoad(stations, 0, 1), 'two')).map!
  const rows = ['states_and_actions_map', 'config', 'rule'].map((part) =>
    toolbox
      .find(({ category }) => category === 'q-learning')!
      .blocks.find(({ type }) => type.includes(part))!,
  )
  const [states, ...others] = rows
  const task = { ...states!, fields: { ...states!.fields, START: '0', FINISH: '1' } }
  expect(
    outcomeOf({ observe: 'way' }, { kind: 'learning', document: documentOf(task, ...others), map }),
  ).toBe('0-1')
})
