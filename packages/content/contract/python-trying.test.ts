import { addBlocks, type Block } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { beginNight, ticksOf } from '@botgarten/lab/trying'
import { drivenRun } from '@botgarten/lab/testing/driven'
import { draw, stream } from '@botgarten/numbers'
import { tryingIn, type Program } from '@botgarten/programs'
import { dialects, pythonFrom } from '@botgarten/programs/python'
import { runPython } from '@botgarten/programs/python/testing'
import type { World } from '@botgarten/simulation'
import { beforeAll, describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { cardDocument } from '../index.ts'

beforeAll(() => addBlocks(learning))

const { card, world } = content.card('try-dodge')!
const { programs } = content.program('try-dodge', 'solution')!
const given = cardDocument(world, card, { programs, brains: {} }, 0)
const floor = content.floorOf(given.world)

/** What a robot can know without a touch sensor: pay for what it sees, and for each move. */
function paidBySight(seed: number): Program {
  const [stack] = programs['main']!.stacks
  const pay = [['OPEN', '2'], ['NEAR', '-3'], ['FARTHER', '1.5'], ['MOMENT', '0.1']] as const // prettier-ignore
  const sentences = pay.map(([WHAT, COINS]): Block => ({
    id: `pay${WHAT}`,
    type: 'ai_try_pay',
    fields: { WHAT, COINS },
  }))
  const blocks = stack!.blocks.flatMap((block) => {
    if (block.type === 'ai_try_pay') return block.id === 'pay1' ? sentences : []
    if (block.type !== 'ai_try_learn') return [block]
    return [{ ...block, fields: { ...block.fields, MINUTES: '0.9', SEED: String(seed) } }]
  })
  return { ...programs['main']!, stacks: [{ ...stack!, blocks }] }
}

function learned(seed: number) {
  const night = beginNight(given.world, floor, tryingIn(paidBySight(seed))!.trial)
  night.advance(ticksOf(0.9))
  return night.state
}
/** The lab feels every bump of the body, this robot none: a try in which it never bumped. */
const seed = Array.from({ length: 60 }, (_, k) => k + 1).find((one) => learned(one).minute.bumps === 0)!

describe.each(dialects)('a robot that goes on learning by trying, with %s', (dialect) => {
  it('learns from the same dice and readings the table that the lab learns', async () => {
    const program = paidBySight(seed)
    const dice = stream(seed, 'learn/try/bo/0')
    const heading = Math.floor(draw(dice) * 360)
    const [bo] = given.world.robots
    const turned: World = { ...given.world, robots: [{ ...bo!, pose: { ...bo!.pose, heading } }] }
    const run = drivenRun({ ...given, world: turned }, floor, [], 1)
    const { config } = bo!
    const { text, notes } = pythonFrom(
      { ...{ name: 'learner', program, config, brains: {}, dialect }, learner: true },
      (key) => key,
    )
    expect(notes.map((note) => note.text)).toEqual(['python.missing.bump'])
    const stopped = text.slice(0, text.search(/^while True/m))
    const tick = () => void run.advance()
    const { error, printed } = await runPython(stopped, run.robot, { tick, random: () => draw(dice) }, config)
    expect(error).toBe(null)
    const wanted = learned(seed)
    const table = (JSON.parse(printed.at(-1)!) as number[][]).flat()
    expect(table).toHaveLength(wanted.table.q.length)
    table.forEach((value, k) => expect(value).toBeCloseTo(wanted.table.q[k]!, 6))
    expect(wanted.table.moves).toBe(216)
  })
})

it('says what a real robot cannot be paid for', () => {
  const program = JSON.parse(
    JSON.stringify(programs['main']).replace('"WHAT":"AHEAD"', '"WHAT":"TILE"'),
  ) as Program
  const { config } = given.world.robots[0]!
  const { notes } = pythonFrom(
    { ...{ name: 'x', program, config, brains: {}, dialect: 'pybricks' }, learner: true },
    (key) => key,
  )
  expect(notes.map(({ text }) => text)).toEqual([
    ...['python.missing.bump', 'python.missing.pay', 'python.missing.pay'],
  ])
})
