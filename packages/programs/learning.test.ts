import { addBlocks, blockFrom, toolbox, type Template } from '@botgarten/blocks'
import { learning, learningToolbox } from '@botgarten/blocks/packs/learning'
import { expect, test } from 'vitest'
import { learningIn, ownText } from './index.ts'
import type { Program } from './types.ts'

addBlocks(learning, learningToolbox)
const templates = toolbox.find(({ category }) => category === 'q-learning')!.blocks
const from = (part: string) => templates.find(({ type }) => type.includes(part))!
const start: Template = { type: 'robControls_start' }

function programOf(...stacks: readonly (readonly Template[])[]): Program {
  let next = 0
  const blocks = (rows: readonly Template[]) => rows.map((row) => blockFrom(row, () => `b${next++}`))
  return { stacks: stacks.map((rows) => ({ x: 0, y: 0, blocks: blocks(rows) })), config: { stacks: [] } }
}

const changed = (template: Template, fields: Template['fields']): Template => ({
  ...template,
  fields: { ...template.fields, ...fields },
})

test('a program without a map learns nothing', () => {
  expect(learningIn(programOf([start, from('config')]))).toBeNull()
})

test('what is to be learned is read from the blocks, wherever they stand under start', () => {
  const config = changed(from('config'), {
    ALPHA: '0.35',
    ALPHA_DECAY: 'visits',
    RHO_DECAY: '0.99',
    RULES: 'study',
  })
  const repeat: Template = { type: 'controls_repeat_ext', statements: { DO: [config, from('rule')] } }
  const learning = learningIn(programOf([start, from('states'), repeat]))!
  expect(learning).toMatchObject({
    map: 'railway',
    start: 3,
    goal: 1,
    closed: [],
    episodes: 100,
    moves: 10_000,
  })
  expect(learning.settings).toMatchObject({ rules: 'study', alpha: 0.35, alphaDecay: { kind: 'visits' } })
  expect(learning.settings.rhoDecay).toEqual({ kind: 'episodes', factor: 0.99 })
  expect(learning.blocks).not.toHaveProperty('draw')
})

test('each share of a learner is read from the field of its name', () => {
  const config = changed(from('config'), { ALPHA: '0.1', GAMMA: '0.2', NU: '0.3', RHO: '0.4' })
  const { settings } = learningIn(programOf([start, from('states'), config]))!
  expect(settings).toMatchObject({ alpha: 0.1, gamma: 0.2, nu: 0.3, rho: 0.4 })
})

test('a stack without blocks is no start', () => {
  expect(learningIn(programOf([], [start, from('states')]))?.start).toBe(3)
})

test('a block under start comes before one that lies about; one that is switched off does not count', () => {
  const other = changed(from('states'), { START: '5' })
  expect(learningIn(programOf([other], [start, from('states')]))?.start).toBe(3)
  expect(learningIn(programOf([start, { ...from('states'), disabled: true }]))).toBeNull()
})

test('numbers that mean nothing are the presets', () => {
  const config = changed(from('config'), { ALPHA: '7', GAMMA: 'x', RHO_DECAY: '2' })
  const rule = changed(from('rule'), { EPISODES: '-4', Q_LEARNER_TIME: 'viel' })
  const learning = learningIn(programOf([start, from('states'), config, rule]))!
  expect(learning).toMatchObject({ episodes: 1, moves: 10_000 })
  expect(learning.settings).toMatchObject({ alpha: 0.5, gamma: 0.8 })
  expect(learning.settings).not.toHaveProperty('rhoDecay')
})

test('what no field takes is as much as a field takes: learning comes to an end', () => {
  const endless = changed(from('rule'), { EPISODES: '1e12', Q_LEARNER_TIME: '999999999999' })
  const learning = learningIn(programOf([start, from('states'), endless]))
  expect(learning).toMatchObject({ episodes: 100_000, moves: 1_000_000 })
})

test('own rewards are read from the map block; without them nothing is said of pay', () => {
  const paying = (fields: Template['fields']) =>
    learningIn(programOf([start, changed(from('states'), fields)]))!
  expect(paying({})).not.toHaveProperty('pay')
  expect(paying({ LENGTH: 'TRUE', STEP_COST: '0.5', REWARDS: '3:10 2-5:-2.5' }).pay).toEqual({
    ...{ length: true, step: 0.5 },
    own: { '3': 10, '2-5': -2.5 },
  })
  const own = { '3': 10, '2-5': -2.5 }
  expect(paying({ REWARDS: ownText(own) }).pay).toEqual({ own })
})

test('rewards that mean nothing are left out, and none is beyond all bounds', () => {
  const { pay } = learningIn(
    programOf([start, changed(from('states'), { STEP_COST: 'much', REWARDS: 'x:1 3:1e9 4:99999 5:0 6' })]),
  )!
  expect(pay).toEqual({ own: { '4': 1000 } })
})
