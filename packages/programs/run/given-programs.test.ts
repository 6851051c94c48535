import { beforeAll, describe, expect, it } from 'vitest'
import { addBlocks } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { indexProgram, runThread, startThread, type Thread } from '../index.ts'
import { readOpenRoberta } from '../open-roberta/index.ts'
import { givenFiles } from '../testing/mutations.ts'
import { nextTick, recordingRobot } from '../testing/recording-robot.ts'

addBlocks(expert)

/** The default robot of Open Roberta. */
const sensors = {
  1: { kind: 'touch' },
  2: { kind: 'gyro' },
  3: { kind: 'colour' },
  4: { kind: 'ultrasonic' },
} as const

/** Fifty seconds, or to the end. */
function run(file: string): Thread {
  const recording = recordingRobot(2, sensors)
  const index = indexProgram(readOpenRoberta(file))
  const thread = startThread(index)
  while (!thread.ended && recording.tick < 3000) {
    runThread(thread, index, recording.context)
    nextTick(recording)
  }
  return thread
}

/** Why an assertion of a given file does not hold here: semantics.md, "Given programs". */
const named: {
  readonly [file: string]: readonly (readonly [text: string, expected: string, got: string])[]
} = {
  'composed__common__controlFlowDecisons.xml': [['pos-14', '14', '13']],
  'fork__progOriginals__ev3ControlFlowDecisons.xml': [['pos-14', '14', '13']],
  'history__progOriginals____statisticalCalculationsOnLists__ev3.xml': [
    ['POS-5', '1.4142', '1.4142135623730951'],
  ],
  'fork__progOriginals__ev3StringConcat.xml': [
    [
      'POS-5',
      'start: one two three456 seven eight nine\n\t\t\t\t\t\t\t\t\t',
      'start: one two three456 seven eight nine',
    ],
  ],
  'history__progOriginals__stringConcat__ev3.xml': [
    [
      'POS-5',
      'start: one two three456 seven eight nine\n\t\t\t\t\t\t\t\t\t',
      'start: one two three456 seveneight nine',
    ],
  ],
}

/** Stops that a file of Open Roberta runs into here: semantics.md, "Given programs". */
const stops: readonly string[] = [
  'problem.missingValue',
  'problem.nothingToRead',
  'problem.noSuchEntry',
  'problem.emptyList',
  'problem.noSuchNeuron',
  'problem.noSuchRobot',
  'problem.notANumberText',
  'problem.divisionByZero',
  'problem.tooBigNumber',
  'problem.cannotCompare',
  'problem.cannotRun',
]

describe('the given programs', () => {
  let threads: { readonly [file: string]: Thread } = {}
  beforeAll(() => {
    threads = Object.fromEntries(Object.entries(givenFiles()).map(([file, text]) => [file, run(text)]))
  })

  it('keep 151 assertions; the others are named', () => {
    const failed = Object.entries(threads).flatMap(([file, { assertions }]) =>
      assertions.failed.map(({ text, expected, got }) => [file, text, expected, got]),
    )
    const expected = Object.entries(named).flatMap(([file, rows]) => rows.map((row) => [file, ...row]))
    expect(failed.sort()).toEqual(expected.sort())
    expect(Object.values(threads).reduce((sum, { assertions }) => sum + assertions.passed, 0)).toBe(151)
  })

  it('know every block they reach, and stop only for reasons that are named', () => {
    for (const [file, { problem }] of Object.entries(threads))
      if (problem) expect(stops, file).toContain(problem.problem)
  })
})
