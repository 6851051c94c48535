// The interpreter calls a block's `run` again in every tick until it returns `done`. A block must not act on the robot
// again each time: `frame.counter` or `frame.stage` remembers that it has acted.
import { indexProgram, runThread, startThread } from '@botgarten/programs'
import { describe, expect, test } from 'vitest'
import { programOf, start, wait } from '../programs/testing/build.ts'
import { nextTick, recordingRobot, type Entry } from '../programs/testing/recording-robot.ts'
import { addBlocks, definitions, type Definition, type Template } from './index.ts'
import { expert } from './packs/expert/index.ts'

addBlocks(expert)

const within = (template: Template): readonly Template[] => [
  template,
  ...Object.values(template.values ?? {}).flatMap(within),
  ...Object.values(template.statements ?? {}).flatMap((rows) => rows.flatMap(within)),
]

/** The block as its example has it, without the blocks in its mouths: those of a loop act again in each pass. */
function alone({ type, example }: Definition): Template {
  const { statements: _, ...block } = example.flatMap(within).find((one) => one.type === type)!
  return block
}

/** Commands that a block gives to the robot in the two seconds after its start. */
function effectsOf(block: Template): readonly Entry[] {
  const recording = recordingRobot()
  const index = indexProgram(programOf([start, block, wait(10_000)]))
  const thread = startThread(index)
  while (recording.tick < 120 && !thread.ended) {
    runThread(thread, index, recording.context)
    nextTick(recording)
  }
  return recording.log
}

const ticksOf = (effects: readonly Entry[]) => [...new Set(effects.map(([tick]) => tick))]

/** Commands by the part of the robot that executes them. */
const partsOf: { readonly [verb: string]: NonNullable<Definition['uses']> } = {
  ...{ led: 'lamp', display: 'display', clearDisplay: 'display', picture: 'display', say: 'speech' },
}

/** The first tick in which an effect follows one in the tick before. */
const repeatedIn = (ticks: readonly number[]) => ticks.find((tick) => ticks.includes(tick - 1))

const statements = Object.values<Definition>(definitions).filter(({ look }) => look.shape === 'statement')

describe.each(statements.map((definition) => [definition.type, definition] as const))(
  '%s',
  (_, definition) => {
    test('acts once while it waits, though its `run` is called again every tick', () => {
      const again = repeatedIn(ticksOf(effectsOf(alone(definition))))
      expect(
        again,
        'it acts again in this tick: remember in frame.counter or frame.stage that it did',
      ).toBeUndefined()
    })

    if (definition.uses)
      test(`uses the robot’s ${definition.uses}`, () => {
        expect(effectsOf(alone(definition))).not.toEqual([])
      })

    test('names the lamp, the display or the voice exactly if it uses it', () => {
      const used = effectsOf(alone(definition)).flatMap(([, verb]) => partsOf[verb] ?? [])
      const named = definition.uses === 'sound' ? undefined : definition.uses
      expect([...new Set(used)]).toEqual(named ? [named] : [])
    })
  },
)
